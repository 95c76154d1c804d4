"""Many cases of one deck by the program's own sweep: in processes, restartable, as one table."""

import contextlib
import os
import pathlib
import signal
import subprocess
import tempfile
import warnings

from . import _deck, _library
from ._errors import EhlWarning, error_of


def _one_of_list(value):
    """A value between the commas and colons of a list."""
    text = "" if value is None else _deck.value_text(value)
    if not text or any(sign in text for sign in ",:\"#\n\r\0"):
        raise ValueError(f"vary: {value!r} cannot stand in a list of values: it is empty, or holds a comma, a colon, "
                         f"a quote, # or a line break")
    return text


def _range(values):
    """LIST of --vary: a text as it is ("5:2000:17:log"), or the values between commas."""
    if isinstance(values, str):
        return values
    rows = [":".join(map(_one_of_list, one)) if isinstance(one, tuple) else _one_of_list(one) for one in values]
    return ",".join(rows)


def _variations(vary):
    for names, values in (vary or {}).items():
        name = ",".join(names) if isinstance(names, tuple) else names
        yield from ("--vary", f"{name}={_range(values)}")


@contextlib.contextmanager
def _files(deck, cases, output):
    """Paths of the deck, of the cases (or None) and of the table."""
    with tempfile.TemporaryDirectory(prefix="ehl_") as folder:
        text, name = _deck.source(deck)
        if text is not None:
            name = str(pathlib.Path(folder, "deck.ini"))
            pathlib.Path(name).write_text(text, encoding="utf-8")
        if cases is not None and not isinstance(cases, (str, os.PathLike)):
            table = str(pathlib.Path(folder, "cases.csv"))
            cases.to_csv(table, index=False)
            cases = table
        yield name, cases, os.fspath(output or pathlib.Path(folder, "table.csv"))


def _messages(stderr):
    lines = [line.removeprefix("ehl: ") for line in stderr.splitlines() if line]
    return lines or ["the sweep ended without a message"]


def _finished(command, quiet):
    """Runs the program to its end; Ctrl-C reaches it too, and what it has computed is kept."""
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        heard = []
        try:
            for line in process.stderr:
                heard.append(line)
                if not quiet and line.startswith("ehl: ") and "/" in line.split(" ", 2)[1]:
                    print(line.removeprefix("ehl: "), end="")
        except KeyboardInterrupt:
            # At a terminal, the program has received Ctrl-C too; a second one would end it before
            # it has saved its results.
            process.send_signal(signal.SIGUSR1)
            process.wait()
            raise
    return process.returncode, "".join(heard)


def read_table(path):
    """The table of a sweep as a pandas DataFrame; its comment lines are in `attrs["header"]`."""
    import pandas

    with open(path, encoding="utf-8") as file:
        header = [line[1:].strip() for line in file if line.startswith("#")]
    table = pandas.read_csv(path, comment="#")
    table.attrs["header"] = header
    return table


def sweep(deck, vary=None, *, cases=None, output=None, overwrite=False, keep=False, threads=None, quiet=True, **keys):
    """Solves many cases of one deck, several at a time, and gives a pandas DataFrame, a row for each.

    deck, keys: as run() takes them.
    vary: {"contact.M": [20, 50, 100], "contact.L": "0:25:6"}: all combinations; keys varied together:
          {("contact.M", "contact.L"): [(20, 5), (50, 10)]}.
    cases: or a DataFrame (or a CSV file) with a column for each key, "contact.M", and a row for each case.
    output: the table as a CSV file, which the same call continues where it was stopped; None: it is not stored.
    keep: stores the result of each case in one HDF5 file next to the table: ehl.open("speed.h5", case=3).
    threads: cases at a time; None: all cores. quiet=False prints each case as it ends.

    `status` of a row says whether it converged. Warns where not all did. Raises InputError, FileError."""
    if keep and output is None:
        raise ValueError("keep: say where: output=\"table.csv\"")
    with _files(deck, cases, output) as (name, table_of_cases, table):
        command = [_library.find_file("ehl", "EHL_PROGRAM"), "sweep", name, *_variations(vary), "--output", table]
        if table_of_cases is not None:
            command += ["--cases", os.fspath(table_of_cases)]
        for one in _deck.overrides(keys):
            command += ["--unset", one[1:]] if one.startswith("-") else ["--set", one]
        command += ["--overwrite"] * overwrite + ["--keep"] * keep
        if threads:
            command += ["--threads", str(threads)]
        status, stderr = _finished(command, quiet)
        if status == _library.INTERRUPTED:
            raise KeyboardInterrupt
        if status not in (_library.SOLVED, _library.NOT_CONVERGED) or not pathlib.Path(table).is_file():
            raise error_of(status, _messages(stderr))
        found = read_table(table)
    left = int((found["status"] != "converged").sum())
    if left:
        warnings.warn(f"{left} of {len(found)} cases did not converge: see the column status", EhlWarning, stacklevel=2)
    return found
