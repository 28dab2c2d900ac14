"""formats.md, *always* (parts left out)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tests.decide.conftest import Play

END: dict[str, Any] = {"at": 100, "end": True}
AT = 'x="1" y="1" width="9" height="9"'
HOME = f'<button id="home" {AT} event="clickHome">Home</button>'
ALWAYS = f"""<always><timeout next="3">9</timeout>
  <screen background="shared.png"><components>{HOME}</components></screen>
  <expectedevents><event name="clickHome" next="3"/></expectedevents></always>"""


def state(no: str, inside: str = "", always: bool = True) -> str:
    return f'<state no="{no}" always="{str(always).lower()}">{inside}</state>'


def text(name: str) -> str:
    return f'<screen><components><text id="{name}" {AT}>{name}</text></components></screen>'


def test_its_components_lie_above_the_states(play: Play) -> None:
    trace = play(ALWAYS + state("1", text("a")) + state("3"), [])
    assert trace.lines("screen") == ["0 screen app 1 [a=a home=Home] <enter"]


def test_a_state_without_screen_shows_those_of_always(play: Play) -> None:
    trace = play(ALWAYS + state("1") + state("3"), [])
    assert trace.lines("acquire", "screen") == [
        "0 acquire app [screen] <enter",
        "0 screen app 1 [home=Home] <enter",
    ]


def test_the_states_background_goes_before_that_of_always(play: Play) -> None:
    own = text("a").replace("<screen>", '<screen background="own.png">')
    assert play(ALWAYS + state("1", own) + state("3"), []).one("screen")["background"] == "own.png"
    shared = play(ALWAYS + state("1", text("a")) + state("3"), []).one("screen")
    assert shared["background"] == "shared.png"


def test_its_components_can_be_used_in_every_state(play: Play) -> None:
    trace = play(ALWAYS + state("1") + state("3"), [{"at": 1, "use": {"component": "home"}}])
    assert trace.states() == [(0, "1"), (1, "3")]


def test_its_timeout_serves_where_the_state_has_none(play: Play) -> None:
    assert play(ALWAYS + state("1") + state("3"), [{"at": 10, "end": True}]).states() == [
        (0, "1"), (9, "3"),
    ]  # fmt: skip
    own = state("1", '<timeout next="2">2</timeout>') + state("2") + state("3")
    assert play(ALWAYS + own, [{"at": 12, "end": True}]).states() == [
        (0, "1"), (2, "2"), (11, "3"),
    ]  # fmt: skip


def test_a_state_may_leave_it_out(play: Play) -> None:
    rbd = ALWAYS + state("1", always=False) + state("3")
    trace = play(rbd, [{"at": 1, "event": "clickHome"}, END])
    assert trace.lines() == [
        "0 enter app 1 <-",
        "1 event app clickHome <-",
        "1 ignored app clickHome unexpected <event",
    ]


def test_what_always_shows_goes_when_a_state_leaves_it_out(play: Play) -> None:
    go = '<expectedevents><event name="go" next="2"/></expectedevents>'
    rbd = ALWAYS + state("1", text("a") + go) + state("2", go.replace("2", "3"), False)
    trace = play(rbd + state("3"), [{"at": 1, "event": "go"}, {"at": 2, "event": "go"}])
    assert trace.lines("screen", "acquire", "abandon") == [
        "0 acquire app [screen] <enter",
        "0 screen app 1 [a=a home=Home] <enter",
        "1 screen app 2 [a=a] <enter",
        "2 screen app 3 [a=a home=Home] <enter",
    ]


def test_without_a_screen_of_its_own_the_state_that_leaves_it_out_gives_the_screen_back(
    play: Play,
) -> None:
    go = '<expectedevents><event name="go" next="2"/></expectedevents>'
    rbd = ALWAYS + state("1", go) + state("2", always=False) + state("3")
    trace = play(rbd, [{"at": 1, "event": "go"}])
    assert trace.lines("abandon", "authority", "mapping", since=1) == [
        "1 abandon app [screen] <enter",
        "1 authority screen app - <abandon",
        "1 mapping screen - null <authority",
    ]
