"""docs/semantics.md, *Deploy*: another script (SPDS), with or without the applications."""

from __future__ import annotations

import pytest
from tests.decide.test_deploy import HELLO, Run, event, state, texts

from situ.decide import inputs

MODULES = (
    '<modules><module name="m" resources="head"/><module name="n" resources="head"/></modules>'
)


def situation(name: str, more: str = "", *children: str) -> str:
    return f'<situation name="{name}" {more}>{"".join(children)}</situation>'


def when(test: str, of: str = "condition") -> str:
    return f"<{of}><data {test}/></{of}>"


def gives(**priorities: int) -> str:
    return "".join(f'<module name="{n}" priority="{p}"/>' for n, p in priorities.items())


LAST = situation("last", "", gives(m=1))
X = when('tag="x" is="1"')


def script(*situations: str, rbd: str = "", modules: str = MODULES) -> dict[str, str]:
    """Situations after those modules; without an application unless one is given."""
    return texts(rbd or [], modules + "".join(situations))


def x(value: int) -> inputs.Set:
    return inputs.Set({"x": value}, "w")


# -- who may do what ---------------------------------------------------------


def test_a_script_alone_touches_no_application_and_no_module() -> None:
    """Where the new one gives what the old one gave, nothing but the deploy is traced."""
    says = state("1", '<timeout next="2">9</timeout>', event("go", "2"), HELLO) + state("2")
    modules = MODULES.replace("</modules>", '<module name="app" resources="speech"/></modules>')
    last = situation("last", "", gives(m=1, app=1))
    other = situation("other", "", X, gives(n=1))
    run = Run(script(last, rbd=says, modules=modules))
    run.at(1, inputs.Acquire("m", ("head",)), inputs.Command("m", "head", {"yaw": 5}, None))
    run.at(2, inputs.Finish("speech"))
    run.deploy(3, script(other, last.replace('"1"', '"7"'), rbd=says, modules=modules))
    assert run.since(3) == []
    assert run.look("robot/head") == {"yaw": 5}
    assert run.look("situation") == {"name": "last", "priorities": {"m": 7, "app": 7}}
    assert run.trace.states() == [(0, "1")]
    assert run.at(20).trace.states() == [(0, "1"), (9, "2")]


def test_other_priorities_hand_over_in_the_step_of_the_deploy() -> None:
    run = Run(script(situation("last", "", gives(m=2, n=1))))
    run.at(1, inputs.Acquire("m", ("head",)), inputs.Acquire("n", ("head",)))
    run.at(1, inputs.Command("n", "head", 5, 60))
    run.deploy(2, script(situation("last", "", gives(m=2, n=3))))
    assert run.since(2) == [
        "2 authority head m n <deployed",
        "2 mapping head n 5 <authority",
    ]


def test_a_module_no_longer_asks_for_what_it_does_not_declare_any_longer() -> None:
    run = Run(script(LAST)).at(1, inputs.Acquire("m", ("head",)), inputs.Command("m", "head", 5))
    for modules in ('<module name="m" resources="arm"/>', '<module name="k" resources="arm"/>'):
        other = Run(script(LAST))
        other.at(1, inputs.Acquire("m", ("head",)), inputs.Command("m", "head", 5))
        other.at(1, inputs.Command("n", "head", 5))
        last = LAST.replace('"m"', '"k"') if '"k"' in modules else LAST
        other.deploy(2, script(last, modules=f"<modules>{modules}</modules>"))
        assert other.since(2) == [
            "2 abandon m [head] <deployed",
            "2 authority head m - <deployed",
            "2 mapping head - null <authority",
        ]
        assert other.look("module/n/head") is None
    assert run.robot.modules() == {"m": True, "n": True}


def test_modules_stay_connected_or_lost() -> None:
    run = Run(script(LAST), everyone=False)
    run.at(1, inputs.Connected("m", ("head",)), inputs.Connected("guest", ("arm",)))
    run.at(1, inputs.Acquire("guest", ("arm",)))
    run.deploy(2, script(LAST.replace('m"', 'n"')))
    assert run.robot.modules() == {"guest": True, "m": True, "n": False}
    assert run.since(2) == []


