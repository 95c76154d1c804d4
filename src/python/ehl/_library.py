"""libehl, the C interface, by ctypes: src/api/ehl.h in Python's words."""

import ctypes
import os
import pathlib
from ctypes import POINTER, c_char_p, c_double, c_int, c_size_t, c_ssize_t, c_void_p

API_VERSION = 1
FILE_NAME = f"libehl.so.{API_VERSION}"

SOLVED, INTERNAL_FAILURE, WRONG_INPUT, NOT_CONVERGED, FILE_TROUBLE, INTERRUPTED = 0, 1, 2, 3, 4, 130
GROUP, TEXT, NUMBERS = 0, 1, 2

Progress = ctypes.CFUNCTYPE(c_int, c_void_p, c_double, c_char_p)


class Entry(ctypes.Structure):
    _fields_ = [
        ("path", c_char_p),
        ("kind", c_int),
        ("whole", c_int),
        ("unit", c_char_p),
        ("meaning", c_char_p),
        ("error", c_char_p),
        ("text", c_char_p),
        ("rank", c_int),
        ("dims", c_size_t * 3),
        ("strides", c_ssize_t * 3),
        ("values", c_void_p),
    ]


def _candidates(names):
    """Files below the folders above this one: of an installed package its prefix, of the sources the builds."""
    places = ["lib", "lib64", "lib/x86_64-linux-gnu", "lib/aarch64-linux-gnu", "bin"]
    builds = ["build/release", "build/native"]
    for folder in pathlib.Path(__file__).resolve().parents:
        for place in [*builds, *places, *(f"{build}/{place}" for build in builds for place in places)]:
            for name in names:
                yield folder / place / name


def find_file(name, variable):
    """A file of ehl: what the environment variable names, or the nearest one next to this package."""
    given = os.environ.get(variable)
    if given:
        if not pathlib.Path(given).is_file():
            raise ImportError(f"{variable} = {given}: there is no such file")
        return given
    for path in _candidates([name]):
        if path.is_file():
            return str(path)
    raise ImportError(f"{name} is not found: build it by `./ehl-setup python`, or let {variable} name the file")


def _load(path):
    # OpenMP reads the waiting policy of its threads when it is loaded: as in the program, they spin for
    # a tenth of a millisecond.
    waits = {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT"} & os.environ.keys()
    if not waits:
        os.environ["GOMP_SPINCOUNT"] = "3000"
    try:
        return ctypes.CDLL(path)
    finally:
        if not waits:
            del os.environ["GOMP_SPINCOUNT"]


def _declare(library):
    result, entry = c_void_p, POINTER(Entry)
    deck = [c_char_p, c_char_p, POINTER(c_char_p), c_size_t, c_int]
    functions = {
        "ehl_api_version": (c_int, []),
        "ehl_version": (c_char_p, []),
        "ehl_run": (result, [*deck, Progress, c_void_p]),
        "ehl_check": (result, deck),
        "ehl_open": (result, [c_char_p]),
        "ehl_open_case": (result, [c_char_p, c_size_t]),
        "ehl_free": (None, [result]),
        "ehl_status": (c_int, [result]),
        "ehl_message": (c_char_p, [result, c_size_t]),
        "ehl_warning": (c_char_p, [result, c_size_t]),
        "ehl_report": (c_char_p, [result]),
        "ehl_json": (c_char_p, [result]),
        "ehl_entry_count": (c_size_t, [result]),
        "ehl_entry_at": (c_int, [result, c_size_t, entry]),
        "ehl_find": (c_int, [result, c_char_p, entry]),
        "ehl_attribute": (c_char_p, [result, c_char_p, c_char_p]),
        "ehl_save": (c_int, [result, c_char_p, c_int]),
        "ehl_keys": (c_char_p, []),
    }
    for name, (returned, taken) in functions.items():
        function = getattr(library, name)
        function.restype = returned
        function.argtypes = taken


_library = None


def library():
    """The library, loaded when it is first needed."""
    global _library
    if _library is None:
        path = find_file(FILE_NAME, "EHL_LIBRARY")
        loaded = _load(path)
        _declare(loaded)
        if loaded.ehl_api_version() != API_VERSION:
            raise ImportError(f"{path} has version {loaded.ehl_api_version()} of the interface, not {API_VERSION}")
        _library = loaded
    return _library


def texts(function, handle):
    """All texts of a function that counts them until there is none."""
    found = []
    while (text := function(handle, len(found))) is not None:
        found.append(text.decode("utf-8", "replace"))
    return found
