"""Rules of formats.md in each other's way: several things happen at one moment.

Every expected line was worked out by hand.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tests.decide.in_short import (
    AT,
    END,
    GO,
    GO_ON,
    NOD,
    STOP,
    state,
    text,
)

if TYPE_CHECKING:
    from tests.decide.conftest import Play


# -- situations ---------------------------------------------------------------


def held(name: str, tag: str, **more: str) -> str:
    attributes = "".join(f' {k}="{v}"' for k, v in more.items() if k != "until")
    until = f'<until><data tag="{more["until"]}" is="true"/></until>' if "until" in more else ""
    return (
        f'<situation name="{name}"{attributes}><condition><data tag="{tag}" is="true"/></condition>'
        f"{until}</situation>"
    )


def test_dwell_until_and_limit_in_precedence(play: Play) -> None:
    spds = (
        held("dwells", "d", dwell="4")
        + held("until", "u", until="end", limit="10")
        + held("limited", "l", limit="6")
        + '<situation name="rest"/>'
    )
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"l": True}},  # limited, till 7
        {"at": 2, "set": {"u": True}},  # until, till 12
        {"at": 3, "set": {"d": True, "u": False}},  # dwells, till 7
        {"at": 4, "set": {"d": False}},
        # 7: dwells ends; until still holds; limited has ended at 7 too, and is spent.
        {"at": 9, "set": {"end": True}},  # until ends; limited is spent: rest
        {"at": 10, "set": {"l": False}},
        {"at": 11, "set": {"l": True}},  # limited, till 17
        {"at": 12, "set": {"end": False}},
        {"at": 13, "set": {"u": True}},  # until, till 23; u stays true
        END,
    ]
    trace = play((), lines, spds=spds)
    assert trace.situations() == [
        (0, "rest"), (1, "limited"), (2, "until"), (3, "dwells"), (7, "until"), (9, "rest"),
        (11, "limited"), (13, "until"), (23, "rest"),
    ]  # fmt: skip
    assert trace.lines("situation", since=7)[0] == "7 situation dwells until <situation"


def test_a_limit_and_an_until_of_one_moment(play: Play) -> None:
    """The limit falls due first, so the situation is spent; until changes nothing more."""
    spds = held("a", "x", until="end", limit="5") + '<situation name="rest"/>'
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"x": True}},
        {"at": 6, "set": {"end": True, "x": False}},
        {"at": 7, "set": {"x": True}},
        {"at": 8, "set": {"end": False}},
        END,
    ]
    trace = play((), lines, spds=spds)
    assert trace.situations() == [(0, "rest"), (1, "a"), (6, "rest"), (8, "a"), (13, "rest")]


def test_until_and_condition_in_one_write(play: Play) -> None:
    """It does not begin, and as it was never ended nothing needs to be false first."""
    spds = held("a", "x", until="end") + '<situation name="rest"/>'
    lines: list[dict[str, Any]] = [
        {"at": 1, "set": {"x": True, "end": True}},
        {"at": 2, "set": {"end": False}},
        {"at": 3, "set": {"x": False}},
        {"at": 4, "set": {"x": True, "end": True}},
        {"at": 5, "set": {"end": False}},
        {"at": 6, "set": {"x": False}},
        {"at": 7, "set": {"x": True}},
        END,
    ]
    # At 4 it is current and ends; x was never false since: it begins again at 7.
    assert play((), lines, spds=spds).situations() == [
        (0, "rest"), (2, "a"), (4, "rest"), (7, "a"),
    ]  # fmt: skip


def test_a_situation_that_ends_itself_by_what_it_lets_happen(play: Play) -> None:
    """The application is resumed in the situation, and its unnamed event ends that."""
    rbd = state(
        "1", NOD, '<event next="2"><when><data tag="go" is="true"/></when>'
        '<set tag="go">false</set></event>',
    ) + state("2")  # fmt: skip
    situation = (
        '<situation name="going"><condition><data tag="go" is="true"/></condition>'
        '<module name="app" priority="1"/></situation>'
    )
    spds = (
        '<modules><module name="app" resources="head"/></modules>'
        f'{situation}<situation name="rest"/>'
    )
    trace = play(rbd, [{"at": 1, "set": {"go": True}}], spds=spds)
    assert trace.lines(since=1) == [
        "1 data go true scenario v1 <-",
        "1 condition going true <data",
        "1 situation rest going <condition",
        "1 authority head - app <situation",
        "1 resume app [] <authority",
        "1 event app resumed <resume",
        '1 action app 1 robot nod resource="head" <resume',
        '1 mapping head app {"command":"nod","params":{}} <action',
        "1 exit app 1 <resume",
        "1 cancelled app robot nod <exit",
        "1 mapping head app null <cancelled",
        "1 transition app 1 2 - <resume",
        '1 action app 2 set - tag="go" value=false <transition',
        "1 data go false app v2 <action",
        "1 finished app set - ok null <action",
        "1 enter app 2 <transition",
        "1 abandon app [head] <enter",
        "1 authority head app - <abandon",
        "1 condition going false <data",
        "1 situation going rest <condition",
    ]


def test_data_of_a_press_may_suspend_the_application_before_the_press_is_judged(
    play: Play,
) -> None:
    button = f'<button id="b" {AT} event="pressed" tag="busy" value="true">B</button>'
    rbd = state("1", "", '<event name="pressed" next="2"/>',
                f"<screen><components>{button}</components></screen>") + state("2")  # fmt: skip
    trace = play(rbd, [{"at": 1, "use": {"component": "b"}}], pauses="screen")
    assert trace.lines(since=1) == [
        "1 data busy true screen v1 <-",
        "1 condition busy true <data",
        "1 situation calm busy <condition",
        "1 authority screen app - <situation",
        "1 mapping screen - null <authority",
        "1 suspend app [screen] <authority",
        "1 event app pressed <-",
        "1 ignored app pressed suspended <event",
    ]


# -- the stack of #back -------------------------------------------------------


def test_back_after_unnamed_events_and_timeouts(play: Play) -> None:
    rbd = (
        state("1", "", GO)
        + state("2", "", "", '<timeout next="3">1</timeout>')
        + state("3", "", '<event next="4"><when><data tag="x" is="1"/></when></event>')
        + state(
            "4", "", '<event name="back" next="#back"><set tag="x">0</set><set tag="in">{x}</set>'
            "</event>",
        )
    )  # fmt: skip
    lines: list[dict[str, Any]] = [
        {"at": 1, "event": "go"},
        {"at": 3, "set": {"x": 1}},
        {"at": 4, "event": "back"},
    ]
    trace = play(rbd, lines)
    assert trace.states() == [(0, "1"), (1, "2"), (2, "3"), (3, "4"), (4, "3")]
    # Its actions belong to the state that it goes to.
    assert [e["state"] for e in trace.of("action")] == ["3", "3"]


def test_back_by_resumed(play: Play) -> None:
    rbd = state("1", "", GO) + state("2", NOD, '<event name="resumed" next="#back"/>')
    lines = [{"at": 1, "event": "go"}, {"at": 2, **STOP}, {"at": 3, **GO_ON}]
    trace = play(rbd, lines, pauses="head")
    assert trace.states() == [(0, "1"), (1, "2"), (3, "1")]


def test_a_refused_back_of_the_state_gives_way_to_always(play: Play) -> None:
    rbd = (
        '<always><expectedevents><event name="back" next="1"/></expectedevents></always>'
        + state("1", "", GO)
        + state("2", "", '<event name="back" next="#back"/>')
    )
    lines = [{"at": 1, "event": "back"}, {"at": 2, "event": "go"}, {"at": 3, "event": "back"}]
    assert play(rbd, lines).states() == [(0, "1"), (1, "1"), (2, "2"), (3, "1")]


# -- live screens -------------------------------------------------------------


def test_a_screen_shown_in_the_step_is_shown_once_more_only_for_what_came_after(
    play: Play,
) -> None:
    rbd = state("1", "", '<event name="go" next="2"><set tag="x">1</set></event>', text("a", "{x}"))
    rbd += state("2", '<set tag="y">1</set>', "", text("b", "{x} {y}"))
    trace = play(rbd, [{"at": 1, "event": "go"}], tags={"x": 0, "y": 0})
    assert trace.lines("screen", since=1) == [
        "1 screen app 2 [b=1 0] <enter",
        "1 screen app 2 [b=1 1] <data",
    ]


def test_a_text_that_changes_and_changes_back_in_one_step_is_not_shown(play: Play) -> None:
    rbd = state("1", "", '<event name="go"><set tag="x">1</set><set tag="x">0</set></event>',
                text("a", "{x}"))  # fmt: skip
    assert play(rbd, [{"at": 1, "event": "go"}], tags={"x": 0}).lines("screen", since=1) == []


def test_a_screen_lost_in_the_step_is_not_shown_live(play: Play) -> None:
    rbd = state("1", "", "", text("a", "{busy}"))
    lines = [{"at": 1, **STOP}, {"at": 2, **GO_ON}]
    trace = play(rbd, lines, pauses="screen")
    assert trace.lines("screen", since=1) == ["2 screen app 1 [a=false] <resume"]


# -- conditions of guards -----------------------------------------------------


def test_a_guards_within_at_its_very_end(play: Play) -> None:
    when = '<when><data tag="x" is="1" within="3"/></when>'
    rbd = state("1", "", f'<event name="go" next="2">{when}</event>') + state("2")
    for at, taken in ((3.999999, True), (4, False)):
        trace = play(rbd, [{"at": 1, "set": {"x": 1}}, {"at": at, "event": "go"}])
        assert (trace.states()[-1][1] == "2") is taken


def test_a_guards_for_at_its_very_beginning(play: Play) -> None:
    when = '<when><data tag="x" is="1" for="3"/></when>'
    rbd = state("1", "", f'<event name="go" next="2">{when}</event>') + state("2")
    for at, taken in ((3.999999, False), (4, True)):
        trace = play(rbd, [{"at": 1, "set": {"x": 1}}, {"at": at, "event": "go"}])
        assert (trace.states()[-1][1] == "2") is taken


def test_an_unnamed_event_whose_within_ends_is_taken_then(play: Play) -> None:
    rbd = state("1", "", '<event next="2"><when><none><data tag="x" exists="true" within="3"/>'
                "</none></when></event>") + state("2")  # fmt: skip
    lines: list[dict[str, Any]] = [{"at": 2, "set": {"x": 1}}, END]
    trace = play(rbd, lines, tags={"x": 0})
    assert trace.lines("transition") == ["5 transition app 1 2 - <data"]
