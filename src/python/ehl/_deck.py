"""Decks as Python writes them: a file, a text, or {"contact": {"M": 20, "L": 10}}."""

import os


def value_text(value):
    """A value as a deck has it: 0.1 is read back as the same double, [1, 2] is a list of words, True is on."""
    if not isinstance(value, (float, int, str)) and hasattr(value, "tolist"):  # a scalar or an array of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, (list, tuple)):
        return ", ".join(value_text(one) for one in value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    return repr(float(value))


def _one_line(where, value):
    text = value_text(value)
    if any(sign in text for sign in "\n\r#\0"):
        raise ValueError(f"{where}: a value is one line without # and without NUL characters, not {text!r}")
    return text


def overrides(keys):
    """contact={"M": 20} or **{"contact.M": 20} as the program's --set; None removes a key."""
    flat = []
    for name, value in keys.items():
        if isinstance(value, dict):
            flat += [(f"{name}.{key}", one) for key, one in value.items()]
        elif "." in name:
            flat.append((name, value))
        else:
            raise TypeError(f"{name} = {value!r}: keys of a deck are given as {name}={{'key': value}}, "
                            f"or **{{'section.key': value}}")
    return [f"-{name}" if value is None else f"{name}={_one_line(name, value)}" for name, value in flat]


def text_of(sections):
    """The text of a deck in a dict of sections."""
    lines = []
    for section, keys in sections.items():
        if not isinstance(keys, dict):
            raise TypeError(f"deck: section {section!r} is a dict of keys and values, not {keys!r}")
        lines.append(f"[{section}]")
        lines += [f"{key} = {_one_line(f'{section}.{key}', one)}" for key, one in keys.items() if one is not None]
    return "\n".join(lines) + "\n"


def source(deck):
    """(text or None, name) of a deck: None is a file of this name. A text has more than one line: a section and a key."""
    if isinstance(deck, dict):
        return text_of(deck), "deck"
    if isinstance(deck, str) and "\n" in deck:
        return deck, "deck"
    return None, os.fspath(deck)


def encoded(text, what):
    """The bytes of a text or a path for C, where the first NUL character would end it."""
    found = os.fsencode(text) if isinstance(text, os.PathLike) else text if isinstance(text, bytes) else text.encode()
    if b"\0" in found:
        raise ValueError(f"{what}: there is a NUL character in it, at byte {found.index(0)}")
    return found
