"""A case that was solved, or a result file that was opened: its numbers, fields and tables."""

import ctypes
import functools
import json
import os

import numpy as np

from . import _deck, _library
from ._errors import error_of


class Quantity(float):
    """A number with what is known of it: `unit`, `meaning`, and `error`, the estimated relative error (None: not
    estimated)."""

    __slots__ = ("error", "meaning", "name", "unit")

    def __new__(cls, value, name="", unit="", meaning="", error=None):
        made = super().__new__(cls, value)
        made.name, made.unit, made.meaning, made.error = name, unit, meaning, error
        return made

    def __getnewargs__(self):
        return float(self), self.name, self.unit, self.meaning, self.error

    def __getstate__(self):  # all of the state is in the arguments
        return None

    @property
    def bar(self):
        """The estimated error in the number's own unit; None where it is not estimated."""
        return None if self.error is None else abs(float(self)) * self.error

    def __str__(self):
        unit = "" if self.unit in ("", "-") else f" {self.unit}"
        bar = "" if self.error is None else f" +- {100.0 * self.error:.2g} %"
        return f"{float(self):.6g}{unit}{bar}"

    def __repr__(self):
        return f"<{self.name} = {self}>"


class _Handle:
    """Owns a result of the library, and what numpy sees of it."""

    def __init__(self, pointer):
        if not pointer:
            raise MemoryError("ehl: no memory for a result")
        self.library = _library.library()
        self.pointer = pointer

    def __del__(self):
        pointer, self.pointer = getattr(self, "pointer", None), None
        if pointer:
            self.library.ehl_free(pointer)


def _array(entry, handle):
    shape = tuple(entry.dims[: entry.rank])
    if 0 in shape:
        return np.empty(shape)
    steps = tuple(entry.strides[: entry.rank])
    length = 1 + sum((n - 1) * step for n, step in zip(shape, steps))
    memory = (ctypes.c_double * length).from_address(entry.values)
    memory.owner = handle
    flat = np.frombuffer(memory, dtype=np.float64)
    view = np.lib.stride_tricks.as_strided(flat, shape, tuple(8 * step for step in steps), writeable=False)
    return view.astype(np.int64) if entry.whole else view


class Result:
    """What a case gave. `result.Hc`, `result.mu`: a number of the summary or of the scales, a Quantity; `result.P`: a
    field, a view (row = y, column = x) that keeps the result in memory; `result.x`, `result.y`: its nodes;
    `result["/levels/Hc"]`: anything by its path in the result file."""

    def __init__(self, handle, path=None):
        self._handle = handle
        #: The result file that this was read from, or None.
        self.path = path

    # What is behind it -------------------------------------------------------------------------------------------

    def _text(self, function):
        return function(self._handle.pointer).decode("utf-8", "replace")

    def _entry(self, path):
        entry = _library.Entry()
        found = self._handle.library.ehl_find(self._handle.pointer, path.encode(), ctypes.byref(entry))
        return entry if found else None

    def _value(self, path, entry):
        if entry.kind == _library.TEXT:
            return entry.text.decode("utf-8", "replace")
        if entry.rank > 0:
            return _array(entry, self._handle)
        value = ctypes.c_double.from_address(entry.values).value
        at = self._entry(entry.error.decode()) if entry.error else None
        error = None if at is None else ctypes.c_double.from_address(at.values).value
        name = path.rsplit("/", 1)[1]
        return Quantity(value, name, entry.unit.decode(), entry.meaning.decode(), error)

    def __getitem__(self, path):
        """A number, text, array, or the names in a group, by its path: "/summary/Hc", "/fields/P", "/levels"."""
        entry = self._entry(path)
        if entry is None:
            raise KeyError(f"{path}: the result has no such thing; list(result) has all paths")
        if entry.kind == _library.GROUP:
            below = path.rstrip("/") + "/"
            return [name[len(below):] for name in self if name.startswith(below) and "/" not in name[len(below):]]
        return self._value(path, entry)

    def __contains__(self, path):
        return self._entry(path) is not None

    @functools.cached_property
    def _paths(self):
        entry, paths = _library.Entry(), []
        while self._handle.library.ehl_entry_at(self._handle.pointer, len(paths), ctypes.byref(entry)):
            paths.append(entry.path.decode())
        return paths

    def __iter__(self):
        return iter(self._paths)

    def __len__(self):
        return len(self._paths)

    def __getattr__(self, name):
        if not name.startswith("_"):
            for group in ("/summary/", "/scales/", "/fields/", "/grid/", "/"):
                entry = self._entry(group + name)
                if entry is not None:
                    return self[group + name]
        raise AttributeError(f"the result has no {name!r}: list(result) has all there is")

    def __dir__(self):
        groups = ("/summary/", "/scales/", "/fields/", "/grid/")
        return [*super().__dir__(), *(path.rsplit("/", 1)[1] for path in self if path.startswith(groups))]

    # What people ask for -----------------------------------------------------------------------------------------

    @property
    def status(self):
        """0: solved; 3: not converged; 130: interrupted."""
        return self._handle.library.ehl_status(self._handle.pointer)

    @property
    def converged(self):
        """Whether its numbers are a solution."""
        return self.status == _library.SOLVED

    @property
    def messages(self):
        """Why it is no solution; empty where it is one."""
        return _library.texts(self._handle.library.ehl_message, self._handle.pointer)

    @property
    def warnings(self):
        return _library.texts(self._handle.library.ehl_warning, self._handle.pointer)

    @property
    def report(self):
        """What `ehl run` or `ehl check` prints; empty for a result file."""
        return self._text(self._handle.library.ehl_report)

    @functools.cached_property
    def json(self):
        """What `ehl run --json` prints, as a dict; None for a file, or a case that was only checked."""
        text = self._text(self._handle.library.ehl_json)
        return json.loads(text) if text else None

    @property
    def quantities(self):
        """The numbers of the summary and of the scales: {"Hc": Quantity, ...}."""
        found = {}
        for path in self:
            if path.startswith(("/scales/", "/summary/")):
                value = self[path]
                if isinstance(value, Quantity):
                    found[value.name] = value
        return found

    @property
    def fields(self):
        """The fields on the nodes: {"P": array, ...}, views (row = y, column = x)."""
        return {name: self["/fields/" + name] for name in self["/fields"]}

    def table(self, name):
        """A table of the result, "levels", "history", "transient", as a pandas DataFrame."""
        import pandas

        order = self._handle.library.ehl_attribute(self._handle.pointer, f"/{name}".encode(), b"columns")
        if order is None:
            raise KeyError(f"{name}: the result has no such table")
        return pandas.DataFrame({column: self[f"/{name}/{column}"] for column in order.decode().split()})

    def save(self, path, overwrite=False):
        """Writes the result file (HDF5) and the XDMF file next to it, as `ehl run` does; for a result of run()."""
        library, pointer = self._handle.library, self._handle.pointer
        before = len(self.messages)
        status = library.ehl_save(pointer, _deck.encoded(os.fsencode(path), "path"), bool(overwrite))
        if status != _library.SOLVED:
            raise error_of(status, self.messages[before:] or [f"{path}: not enough memory"])

    def __repr__(self):
        title = self._handle.library.ehl_attribute(self._handle.pointer, b"/", b"title") or b""
        lines = [f"<ehl result: {title.decode('utf-8', 'replace')}" + ("" if self.converged else "  NOT CONVERGED")]
        for name in ("hc", "hm", "p_max", "Hc", "Hm", "P_max", "mu"):
            if f"/summary/{name}" in self:
                lines.append(f"  {name} = {self['/summary/' + name]}")
        return "\n".join(lines) + ">"
