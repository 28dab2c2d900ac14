"""Which texts of a project people read, hear and say: those that ``texts/LANG.po`` translates.

The same that the robot looks up there (``situ.decide.texts``): what a screen shows, speeches,
and the phrases of events; and what the pages beside the screen show of the settings.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from msgspec import Struct

from situ.document import names, words
from situ.document.aside import Aside
from situ.document.finding import Place
from situ.document.project import Setting
from situ.document.rbd import Application, Button, Event, List, Screen, Speech, Text

_SPOKEN = re.compile(r"[^\W\d_]")


class ShownText(Struct, frozen=True):
    """A text as written, and where.

    where: the place in designers' words: ``state 3 garden: button yes``.
    lang: the language that a speech asks for, whatever the tag ``language`` says.
    """

    text: str
    where: str
    aside: Aside
    place: Place
    lang: str | None = None

    @property
    def is_to_translate(self) -> bool:
        """Whether there is a word in it, and no language asked for."""
        return self.lang is None and has_words(self.text)


def has_words(text: str) -> bool:
    """Whether there is a letter outside its references; else all languages write it alike."""
    return any(_SPOKEN.search(literal) for literal, _ in names.split(text))


def shown_texts(application: Application) -> Iterator[ShownText]:
    """Those of ``always``, then those of one state after the other: screen, speeches, phrases."""
    if (always := application.always) is not None:
        yield from _screen(always.screen, "always", ("always",))
        yield from _phrases(always.events, "always", ("always",))
    for state in application.states:
        where, place = " ".join(f"state {words.state(state)}".split()), ("state", state.no)
        yield from _screen(state.screen, where, place)
        for index, action in enumerate(state.actions):
            if isinstance(action, Speech):
                at = (*place, "action", str(index))
                yield ShownText(action.text, f"{where}: speech", action.aside, at, action.lang)
        yield from _phrases(state.events, where, place)


class SettingText(Struct, frozen=True):
    """A text of a setting as written, and where; place: from its position among the settings."""

    text: str
    where: str
    place: Place


def setting_texts(settings: Iterable[Setting]) -> Iterator[SettingText]:
    """The labels and choices of settings that have a word in them."""
    for number, one in enumerate(settings):
        place = ("setting", str(number))
        if has_words(one.label):
            yield SettingText(one.label, f"setting {one.tag}", (*place, "label"))
        for at, choice in enumerate(one.choices):
            if has_words(choice):
                where = f"setting {one.tag}: choice"
                yield SettingText(choice, where, (*place, "choices", str(at)))


def _screen(screen: Screen | None, where: str, place: Place) -> Iterator[ShownText]:
    for component in screen.components if screen is not None else ():
        if isinstance(component, (Text, Button, List)):
            written = component.label if isinstance(component, List) else component.text
            named = f"{where}: {component.element} {component.id}"
            yield ShownText(written, named, component.aside, (*place, "screen", component.id))


def _phrases(events: tuple[Event, ...], where: str, place: Place) -> Iterator[ShownText]:
    for at, event in enumerate(events):
        named = f"{where}: phrase of {event.name}"
        for index, say in enumerate(event.says):
            yield ShownText(
                say.text, named, say.aside, (*place, "event", str(at), "say", str(index))
            )
