"""run, check, open: from a deck or a file to a Result."""

import ctypes
import os
import signal
import threading
import warnings

from . import _deck, _library
from ._errors import EhlWarning, error_of
from ._result import Result, _Handle


class _Listener:
    """Hears how far a run is, on the thread that solves. Stops it for Ctrl-C, and for whatever the user's function
    raises or answers with False."""

    def __init__(self, function):
        self.function = function
        self.raised = None
        self.stopped = False

    def __call__(self, _context, fraction, text):
        try:
            if self.function is not None and self.function(fraction, text.decode("utf-8", "replace")) is False:
                self.stopped = True
        except BaseException as error:  # an exception cannot pass through C: run() raises it again
            self.raised = error
        return int(self.stopped or self.raised is not None)


class _InterruptBecomesFlag:
    """While a case is solved on the main thread, Ctrl-C stops it between two cycles."""

    def __init__(self, listener):
        self.listener = listener
        self.before = None

    def _note(self, _signal, _frame):
        self.listener.raised = KeyboardInterrupt()

    def __enter__(self):
        default = signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if default and threading.current_thread() is threading.main_thread():
            self.before = signal.signal(signal.SIGINT, self._note)
        return self

    def __exit__(self, *_):
        if self.before is not None:
            signal.signal(signal.SIGINT, self.before)


def _arguments(deck, keys, threads):
    text, name = _deck.source(deck)
    overrides = [_deck.encoded(one, one) for one in _deck.overrides(keys)]
    array = (ctypes.c_char_p * len(overrides))(*overrides)
    text = None if text is None else _deck.encoded(text, "deck")
    return (text, _deck.encoded(os.fsencode(name), "the name of the deck"), array, len(overrides), int(threads or 0))


def _warn(result):
    for text in result.warnings:
        warnings.warn(text, EhlWarning, stacklevel=3)


def run(deck, *, threads=None, progress=None, **keys):
    """Solves a case; the stubs of this module tell all sections and keys.

    deck: the path of a deck, its text, or a dict {"contact": {"M": 20, "L": 10}}.
    keys: changes to the deck, contact={"M": 50} or **{"contact.M": 50}; None removes a key.
    threads: number of threads; None: all cores that the process may use. The numbers do not depend on it.
    progress: called with the share of the work that is done and a text, several times a second; False stops the run.

    The interpreter is free for other threads meanwhile. Raises InputError with every error of the deck, NotConverged
    (its `result` contains what was computed), FileError, Interrupted, KeyboardInterrupt. Warns with EhlWarning."""
    listener = _Listener(progress)
    callback = _library.Progress(listener)
    library = _library.library()
    with _InterruptBecomesFlag(listener):
        result = Result(_Handle(library.ehl_run(*_arguments(deck, keys, threads), callback, None)))
    if listener.raised is not None:
        raise listener.raised
    if not result.converged:
        raise error_of(result.status, result.messages, result if len(result) else None)
    _warn(result)
    return result


def check(deck, *, threads=None, **keys):
    """Validates a deck, and derives what follows from it; solves nothing. `report` of the result is what `ehl check`
    prints, its numbers are the scales. Raises InputError with every error, FileError."""
    result = Result(_Handle(_library.library().ehl_check(*_arguments(deck, keys, threads))))
    if not result.converged:
        raise error_of(result.status, result.messages)
    return result


def open(path, case=None):
    """Reads a result file of `ehl run`; or, of a sweep that kept its results, the case of this number, from 0 in the
    order of the table. One that holds no solution is read with a warning; see `converged`. Raises FileError."""
    library, name = _library.library(), _deck.encoded(os.fsencode(path), "path")
    handle = library.ehl_open(name) if case is None else library.ehl_open_case(name, case)
    result = Result(_Handle(handle), os.fspath(path))
    if not len(result) or result.status == _library.FILE_TROUBLE:
        raise error_of(result.status, result.messages)
    for message in result.messages:
        warnings.warn(f"{path}: {message}", EhlWarning, stacklevel=2)
    return result


def version():
    """The version of ehl, its commit, and what its numerics were compiled for."""
    return _library.library().ehl_version().decode()
