"""No English is said past the translators: every sentence in the editor's sources is theirs."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from tests.gui.test_texts import JAPANESE

import situ_studio

SOURCES = Path(situ_studio.__file__).parent
SENTENCE = re.compile(r"[A-Za-z]{2,}[,:;.!?]? +[A-Za-z“({]|\}[,:;.]? +[a-z]{2,}")
"""Two words in a row, or one beside a value."""
HOLE = re.compile(r"\{\d*\}")
STYLE = re.compile(r"\(\?|[\w-]+: [^;]+;|\{\s*[\w-]+:|<\w+ \w+=|::")
"""Sheets of style, marks around what is shown, and patterns."""
TOLD = {"tr", "translated", "say", "said", "translate"}
"""Whoever asks the translators."""
QUIET = {"debug", "info", "warning", "error", "exception", "setObjectName"}
"""Whoever writes into the log, and gives names."""
ELSEWHERE = {"main.py", "actions"}
"""The command, which speaks English; and the table of commands, whose texts are gathered by field:
what else has blanks there are lists of names."""
KEYS = {
    "action", "chip", "earlier", "example", "exit", "extends", "forget", "lacks", "locate",
    "module", "over", "phrase", "ran", "resource", "row", "situation", "template", "type",
}  # fmt: skip
"""What the sources call one of several by, with its name behind: nobody reads that."""
UNREAD = {
    "Noto Sans": "a typeface",
    "Noto Sans CJK JP": "a typeface",
    "Situ Studio {}": "our name",
    "Situ Studio {}, Python {}, Qt {}, {}": "what a report of a fault begins with",
    "gettext (*.po)": "a format's name",
    "gettext (*.po *.pot)": "a format's name",
    "Ctrl N": "keys",
    "Ctrl O": "keys",
    "Ctrl R": "keys",
    "rolled back": "a word of the robot's, which has its sentence",
    "what can not be saved": "what a notice is about, for the studio",
    "clearing a folder": "a thread's name",
    "reading a project": "a thread's name",
    "{}:{} in {}": "a line of the log",
    "{} loop": "whose way a pipe may share",
    "there is nothing at {}": "a broken promise",
    "extends none": "what is typed to find an entry of a menu",
}
"""Sentences that translators do not get, and why."""


@pytest.fixture(scope="module")
def known() -> set[str]:
    """What translators have, with nothing in its holes."""
    return {HOLE.sub("{}", text) for _, text, _ in JAPANESE}


def untold(tree: ast.AST, known: set[str]) -> Iterator[tuple[int, str]]:
    """(line, text) of the sentences for people that no translator gets."""
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        text, inside = _said(node)
        waiting.extend(inside)
        # The help's paragraphs, each in one line.
        for part in text.split("\n\n"):
            one = HOLE.sub("{}", " ".join(part.split()))
            if not SENTENCE.search(one) or STYLE.search(one):
                continue
            if one not in known and one not in UNREAD and one.removesuffix(" {}") not in KEYS:
                yield getattr(node, "lineno", 0), one


def _said(node: ast.AST) -> tuple[str, Iterable[ast.AST]]:
    """The text that it is, with ``{}`` where values are; and what in it may be another one."""
    match node:
        case ast.Call(func=ast.Name(id=called) | ast.Attribute(attr=called)):
            return "", () if called in TOLD | QUIET else ast.iter_child_nodes(node)
        case ast.Expr(value=ast.Constant()):
            return "", ()
        case ast.AnnAssign():
            return "", (node.value,) if node.value is not None else ()
        case ast.Constant(value=str(text)):
            return text, ()
        case ast.JoinedStr():
            values = [one for one in node.values if not isinstance(one, ast.Constant)]
            pieces = (one.value if isinstance(one, ast.Constant) else "{}" for one in node.values)
            return "".join(map(str, pieces)), values
    return "", ast.iter_child_nodes(node)


def told_to_none(file: str, source: str, known: set[str]) -> list[str]:
    return [f"{file}:{line}: {text}" for line, text in untold(ast.parse(source), known)]


def test_no_sentence_of_the_editor_is_kept_from_translators(known: set[str]) -> None:
    found = [
        one
        for file in sorted(SOURCES.rglob("*.py"))
        if ELSEWHERE.isdisjoint(file.relative_to(SOURCES).parts)
        for one in told_to_none(file.name, file.read_text(encoding="utf-8"), known)
    ]
    assert found == []


@pytest.mark.parametrize(
    "source",
    [
        'FOLLOWS = (Follow("", "What shall follow?"),)',
        'menu.addAction("Take this out")',
        'text = f"Put {count} cards in order"',
        'guard = f"if {leaving.guard}"',
        'raise UsageError(f"{file}: gone from here")',
    ],
)
def test_a_sentence_that_no_translator_gets_is_found(source: str) -> None:
    assert told_to_none("a.py", source, set()) != []


def test_a_sentence_that_translators_get_is_left(known: set[str]) -> None:
    assert told_to_none("a.py", 'tr("Take this out"); self.tr("Take {0} out")', set()) == []
    assert told_to_none("a.py", 'TABLE = ("Put on the grid",)', known) == []
