"""Changes of ``situ.toml`` that leave all else as it was written: order, comments, what is unknown.

Values are those of TOML: texts, numbers, true and false, lists and tables of them.
"""

from __future__ import annotations

from collections.abc import Mapping, MutableMapping
from typing import Any

import tomlkit
from tomlkit.items import AoT, Array

from situ.document.beside import Toml

SETTING = "setting"
Values = Mapping[str, Any]


def put(toml: Toml, table: str, key: str, value: Any) -> Toml:
    """The file with ``value`` at ``table.key``; None takes it out.

    What stands in the table's place and is none, an error, makes room for one.
    """
    document = tomlkit.parse(toml.text)
    found = document.get(table)
    if value is None:
        if isinstance(found, MutableMapping) and key in found:
            del found[key]
        return _made(toml, document)
    if not isinstance(found, MutableMapping):
        if found is not None:
            document.remove(table)
        found = tomlkit.table()
        if document.body and not toml.text.endswith("\n\n"):
            document.add(tomlkit.nl())
        document.add(table, found)
        found = document[table]
    _put(found, key, value)
    return _made(toml, document)


def rename(toml: Toml, table: str, old: str, new: str) -> Toml:
    """The file with another name for a key of ``table``; what stands behind it stays."""
    document = tomlkit.parse(toml.text)
    found: Any = document[table]
    # Of tomlkit's own, which has no public way to a key's place.
    container = found.value
    container._replace(old, new, found[old])
    return _made(toml, document)


def put_in(toml: Toml, table: str, key: str, inner: str, value: Any) -> Toml:
    """As ``put``, in the table at ``table.key``."""
    document = tomlkit.parse(toml.text)
    outer = document.get(table)
    found = outer.get(key) if isinstance(outer, MutableMapping) else None
    if not isinstance(found, MutableMapping):
        return put(toml, table, key, {inner: value}) if value is not None else toml
    if value is not None:
        _put(found, inner, value)
    elif inner in found:
        del found[inner]
    return _made(toml, document)


def rename_in(toml: Toml, table: str, key: str, old: str, new: str) -> Toml:
    """As ``rename``, in the table at ``table.key``."""
    document = tomlkit.parse(toml.text)
    found: Any = document[table][key]
    found.value._replace(old, new, found[old])
    return _made(toml, document)


def add_setting(toml: Toml, values: Values) -> Toml:
    """The file with one more ``[[setting]]`` at its end."""
    document = tomlkit.parse(toml.text)
    made = tomlkit.table()
    for key, value in values.items():
        made.add(key, value)
    found = document.get(SETTING)
    if isinstance(found, AoT):
        found.append(made)
    else:
        if found is not None:
            document.remove(SETTING)
        if document.body and not toml.text.endswith("\n\n"):
            document.add(tomlkit.nl())
        every = tomlkit.aot()
        every.append(made)
        document.add(SETTING, every)
    return _made(toml, document)


def put_setting(toml: Toml, index: int, key: str, value: Any) -> Toml:
    """The file with ``value`` at a key of one ``[[setting]]``; None takes it out."""
    document = tomlkit.parse(toml.text)
    found: Any = document[SETTING]
    if value is not None:
        _put(found[index], key, value)
    elif key in found[index]:
        found[index].remove(key)
    return _made(toml, document)


def remove_setting(toml: Toml, index: int) -> Toml:
    """The file without one ``[[setting]]``."""
    document = tomlkit.parse(toml.text)
    found: Any = document[SETTING]
    if len(found) == 1:
        document.remove(SETTING)
    else:
        del found[index]
    return _made(toml, document)


def _put(table: Any, key: str, value: Any) -> None:
    old = table.get(key)
    if isinstance(old, Array) and isinstance(value, (list, tuple)):
        _settle(old, list(value))
    else:
        table[key] = list(value) if isinstance(value, tuple) else value


def _settle(array: Array, wanted: list[Any]) -> None:
    """Makes a list another one; entries that stay keep their lines and comments."""
    for index in reversed(range(len(array))):
        if array[index] not in wanted:
            array.pop(index)
    if [one for one in wanted if one in array] == list(array):
        for index, one in enumerate(wanted):
            if index >= len(array) or array[index] != one:
                array.insert(index, one)
    if list(array) != wanted:
        array.clear()
        array.extend(wanted)


def _made(toml: Toml, document: tomlkit.TOMLDocument) -> Toml:
    made = tomlkit.dumps(document)
    return Toml(made) if made != toml.text else toml
