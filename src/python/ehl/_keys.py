"""What a deck may say, from the records of the program."""

import dataclasses
import functools
import json

from . import _library


@dataclasses.dataclass(frozen=True)
class Key:
    """A key of the deck."""

    section: str
    name: str
    type: str  #: number, integer, word, words (several) or text
    unit: str
    default: str  #: as the deck would write it; empty: none
    default_note: str  #: how a value is found where there is no fixed default
    allowed: str
    words: tuple
    needs: str  #: "[section] key = words" without which it has no influence; empty: none
    meaning: str
    source: str
    example: str

    def __str__(self):
        unit = f" [{self.unit}]" if self.unit else ""
        default = self.default or self.default_note or "none"
        needs = f" (only with {self.needs})" if self.needs else ""
        return f"{self.section}.{self.name}{unit}: {self.meaning}{needs}\n  default: {default}; allowed: {self.allowed}"


def _needed(needs):
    if not needs:
        return ""
    words = f" = {' or '.join(needs['words'])}" if needs["words"] else ""
    return f"[{needs['section']}] {needs['name']}{words}"


@functools.lru_cache(maxsize=None)
def _records():
    everything = json.loads(_library.library().ehl_keys())
    known = [Key(**{**one, "words": tuple(one["words"]), "needs": _needed(one["needs"])}) for one in everything["keys"]]
    return everything["sections"], tuple(known)


def sections():
    """The sections of a deck: {"contact": meaning, ...}."""
    return {one["name"]: one["meaning"] for one in _records()[0]}


def keys(selection=None):
    """The keys of a deck: all, those of a section ("contact"), or the one of this name ("contact.M"), as a list of Key.
    Raises KeyError where there is no such section or key."""
    known = _records()[1]
    if selection is None:
        return list(known)
    found = [one for one in known if selection in (one.section, f"{one.section}.{one.name}")]
    if not found:
        raise KeyError(f"{selection}: there is no such section or key; ehl.keys() lists all")
    return found
