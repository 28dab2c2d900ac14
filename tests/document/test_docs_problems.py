"""docs/problems.md is true: every code has its section, and every example does what it says.

The format stands at the top of the page itself.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from msgspec import Struct

from situ.document.check import check, merge
from situ.document.folder import load
from situ.document.problem import Problem
from situ.document.project import Project

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "problems.md"
SOURCES = ROOT / "runtime" / "situ" / "document"

TELLERS = {
    "error",
    "warning",
    "warn",
    "problem",
    "bad",
    "Finding",
    "Found",
    "Problem",
    "append",
}
"""What is called with a code, among other texts."""

NO_CODES = {"utf-8", "utf-8-sig", "us-ascii", "event-driven"}
"""Constants of the sources that look like a code and are none."""

_KEBAB = re.compile(r"[a-z]+(-[a-z0-9]+)+")
_FENCE = re.compile(r"^```(\w*) ?(\S*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_NAMES = {"application": "example.rbd.xml", "spds": "example.spds.xml", "modules": "modules.xml"}


class Example(Struct, frozen=True):
    """Files by name, as they fail and as they are mended."""

    code: str
    failing: dict[str, str]
    mended: dict[str, str]


def sections() -> dict[str, str]:
    """By code, what the page says of it."""
    parts = re.split(r"^### (\S+)$", PAGE.read_text(), flags=re.MULTILINE)
    codes = parts[1::2]
    assert len(codes) == len(set(codes)), "a code has two sections"
    return dict(zip(codes, parts[2::2], strict=True))


def blocks(text: str) -> dict[str, str]:
    """Fenced blocks by the name of the file."""
    found: dict[str, str] = {}
    for language, name, content in _FENCE.findall(text):
        if not name and language == "toml":
            name = "situ.toml"
        if not name:
            root = re.search(r"<(application|spds|modules)\b", content)
            assert root is not None, f"name the file of this block:\n{content}"
            name = _NAMES[root[1]]
        assert name not in found, f"two blocks are {name}"
        found[name] = content
    return found


def examples() -> Iterator[Example]:
    for code, text in sections().items():
        pieces = re.split(r"^(Failing|Mended):$", text, flags=re.MULTILINE)
        kinds = pieces[1::2]
        assert kinds == ["Failing", "Mended"] * (len(kinds) // 2), f"{code}: Failing, then Mended"
        shown = [blocks(piece) for piece in pieces[2::2]]
        for failing, mended in zip(shown[::2], shown[1::2], strict=True):
            yield Example(code, failing, {**failing, **mended})


EXAMPLES = list(examples())
NUMBERED = [f"{one.code}-{number}" for number, one in enumerate(EXAMPLES)]


def checked(folder: Path, files: dict[str, str]) -> tuple[Project | None, list[Problem]]:
    """The project of the files, and its problems: as ``situ check`` tells them."""
    for name, content in files.items():
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(content)
    documents = [name for name in files if name.endswith(".xml")]
    single = "situ.toml" not in files and "modules.xml" not in files
    single = single and len({name.split(".")[1] for name in documents}) == 1
    if "situ.toml" not in files and not single and len(documents) > 1:
        (folder / "situ.toml").write_text(_table(documents))
    has_table = (folder / "situ.toml").exists()
    project, found = load(folder if has_table else folder / documents[0])
    return project, merge(found, check(project)) if project is not None else found


def _table(documents: list[str]) -> str:
    """A project of these documents."""
    lines = [f"applications = {[n for n in documents if n.endswith('.rbd.xml')]}"]
    lines += [f'spds = "{name}"' for name in documents if name.endswith(".spds.xml")]
    lines += [f'modules = "{name}"' for name in documents if name == "modules.xml"]
    return "\n".join(["[project]", *lines, ""])


def codes_in(tree: ast.AST) -> Iterator[str]:
    """Every constant of a source that is a code: by its form, or by who is called with it."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            if _KEBAB.fullmatch(node.value) and node.value not in NO_CODES:
                yield node.value
        elif isinstance(node, ast.Call):
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            if name in TELLERS:
                given = [*node.args[:2], *(k.value for k in node.keywords if k.arg == "code")]
                texts = [str(one.value) for one in given if isinstance(one, ast.Constant)]
                yield from (one for one in texts if re.fullmatch(r"[a-z]{2,}", one))


def source_codes() -> set[str]:
    return {
        code
        for file in sorted(SOURCES.glob("*.py"))
        for code in codes_in(ast.parse(file.read_text()))
    }


def test_every_code_has_a_section_and_every_section_a_code() -> None:
    told, given = set(sections()), source_codes()
    assert sorted(given - told) == [], "no section in docs/problems.md"
    assert sorted(told - given) == [], "a section of docs/problems.md without a code"


@pytest.mark.parametrize("code", sections())
def test_a_section_tells_what_why_and_what_to_do(code: str) -> None:
    text = sections()[code]
    assert re.match(r"\n+\*(error|warning|error or warning)\* · \S", text), "begin: *error* · …"
    assert "\n**Why.** " in text
    assert "\n**Do.** " in text
    shown = any(one.code == code for one in EXAMPLES)
    assert shown != ("\n**Example.** None: " in text), (
        "Failing: and Mended:, or say why there is none"
    )


@pytest.mark.parametrize("example", EXAMPLES, ids=NUMBERED)
def test_an_example_fails_as_it_says_alone_and_its_mended_form_has_no_problem(
    tmp_path: Path, example: Example
) -> None:
    failing, mended = tmp_path / "failing", tmp_path / "mended"
    failing.mkdir()
    mended.mkdir()
    _, found = checked(failing, example.failing)
    _, left = checked(mended, example.mended)
    said = [str(problem) for problem in (*found, *left)]
    told = [problem for problem in found if problem.code == example.code]
    assert told, said
    assert all(problem.line > 0 for problem in told), said
    severity = sections()[example.code].split("*")[1]
    assert all(problem.severity in severity for problem in told), said
    assert {p.code for p in found} == {example.code}, said
    assert left == [], said
