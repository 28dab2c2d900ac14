"""Automatic layout, and walking from card to card: pure functions."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document.aside import NOTHING
from situ.document.rbd import Always, Application, Event, State, Timeout
from situ_studio.canvas import layout, walk
from situ_studio.canvas.projection import Projector


@st.composite
def applications(draw: st.DrawFn) -> Application:
    """Any graph: circles, islands, targets that are not there, doubled numbers."""
    numbers = [str(n) for n in range(1, draw(st.integers(1, 25)))] + draw(
        st.lists(st.sampled_from(["1", "2"]), max_size=1)
    )
    target = st.sampled_from([*numbers, "99", "#back", "#again"]) if numbers else st.just("99")
    states = tuple(
        State(
            no=no,
            events=tuple(
                Event(name=f"e{i}", next=n)
                for i, n in enumerate(draw(st.lists(target, max_size=4)))
            ),
            timeout=Timeout(seconds=1, next=draw(target)) if draw(st.booleans()) else None,
        )
        for no in numbers
    )
    always = Always(events=(Event(name="home", next="1"),)) if draw(st.booleans()) else None
    return Application(name="any", states=states, always=always)


@settings(max_examples=100, deadline=None)
@given(applications())
def test_no_two_cards_lie_on_each_other(application: Application) -> None:
    places = layout.arrange(application)
    cards = Projector().picture(application, (), places).cards
    assert set(places) == set(cards)
    boxes = list(cards.values())
    for index, one in enumerate(boxes):
        for other in boxes[index + 1 :]:
            assert (
                one.x + one.width <= other.x
                or other.x + other.width <= one.x
                or one.y + one.height <= other.y
                or other.y + other.height <= one.y
            )


def chain(count: int) -> Application:
    return Application(
        name="chain",
        states=tuple(
            State(no=str(i), events=(Event(name="on", next=str(i + 1)),)) for i in range(count)
        ),
    )


def test_the_way_runs_to_the_right_and_wraps() -> None:
    places = layout.arrange(chain(8))
    assert [places[str(i)][0] for i in range(6)] == [24 + 230 * i for i in range(6)]
    assert len({places[str(i)][1] for i in range(6)}) == 1
    assert places["6"] == (24.0, places["0"][1] + 228)


def test_only_what_has_no_place_gets_one() -> None:
    application = chain(4)
    placed = replace(application.states[0], aside=NOTHING.at(500, 300))
    mixed = replace(application, states=(placed, *application.states[1:]), always=Always())
    found = layout.missing(mixed, {"1": (500.0, 600.0)})
    assert set(found) == {"always ", "2", "3"}
    assert found["always "] == (500.0, 300.0 - 116 - 48)
    assert all(y > 716 for uid, (_, y) in found.items() if uid != "always ")
    assert layout.missing(mixed, {**found, "1": (500.0, 600.0)}) == {}


def test_walking_by_direction() -> None:
    spots = {"a": (0.0, 0.0), "b": (230.0, 0.0), "c": (460.0, 10.0), "d": (20.0, 228.0)}
    assert walk.beside(spots, "a", 1, 0) == "b"
    assert walk.beside(spots, "c", -1, 0) == "b"
    assert walk.beside(spots, "a", 0, 1) == "d"
    assert walk.beside(spots, "a", 0, -1) is None


def test_walking_in_order_and_by_letter() -> None:
    order = ["1", "2", "3"]
    assert walk.onwards(order, "3", 1) == "1"
    assert walk.onwards(order, None, 1) == "1"
    assert walk.onwards(order, None, -1) == "3"
    assert walk.onwards([], None, 1) is None
    names = {"1": ("start", "1"), "2": ("Stop", "2"), "3": ("end", "3")}
    assert walk.beginning(names, "1", "s") == "2"
    assert walk.beginning(names, "2", "s") == "1"
    assert walk.beginning(names, None, "3") == "3"
    assert walk.beginning(names, "1", "x") is None
