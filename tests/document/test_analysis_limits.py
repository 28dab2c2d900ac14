"""Searches that would take too long: what is not known is told so, and nothing else is claimed."""

from __future__ import annotations

import pytest
from msgspec.structs import replace

from situ.document import (
    analysis_loops,
    analysis_search,
    analysis_winning,
    check_application,
    codec,
)
from situ.document.analysis import Cancelled, Search, analyse
from situ.document.analysis_search import NOWHERE
from situ.document.check import check
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds

FILE = "a.rbd.xml"
SCRIPT = "a.spds.xml"

GUARDS = (
    '<state no="1"><expectedevents>'
    '<event name="e" next="2"><when><data tag="x" above="3"/><data tag="x" below="2"/></when>'
    "</event>"
    '<event name="e" next="2"><when><data tag="x" is="9"/></when></event>'
    "</expectedevents></state>"
    '<state no="2"><expectedevents><event name="e" next="1"/></expectedevents></state>'
)
LOOP = (
    '<state no="1"><expectedevents>'
    '<event next="2"><when><data tag="x" above="3"/></when></event>'
    '<event name="e" next="2"/></expectedevents></state>'
    '<state no="2"><expectedevents>'
    '<event next="1"><when><data tag="x" above="5"/></when></event>'
    '<event name="e" next="1"/></expectedevents></state>'
)
ASKING = '<module name="a" resources="speech"/>'
BELOW = (
    '<event name="e" next="1"><when><data tag="x" below="2"/></when></event>'
    '<event name="e" next="1"><when><data tag="x" atmost="3"/><data tag="x" atleast="2"/></when>'
    "</event>"
)


def application(states: str) -> Application:
    document, problems = codec.read(f'<application name="a">{states}</application>'.encode(), FILE)
    assert isinstance(document, Application), problems
    return document


def script(text: str) -> Spds:
    document, problems = codec.read(f'<spds name="a">{text}</spds>'.encode(), SCRIPT)
    assert isinstance(document, Spds), problems
    return document


def project(app: str = "", situations: str = "") -> Project:
    return Project(
        root="nowhere",
        name="a",
        applications={FILE: application(app)} if app else {},
        spds_file=SCRIPT if situations else None,
        spds=script(situations) if situations else None,
    )


def found(of: Project, *codes: str) -> list[Problem]:
    return [problem for problem in check(of) if problem.code in codes]


def test_a_search_stops_when_it_is_cancelled() -> None:
    with pytest.raises(Cancelled):
        analyse(project(LOOP), lambda: True)


