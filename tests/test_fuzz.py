"""Files from anybody, damaged at random: only our own errors come out, each one line.

A few hundred a run; ``make fuzz`` (``SITU_FUZZ=SECONDS``) goes on for so long with each kind of
file. A failure names its seed, with which it can be made again.
"""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.document import codec, texts
from situ.document.check import check, merge
from situ.document.folder import load
from situ.document.problem import Problem
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.errors import ScenarioError
from situ.rehearse import scenario
from situ.rehearse.simulate import simulate

EXAMPLES = Path(__file__).parents[1] / "examples"
SECONDS = float(os.environ.get("SITU_FUZZ", "0"))
LAST = 900_000_000
"""µs; no damaged scenario is played for longer."""

RECEPTION, _ = load(EXAMPLES / "reception")
assert RECEPTION is not None

PIECES: dict[str, tuple[bytes, ...]] = {
    "xml": (
        *(b"<", b">", b"&", b'"', b"'", b"/", b"<!--", b"-->", b"]]>", b"<![CDATA[", b"<?a b?>"),
        *(b"<a:b/>", b' xmlns:a="u"', b' xmlns="u"', b"&#0;", b"&#x10FFFF;", b"&a;", b"\xff"),
        *(b"<!DOCTYPE a>", b"{", b"}", b"{{a}}", b"{a.b}", b"-1", b"1e9", b"NaN", b"#back"),
        *(b"<all>", b"</all>", b"<any/>", b"<repeat/>", b'next="1"', b' no="1"', b"\0", b"\r\n"),
    ),
    "toml": (
        *(b"[", b"]", b"[[", b"]]", b"=", b'"', b"'", b'"""', b"{", b"}", b",", b"#", b"\\u0000"),
        *(b"[project]\n", b"[[setting]]\n", b"inf", b"nan", b"1e999", b"0x1", b"2026-11-21"),
        *(b"true", b"a.b.c", b'".."', b'"/"', b"\xff", b"\0", b"\r", b"[" * 500, b"[tags]\n"),
    ),
    "jsonl": (
        *(b"{", b"}", b"[", b"]", b":", b",", b'"', b"\n", b"null", b"true", b"-1", b"1e308"),
        *(b"1e999", b"NaN", b'"end":true', b'"at":', b'"set":{}', b'"for":', b"\\ud800", b"\xff"),
        *(b'{"at":1,"touch":true}\n', b"[" * 2000, b'"finish":{}', b'"value":', b"\0", b"9" * 400),
    ),
    "po": (
        *(
            b'msgid "a"\n',
            b'msgstr "b"\n',
            b"msgctxt",
            b"msgid_plural",
            b"msgstr[0]",
            b"#~ ",
            b"#,",
        ),
        *(
            b'"',
            b"\\",
            b"\\n",
            b"\n\n",
            b"#| ",
            b"fuzzy",
            b"\xff",
            b"\0",
            b"\xef\xbb\xbf",
            b"charset=",
        ),
    ),
}


def wounded(data: bytes, pieces: tuple[bytes, ...], dice: Random) -> bytes:
    """The data with a few bytes changed, cut out, doubled, or pieces of its kind put in."""
    made = bytearray(data)
    for _ in range(dice.randint(1, 8)):
        at = dice.randrange(len(made) + 1)
        kind = dice.randrange(6)
        if kind == 0 and at < len(made):
            made[at] = dice.randrange(256)
        elif kind == 1:
            del made[at : at + dice.randint(1, 60)]
        elif kind == 2:
            made[at:at] = made[dice.randrange(len(made) + 1) :][: dice.randint(1, 200)]
        elif kind == 3 and dice.random() < 0.1:
            del made[at:]
        else:
            made[at:at] = dice.choice(pieces)
    return bytes(made)


ODD: tuple[Any, ...] = (
    *(None, True, -1, 0.5, 1e300, 10**400, "", "a", "{a}", "#back", "\ud800", "\0", "2", "robot/x"),
    *([], [[]], {}, {"a": {"b": None}}, ["a", 1], {"": ""}, "start", "clickContinue", "language"),
)


