"""Pure gestures on an application: document in, document and words out."""

from __future__ import annotations

from msgspec.structs import replace

from situ.document.rbd import Application, Event, State, Timeout
from situ_studio.canvas import gestures
from situ_studio.canvas.gestures import Area


def test_a_move_writes_places_and_nothing_else(small: Application) -> None:
    after, text = gestures.move(small, {("state", "2"): (300, 8), ("always",): (0, -210)})
    assert text == "Move 2 cards"
    assert after == small  # places do not count in a comparison of documents
    assert after.states[1].aside.position == (300.0, 8.0)
    assert after.always is not None
    assert after.always.aside.position == (0.0, -210.0)
    assert after.states[0] is small.states[0]


def test_a_move_to_where_it_is_is_no_edit(small: Application) -> None:
    assert gestures.move(small, {("state", "2"): (230, 0)}) == (small, "")


def test_connect_leads_an_exit_elsewhere(small: Application) -> None:
    after, text = gestures.connect(small, ("state", "1", "event", "0"), "3")
    assert after.states[0].events[0].next == "3"
    assert text == "Lead touched of state 1 to 3 names"
    assert after.states[1:] == small.states[1:]
    after, text = gestures.connect(small, ("state", "1", "timeout"), "2")
    assert after.states[0].timeout == Timeout(seconds=30, next="2")
    assert text == "Lead the timeout of state 1 to 2 look"


def test_connect_to_where_it_leads_is_no_edit(small: Application) -> None:
    assert gestures.connect(small, ("state", "1", "event", "0"), "2") == (small, "")


def test_disconnect_makes_an_event_internal_and_takes_an_unnamed_one_away(
    small: Application,
) -> None:
    after, _ = gestures.disconnect(small, ("state", "1", "event", "0"))
    assert after.states[0].events[0] == Event(name="touched")
    after, _ = gestures.disconnect(small, ("state", "4", "event", "1"))
    assert after.states[3].events == small.states[3].events[:1]


def test_a_new_event_takes_the_name_of_what_nobody_expects_yet(small: Application) -> None:
    after, text = gestures.lead(small, ("state", "1"), "new", "3")
    assert after.states[0].events[-1] == Event(name="go", next="3")
    assert text == "Add go of state 1 to 3 names"
    again, _ = gestures.lead(after, ("state", "1"), "new", "3")
    assert again.states[0].events[-1].name == "event4"


def test_follow_adds_a_state_of_the_kind_at_the_place(small: Application) -> None:
    after, text, no = gestures.follow(small, ("state", "3"), "0", "question", 703, 311)
    assert no == "6"
    assert text == "Add state 6 after state 3"
    assert after.states[2].events[0].next == "6"
    new = after.states[-1]
    assert [e.name for e in new.events] == ["clickYes", "clickNo"]
    assert new.aside.position == (704, 312)


def test_follow_to_a_state_back_again_or_nowhere(small: Application) -> None:
    exit = ("state", "3"), "0"
    assert gestures.follow(small, *exit, "5", 0, 0)[0].states[2].events[0].next == "5"
    assert gestures.follow(small, *exit, "#back", 0, 0)[0].states[2].events[0].next == "#back"
    assert gestures.follow(small, *exit, "", 0, 0)[0].states[2].events[0].next is None
    assert gestures.follow(small, *exit, "", 0, 0)[2] is None


def test_a_state_that_is_called_like_a_kind_is_meant_itself() -> None:
    document = Application(name="a", states=(State(no="end", events=(Event(name="x"),)),))
    after, _, new = gestures.follow(document, ("state", "end"), "0", "end", 0, 0)
    assert new is None
    assert after.states[0].events[0].next == "end"


def test_insert_puts_a_state_into_a_pipe(small: Application) -> None:
    after, text = gestures.insert(small, ("state", "3", "event", "1"), 400, 200)
    assert text == "Insert state 6"
    assert after.states[2].events[1].next == "6"
    assert after.states[-1].events[0].next == "1"


def test_delete_takes_states_with_what_led_to_them(small: Application) -> None:
    after, text = gestures.delete(small, [("state", "4")])
    assert text == "Delete state 4"
    assert [s.no for s in after.states] == ["1", "2", "3", "5"]
    assert [e.next for e in after.states[1].events] == ["3"]
    assert [e.next for e in after.states[2].events] == ["1", "#again", "17"]


def test_delete_takes_events_by_position_whatever_the_order(small: Application) -> None:
    gone = [("state", "3", "event", "0"), ("state", "3", "event", "2"), ("state", "1", "timeout")]
    for order in (gone, gone[::-1]):
        after, text = gestures.delete(small, order)
        assert text == "Delete 3 things"
        assert [e.name for e in after.states[2].events] == ["clickBack", "lost"]
        assert after.states[0].timeout is None


def test_delete_of_the_start_leaves_a_start(small: Application) -> None:
    after, _ = gestures.delete(small, [("state", "1")])
    assert after.start is None
    assert after.start_no == "2"


def test_rename_tidies_blanks_and_refuses_nothing(small: Application) -> None:
    assert gestures.rename(small, "2", "  search   names ")[0].states[1].name == "search names"
    assert gestures.rename(small, "2", "  ") == (small, "")
    assert gestures.rename(small, "2", "look") == (small, "")


def test_align_and_distribute(small: Application) -> None:
    areas: dict[tuple[str, ...], Area] = {
        ("state", "1"): Area(0, 0, 176, 116),
        ("state", "2"): Area(240, 16, 176, 134),
        ("state", "3"): Area(640, 8, 176, 134),
    }
    after, text = gestures.align(small, areas, "bottom")
    assert text == "Align 3 cards"
    assert [s.aside.position for s in after.states[:3]] == [(0, 34), (240, 16), (640, 16)]
    after, _ = gestures.align(small, areas, "left")
    assert [s.aside.position for s in after.states[:3]] == [(0, 0), (0, 16), (0, 8)]
    after, text = gestures.align(small, areas, "across")
    assert text == "Distribute 3 cards"
    assert after.states[1].aside.position == (320.0, 16.0)
    assert gestures.align(small, dict(list(areas.items())[:1]), "left") == (small, "")


def test_what_every_state_has_is_called_so(small: Application) -> None:
    after, text = gestures.delete(small, [("always",)])
    assert text == "Delete what every state has"
    assert replace(after, always=small.always) == small
    assert gestures.connect(small, ("always", "event", "0"), "2")[1] == (
        "Lead home of every state to 2 look"
    )
