"""Runs of ehl for the scripts of this folder; each report is kept, so that a script that was stopped goes on."""

import json
import subprocess


def solved(program, deck, result, *settings, output=None):
    """The JSON report of a deck with these settings ("grid.cells=128").

    Solves, with one thread, what the file `result` does not hold yet; what the program says is kept next to it (.err).
    A run without a report gives {}. output: the result file, by default one that all runs of the folder share.
    """
    if not result.exists():
        command = [program, "run", deck, "--json", "--quiet", "--overwrite", "--threads", "1"]
        command += ["--output", output or result.with_name("out.h5")]
        command += [word for setting in settings for word in ("--set", setting)]
        run = subprocess.run(command, capture_output=True, text=True)
        result.write_text(run.stdout or "{}")
        result.with_suffix(".err").write_text(run.stderr)
    return json.loads(result.read_text())
