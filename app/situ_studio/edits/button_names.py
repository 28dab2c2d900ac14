"""A new button is called after its words: ``START`` sends ``clickStart``, not ``clickButton1``.

Nobody who draws has to think of names: what the button is called is what stands at its port, on its
pipe and in the trace. A name that a person gave, or for which something waits, is left.
"""

from __future__ import annotations

import re

from msgspec.structs import replace

from situ.document import rbd
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.kinds.screen import event_of

WORDS = 3
"""Of a longer text the first ones."""
_UNNAMED = re.compile(r"button[0-9]+")


def with_words(
    application: rbd.Application, place: Place, words: str
) -> tuple[rbd.Application, Place]:
    """The application with other words on the button at ``place``, and the button's place then.

    Its id and its event follow while they are those that it began with and no event of that name
    is expected where it is shown, unless the new ones are taken there.
    """
    button = places.get(application, place)
    named = replace(button, text=words)
    root = places.root(place)
    id = _id_of(words)
    new = event_of(id)
    if id and _UNNAMED.fullmatch(button.id) and button.event == event_of(button.id):
        seen = _seen_with(application, root)
        components = [c for part in seen for c in _components(part)]
        expected = {e.name for part in seen for e in part.events}
        others = [c for c in components if c is not button]
        taken = {c.id for c in others} | {getattr(c, "event", None) for c in others}
        if button.event not in expected and not {id, new} & taken:
            named = replace(named, id=id, event=new)
    return places.put(application, place, named), (*place[:-1], named.id)


def written(
    application: rbd.Application, part: Place, screen: rbd.Screen
) -> tuple[rbd.Application, dict[str, str]]:
    """The application with another screen there, and what buttons that got words were called.

    The second: from the id that a button had to the one that it has.
    """
    shown = places.get(application, part)
    before = {c.id: c for c in _components(shown)}
    called: dict[str, str] = {}
    after = places.change(application, part, screen=screen)
    for one in screen.components:
        old = before.get(one.id)
        if not isinstance(one, rbd.Button) or not isinstance(old, rbd.Button):
            continue
        if old.text != one.text and replace(old, text=one.text) == one:
            after, place = with_words(after, (*part, "screen", one.id), one.text)
            called[one.id] = place[-1]
    return after, called


def _id_of(words: str) -> str:
    """``Call the nurse`` is ``callTheNurse``; "" where nothing in it can be a name."""
    if "{" in words:
        return ""
    found = re.findall(r"[^\W_]+", re.sub("['’]", "", words))[:WORDS]
    parts = [one if one[1:].islower() else one.lower() for one in found]
    joined = "".join(one[:1].upper() + one[1:] for one in parts)
    return joined[:1].lower() + joined[1:] if joined[:1].isalpha() else ""


def _seen_with(application: rbd.Application, root: Place) -> list[rbd.State | rbd.Always]:
    """What is shown, and waits, together with the part there."""
    always = application.always
    beside = [always] if always is not None else []
    if root == ("always",):
        return [*beside, *application.states]
    return [places.get(application, root), *beside]


def _components(part: rbd.State | rbd.Always) -> tuple[rbd.Component, ...]:
    return part.screen.components if part.screen is not None else ()
