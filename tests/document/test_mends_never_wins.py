"""The mends of ``never-wins``: what is offered takes the problem away and harms no other module."""

from __future__ import annotations

from random import Random

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests.document.test_analysis_script import found, project, screen_app, script, situation

from situ.document import analysis_winning, codec
from situ.document.mend import mends
from situ.document.problem import Problem
from situ.document.rbd import Application, State
from situ.document.rbd import Robot as RobotAction
from situ.document.spds import Declaration, Entry, Situation, Spds

LAST = situation("z")
SPEAKER = '<module name="app" resources="screen speech"/>'
ALWAYS = screen_app("app", "speech", "speech")
"""It holds screen and speech whatever it does."""


def never(source: Spds, *applications: Application) -> list[Problem]:
    return [p for p in found(source, *applications) if p.code == "never-wins"]


def mended(source: Spds, *applications: Application) -> tuple[str, str, Spds]:
    """The module that never wins, what its mend says, and the script after it."""
    (problem,) = never(source, *applications)
    ((words, document),) = mends(project(source, *applications), problem)
    assert isinstance(document, Spds)
    return module_of(source, problem), words, document


def module_of(source: Spds, problem: Problem) -> str:
    place = problem.place
    if place[0] == "module":
        return place[1]
    held = source.situation(place[1])
    assert held is not None
    return held.entries[int(place[3])].module


def entries(*priorities: tuple[str, int | str]) -> str:
    return "".join(f'<module name="{name}" priority="{p}"/>' for name, p in priorities)


def test_it_is_raised_just_above_who_always_holds_what_it_could_ask_for() -> None:
    modules = f'<modules>{SPEAKER}<module name="m" resources="speech"/></modules>'
    source = script(modules + situation("z", rest=entries(("app", 9), ("m", 5))))
    _, words, after = mended(source, ALWAYS)
    assert words == 'Raise it to 10 in "z", above "app"'
    assert after.situations[0].entries[1] == Entry("m", 10)
    assert found(after, ALWAYS) == []


def test_it_is_raised_above_all_of_those_that_are_in_its_way_and_to_a_number_of_its_own() -> None:
    modules = f'{SPEAKER}<module name="m" resources="speech"/>'
    modules += "".join(f'<module name="n{at}" resources="base"/>' for at in range(4))
    others = entries(*((f"n{at}", 10) for at in range(4)))
    rest = entries(("app", 9), ("m", 5)) + others
    source = script(f"<modules>{modules}</modules>" + situation("z", rest=rest))
    (problem,) = never(source, ALWAYS)
    assert problem.mend is not None
    assert problem.mend.words == 'Raise it to 11 in "z", above "n0", "n1" and 2 more'


def test_it_is_raised_above_who_holds_it_and_not_only_above_the_next() -> None:
    modules = f'<modules>{SPEAKER}<module name="m" resources="speech"/>'
    modules += '<module name="n" resources="base"/></modules>'
    rest = entries(("app", 20), ("n", 9), ("m", 5))
    _, words, after = mended(script(modules + situation("z", rest=rest)), ALWAYS)
    assert words == 'Raise it to 21 in "z", above "app"'
    assert found(after, ALWAYS) == []


def test_of_two_priorities_in_one_situation_the_one_that_counts_is_raised() -> None:
    modules = f'<modules>{SPEAKER}<module name="m" resources="speech"/></modules>'
    source = script(modules + situation("z", rest=entries(("app", 9), ("m", 5), ("m", 6))))
    after = mended(source, ALWAYS)[2]
    assert [entry.priority for entry in after.situations[0].entries] == [9, 5, 10]


def test_situations_that_extend_each_other_in_a_circle_are_gone_through_once() -> None:
    modules = '<modules><module name="m" resources="head"/></modules>'
    circle = situation("a", 'is="1"', attributes='extends="z"')
    source = script(modules + circle + situation("z", attributes='extends="a"'))
    assert mended(source)[1] == 'Give it the priority 1 in "z"'


def test_a_priority_that_is_taken_over_is_raised_where_it_stands() -> None:
    modules = f'<modules>{SPEAKER}<module name="m" resources="speech"/></modules>'
    never_current = situation("a", 'in="[]"', entries(("m", 7)))
    removed = situation("b", 'is="1"', entries(("m", "none")), 'extends="z"')
    source = script(
        modules
        + never_current
        + removed
        + situation("c", 'is="2"', entries(("app", 20)), 'extends="z"')
        + situation("z", rest=entries(("app", 9), ("m", 5)))
    )
    _, words, after = mended(source, ALWAYS)
    assert words == 'Raise it to 10 in "z", above "app"'
    assert never(after, ALWAYS) == []


def test_nothing_is_offered_where_no_situation_that_gives_it_a_priority_is_ever_current() -> None:
    modules = '<modules><module name="m" resources="head"/></modules>'
    source = script(modules + situation("a", 'in="[]"', entries(("m", 5))) + LAST)
    (problem,) = never(source)
    assert problem.mend is None


