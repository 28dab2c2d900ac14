"""formats.md, *SPDS*: requests and authority."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from situ.decide.effects import Refuse
from situ.decide.inputs import Acquire, Command, Start
from situ.decide.robot import Robot

if TYPE_CHECKING:
    from tests.decide.conftest import Build, Play, Trace

ALL = "arm base head"


def script(priorities: str, more: str = "") -> str:
    """Modules with all resources and their priorities: ``a=3 b=2``; ``more`` situations first."""
    pairs = [pair.split("=") for pair in priorities.split()]
    declared = "".join(f'<module name="{name}" resources="{ALL}"/>' for name, _ in pairs)
    given = "".join(
        f'<module name="{name}" priority="{priority}"/>' for name, priority in pairs if priority
    )
    return f'<modules>{declared}</modules>{more}<situation name="s">{given}</situation>'


def acquire(at: float, module: str, resources: str, optional: str = "") -> dict[str, Any]:
    asked: dict[str, Any] = {"module": module, "resources": resources.split()}
    if optional:
        asked["optional"] = optional.split()
    return {"at": at, "acquire": asked}


def abandon(at: float, module: str, resources: str) -> dict[str, Any]:
    return {"at": at, "abandon": {"module": module, "resources": resources.split()}}


def lost(at: float, module: str) -> dict[str, Any]:
    return {"at": at, "lost": {"module": module}}


def holders(trace: Trace) -> dict[str, str | None]:
    """Who holds what at the end."""
    return {event["resource"]: event["to"] for event in trace.of("authority")}


# -- priorities --------------------------------------------------------------


def test_the_higher_priority_wins(play: Play) -> None:
    lines = [acquire(1, "low", "head"), acquire(2, "high", "head")]
    assert play((), lines, spds=script("low=-5 high=3")).lines(since=1) == [
        "1 acquire low [head] <-",
        "1 authority head - low <acquire",
        "2 acquire high [head] <-",
        "2 authority head low high <acquire",
    ]


def test_a_lower_one_waits(play: Play) -> None:
    lines = [acquire(1, "high", "head"), acquire(2, "low", "head"), abandon(3, "high", "head")]
    assert play((), lines, spds=script("low=2 high=3")).lines(since=2) == [
        "2 acquire low [head] <-",
        "3 abandon high [head] <-",
        "3 authority head high low <abandon",
    ]


def test_a_module_without_a_priority_holds_nothing(play: Play) -> None:
    trace = play((), [acquire(1, "none", "head")], spds=script("none= other=1"))
    assert trace.lines(since=1) == ["1 acquire none [head] <-"]


def test_authority_follows_the_situation(play: Play) -> None:
    busy = """<situation name="busy"><condition><data tag="x" is="1"/></condition>
      <module name="b" priority="1"/></situation>"""
    lines = [
        acquire(1, "a", "head"),
        acquire(1, "b", "head"),
        {"at": 2, "set": {"x": 1}},
        {"at": 3, "set": {"x": 2}},
    ]
    trace = play((), lines, spds=script("a=3 b=2", busy))
    assert trace.lines("situation", "authority", since=2) == [
        "2 situation s busy <condition",
        "2 authority head a b <situation",
        "3 situation busy s <condition",
        "3 authority head b a <situation",
    ]


def test_authority_that_was_lost_comes_back_by_itself(play: Play) -> None:
    lines = [acquire(1, "a", "head"), acquire(2, "b", "head"), abandon(3, "b", "head")]
    trace = play((), lines, spds=script("a=1 b=2"))
    assert trace.lines("authority", since=3) == ["3 authority head b a <abandon"]


# -- all or none -------------------------------------------------------------


def test_a_request_is_granted_whole_or_not_at_all(play: Play) -> None:
    lines = [
        acquire(1, "high", "head"),
        acquire(2, "low", "base head"),
        acquire(3, "least", "base"),
    ]
    trace = play((), lines, spds=script("high=3 low=2 least=1"))
    assert holders(trace) == {"head": "high", "base": "least"}


def test_one_that_is_not_granted_takes_nothing_from_those_below(play: Play) -> None:
    lines = [
        acquire(1, "least", "arm base"),
        acquire(2, "high", "head"),
        acquire(3, "low", "base head"),
    ]
    trace = play((), lines, spds=script("high=3 low=2 least=1"))
    assert trace.lines("authority", since=3) == []
    assert holders(trace) == {"arm": "least", "base": "least", "head": "high"}


def test_losing_one_of_its_resources_it_loses_all(play: Play) -> None:
    lines = [acquire(1, "low", "base head"), acquire(2, "high", "head")]
    assert play((), lines, spds=script("low=1 high=2")).lines("authority", since=2) == [
        "2 authority base low - <acquire",
        "2 authority head low high <acquire",
    ]


def test_what_it_loses_goes_to_who_can_have_it_in_the_same_step(play: Play) -> None:
    lines = [
        acquire(1, "low", "base head"),
        acquire(2, "least", "base"),
        acquire(3, "high", "head"),
        abandon(4, "high", "head"),
    ]
    trace = play((), lines, spds=script("least=1 low=2 high=3"))
    assert trace.lines("authority", since=3) == [
        "3 authority base low least <acquire",
        "3 authority head low high <acquire",
        "4 authority base least low <abandon",
        "4 authority head high low <abandon",
    ]


# -- optional ----------------------------------------------------------------


def test_optional_resources_are_granted_one_by_one_where_they_are_free(play: Play) -> None:
    lines = [acquire(1, "high", "head"), acquire(2, "low", "base", "arm head")]
    trace = play((), lines, spds=script("low=1 high=2"))
    assert trace.lines("acquire", since=2) == ["2 acquire low [base] [arm head] <-"]
    assert holders(trace) == {"head": "high", "base": "low", "arm": "low"}


def test_an_optional_resource_of_a_higher_one_is_not_free_for_a_lower(play: Play) -> None:
    lines = [acquire(1, "low", "arm"), acquire(2, "high", "base", "arm")]
    assert holders(play((), lines, spds=script("low=1 high=2"))) == {"arm": "high", "base": "high"}


def test_optional_resources_are_not_granted_without_the_others(play: Play) -> None:
    lines = [acquire(1, "high", "base"), acquire(2, "low", "base", "arm")]
    assert holders(play((), lines, spds=script("low=1 high=2"))) == {"base": "high"}


def test_a_request_for_optional_resources_alone_takes_what_is_free(play: Play) -> None:
    lines = [acquire(1, "high", "base"), acquire(2, "low", "", "arm base")]
    assert holders(play((), lines, spds=script("low=1 high=2"))) == {"base": "high", "arm": "low"}


# -- equal priorities --------------------------------------------------------


def test_of_equal_priorities_who_holds_goes_first(play: Play) -> None:
    lines = [acquire(1, "a", "head"), acquire(2, "b", "head")]
    assert holders(play((), lines, spds=script("a=1 b=1"))) == {"head": "a"}


def test_then_the_earlier_request(play: Play) -> None:
    lines = [
        acquire(1, "c", "head"),
        acquire(2, "b", "head"),
        acquire(3, "a", "head"),
        abandon(4, "c", "head"),
    ]
    trace = play((), lines, spds=script("a=1 b=1 c=1"))
    assert trace.lines("authority", since=4) == ["4 authority head c b <abandon"]


def test_who_holds_any_of_it_goes_before_an_earlier_request(play: Play) -> None:
    """b asked first for base, a holds head and asks for base too."""
    lines = [
        acquire(1, "high", "base"),
        acquire(2, "b", "base arm"),
        acquire(3, "a", "head"),
        acquire(4, "a", "head", "base"),
        abandon(5, "high", "base"),
    ]
    assert holders(play((), lines, spds=script("a=1 b=1 high=2"))) == {"head": "a", "base": "a"}


def test_asking_again_keeps_its_place_in_time(play: Play) -> None:
    lines = [
        acquire(1, "high", "arm base head"),
        acquire(2, "a", "arm"),
        acquire(3, "b", "head"),
        acquire(4, "a", "head"),
        abandon(5, "high", ALL),
    ]
    assert holders(play((), lines, spds=script("a=1 b=1 high=2"))) == {
        "arm": None, "base": None, "head": "a",
    }  # fmt: skip


def test_giving_all_back_gives_up_its_place(play: Play) -> None:
    lines = [
        acquire(1, "high", "head"),
        acquire(2, "a", "head"),
        acquire(3, "b", "head"),
        abandon(4, "a", "head"),
        acquire(4, "a", "head"),
        abandon(5, "high", "head"),
    ]
    assert holders(play((), lines, spds=script("a=1 b=1 high=2"))) == {"head": "b"}


# -- asking and giving back --------------------------------------------------


def test_asking_again_replaces_the_request(play: Play) -> None:
    lines = [acquire(1, "a", "base head"), acquire(2, "a", "arm head"), acquire(3, "a", "head")]
    assert play((), lines, spds=script("a=1")).lines(since=2) == [
        "2 acquire a [arm head] <-",
        "2 authority arm - a <acquire",
        "2 authority base a - <acquire",
        "3 acquire a [head] <-",
        "3 authority arm a - <acquire",
    ]


def test_asking_for_the_same_again_changes_nothing(play: Play) -> None:
    lines = [acquire(1, "a", "base head"), acquire(2, "a", "head base")]
    assert play((), lines, spds=script("a=1")).lines(since=2) == []


def test_abandoning_some_keeps_the_rest(play: Play) -> None:
    lines = [acquire(1, "a", "base head"), abandon(2, "a", "head arm")]
    trace = play((), lines, spds=script("a=1"))
    assert trace.lines(since=2) == ["2 abandon a [head] <-", "2 authority head a - <abandon"]
    assert holders(trace) == {"base": "a", "head": None}


def test_abandoning_without_saying_what_gives_all_back(play: Play) -> None:
    lines = [acquire(1, "a", "base head", "arm"), abandon(2, "a", "")]
    assert play((), lines, spds=script("a=1")).lines("abandon", since=2) == [
        "2 abandon a [arm base head] <-"
    ]


def test_what_is_abandoned_may_make_the_rest_grantable(play: Play) -> None:
    lines = [acquire(1, "b", "head"), acquire(2, "a", "base head"), abandon(3, "a", "head")]
    assert play((), lines, spds=script("a=1 b=2")).lines(since=3) == [
        "3 abandon a [head] <-",
        "3 authority base - a <abandon",
    ]


def test_a_request_ends_when_its_module_is_lost(play: Play) -> None:
    lines = [acquire(1, "a", "head"), acquire(2, "b", "head"), lost(3, "a"), lost(4, "b")]
    assert play((), lines, spds=script("a=2 b=1")).lines(since=3) == [
        "3 lost a [head] <-",
        "3 authority head a b <lost",
        "4 lost b [head] <-",
        "4 authority head b - <lost",
    ]


def test_a_part_of_what_was_declared_may_be_asked_for(play: Play) -> None:
    assert holders(play((), [acquire(1, "a", "head")], spds=script("a=1"))) == {"head": "a"}


# -- refusals ----------------------------------------------------------------


@pytest.mark.parametrize(
    "line",
    [
        acquire(1, "a", "wings"),
        acquire(1, "a", "head wings"),
        acquire(1, "a", "head", "wings"),
        acquire(1, "nobody", "head"),
        {"at": 1, "command": {"module": "a", "resource": "wings", "value": 1}},
        {"at": 1, "command": {"module": "nobody", "resource": "head", "value": 1}},
        lost(1, "nobody"),
    ],
)
def test_what_was_not_declared_is_refused_and_nothing_changes(
    play: Play, line: dict[str, Any]
) -> None:
    lines = [acquire(0, "a", "base"), line]
    trace = play((), lines, spds=script("a=1"))
    assert [e["kind"] for e in trace if e["t"] == 1] == ["error"]


def test_the_module_is_told_what_to_do(build: Build) -> None:
    robot = Robot(build((), script("a=1")))
    robot.step(Start(), 0)
    for given in (Acquire("new", ("head",)), Command("new", "head", 1), Acquire("a", ("wings",))):
        events, effects = robot.step(given, 1)
        (refusal,) = [effect for effect in effects if isinstance(effect, Refuse)]
        assert "ask the task designer for a priority" in refusal.message
        assert len(events) == 1


def test_modules_of_the_module_information_are_declared_too(play: Play) -> None:
    trace = play(
        (),
        [acquire(1, "m", "head")],
        spds='<situation name="s"><module name="m" priority="1"/></situation>',
        modules='<module name="m" resources="head"/>',
    )
    assert holders(trace) == {"head": "m"}


# -- applications ------------------------------------------------------------


def test_an_application_is_a_module_named_after_it(play: Play) -> None:
    rbd = '<state no="1"><backgroundactions><speech>A</speech></backgroundactions></state>'
    spds = """<modules><module name="app" resources="speech"/><module name="m" resources="speech"/>
      </modules><situation name="s"><module name="app" priority="2"/>
      <module name="m" priority="1"/></situation>"""
    trace = play(rbd, [acquire(1, "m", "speech")], spds=spds)
    assert trace.lines("authority", since=0) == ["0 authority speech - app <acquire"]


def test_an_application_asks_for_what_its_state_uses(play: Play) -> None:
    def state(no: str, inside: str, go: str) -> str:
        return (
            f'<state no="{no}">{inside}<expectedevents><event name="go" next="{go}"/>'
            "</expectedevents></state>"
        )

    def acts(*actions: str) -> str:
        return f"<backgroundactions>{''.join(actions)}</backgroundactions>"

    screen = '<screen background="a.png"/>'
    head = '<robot resource="head" command="nod"/>'
    arm = '<robot resource="arm" command="wave" optional="true"/>'
    speech = "<speech>A</speech>"
    rbd = (
        state("1", acts(speech, head), "2")
        + state("2", screen + acts(head, arm), "3")
        # The screen is kept, and with it the resource.
        + state("3", acts(head, arm), "4")
        + state("4", "", "5")
        + state("5", "<screen/>", "6")
        + state("6", acts(head.replace("/>", ' optional="true"/>'), head), "7")
        + state("7", "", "7")
    )
    lines = [{"at": t, "event": "go"} for t in range(1, 7)]
    trace = play(rbd, lines)
    assert trace.lines("acquire", "abandon") == [
        "0 acquire app [head speech] <enter",
        "1 acquire app [head screen] [arm] <enter",
        "3 abandon app [arm head] <enter",
        "4 abandon app [screen] <enter",
        "5 acquire app [head] <enter",
        "6 abandon app [head] <enter",
    ]


def test_without_a_script_the_application_has_priority_1_and_no_situation(play: Play) -> None:
    rbd = '<state no="1"><backgroundactions><speech>A</speech></backgroundactions></state>'
    trace = play(rbd, [])
    assert trace.lines("authority", "situation", "condition") == [
        "0 authority speech - app <acquire"
    ]


def test_nobody_may_ask_in_the_name_of_an_application(play: Play) -> None:
    rbd = '<state no="1"/>'
    trace = play(rbd, [acquire(1, "app", "head")], pauses="head")
    assert [e["kind"] for e in trace if e["t"] == 1] == ["error"]
