"""docs/semantics.md cites tests that exist, and every test of the rules is cited there."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

TESTS = Path(__file__).parent
PAGE = TESTS.parent / "docs" / "semantics.md"
FOLDERS = ("blackboard", "browser", "decide", "document", "engine", "faults", "gui", "rehearse")
FILES = sorted(file for folder in FOLDERS for file in TESTS.glob(f"{folder}/**/test_*.py"))
CITED = set(
    re.findall(rf"`((?:{'|'.join(FOLDERS)})/[\w/]+\.py::\w+)`", PAGE.read_text(encoding="utf-8"))
)
OF_RULES = [file for file in FILES if file.parent.name == "decide"] + [
    TESTS / "rehearse" / "test_scenario.py",
    TESTS / "rehearse" / "test_simulate.py",
]


def names_in(file: Path) -> set[str]:
    tree = ast.parse(file.read_text(encoding="utf-8"))
    return {
        f"{file.relative_to(TESTS).as_posix()}::{node.name}"
        for node in tree.body
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")
    }


def test_every_cited_test_exists() -> None:
    assert CITED - set().union(*map(names_in, FILES)) == set()


@pytest.mark.parametrize("file", OF_RULES, ids=lambda file: file.name)
def test_every_test_of_a_rule_is_cited(file: Path) -> None:
    assert names_in(file) - CITED == set()


def test_every_row_of_the_page_cites_a_test() -> None:
    rows = [line for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")]
    rules = [row for row in rows if not re.match(r"\| (rule|choice|---) \|", row)]
    assert rules
    assert [row for row in rules if "::test_" not in row] == []
