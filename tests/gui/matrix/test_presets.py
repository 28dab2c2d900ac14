"""The values that *what if* offers: those that tell a script's tests apart."""

from __future__ import annotations

from typing import Any

from tests.gui.matrix.conftest import read

from situ_studio.matrix.presets import presets, short, typed


def offered(tests: str, kind: str = "") -> tuple[Any, ...]:
    observed = f'<observe><data tag="t" {kind}/></observe>' if kind else ""
    script = read(
        f'<spds name="s">{observed}<situation name="a"><condition>{tests}</condition></situation>'
        '<situation name="b"/></spds>'
    )
    return presets(script)["t"]


TOLD: tuple[tuple[str, str, tuple[Any, ...]], ...] = (
    ('<data tag="t" is="true"/>', 'type="boolean"', (True, False)),
    ('<data tag="t" is="false"/>', 'type="boolean"', (False, True)),
    ('<data tag="t" is="true" within="3"/>', "", (True, False)),
    ('<data tag="t" exists="true"/>', 'type="number"', (0,)),
    ('<data tag="t" exists="false"/>', 'type="text"', ("…",)),
    ('<data tag="t" above="5"/>', 'type="number"', (6, 4)),
    ('<data tag="t" below="1.5"/>', 'type="number"', (1.35, 1.65)),
    ('<data tag="t" atleast="0"/>', "", (1, -1)),
    ('<data tag="t" in=\'["a", 2]\'/>', 'type="text"', ("a", 2)),
    ('<data tag="t" is="3"/>', 'type="text"', ("3",)),
    ('<data tag="t" is="3"/>', "", (3,)),
    ('<data tag="t" above="08:00"/>', 'type="text"', ("08:00",)),
    ('<none><data tag="t" is="1"/></none>', 'type="number"', (1,)),
)


def test_the_first_value_lets_a_test_hold_and_the_others_tell_tests_apart() -> None:
    for tests, kind, values in TOLD:
        found = offered(tests, kind)
        assert found == values, tests
        assert [type(one) for one in found] == [type(one) for one in values], tests


def test_what_is_observed_comes_first_and_what_no_condition_looks_at_not_at_all() -> None:
    script = read(
        '<spds name="s"><observe><data tag="never"/><data tag="b"/></observe>'
        '<situation name="a"><condition><any><data tag="c" is="1"/><data tag="b" is="1"/></any>'
        '</condition><until><data tag="d" is="1"/></until></situation>'
        '<situation name="z"/></spds>'
    )
    assert list(presets(script)) == ["b", "c", "d"]


def test_a_typed_value_is_json_or_text_and_text_stays_text() -> None:
    assert (typed("1.5", "number"), typed("true", None), typed("[1]", None)) == (1.5, True, [1])
    assert (typed("12", "text"), typed("hello", None), typed(" ", None)) == ("12", "hello", None)


def test_a_chip_says_a_value_shortly_and_true_by_its_name_alone() -> None:
    assert (short(True), short(False), short("ä"), short({"a": 1})) == (
        "",
        "false",
        "ä",
        '{"a": 1}',
    )
    assert short("x" * 40) == "x" * 15 + "…"
