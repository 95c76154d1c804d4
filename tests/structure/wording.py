#!/usr/bin/env python3
"""Finds prose that a reader must puzzle out, in comments, messages and pages; exit status 1 where there is any.

Rules: word       a word with a private meaning (words.txt); the standard term is printed next to it
       subject    a comment that cannot be read alone, such as "Of ..." or "Likewise ..."
       figures    a comment with three or more measured figures: they belong into tests/bench
       paragraph  a paragraph of a page with more than 60 words
       printed    a test asks for three words or more that a transcript of tests/golden shows: rewording would need both
"""
import pathlib
import re
import subprocess
import sys

WORDS = [
    line.rstrip("\n").split("\t")
    for line in pathlib.Path(__file__).with_name("words.txt").open()
    if not line.startswith("#")
]
WORD = re.compile("|".join(pattern for pattern, _ in WORDS), re.I)
SUBJECT = re.compile(r"^\s*//+\s*(Of|The same|Likewise|With it|Without it|So many|Beside it|What is left)\b")
FIGURE = re.compile(r"(?<![\w.^])(\d+\.\d+|\d+e-\d+|\d+(\.\d+)?( %| s\b| ms\b| times\b))(?!\w)")
FORMULA = re.compile(r"[=*^/+] ?\d|source", re.I)
MOST_WORDS = 60
ASKED = re.compile(r'(?<!!)\b(?:support::)?(?:contains|says)\((?:[^;"]|"(?:[^"\\]|\\.)*")*;')


def term_of(found):
    return next(term for pattern, term in WORDS if re.search(pattern, found, re.I))


def comment_of(line):
    at = re.search(r"//[/!<]*\s?(.*)$", line)
    return at.group(1) if at and line[: at.start()].count('"') % 2 == 0 else ""


def offences_of_line(line, code):
    texts = [line]
    if code:
        strings = [] if line.startswith("#include") else re.findall(r'"((?:[^"\\]|\\.)*)"', line)
        texts = [comment_of(line), *strings]
    for text in texts:
        if found := WORD.search(text):
            yield f"word '{found.group(0)}' (the standard term: {term_of(found.group(0))})"
    if code and SUBJECT.match(line):
        yield "subject: the comment cannot be read alone"
    if code and len(FIGURE.findall(comment_of(line))) >= 3 and not FORMULA.search(comment_of(line)):
        yield "figures: three measured figures or more in a comment"


def offences_of_page(lines):
    start, words, fenced = 1, 0, False
    for number, line in enumerate([*lines, ""], 1):
        plain = line.strip()
        fenced ^= plain.startswith("```")
        apart = fenced or not plain or plain.startswith(("|", "#", "```")) or line.startswith("    ")
        if apart or plain.startswith(("- ", "* ")):
            if words > MOST_WORDS:
                yield start, f"paragraph of {words} words, {MOST_WORDS} at most"
            start, words = number, 0
        if not apart:
            words += len(plain.split())


def printed_words(root):
    lines = (line for path in (root / "tests/golden/commands").glob("*.txt") for line in path.open(errors="replace"))
    return "".join(line[2:] for line in lines if line[0] in "|!")


def offences_of_test(text, printed):
    for asked in ASKED.finditer(text):
        for literal in re.finditer(r'"((?:[^"\\]|\\.)*)"', asked.group(0)):
            words = literal.group(1)
            if re.search(r"^[^#].*[A-Za-z]{2,} [A-Za-z]{2,} [A-Za-z]{2,}", words) and words in printed:
                yield text.count("\n", 0, asked.start() + literal.start()) + 1, f"printed: a transcript shows '{words}'"


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    printed = printed_words(root)
    kinds = ("*.cpp", "*.hpp", "*.h", "*.c", "*.md", "*.py", "*.ini", "*.gp")
    files = subprocess.run(["git", "ls-files", *kinds], cwd=root, capture_output=True, text=True).stdout.split()
    listed = 0
    for path in files:
        if path == "CHANGELOG.md":
            continue
        lines = (root / path).read_text(errors="replace").splitlines()
        code = path.endswith((".cpp", ".hpp", ".h", ".c"))
        found = [(n, what) for n, line in enumerate(lines, 1) for what in offences_of_line(line, code)]
        found += offences_of_page(lines) if path.endswith(".md") else []
        if path.startswith(("tests/scenes/", "tests/unit/program/")):
            found += offences_of_test("\n".join(lines), printed)
        for number, what in found:
            print(f"{path}:{number}: {what}")
        listed += len(found)
    print(f"{listed} places in {len(files)} files")
    return 1 if listed or not files else 0


sys.exit(main())