def test_nothing_is_offered_where_another_would_never_win_instead() -> None:
    """Two applications that always show a screen: whichever is above has it."""
    modules = '<modules><module name="app" resources="screen"/><module name="other" {}/></modules>'
    source = script(
        modules.format('resources="screen"')
        + situation("z", rest=entries(("app", 9), ("other", 5)))
    )
    apps = screen_app("app", "nothing"), screen_app("other", "nothing")
    (problem,) = never(source, *apps)
    assert module_of(source, problem) == "other"
    assert problem.mend is None
    # Where the one above also wins elsewhere, it does no harm.
    elsewhere = situation("a", 'is="1"', entries(("app", 9)))
    source = script(
        modules.format('resources="screen"')
        + elsewhere
        + situation("z", rest=entries(("app", 9), ("other", 5)))
    )
    _, words, after = mended(source, *apps)
    assert words == 'Raise it to 10 in "z", above "app"'
    assert never(after, *apps) == []


def test_without_a_priority_it_gets_the_lowest_of_the_last_situation() -> None:
    modules = '<modules><module name="m" resources="head"/><module name="n" resources="head"/>'
    modules += "</modules>"
    source = script(modules + situation("a", 'is="1"') + situation("z", rest=entries(("m", 5))))
    module, words, after = mended(source)
    assert (module, words) == ("n", 'Give it the priority 1 in "z"')
    assert found(after) == []
    source = script(modules + situation("z", rest=entries(("m", 1))))
    assert mended(source)[1] == 'Give it the priority 0 in "z"'


def test_without_a_priority_it_gets_the_lowest_with_which_it_wins() -> None:
    modules = f'<modules>{SPEAKER}<module name="m" resources="speech"/></modules>'
    source = script(modules + situation("z", rest=entries(("app", 9))))
    assert mended(source, ALWAYS)[1] == 'Give it the priority 10 in "z"'


@pytest.mark.parametrize(
    "situations",
    [
        "",
        situation("a", 'is="1"', entries(("m", "none"))) + LAST,
        # The last is never current, and nothing takes over from it.
        situation("a") + LAST,
    ],
    ids=["no situations", "taken away by hand", "the last is shadowed"],
)
def test_without_a_priority_nothing_is_offered_where_none_is_plain(situations: str) -> None:
    modules = '<modules><module name="m" resources="head"/></modules>'
    (problem,) = never(script(modules + situations))
    assert problem.mend is None


def test_priorities_without_resources_are_all_taken_out() -> None:
    modules = '<modules><module name="m"/><module name="n" resources="head"/></modules>'
    both = entries(("m", 5), ("n", 3), ("m", "none"))
    source = script(modules + situation("a", 'is="1"', both) + situation("z", rest=both))
    _, words, after = mended(source)
    assert words == "Take its priorities out"
    assert [s.entries for s in after.situations] == [(Entry("n", 3),)] * 2
    source = script(modules + situation("z", rest=entries(("m", 5), ("n", 3))))
    assert mended(source)[1] == "Take its priority out"


def test_what_is_not_known_to_win_is_not_offered(monkeypatch: pytest.MonkeyPatch) -> None:
    """Below an application, above which a module may ask for more than is looked through."""
    modules = f'{SPEAKER}<module name="m" resources="speech"/><module name="n" resources="a b c"/>'
    modules += '<module name="drives" resources="base"/>'
    rest = entries(("app", 9), ("drives", 11), ("n", 12))
    source = script(f"<modules>{modules}</modules>" + situation("z", rest=rest))
    move = RobotAction(resource="base", command="go")
    apps = ALWAYS, Application("drives", None, None, (State("1", actions=(move,), final=True),))
    assert mended(source, *apps)[1] == 'Give it the priority 10 in "z"'
    monkeypatch.setattr(analysis_winning, "MOST", 3)
    (problem,) = [p for p in never(source, *apps) if p.place[0] == "module"]
    assert problem.mend is not None
    assert problem.mend.words == 'Give it the priority 13 in "z"'


@given(seed=st.integers(0, 2**64))
@settings(max_examples=60, deadline=None)
def test_a_mend_takes_its_problem_away_and_brings_no_other_and_no_tie(seed: int) -> None:
    random = Random(seed)
    names = ["m", "n", "app", "other"][: random.choice([3, 4])]
    kinds = ["screen", "speech", "screen speech", ""]
    declared = [Declaration(n, tuple(random.choice(kinds).split())) for n in names[:2]]
    declared += [Declaration(n, ("screen", "speech")) for n in names[2:]]
    apps = [screen_app(n, *random.choices(["speech", "nothing"], k=2)) for n in names[2:]]
    made = tuple(
        Situation(
            f"s{at}",
            extends=random.choice([None, "z"]),
            condition=script(situation("a", f'is="{at}"')).situations[0].condition,
            entries=tuple(
                Entry(n, random.choice([1, 2, 3, None])) for n in names if random.random() < 0.5
            ),
        )
        for at in range(random.choice([0, 1, 2]))
    )
    last = Situation("z", entries=tuple(Entry(n, random.randint(1, 4)) for n in names[1:]))
    source = Spds("a", (), tuple(declared), (*made, last))
    problems = never(source, *apps)
    assume(problems)
    ties = [p for p in found(source, *apps) if p.code == "tie"]
    losers = {module_of(source, p) for p in problems}
    for problem in problems:
        for _, document in mends(project(source, *apps), problem):
            assert isinstance(document, Spds)
            left = {module_of(document, p) for p in never(document, *apps)}
            assert left <= losers - {module_of(source, problem)}
            after = [p for p in found(document, *apps) if p.code == "tie"]
            assert len(after) <= len(ties)
            assert codec.read(codec.write(document), "x") == (document, [])
