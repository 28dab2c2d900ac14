"""Places of problems followed into documents."""

from __future__ import annotations

import pytest

from situ.document import codec
from situ.document.place import follow
from situ.document.rbd import Application, Event, Screen, State, Text

TEXT = Text(id="t", x=0, y=0, width=1, height=1)
DOCUMENT = Application(
    "a", states=(State("1"), State("2", screen=Screen(components=(TEXT,)), events=(Event("e"),)))
)


def test_a_place_is_followed_to_its_value() -> None:
    assert follow(DOCUMENT, ()) == ((), [DOCUMENT])
    found = follow(DOCUMENT, ("state", "2", "screen", "t"))
    assert found is not None
    assert found[0] == ("states", 1, "screen", "components", 0)
    assert found[1][-1] is TEXT


@pytest.mark.parametrize(
    "place",
    [
        ("state", "3"),
        ("state", "1", "screen"),
        ("state", "2", "screen", "u"),
        ("state", "2", "event", "1"),
        ("state", "2", "event", "x"),
        ("nothing",),
    ],
)
def test_a_place_that_leads_nowhere_is_none(place: tuple[str, ...]) -> None:
    assert follow(DOCUMENT, place) is None


def test_nothing_is_found_behind_a_doctype() -> None:
    assert codec.locate(b"<!DOCTYPE a><a/>", 0) == (0, 0)
    assert codec.locate(b"<a>\n <b/></a>", 1) == (2, 2)
    assert codec.locate(b"<a>", 1) == (0, 0)