def test_what_would_take_too_long_is_undecided_and_never_told_as_impossible(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    known = ("never-holds", "event-never-taken", "shadowed-situation")
    situations = (
        '<situation name="one"><condition><data tag="x" above="3"/><data tag="x" below="2"/>'
        '</condition></situation><situation name="two"><condition><data tag="x" is="1"/>'
        '</condition></situation><situation name="rest"/>'
    )
    whole = project(GUARDS, situations)
    assert {problem.code for problem in found(whole, *known, "undecided")} == {"never-holds"}
    monkeypatch.setattr(analysis_search, "ALLOWANCE", 0)
    places = [problem.place for problem in found(whole, "undecided")]
    assert ("state", "1", "event", "0", "when") in places
    assert ("state", "1", "event", "1") in places
    assert ("situation", "two") in places
    assert len(places) == len(set(places))
    assert found(whole, *known) == []


def test_a_livelock_is_told_or_undecided_however_little_is_looked_at(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    told = set()
    for most in range(2, 20):
        monkeypatch.setattr(analysis_loops, "MOST", most)
        (problem,) = found(project(LOOP), "livelock", "undecided")
        told.add(problem.code)
    assert told == {"livelock", "undecided"}


def test_a_long_search_for_livelocks_asks_whether_it_is_cancelled(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked: list[int] = []

    def cancel() -> bool:
        asked[-1] += 1
        return False

    for most in (3000, 201):
        monkeypatch.setattr(analysis_loops, "MOST", most)
        asked.append(0)
        analyse(project(LOOP), cancel)
    assert asked[1] > asked[0]


def test_what_surely_comes_first_hides_what_would_go_round() -> None:
    text = (
        '<state no="1"><backgroundactions><set tag="x">{}</set>'
        '<message topic="t" done="sent"/></backgroundactions><expectedevents>'
        '<event name="sent" next="2"><when><data tag="x" is="1"/></when></event>'
        '<event name="sent" next="#again"/><event><when><data tag="x" is="7"/></when></event>'
        "</expectedevents></state>"
        '<state no="2"><expectedevents><event name="e" next="1"/></expectedevents></state>'
    )
    assert found(project(text.format(1)), "livelock", "undecided") == []
    (problem,) = found(project(text.format(2)), "livelock", "undecided")
    assert problem.place == ("state", "1", "event", "1")


def test_what_only_goes_back_is_no_livelock() -> None:
    back = '<event next="#back"><when><data tag="x" above="3"/></when></event>'
    text = (
        '<state no="1"><expectedevents><event name="e" next="2"/></expectedevents></state>'
        f'<state no="2"><expectedevents>{back}<event name="e" next="3"/></expectedevents></state>'
        f'<state no="3"><expectedevents>{back}<event name="e" next="2"/></expectedevents></state>'
    )
    assert found(project(text), "livelock", "undecided") == []


def test_of_many_situations_that_shadow_another_four_are_named() -> None:
    situations = "".join(
        f'<situation name="s{at}"><condition><data tag="x" is="{at}"/></condition></situation>'
        for at in range(1, 8)
    )
    situations += (
        '<situation name="last"><condition><data tag="x" in="[1, 2, 3, 4, 5, 6, 7]"/></condition>'
        '</situation><situation name="rest"/>'
    )
    beside = '<situation name="beside"><condition><data tag="y" is="1"/></condition></situation>'
    (problem,) = found(project(situations=beside + situations), "shadowed-situation")
    assert problem.place == ("situation", "last")
    assert '"s1", "s2", "s3", "s4" and 3 more' in problem.message


def test_a_tie_that_comes_with_extends_is_told_at_the_situation() -> None:
    situations = (
        '<modules><module name="m" resources="head"/><module name="n" resources="head"/></modules>'
        '<situation name="never"><condition><data tag="x" above="3"/><data tag="x" below="2"/>'
        '</condition><module name="m" priority="5"/><module name="n" priority="5"/></situation>'
        '<situation name="rest" extends="never"/>'
    )
    assert [p.place for p in found(project(situations=situations), "tie")] == [
        ("situation", "rest")
    ]


@pytest.mark.parametrize(
    ("own", "why"),
    [
        ('<event name="e" next="1"><when><data tag="x" above="5"/></when></event>', "left first"),
        (
            BELOW + '<event name="e" next="1"/>',
            "whenever it could be",
        ),
    ],
)
def test_an_event_is_never_taken_where_what_leaves_the_state_is_always_first(
    own: str, why: str
) -> None:
    leaves = '<event next="1"><when><any><data tag="x" above="3"/>'
    leaves += '<none><data tag="x" exists="true"/></none></any></when></event>'
    text = (
        '<state no="1"><expectedevents><event name="e" next="2"/></expectedevents></state>'
        f'<state no="2"><expectedevents>{leaves}{own}</expectedevents></state>'
    )
    observed = '<observe><data tag="x" type="number"/></observe><situation name="rest"/>'
    problems = found(project(text, observed), "event-never-taken")
    assert len(problems) == 1
    assert why in problems[0].message


def test_the_second_question_of_a_place_is_not_told_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(analysis_loops, "MOST", 1)
    monkeypatch.setattr(analysis_search, "ALLOWANCE", 0)
    always = (
        '<always><expectedevents><event name="e" next="1"><when><data tag="x" is="1"/></when>'
        "</event></expectedevents></always>"
    )
    problems = found(project(always + '<state no="1"/><state no="2"/>'), "undecided")
    assert len({p.place for p in problems}) == len(problems)


def test_a_module_with_many_resources_beside_an_application_above_is_undecided() -> None:
    many = " ".join(f"r{at}" for at in range(13))
    situations = (
        f'<modules><module name="m" resources="{many}"/><module name="n" resources="r1"/>{ASKING}'
        '</modules><situation name="rest"><module name="m" priority="9"/>'
        '<module name="n" priority="1"/><module name="a" priority="9"/></situation>'
    )
    of = project('<state no="1"/>', situations)
    (problem,) = found(of, "undecided", "never-wins")
    assert problem.place == ("situation", "rest", "entry", "1")
    assert 'It is not known whether "n" ever holds authority' in problem.message


@pytest.mark.parametrize("priority", [8, 9])
def test_whether_a_module_wins_is_undecided_where_too_many_could_ask_before(
    monkeypatch: pytest.MonkeyPatch, priority: int
) -> None:
    monkeypatch.setattr(analysis_winning, "MOST", 3)
    modules = "".join(f'<module name="m{at}" resources="r{at} s"/>' for at in range(3))
    entries = "".join(f'<module name="m{at}" priority="{9 - at}"/>' for at in range(3))
    entries += f'<module name="a" priority="{priority}"/>'
    situations = f'<modules>{modules}{ASKING}</modules><situation name="rest">{entries}</situation>'
    of = project('<state no="1"/>', situations)
    places = [p.place for p in found(of, "undecided", "never-wins")]
    assert places[-1] == ("situation", "rest", "entry", "2")


@pytest.mark.parametrize("priority", [0, 5, 9])
def test_of_however_many_modules_above_it_is_known_whether_one_wins(priority: int) -> None:
    """An application below them, among them, or above; who only may ask hinders nobody."""
    names = [f"m{at}" for at in range(40)]
    modules = "".join(f'<module name="{name}" resources="base"/>' for name in names)
    entries = "".join(f'<module name="{name}" priority="5"/>' for name in names)
    situations = (
        f'<modules>{modules}<module name="last" resources="base"/>{ASKING}</modules>'
        f'<situation name="rest">{entries}<module name="last" priority="1"/>'
        f'<module name="a" priority="{priority}"/></situation>'
    )
    of = project('<state no="1"/>', situations)
    assert found(of, "undecided", "never-wins") == []


def test_an_application_without_states_asks_for_nothing() -> None:
    situations = (
        '<modules><module name="a" resources="speech"/></modules>'
        '<situation name="rest"><module name="a" priority="5"/></situation>'
    )
    empty = Application("a", None, None, ())
    whole = project(situations=situations)
    assert found(replace(whole, applications={FILE: empty}), "tie", "undecided") == []


def test_what_two_places_could_mean_is_not_mended_by_machine() -> None:
    # A second state 1 has an event more than the first, to which its place leads.
    search = Search(project(LOOP))
    place = ("state", "1", "event", "2")
    assert search.path(FILE, place) == NOWHERE
    assert search.mend(FILE, "Lead to state 1", search.put(FILE, place, "next", "1")) is None
    there = search.put(FILE, ("state", "1", "event", "1"), "next", "1")
    assert search.mend(FILE, "Lead to state 1", there) is not None


def test_the_state_nearly_meant_is_looked_for_a_few_times_only(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    events = "".join(f'<event name="e" next="{to}"/>' for to in ("100", "101", "100", "second"))
    text = (
        f'<state no="10"><expectedevents>{events}</expectedevents></state>'
        '<state no="200" name="second"/>'
    )
    monkeypatch.setattr(check_application, "MOST_LOOKED_FOR", 1)
    mends = [problem.mend for problem in found(project(text), "dangling-next")]
    words = [mend.words if mend is not None else "" for mend in mends]
    assert ["10" in said for said in words] == [True, False, True, False]
    assert "200" in words[3]


def test_three_loops_of_one_beginning_are_told_and_no_more() -> None:
    there = "".join(
        f'<event next="{to}"><when><data tag="x" is="{to}"/></when></event>' for to in range(2, 8)
    )
    back = '<event next="1"><when><data tag="x" exists="true"/></when></event>'
    text = f'<state no="1"><expectedevents>{there}</expectedevents></state>' + "".join(
        f'<state no="{no}"><expectedevents>{back}</expectedevents></state>' for no in range(2, 8)
    )
    places = [problem.place for problem in found(project(text), "livelock")]
    assert places == [("state", "1", "event", str(at)) for at in range(3)]