def test_a_script_may_come_and_go() -> None:
    run = Run(texts([])).deploy(1, script(LAST))
    assert run.since(1) == ["1 situation - last <deployed"]
    run.deploy(2, texts([]))
    assert run.since(2) == []
    assert run.look("situation") is None


# -- situations --------------------------------------------------------------


def test_the_current_situation_stays_by_its_name() -> None:
    old, new = situation("a", "", X), situation("a", "", when('tag="x" atleast="1"'))
    run = Run(script(old, LAST)).at(1, x(1)).deploy(2, script(situation("b", "", X), new, LAST))
    assert run.since(2) == [
        "2 condition b true <deployed",
        "2 condition a true <deployed",
        "2 situation a b <deployed",
    ]
    run.at(3, x(2))
    assert run.trace.situations()[-1] == (3, "a")


def test_one_that_is_gone_is_left_by_its_name() -> None:
    run = Run(script(situation("a", "", X), LAST)).at(1, x(1)).deploy(2, script(LAST))
    assert run.since(2) == ["2 situation a last <deployed"]


def test_another_order_is_another_precedence() -> None:
    one, other = situation("a", "", X), situation("b", "", X)
    run = Run(script(one, other, LAST)).at(1, x(1)).deploy(2, script(other, one, LAST))
    assert run.since(2) == ["2 situation a b <deployed"]
    assert run.at(3, x(0)).trace.situations()[-1] == (3, "last")


def test_a_condition_may_come_and_go() -> None:
    bare = situation("a", "", when('tag="u" is="1"', "until"))
    with_it = situation("a", "", X, when('tag="u" is="1"', "until"))
    run = Run(script(bare, LAST)).deploy(1, script(with_it, LAST))
    # It is kept: only its until ends it.
    assert run.since(1) == []
    run.at(2, inputs.Set({"u": 1}, "w")).deploy(3, script(bare, LAST))
    assert run.trace.situations() == [(0, "a"), (2, "last")]
    assert run.at(4, inputs.Set({"u": 0}, "w")).trace.situations()[-1] == (4, "a")


@pytest.mark.parametrize(
    ("old", "new", "left"),
    [
        ('dwell="10"', 'dwell="4"', 6),
        ('dwell="10"', 'dwell="20"', 22),
        ('dwell="10"', 'dwell="0.5"', 5),
        ('dwell="10"', "", 5),
        ('dwell="10"', 'dwell="10"', 12),
    ],
)
def test_dwell_counts_on_under_the_new_length(old: str, new: str, left: float) -> None:
    run = Run(script(situation("a", old, X), LAST)).at(2, x(1)).at(3, x(0))
    run.deploy(5, script(situation("a", new, X), situation("b", "", X), LAST)).at(40)
    assert run.trace.situations() == [(0, "last"), (2, "a"), (left, "last")]


U = when('tag="u" is="1"', "until")


@pytest.mark.parametrize(
    ("old", "new", "left"),
    [
        (("", U), ('limit="10"', U), 15),
        (('limit="10"', U), ('limit="4"', U), 6),
        (('limit="10"', U), ("", U), 30),
        (("", U), ("", ""), 5),
        (("", U), ("", when('tag="v" exists="false"', "until")), 5),
        (('limit="10"', ""), ("", U), 30),
    ],
)
def test_until_and_limit_end_it_as_the_new_script_has_them(
    old: tuple[str, str], new: tuple[str, str], left: float
) -> None:
    run = Run(script(situation("a", old[0], X, old[1]), LAST)).at(2, x(1)).at(3, x(0))
    run.deploy(5, script(situation("a", new[0], X, new[1]), LAST))
    run.at(30, inputs.Set({"u": 1}, "w")).at(40)
    assert run.trace.situations() == [(0, "last"), (2, "a"), (left, "last")]


