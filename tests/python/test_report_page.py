"""The pages of `ehl report` in a browser without a screen: what they load, say and do."""
import json
import os
import re
import shutil
import subprocess

import pytest

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
pytestmark = pytest.mark.skipif(BROWSER is None, reason="chromium is not installed")

STEADY = """[case]
title = <script>document.title = "taken over"</script> & "co"
[contact]
load = 20
radius_x = 0.010
E_prime = 1.2e11
[motion]
u_m = 0.5
[lubricant]
eta0 = 0.08
alpha = 2e-8
[domain]
x_inlet = -4
y_half = 3
[grid]
cells = 64
"""
# The load doubles: every frame differs from the first.
IN_TIME = ["--set", "transient.end_time=0.4", "--set", "transient.output_interval=0.1",
           "--set", "transient.load=0:1 0.1:1 0.3:2"]


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """One page of each kind, and one of all."""
    folder = tmp_path_factory.mktemp("pages")

    def ehl(*words):
        done = subprocess.run([os.environ["EHL_PROGRAM"], *words], cwd=folder, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr

    (folder / "d.ini").write_text(STEADY)
    ehl("run", "d.ini", "--output", "run.h5")
    ehl("run", "d.ini", "--output", "in_time.h5", *IN_TIME)
    ehl("sweep", "d.ini", "--vary", "motion.u_m=0.2,0.5,1", "--vary", "contact.load=20,40", "--output", "sweep.csv")
    ehl("study", "d.ini", "--levels", "32:64", "--evaluators", "fft", "--cycles", "run", "--repeat", "1",
        "--output", "study.csv")
    files = {"run": "run.h5", "in_time": "in_time.h5", "sweep": "sweep.csv", "study": "study.csv"}
    for name, file in files.items():
        ehl("report", file, "--output", name + ".html")
    ehl("report", *files.values(), "--output", "all.html")
    return folder


def shown(page, script=""):
    """The page after its load event, as text; what the console said; every address that was asked for."""
    name = page
    if script:
        name = page.with_name("probed_" + page.name)
        name.write_text(page.read_text().replace("</body>", "<script>" + script + "</script></body>"))
    log = page.with_suffix(".netlog.json")
    # The address of a proxy that does not exist: the browser cannot reach the network.
    done = subprocess.run(
        [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
         "--proxy-server=127.0.0.1:9", "--disable-background-networking",
         "--disable-features=NetworkTimeServiceQuerying", "--disable-component-update", "--user-data-dir=" + str(page.parent / "user"),
         "--log-net-log=" + str(log), "--dump-dom", name.as_uri()], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    console = [line for line in done.stderr.splitlines() if "CONSOLE" in line]
    asked = set(re.findall(r'"url":"([^"]*)"', log.read_text()))
    # Requests of the browser to its vendor are not requests of the page.
    own = r"data:|chrome|about:|https?://[^/]*\.(google|googleapis|gstatic|gvt1)\.com/"
    return done.stdout, console, {url for url in asked if not re.match(own, url)}, name.as_uri()


# The browser decodes every picture; then the title of the page gives their number and the number of good
# ones. The page's load event waits for all pictures, and the text of the page is read after that event,
# so no time limit is needed.
DECODE = """
const pictures = [...document.querySelectorAll("image")].map((one) => {
  const picture = new Image(); picture.src = one.getAttribute("href"); return picture;
});
addEventListener("load", () => {
  document.title = JSON.stringify([pictures.length, pictures.filter((one) => one.naturalWidth > 0).length]);
});
"""


def title_of(text):
    return re.search(r"<title>(.*?)</title>", text, re.S).group(1).replace("&quot;", '"')


@pytest.mark.parametrize("kind", ["run", "in_time", "sweep", "study", "all"])
def test_a_page_is_silent_and_fetches_nothing(pages, kind):
    page = pages / (kind + ".html")
    text, console, asked, own = shown(page, DECODE)
    assert console == []
    # Some browsers report no file requests; a reported one must be the page itself.
    assert asked <= {own}
    assert page.stat().st_size < 2_000_000
    source = page.read_text()
    for address in re.findall(r'(?:href|src)="([^"]*)"', source):
        assert re.match(r"#part\d+$|#f\d+_|data:image/png;base64,", address), address[:80]
    names = re.findall(r'\sid="([^"]*)"', source)
    assert len(names) > 10 and len(names) == len(set(names))
    for name in re.findall(r'href="#([^"]*)"|url\(#([^)]*)\)', source):
        assert (name[0] or name[1]) in names
    count, good = json.loads(title_of(text))
    assert good == count and (count >= 2 if kind in ("run", "in_time", "all") else count == 0)


def test_what_is_fetched_would_be_seen(pages):
    page = pages / "spoilt.html"
    page.write_text((pages / "run.html").read_text().replace("<h1>", '<img src="http://127.0.0.1:9/x.png"><h1>'))
    _, console, _, _ = shown(page)
    assert any("Content Security Policy" in line for line in console)
    # Without the policy the browser asks for the address.
    page.write_text(re.sub(r"<meta http-equiv[^>]*>", "", page.read_text()))
    _, _, asked, _ = shown(page)
    assert "http://127.0.0.1:9/x.png" in asked


@pytest.mark.parametrize("kind", ["run", "in_time"])
def test_a_title_is_no_script(pages, kind):
    text, _, _, _ = shown(pages / (kind + ".html"))
    assert "taken over" in title_of(text) and title_of(text) != "taken over"
    assert "&lt;script&gt;document.title" in text


# Moves the slider to each frame and records what is drawn.
SLIDE = """
const slider = document.querySelector(".frames input"), seen = [];
for (let k = 0; k <= Number(slider.max); ++k) {
  slider.value = k; slider.dispatchEvent(new Event("input"));
  const drawn = (what, name) => [...document.querySelectorAll(".frames .moving " + what)].map((o) => o.getAttribute(name));
  // Film and pressure over the contact; every curve, among them the line at the present time.
  seen.push([document.querySelector(".frames output").textContent, ...drawn("image", "href"),
             drawn("path", "d").join(";")]);
}
document.title = JSON.stringify(seen);
"""


def test_the_slider_shows_every_frame(pages):
    text, console, _, _ = shown(pages / "in_time.html", SLIDE)
    assert console == []
    seen = json.loads(title_of(text))
    times = [float(one[0].split()[0]) for one in seen]
    said = subprocess.run([os.environ["EHL_PROGRAM"], "extract", "in_time.h5", "/transient/frames/time", "--si"],
                          cwd=pages, capture_output=True, text=True).stdout
    in_file = [float(line) for line in said.splitlines() if not line.startswith("#")]
    assert times == pytest.approx(in_file, rel=1e-3, abs=1e-9)
    last = [one[1:] for one in seen][-1]
    assert len(last) == 3
    for k, first in enumerate(seen[0][1:]):
        assert first != last[k]


def test_paper_has_the_whole_page(pages):
    """Printed, nothing is folded away: the deck is in the PDF."""
    text, _, _, _ = shown(pages / "run.html", 'dispatchEvent(new Event("beforeprint"))')
    assert text.count("<details") > 3 and text.count("<details") == text.count('<details open=""')
