"""A file may come from anybody: each of these is one problem with its place, never more."""

from __future__ import annotations

import random
import re
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from situ.document import codec
from situ.document.reader import MAX_DEPTH, MAX_ELEMENTS
from situ.document.start_tags import MAX_TEXT

HEAD = b'<application name="a">'


def only_problem(data: bytes) -> tuple[str, int, int]:
    document, problems = codec.read(data, "a.xml")
    assert document is None
    assert len(problems) == 1, problems
    (problem,) = problems
    assert "\n" not in str(problem)
    assert len(str(problem)) < 300
    return problem.code, problem.line, problem.column


BOMB = (
    b'<?xml version="1.0"?>\n<!DOCTYPE a [<!ENTITY a "aaaaaaaaaa">'
    + b"".join(b'<!ENTITY %c "%s">' % (98 + i, b"&%c;" % (97 + i) * 10) for i in range(9))
    + b']>\n<application name="&j;"/>'
)
EXTERNAL = b'<!DOCTYPE a [<!ENTITY x SYSTEM "file:///etc/passwd">]><application name="&x;"/>'


@pytest.mark.parametrize(
    "data",
    [BOMB, EXTERNAL, b'<!DOCTYPE application SYSTEM "http://127.0.0.1:1/a.dtd"><application/>'],
)
def test_a_doctype_is_refused_before_anything_in_it_counts(data: bytes) -> None:
    code, line, _ = only_problem(data)
    assert (code, line) == ("doctype", data[: data.index(b"<!DOCTYPE")].count(b"\n") + 1)


def test_an_entity_without_doctype_is_malformed() -> None:
    assert only_problem(HEAD + b"\n<state no='&x;'/></application>")[:2] == ("malformed-xml", 2)


@pytest.mark.parametrize("inner", [b"<x>", b"<o:x xmlns:o='u'>"])
def test_depth_is_bounded(inner: bytes) -> None:
    document, problems = codec.read(HEAD + inner * 10_000, "a.xml")
    assert document is None
    assert problems[-1].code == "too-deep"
    deep = SPDS_HEAD + b"<all>" * (MAX_DEPTH + 1)
    assert only_problem(deep)[0] == "too-deep"


SPDS_HEAD = b'<spds name="a"><situation name="s"><condition>'


def test_a_document_as_deep_as_may_be_is_read_and_written() -> None:
    levels = MAX_DEPTH - 4
    data = (
        SPDS_HEAD
        + b"<all>" * levels
        + b'<data tag="a" is="1"/>'
        + b"</all>" * levels
        + b"</condition></situation></spds>"
    )
    document, problems = codec.read(data, "a.xml")
    assert document is not None
    assert problems == []
    assert codec.write(document).count(b"<all>") == levels


@pytest.mark.parametrize("one", [b'<state no="1"/>', b"<o:x xmlns:o='u'/>"])
def test_the_number_of_elements_is_bounded(one: bytes) -> None:
    assert only_problem(HEAD + one * (MAX_ELEMENTS + 1) + b"</application>")[0] == "too-many"


@pytest.mark.parametrize("one", [b'<state no="1"/>', b"<o:x xmlns:o='u'/>"])
def test_it_is_bounded_too_where_end_tags_in_a_comment_hide_it(
    monkeypatch: pytest.MonkeyPatch, one: bytes
) -> None:
    monkeypatch.setattr("situ.document.reader.MAX_ELEMENTS", 50)
    data = HEAD + b"<!-- " + b"</" * 60 + b" -->" + one * 50 + b"</application>"
    assert only_problem(data)[0] == "too-many"


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b'<application name="' + b"a" * (MAX_TEXT + 1) + b'"/>', "too-long"),
        (b'<application name="a" ' + b"x" * 5_000_000 + b'="1"/>', "unknown-attribute"),
        (
            HEAD
            + b'<state no="1"><backgroundactions><speech>'
            + b"a" * (MAX_TEXT + 1)
            + b"</speech></backgroundactions></state></application>",
            "too-long",
        ),
        (HEAD + b"a" * 5_000_000 + b"</application>", "unexpected-text"),
        (b"<" + b"a" * 5_000_000 + b"/>", "unknown-element"),
        (
            b'<application name="a" start="1"><state no="' + b"1" * 900_000 + b'"/></application>',
            "",
        ),
    ],
)
def test_size_is_bounded_and_no_message_repeats_it(data: bytes, code: str) -> None:
    _, problems = codec.read(data, "a.xml")
    assert {problem.code for problem in problems} == ({code} if code else set())
    assert all(len(str(problem)) < 300 for problem in problems)


def test_the_number_of_problems_is_bounded() -> None:
    _, problems = codec.read(HEAD + b"<x/>" * 100_000 + b"</application>", "a.xml")
    assert len(problems) == 100


@pytest.mark.parametrize(
    ("data", "place"),
    [
        (HEAD + b"\n<!-- \xff -->", (2, 6)),
        (b'<application name="\xe4"/>', (1, 20)),
        ("<application/>".encode("utf-16"), (1, 1)),
        (HEAD + b"\n  a\xc3", (2, 4)),
    ],
)
def test_what_is_not_utf8_is_told_with_its_place(data: bytes, place: tuple[int, int]) -> None:
    document, problems = codec.read(data, "a.xml")
    assert document is None
    assert problems[-1].code == "malformed-xml"
    assert "UTF-8" in problems[-1].message
    assert (problems[-1].line, problems[-1].column) == place


