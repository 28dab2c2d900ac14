"""Changes of ``situ.toml`` that leave all else as it was written: order, comments, what is unknown.

Values are those of TOML: texts, numbers, true and false, lists and tables of them.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, MutableMapping, Sequence
from contextlib import suppress
from typing import Any

import tomlkit
from tomlkit.container import Container, OutOfOrderTableProxy
from tomlkit.exceptions import NonExistentKey
from tomlkit.items import AoT, Array, Table

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


def take_out(toml: Toml, table: str) -> Toml:
    """The file without a table, or a key that stands in none."""
    document = tomlkit.parse(toml.text)
    document.remove(table)
    return _made(toml, document)


def rename(toml: Toml, table: str, old: str, new: str) -> Toml:
    """The file with another name for a key of ``table``; what stands behind it stays, and where."""
    return _renamed(toml, (table,), old, new)


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
    return _renamed(toml, (table, key), old, new)


def rename_at(toml: Toml, way: Sequence[str | int], new: str) -> Toml:
    """As ``rename``, of the key in which a way of keys and positions ends: a table's own too."""
    return _renamed(toml, way[:-1], str(way[-1]), new)


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


def _renamed(toml: Toml, way: Sequence[str | int], old: str, new: str) -> Toml:
    document = tomlkit.parse(toml.text)
    wanted: Any = tomllib.loads(toml.text)
    inner = wanted
    for step in way:
        inner = inner[step]
    pairs = [(new if key == old else key, value) for key, value in inner.items()]
    inner.clear()
    inner.update(pairs)
    for piece in _pieces(document, way):
        # Of tomlkit's own, which has no public way to a key's place.
        container = piece if isinstance(piece, Container) else getattr(piece, "value", None)
        if isinstance(container, Container) and old in container:
            with suppress(NonExistentKey, IndexError):
                container._replace(old, new, container[old])
                if isinstance(container[new], Table):
                    # What its header was written as.
                    container[new].display_name = None
    with suppress(IndexError):
        if tomllib.loads(tomlkit.dumps(document)) == wanted:
            return _made(toml, document)
    # A key such as a.b = 1, or a table of its own after others, has no place in its table: that
    # is written anew.
    document = tomlkit.parse(toml.text)
    whole = str(way[0]) if way else new
    document.remove(str(way[0]) if way else old)
    document.add(whole, wanted[whole])
    return _made(toml, document)


def _pieces(document: tomlkit.TOMLDocument, way: Sequence[str | int]) -> list[Any]:
    """The table at the end of a way: several where others stand between its parts."""
    found: list[Any] = [document]
    for step in way:
        inner: list[Any] = []
        for one in found:
            if isinstance(step, int) or step in one:
                part = one[step]
                inner += part._tables if isinstance(part, OutOfOrderTableProxy) else [part]
        found = inner
    return found


def _put(table: Any, key: str, value: Any) -> None:
    old = table.get(key)
    if isinstance(old, Array) and isinstance(value, (list, tuple)):
        _settle(old, list(value))
    else:
        table[key] = list(value) if isinstance(value, tuple) else value


def _settle(array: Array, wanted: list[Any]) -> None:
    """Makes a list another one; entries that stay keep their lines and comments."""
    if len(array) == len(wanted):
        for index, one in enumerate(wanted):
            if array[index] != one and one not in array:
                array[index] = one
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
