"""The drawing in the accessible tree: what screen readers find, hear and can do."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest

from situ.document import codec
from situ.document.problem import Problem
from situ.document.rbd import Application
from situ.resources import example
from situ_studio.canvas.projection import identified
from situ_studio.canvas.script import ScriptCanvas

NAME, DESCRIPTION = QAccessible.Text.Name, QAccessible.Text.Description
ROLE = QAccessible.Role


def tree(canvas: Any) -> Any:
    return QAccessible.queryAccessibleInterface(canvas.viewer)


def told_by(canvas: Any) -> list[tuple[Any, str]]:
    """What the drawing tells a screen reader from now on: each event with the name it is about."""
    told: list[tuple[Any, str]] = []
    tree(canvas).tell = lambda event: told.append(
        (event.type(), event.accessibleInterface().text(NAME))
    )
    return told


def below(part: Any) -> list[Any]:
    return [part.child(i) for i in range(part.childCount())]


def every(part: Any) -> Iterator[Any]:
    for inner in below(part):
        yield inner
        yield from every(inner)


def named(part: Any, name: str) -> Any:
    return next(p for p in every(part) if p.text(NAME) == name)


def test_cards_are_children_of_the_drawing(desk: Callable[..., Any], small: Application) -> None:
    made = desk(small)
    cards = below(tree(made.canvas))
    names = [c.text(NAME) for c in cards]
    assert names == ["In every state", "1 start", "2 look", "3 names", "4 no user", "5 end"]
    assert cards[1].text(DESCRIPTION) == (
        "start; Touch me to begin; touched leads to 2; human leads to 2; after 30 s leads to 1; "
        "reached from every state, 2, 3"
    )
    assert cards[3].text(DESCRIPTION).startswith("Please touch your name.; ")
    assert "again begins the same state anew; " in cards[3].text(DESCRIPTION)
    assert cards[5].text(DESCRIPTION) == "end; reached from 4"
    corner = made.canvas.viewer.viewport().mapToGlobal(
        made.hand.pixel(made.hand.card("2").scenePos())
    )
    assert (cards[2].rect().topLeft() - corner).manhattanLength() <= 2
    made.canvas.select([("state", "2")])
    assert [bool(c.state().selected) for c in cards] == [False, False, True, False, False, False]


def test_a_card_has_its_actions_and_then_its_transitions(
    desk: Callable[..., Any], small: Application
) -> None:
    made = desk(small)
    parts = below(named(tree(made.canvas), "2 look"))
    assert [(p.role(), p.text(NAME)) for p in parts] == [
        (ROLE.StaticText, "speech “One moment, I am looking for your name”"),
        (ROLE.StaticText, "service find"),
        (ROLE.StaticText, "robot head nod"),
        (ROLE.Link, "returned leads to 3 names"),
        (ROLE.Link, "returned leads to 4 no user"),
        (ROLE.Link, "offline leads to 4 no user"),
        (ROLE.Link, "after 60 s leads to 1 start"),
    ]
    assert parts[1].text(DESCRIPTION) == (
        "action on entry of state 2; then returned; offline if it fails"
    )
    assert parts[3].text(DESCRIPTION) == "transition of state 2; only if patients.0 exists"
    lost = named(tree(made.canvas), "lost leads to 17, which does not exist")
    assert lost.parent().text(NAME) == "3 names"
    assert lost.parent().indexOfChild(lost) == 4


@pytest.mark.parametrize(
    "file",
    ["reception/reception.rbd.xml", "reception/register.rbd.xml", "conversation/converse.rbd.xml"],
)
def test_every_state_transition_and_action_of_the_examples_is_found(
    desk: Callable[..., Any], file: str
) -> None:
    name, _, inner = file.partition("/")
    document, _ = codec.read((example(name) / inner).read_bytes(), inner)
    assert isinstance(document, Application)
    made = desk(document)
    made.canvas.zoom_to_fit()
    window = made.canvas.viewer.viewport()
    seen = window.rect().translated(window.mapToGlobal(window.rect().topLeft()))
    places = [place for uid, _ in identified(document) for place in _places(document, uid)]
    heard = [p for p in every(tree(made.canvas)) if p.place()[0] not in ("note", "frame")]
    found = {p.place(): p for p in heard}
    assert list(found) == places
    for place, part in found.items():
        wanted = {"action": ROLE.StaticText, "event": ROLE.Link, "timeout": ROLE.Link}
        word = next((w for w in reversed(place[1:]) if w in wanted), "")
        assert part.role() == wanted.get(word, ROLE.ListItem)
        assert part.text(NAME).strip()
        assert part.text(DESCRIPTION).strip() or word == ""
        assert seen.contains(part.rect()), f"{place}: {part.rect()}"
        assert not part.state().offscreen
        outer = part.parent()
        assert outer.child(outer.indexOfChild(part)) is part


def _places(document: Application, uid: str) -> Iterator[Any]:
    """All places of a card that are heard, in order."""
    value = dict(identified(document))[uid]
    root = ("state", uid) if uid in {s.no for s in document.states} else ("always",)
    yield root
    for index, _ in enumerate(getattr(value, "actions", ())):
        yield (*root, "action", str(index))
    for index, event in enumerate(value.events):
        yield (*root, "event", str(index))
        for inner, _ in enumerate(event.actions):
            yield (*root, "event", str(index), "action", str(inner))
    if value.timeout is not None:
        yield (*root, "timeout")


def test_what_is_out_of_sight_says_so(desk: Callable[..., Any], small: Application) -> None:
    made = desk(small)
    card = named(tree(made.canvas), "1 start")
    assert not card.state().offscreen
    made.hand.viewer._scene_range.translate(5000, 0)
    made.hand.viewer._update_scene()
    assert card.state().offscreen


def test_a_transition_can_be_focused_and_pressed(
    desk: Callable[..., Any], small: Application
) -> None:
    made = desk(small)
    link = named(tree(made.canvas), "offline leads to 4 no user")
    actions = link.actionInterface()
    assert actions.actionNames() == ["Press", "SetFocus"]
    actions.doAction("SetFocus")
    assert made.canvas.selection() == (("state", "2", "event", "2"),)
    assert link.state().selected
    begun: list[Any] = []
    made.canvas.activated.connect(begun.append)
    link.actionInterface().doAction("Press")
    assert begun == [("state", "2", "event", "2")]


def test_an_action_can_be_focused_though_only_its_card_is_drawn_selected(
    desk: Callable[..., Any], small: Application
) -> None:
    made = desk(small)
    named(tree(made.canvas), "service find").actionInterface().doAction("SetFocus")
    assert made.selections[-1] == (("state", "2", "action", "1"),)
    assert made.hand.card("2").isSelected()


def test_who_listens_hears_where_the_focus_goes(
    desk: Callable[..., Any], small: Application, listening: None
) -> None:
    made = desk(small)
    told = told_by(made.canvas)
    made.hand.viewer.setFocus()
    made.hand.click(made.hand.body("2"))
    event = QAccessible.Event
    assert told == [(event.SelectionAdd, "2 look"), (event.Focus, "2 look")]
    told.clear()
    made.hand.key(Qt.Key.Key_Right)
    assert told == [
        (event.SelectionRemove, "2 look"),
        (event.SelectionAdd, "3 names"),
        (event.Focus, "3 names"),
    ]
    focused = tree(made.canvas).focusChild()
    assert focused.text(NAME) == "3 names"
    assert focused.state().focused


def test_who_listens_hears_what_comes_goes_and_is_renamed(
    desk: Callable[..., Any], small: Application, listening: None
) -> None:
    made = desk(small)
    list(every(tree(made.canvas)))
    made.canvas.select([("state", "5")])
    told = told_by(made.canvas)
    event = QAccessible.Event
    made.canvas.rename()
    made.hand.key(Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClicks(made.canvas._editor, "bye")
    QTest.keyClick(made.canvas._editor, Qt.Key.Key_Return)
    assert (event.NameChanged, "5 bye") in told
    told.clear()
    made.canvas.add_state()
    assert (event.ObjectCreated, "state 6") in told
    told.clear()
    made.canvas.delete_selection()
    assert next(kind for kind, _ in told) == event.ObjectDestroyed


def test_a_card_that_is_gone_is_forgotten(desk: Callable[..., Any], small: Application) -> None:
    made = desk(small)
    drawing = tree(made.canvas)
    list(every(drawing))
    assert ("5",) in drawing._parts
    made.canvas.select([("state", "5")])
    made.canvas.delete_selection()
    assert ("5",) not in drawing._parts
    assert drawing.childCount() == 5
    assert drawing.child(5) is None


def test_what_lies_under_a_point_is_found(desk: Callable[..., Any], small: Application) -> None:
    made = desk(small)
    drawing = tree(made.canvas)
    viewport = made.hand.port
    at = viewport.mapToGlobal(made.hand.pixel(made.hand.exit("2", "2")))
    assert drawing.childAt(at.x() - 10, at.y()).text(NAME) == "offline leads to 4 no user"
    at = viewport.mapToGlobal(made.hand.pixel(made.hand.header("2")))
    assert drawing.childAt(at.x(), at.y()).text(NAME) == "2 look"


def test_script_nodes_too(desk: Callable[..., Any]) -> None:
    from situ.document.spds import Situation, Spds

    made = desk(Spds(name="s", situations=(Situation("talk"),)), ScriptCanvas)
    card = tree(made.canvas).child(0)
    assert card.text(NAME) == "talk"
    assert card.text(DESCRIPTION) == "situation; number 1; always"


def test_a_script_is_heard_with_what_its_pipes_join(desk: Callable[..., Any]) -> None:
    document, _ = codec.read(
        (example("conversation") / "conversation.spds.xml").read_bytes(), "conversation.spds.xml"
    )
    cards = below(tree(desk(document, ScriptCanvas).canvas))
    told = {card.text(NAME): card.text(DESCRIPTION) for card in cards}
    assert told["person.calling"] == "data; yes or no; looked at in invited, called"
    assert told["Condition of invited"] == (
        "condition; all of these; person.calling is true, within 5 s; "
        "hand.waving is true, within 2 s"
    )
    assert told["sound"].startswith(
        "situation; number 4; extends conversation; stays 1.5 s at least; "
    )
    assert told["sound"].endswith(
        "; while sound.slap exists, within 1 s; priority 60 for gaze-sound"
    )
    assert told["nod"] == "module; in accepted"
    assert told["speech"] == "resource; used by converse"


def test_what_is_wrong_is_heard_where_it_is(desk: Callable[..., Any], small: Application) -> None:
    made = desk(small)
    place = ("state", "4")
    wrong = [
        Problem(file="f", code="a", message="Dull.", severity="warning", place=place),
        Problem(file="f", code="b", message="No.", place=(*place, "event", "0")),
    ]
    made.canvas.show_document(small, wrong)
    card = named(tree(made.canvas), "4 no user")
    assert card.text(DESCRIPTION).startswith(
        "has an error; Dull.; tryAgain leads to 2, with an error"
    )
    assert below(card)[0].text(DESCRIPTION) == "transition of state 4; No."


def test_who_comes_back_to_the_drawing_hears_what_is_selected(
    desk: Callable[..., Any], small: Application, listening: None
) -> None:
    made = desk(small)
    told = told_by(made.canvas)
    made.hand.viewer.clearFocus()
    made.canvas.select([("state", "5")])
    assert told == [(QAccessible.Event.SelectionAdd, "5 end")]
    made.hand.viewer.setFocus()
    made.hand.settle()
    assert told[1:] == [(QAccessible.Event.Focus, "5 end")]


def test_what_a_part_can_not_do_is_said_and_nothing_breaks(
    desk: Callable[..., Any], small: Application
) -> None:
    made = desk(small)
    # The bridge to a screen reader asks every part for each of these.
    for part in every(tree(made.canvas)):
        assert part.textInterface() is None
        assert part.valueInterface() is None
        assert part.tableCellInterface() is None
        assert part.actionInterface() is not None
