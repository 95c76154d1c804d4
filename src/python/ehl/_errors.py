"""What can go wrong, as Python says it. Each has `messages`, a text for each error of the deck."""

from . import _library


class EhlError(Exception):
    """Whatever ehl could not do."""

    def __init__(self, messages, result=None):
        super().__init__("\n".join(messages))
        self.messages = list(messages)
        #: The partial result, for diagnosis; it is no solution. None if nothing was computed.
        self.result = result

    def __reduce__(self):  # a pickled exception loses its result
        return type(self), (self.messages,)


class InputError(EhlError, ValueError):
    """The deck is wrong: `messages` has all its errors."""


class NotConverged(EhlError, RuntimeError):
    """The case has no solution that can be trusted; `result` contains what was computed."""


class FileError(EhlError, OSError):
    """A file could not be read or written."""

    def __str__(self):
        return "\n".join(self.messages)


class Interrupted(EhlError, RuntimeError):
    """The progress function asked to stop; `result` contains what was computed."""


class InternalError(EhlError, RuntimeError):
    """An error of ehl itself, or not enough memory."""


class EhlWarning(UserWarning):
    """What ehl warns of in a result: a film that is not resolved, a law beyond its range."""


OF_STATUS = {
    _library.WRONG_INPUT: InputError,
    _library.NOT_CONVERGED: NotConverged,
    _library.FILE_TROUBLE: FileError,
    _library.INTERRUPTED: Interrupted,
}


def error_of(status, messages, result=None):
    return OF_STATUS.get(status, InternalError)(messages, result)