def odd(value: Any, dice: Random, depth: int = 0) -> Any:
    """A line of a scenario with now and then another value in it; its time stays."""
    if depth and dice.random() < 0.02:
        return dice.choice(ODD)
    if isinstance(value, dict):
        return {k: v if k == "at" else odd(v, dice, depth + 1) for k, v in value.items()}
    if isinstance(value, list):
        return [odd(one, dice, depth + 1) for one in value]
    return value


def told_well(problems: list[Problem]) -> None:
    for problem in problems:
        assert "\n" not in str(problem)
        assert problem.code
        assert problem.message


def xml(dice: Random, _folder: Path) -> None:
    source = dice.choice(sorted(EXAMPLES.glob("*/*.xml")))
    document, problems = codec.read(wounded(source.read_bytes(), PIECES["xml"], dice), "a.xml")
    told_well(problems)
    assert document is not None or problems
    if document is None:
        return
    again, after = codec.read(codec.write(document), "a.xml")
    project = Project(root="nowhere", name="a")
    if isinstance(document, Application):
        project = Project(root="nowhere", name="a", applications={"a.rbd.xml": document})
    elif isinstance(document, Spds):
        project = Project(root="nowhere", name="a", spds_file="a.spds.xml", spds=document)
    told_well(check(project))
    if not problems:
        assert (again, after) == (document, [])


def toml(dice: Random, folder: Path) -> None:
    source = dice.choice(sorted(EXAMPLES.glob("*/situ.toml")))
    data = wounded(source.read_bytes(), PIECES["toml"], dice)
    (folder / dice.choice(("situ.toml", "robot.local.toml"))).write_bytes(data)
    if not (folder / "situ.toml").exists():
        (folder / "situ.toml").write_bytes(source.read_bytes())
    project, problems = load(folder)
    told_well(merge(problems, check(project)) if project is not None else problems)
    for file in folder.iterdir():
        file.unlink()


def jsonl(dice: Random, _folder: Path) -> None:
    source = dice.choice(sorted(EXAMPLES.glob("reception/scenarios/*.jsonl")))
    data = source.read_bytes()
    if dice.random() < 0.7:
        data = b"\n".join(json.dumps(odd(json.loads(x), dice)).encode() for x in data.splitlines())
    else:
        data = wounded(data, PIECES["jsonl"], dice)
    try:
        lines = scenario.parse(data, "s.jsonl", ["reception"])
    except ScenarioError as error:
        told = str(error)
        lines = []
    else:
        told = "s.jsonl:"
    assert told.startswith("s.jsonl:")
    assert "\n" not in told
    assert RECEPTION is not None
    simulate(RECEPTION, [line for line in lines if line.at <= LAST])


def po(dice: Random, _folder: Path) -> None:
    source = dice.choice(sorted(EXAMPLES.glob("*/texts/*.po")))
    data = wounded(source.read_bytes(), PIECES["po"], dice)
    found, readings, problems = texts.read(data, "ja.po")
    told_well(problems)
    assert all(
        isinstance(one, str) for kept in (found, readings) for pair in kept.items() for one in pair
    )


KINDS: dict[str, tuple[Callable[[Random, Path], None], int]] = {
    "xml": (xml, 60),
    "toml": (toml, 150),
    "jsonl": (jsonl, 80),
    "po": (po, 120),
}
"""By kind of file, what is done with one, and with how many in a run."""


@pytest.mark.parametrize("kind", KINDS)
def test_a_damaged_file_gives_only_our_own_errors(kind: str, tmp_path: Path) -> None:
    judge, many = KINDS[kind]

    if SECONDS:
        seed = Random().randrange(2**48)
        end = time.monotonic() + SECONDS
        while time.monotonic() < end:
            seed += 1
            try:
                judge(Random(seed), tmp_path)
            except Exception as error:
                raise AssertionError(f"{kind}, seed {seed}") from error
        return

    @given(seed=st.integers(0, 2**48))
    @settings(max_examples=many, deadline=None, database=None)
    def judged(seed: int) -> None:
        judge(Random(seed), tmp_path)

    judged()
