"""What the documentation tells a newcomer to type can be typed, and what it links to is there."""

from __future__ import annotations

import argparse
import re
import shlex
from pathlib import Path

import pytest

from situ import cli

ROOT = Path(__file__).resolve().parent.parent
TYPED = [ROOT / "README.md", *sorted((ROOT / "examples").glob("*/README.md"))]
PAGES = [*TYPED, *sorted((ROOT / "docs").glob("*.md"))]


def name(page: Path) -> str:
    return str(page.relative_to(ROOT))


def commands(text: str) -> list[str]:
    """Lines of plain code blocks and inline code that call ``situ`` with something."""
    blocks = re.findall(r"^```\n(.*?)^```", text, re.M | re.S)
    lines = [line for block in blocks for line in block.splitlines()]
    prose = re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)
    return [line for line in [*lines, *re.findall(r"`([^`]+)`", prose)] if line.startswith("situ ")]


def command_names() -> set[str]:
    parser = cli.parser()
    (table,) = (a for a in parser._actions if isinstance(a, argparse._SubParsersAction))
    return set(table.choices)


@pytest.mark.parametrize("page", TYPED, ids=name)
def test_every_command_that_is_shown_can_be_typed(
    page: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for command in commands(page.read_text(encoding="utf-8")):
        words = shlex.split(command.replace("…", "WHAT"))[1:]
        if len(words) < 2:  # a command's name only, in prose
            assert words[0].strip(",") in command_names() | {"--help"}, command
            continue
        try:
            cli.parser().parse_args(words)
        except SystemExit:
            pytest.fail(f"{command}: {capsys.readouterr().err}")


def test_the_tour_has_commands() -> None:
    assert len(commands((ROOT / "README.md").read_text(encoding="utf-8"))) > 5


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_every_link_leads_somewhere(page: Path) -> None:
    links = re.findall(r"\]\((?!https?:|#)([^)#]+)", page.read_text(encoding="utf-8"))
    assert [link for link in links if not (page.parent / link).exists()] == []


def test_the_programs_that_the_tour_starts_are_there() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    programs = re.findall(r"python (examples/\S+\.py)", text)
    assert programs
    assert [program for program in programs if not (ROOT / program).is_file()] == []
