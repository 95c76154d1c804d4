"""Writes the stubs of this package, __init__.pyi, from the records of the program's keys: `python3 -m ehl._stubs`."""

import pathlib

from . import _keys

HEAD = '''"""Elastohydrodynamic contacts. Made from the records of the program's keys by `python3 -m ehl._stubs`."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Literal, TypedDict

import numpy as np
import pandas as pd

Deck = str | os.PathLike[str] | Mapping[str, Mapping[str, Any]]

class EhlError(Exception):
    messages: list[str]
    result: Result | None

class InputError(EhlError, ValueError): ...
class NotConverged(EhlError, RuntimeError): ...
class FileError(EhlError, OSError): ...
class Interrupted(EhlError, RuntimeError): ...
class InternalError(EhlError, RuntimeError): ...
class EhlWarning(UserWarning): ...

class Quantity(float):
    name: str
    unit: str
    meaning: str
    error: float | None
    """Estimated relative error."""
    @property
    def bar(self) -> float | None: ...

class Result:
    path: str | None
    @property
    def status(self) -> int: ...
    @property
    def converged(self) -> bool: ...
    @property
    def messages(self) -> list[str]: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def report(self) -> str: ...
    @property
    def json(self) -> dict[str, Any] | None: ...
    @property
    def quantities(self) -> dict[str, Quantity]: ...
    @property
    def fields(self) -> dict[str, np.ndarray]: ...
    def table(self, name: str) -> pd.DataFrame: ...
    def save(self, path: str | os.PathLike[str], overwrite: bool = False) -> None: ...
    def __getitem__(self, path: str) -> Any: ...
    def __getattr__(self, name: str) -> Any: ...
    def __contains__(self, path: str) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...

class Key:
    section: str
    name: str
    type: str
    unit: str
    default: str
    default_note: str
    allowed: str
    words: tuple[str, ...]
    needs: str
    meaning: str
    source: str
    example: str

def open(path: str | os.PathLike[str], case: int | None = None) -> Result: ...
def keys(selection: str | None = None) -> list[Key]: ...
def sections() -> dict[str, str]: ...
def version() -> str: ...
def read_table(path: str | os.PathLike[str]) -> pd.DataFrame: ...
'''

PYTHON_TYPES = {"number": "float | str", "integer": "int", "text": "str | os.PathLike[str]"}


def _type(key):
    words = "Literal[" + ", ".join(f'"{word}"' for word in key.words) + "]"
    if key.type == "word":
        return words + (" | bool" if {"on", "off"} <= set(key.words) else "")
    if key.type == "words":
        return f"{words} | Sequence[{words}]"
    return PYTHON_TYPES[key.type]


def _section_class(section):
    return section.capitalize() + "Keys"


def _section(name, meaning):
    text = f'\nclass {_section_class(name)}(TypedDict, total=False):\n    """{meaning}"""\n'
    for key in _keys.keys(name):
        about = str(key).split(": ", 1)[1].replace("\\", "\\\\").replace("\n ", "\n   ")
        text += f'    {key.name}: {_type(key)}\n    """{about}"""\n'
    return text


def stubs():
    """The text of the stubs."""
    sections = [name for name in _keys.sections() if any(key.section == name for key in _keys.keys())]
    text = HEAD + "".join(_section(name, _keys.sections()[name]) for name in sections)
    of_deck = "".join(f"    {name}: {_section_class(name)} = ...,\n" for name in sections)
    text += f"\ndef run(\n    deck: Deck,\n    *,\n    threads: int | None = None,\n"
    text += "    progress: Callable[[float, str], bool | None] | None = None,\n" + of_deck + ") -> Result: ...\n"
    text += f"\ndef check(\n    deck: Deck,\n    *,\n    threads: int | None = None,\n{of_deck}) -> Result: ...\n"
    text += "\ndef sweep(\n    deck: Deck,\n    vary: Mapping[str | tuple[str, ...], str | Sequence[Any]] | None = None,\n"
    text += "    *,\n    cases: pd.DataFrame | str | os.PathLike[str] | None = None,\n"
    text += "    output: str | os.PathLike[str] | None = None,\n    overwrite: bool = False,\n    keep: bool = False,\n"
    text += "    threads: int | None = None,\n    quiet: bool = True,\n" + of_deck + ") -> pd.DataFrame: ...\n"
    return text


if __name__ == "__main__":
    pathlib.Path(__file__).with_name("__init__.pyi").write_text(stubs(), encoding="utf-8")