def test_where_no_until_is_left_it_begins_again() -> None:
    run = Run(script(situation("a", "", X, U), LAST)).at(1, inputs.Set({"x": 1, "u": 1}, "w"))
    run.deploy(2, script(situation("a", "", X), LAST))
    assert run.since(2) == ["2 situation last a <deployed"]


def test_a_dwell_that_is_gone_and_comes_again_is_counted_anew() -> None:
    dwells, plain = (script(situation("a", more, X), LAST) for more in ('dwell="9"', ""))
    run = Run(dwells).at(1, x(1)).at(2, x(0)).deploy(3, plain).deploy(4, dwells)
    assert run.at(5, x(1)).at(6, x(0)).at(20).trace.situations()[1:] == [
        (1, "a"),
        (3, "last"),
        (5, "a"),
        (14, "last"),
    ]


def test_one_that_had_ended_does_not_begin_again_by_a_deploy() -> None:
    ends = situation("a", 'limit="2"', X)
    run = Run(script(ends, LAST)).at(1, x(1)).at(4).deploy(5, script(ends, situation("b"), LAST))
    assert run.trace.situations() == [(0, "last"), (1, "a"), (3, "last"), (5, "b")]


# -- clocks of conditions ----------------------------------------------------


def test_within_and_for_count_on_where_the_same_test_stands() -> None:
    within = situation("a", "", when('tag="x" is="1" within="5"'))
    held = situation("a", "", when('tag="x" is="1" for="5"'))
    other = situation("c", "", X)
    run = Run(script(within, LAST)).at(1, x(1)).deploy(3, script(other, within, LAST))
    assert run.at(20).trace.lines("condition", since=4) == ["6 condition a false <data"]
    run = Run(script(held, LAST)).at(1, x(1)).deploy(3, script(other, held, LAST))
    assert run.at(20).trace.lines("condition", since=4) == ["6 condition a true <data"]


def test_another_for_counts_from_when_its_test_began_to_hold() -> None:
    def files(seconds: float) -> dict[str, str]:
        return script(situation("a", "", when(f'tag="x" is="1" for="{seconds}"')), LAST)

    run = Run(files(5)).at(1, x(1)).deploy(3, files(9)).at(30)
    assert run.trace.lines("condition") == ["10 condition a true <data"]
    run = Run(files(9)).at(1, x(1)).deploy(3, files(1)).at(30)
    assert run.trace.lines("condition") == ["3 condition a true <deployed"]
    assert Run(files(9)).deploy(3, files(1)).at(30).trace.lines("condition") == []


def test_a_new_test_counts_from_the_deploy_and_within_from_the_last_set() -> None:
    held = situation("a", "", when('tag="x" is="1" for="5"'))
    within = situation("a", "", when('tag="x" is="1" within="5"'))
    run = Run(script(LAST)).at(1, x(1)).deploy(3, script(held, LAST)).at(20)
    assert run.trace.lines("condition") == ["8 condition a true <deployed"]
    assert Run(script(LAST)).deploy(3, script(held, LAST)).at(20).trace.lines("condition") == []
    run = Run(script(LAST)).at(1, x(1)).deploy(3, script(within, LAST)).at(20)
    assert run.trace.lines("condition") == [
        "3 condition a true <deployed",
        "6 condition a false <data",
    ]
    for second in (1, 9):
        run = Run(script(LAST)).at(1, *[x(1)] * (second - 1)).deploy(second, script(within, LAST))
        assert run.at(20).trace.lines("condition") == []


def test_what_a_livelock_left_unjudged_is_judged() -> None:
    """Two situations that each let the other hold: the last change of them was not judged."""
    other = situation("a", "", when('tag="situation.name" isnot="a"'))
    run = Run(script(other, LAST))
    assert run.trace.one("error")["message"].startswith("livelock")
    before = run.look("situation.name")
    run.deploy(1, script(other, LAST, modules='<observe><data tag="x"/></observe>' + MODULES))
    assert run.trace.of("situation")[-1]["t"] == 1
    assert next(e["from"] for e in run.trace.of("situation") if e["t"] == 1) == before
