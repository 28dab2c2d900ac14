"""Copies of components: their ids, their places, and their way over the clipboard."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from situ.document import rbd
from situ.document.folder import load
from situ.resources import example
from situ_studio.screens import copies, placing


def text(id: str, x: float = 10, y: float = 10) -> rbd.Text:
    return rbd.Text(id=id, x=x, y=y, width=30, height=10, text=id)


def test_a_copy_gets_the_next_free_id_and_lies_beside_the_original() -> None:
    screen = rbd.Screen(components=(text("yes"), text("yes2", 60)))
    made, ids = copies.pasted(screen, [text("yes")])
    assert ids == ("yes3",)
    assert made.components[:2] == screen.components
    assert placing.box_of(made.components[2])[:2] == (13, 13)


def test_on_another_screen_it_keeps_id_and_place() -> None:
    made, ids = copies.pasted(None, [text("yes", 42, 7)])
    assert ids == ("yes",)
    assert made.components == (text("yes", 42, 7),)


def test_copies_of_copies_lie_each_beside_the_one_before() -> None:
    screen = rbd.Screen(components=(text("a"),))
    for _ in range(12):
        screen, _ = copies.pasted(screen, [text("a")])
    assert len({placing.box_of(c) for c in screen.components}) == 13


def test_what_is_no_component_is_nothing() -> None:
    assert copies.read(b"") == ()
    assert copies.read(b"hello") == ()
    assert copies.read(b'<application name="a"><state no="1"/></application>') == ()


@settings(max_examples=30, deadline=None)
@given(st.data())
def test_any_components_of_an_example_are_the_same_after_the_clipboard_and_free_of_doubles(
    data: st.DataObject,
) -> None:
    project, _ = load(example("reception"))
    assert project is not None
    states = [s for a in project.applications.values() for s in a.states if s.screen is not None]
    one, other = data.draw(st.sampled_from(states)), data.draw(st.sampled_from(states))
    assert one.screen is not None
    chosen = one.screen.components
    read = copies.read(copies.written(chosen))
    assert read == chosen
    made, ids = copies.pasted(other.screen, read)
    every = [c.id for c in made.components]
    assert len(every) == len(set(every))
    assert every[len(every) - len(ids) :] == list(ids)
    again, _ = copies.pasted(made, read)
    assert len({c.id for c in again.components}) == len(again.components)
