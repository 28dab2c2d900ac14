"""Notes and frames of a drawing: what designers write beside the states, for themselves.

They stand in the application's file as ``ed:note`` and ``ed:frame`` of the namespace
``urn:situ:editor``; the runtime ignores them and an export leaves them out (formats.md). They
ride along with the document (``situ.document.aside``), so two documents that differ only in them
are equal. Lengths are scene units, as ``ed:x`` and ``ed:y`` of states are.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import lru_cache
from html import escape
from xml.etree import ElementTree

from msgspec import Struct
from msgspec.structs import replace

from situ.document.aside import EDITOR, Aside
from situ.document.rbd import Application
from situ.document.writer import ATTRIBUTE


class Note(Struct, frozen=True, gc=False):
    """``<ed:note x y width height color>text</ed:note>``. color: as ``#0a5a4c``; "": the usual."""

    x: float = 0.0
    y: float = 0.0
    width: float = 176.0
    height: float = 72.0
    text: str = ""
    color: str = ""


class Frame(Struct, frozen=True, gc=False):
    """``<ed:frame title x y width height color/>``: goes round some states, and with them."""

    x: float = 0.0
    y: float = 0.0
    width: float = 448.0
    height: float = 256.0
    title: str = ""
    color: str = ""


Drawn = Note | Frame


def drawn(application: Application) -> tuple[Drawn, ...]:
    """Every note and frame, in the order of the file."""
    return tuple(value for _, _, value in _found(application))


def exchange(application: Application, index: int, value: Drawn | None) -> Application:
    """The application with the one at ``index`` of ``drawn`` exchanged, or (None) without it."""
    holder, at, _ = list(_found(application))[index]
    aside = _aside(application, holder)
    held = aside.inside if holder is None else aside.before
    kept = (*held[:at], *(() if value is None else (_written(value),)), *held[at + 1 :])
    aside = replace(aside, inside=kept) if holder is None else replace(aside, before=kept)
    if holder is None:
        return replace(application, aside=aside)
    if holder < 0:
        assert application.always is not None
        return replace(application, always=replace(application.always, aside=aside))
    states = list(application.states)
    states[holder] = replace(states[holder], aside=aside)
    return replace(application, states=tuple(states))


def add(application: Application, value: Drawn) -> Application:
    """The application with one more, behind all others."""
    aside = application.aside
    return replace(application, aside=replace(aside, inside=(*aside.inside, _written(value))))


def kept(application: Application, no: str) -> Application:
    """The application with the notes and frames that stand before state ``no`` behind all others,
    so that they stay when the state goes."""
    at = next((i for i, state in enumerate(application.states) if state.no == no), -1)
    if at < 0 or not any(map(_read, application.states[at].aside.before)):
        return application
    aside = application.states[at].aside
    taken = tuple(one for one in aside.before if _read(one) is not None)
    rest = tuple(one for one in aside.before if _read(one) is None)
    states = list(application.states)
    states[at] = replace(states[at], aside=replace(aside, before=rest))
    own = application.aside
    own = replace(own, inside=(*own.inside, *taken))
    return replace(application, states=tuple(states), aside=own)


# -- where they stand ----------------------------------------------------------------


def _found(application: Application) -> Iterator[tuple[int | None, int, Drawn]]:
    """Before which state (its index; -1: ``always``; None: at the end), as which fragment."""
    holders: list[tuple[int | None, tuple[str, ...]]] = []
    if application.always is not None:
        holders.append((-1, application.always.aside.before))
    holders += [(i, s.aside.before) for i, s in enumerate(application.states) if s.aside.before]
    holders.append((None, application.aside.inside))
    for holder, fragments in holders:
        for at, fragment in enumerate(fragments):
            value = _read(fragment)
            if value is not None:
                yield holder, at, value


def _aside(application: Application, holder: int | None) -> Aside:
    if holder is None:
        return application.aside
    if holder < 0:
        assert application.always is not None
        return application.always.aside
    return application.states[holder].aside


@lru_cache(maxsize=1024)
def _read(fragment: str) -> Drawn | None:
    """A piece of foreign XML as what it draws; None for any other."""
    if not fragment.startswith("<") or fragment.startswith(("<!", "<?")):
        return None
    try:
        whole = ElementTree.fromstring(f'<r xmlns:ed="{EDITOR}">{fragment}</r>')
    except ElementTree.ParseError:
        return None
    element = whole[0]
    given = {name: element.get(name, "") for name in ("x", "y", "width", "height")}
    numbers = {name: n for name, text in given.items() if (n := _number(text)) is not None}
    color = element.get("color", "")
    if element.tag == f"{{{EDITOR}}}note":
        return Note(**numbers, text="".join(element.itertext()).strip(), color=color)
    if element.tag == f"{{{EDITOR}}}frame":
        return Frame(**numbers, title=element.get("title", ""), color=color)
    return None


def _number(text: str) -> float | None:
    try:
        found = float(text)
    except ValueError:
        return None
    return found if math.isfinite(found) else None


def _written(value: Drawn) -> str:
    given = {
        "title": value.title if isinstance(value, Frame) else "",
        "color": value.color,
        **{n: f"{round(getattr(value, n), 1):g}" for n in ("x", "y", "width", "height")},
    }
    name = "ed:note" if isinstance(value, Note) else "ed:frame"
    said = "".join(f' {n}="{text.translate(ATTRIBUTE)}"' for n, text in given.items() if text)
    if isinstance(value, Note):
        return f"<{name}{said}>{escape(value.text, quote=False)}</{name}>"
    return f"<{name}{said}/>"