def test_another_declared_encoding_is_refused() -> None:
    assert only_problem(b'<?xml version="1.0" encoding="latin-1"?><application/>')[0] == "not-utf-8"


def test_a_byte_order_mark_does_not_matter() -> None:
    document, problems = codec.read(
        b"\xef\xbb\xbf" + HEAD + b"<o:x xmlns:o='u'/></application>", "a"
    )
    assert problems == []
    assert document is not None
    assert document.aside.inside == ("<o:x xmlns:o='u'/>",)


def test_nul_is_told_by_its_name() -> None:
    _, problems = codec.read(b'<application name="\0"/>', "a.xml")
    assert [(p.code, p.line, p.column) for p in problems] == [("malformed-xml", 1, 20)]
    assert "NUL" in problems[0].message


@given(st.integers(0, 2**32), st.integers(1, 8))
@settings(
    max_examples=200,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
def test_a_damaged_file_is_read_or_refused_but_never_raises(
    example: bytes, seed: int, wounds: int
) -> None:
    dice = random.Random(seed)
    data = bytearray(example)
    for _ in range(wounds):
        at = dice.randrange(len(data))
        kind = dice.randrange(4)
        if kind == 0:
            data[at] = dice.randrange(256)
        elif kind == 1:
            del data[at : at + dice.randrange(1, 40)]
        elif kind == 2:
            data[at:at] = data[dice.randrange(len(data)) :][:60]
        else:
            data[at:at] = dice.choice([b"<", b">", b"&", b'"', b"<!--", b"]]>", b"<?", b"<a:b/>"])
        if not data:
            break
    document, problems = codec.read(bytes(data), "a.xml")
    assert document is not None or problems
    assert all(p.line >= 1 and p.column >= 1 for p in problems), [str(p) for p in problems]
    if document is not None:
        codec.write(document)


HOSTILE: dict[str, tuple[bytes, str, int]] = {
    "an entity bomb": (BOMB, "doctype", 2),
    "an external entity": (b"\n" + EXTERNAL, "doctype", 2),
    "a DOCTYPE": (b"\n\n<!DOCTYPE application><application/>", "doctype", 3),
    "10,000 elements deep": (HEAD + b"\n<x>" * 10_000, "unknown-element", 2),
    "conditions 10,000 deep": (SPDS_HEAD + b"\n<all>" * 10_000, "too-deep", 199),
    "a million siblings": (HEAD + b'\n<state no="1"/>' * 1_000_000, "too-many", 300_001),
    "a million strangers": (HEAD + b"\n<x/>" * 1_000_000, "too-many", 300_001),
    "a million foreign siblings": (
        HEAD + b"\n<o:x xmlns:o='u'/>" * 1_000_000,
        "too-many",
        300_001,
    ),
    "an attribute of 11 MB": (
        b'\n<application name="' + b"a" * 11_000_000 + b'"/>',
        "too-long",
        2,
    ),
    "a name of 11 MB": (b"\n<" + b"a" * 11_000_000 + b"/>", "unknown-element", 2),
    "a text of 11 MB": (HEAD + b"\n" + b"a" * 11_000_000 + b"</application>", "unexpected-text", 1),
    "a comment of 11 MB": (HEAD + b"\n<!--" + b"a" * 11_000_000, "malformed-xml", 2),
    "not UTF-8": (HEAD + b"\n\n<state no='\xe4'/></application>", "malformed-xml", 3),
    "NUL": (HEAD + b"\n<state no='\0'/></application>", "malformed-xml", 2),
}

MOST = 200_000
"""kB of memory that ``situ check`` takes at most, the interpreter included."""

CHILD = r"""
import re, resource, sys
resource.setrlimit(resource.RLIMIT_AS, (1_000_000_000, 1_000_000_000))
from situ import cli
for file in sys.argv[1:]:
    cli.main(["check", file])
print(re.search(r"VmHWM:\s*(\d+)", open("/proc/self/status").read())[1], file=sys.stderr)
"""


def test_a_hostile_file_is_a_line_with_its_place_and_takes_little_memory(tmp_path: Path) -> None:
    files: dict[str, str] = {}
    for number, (what, (data, _, _)) in enumerate(HOSTILE.items()):
        file = tmp_path / f"{number}.{'spds' if data.startswith(SPDS_HEAD) else 'rbd'}.xml"
        file.write_bytes(data)
        files[what] = str(file)
    done = subprocess.run(
        [sys.executable, "-c", CHILD, *files.values()], capture_output=True, text=True, check=True
    )
    for what, (_, code, line) in HOSTILE.items():
        first = next(one for one in done.stdout.splitlines() if one.startswith(files[what]))
        assert first.startswith(f"{files[what]}:{line}:"), what
        assert re.match(rf":\d+: error {code} .", first[len(f"{files[what]}:{line}") :]), first
        assert len(first) < 300 + len(files[what])
    assert int(done.stderr) <= MOST


def test_reading_leaves_the_recursion_limit_alone() -> None:
    before = sys.getrecursionlimit()
    codec.read(HEAD * 5000, "a.xml")
    assert sys.getrecursionlimit() == before
