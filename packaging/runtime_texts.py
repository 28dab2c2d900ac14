"""Gathers what the runtime says to people in the editor, as templates, for its translators.

Of ``situ.document`` problems, mends and differences; of ``situ.rehearse`` what happened, why
something did or did not, where two runs part, and what is wrong with a recording or a scenario.

packaging/texts.py uses it. A template is a text of the sources; where an f-string has a value, it
has ``{0}``, ``{1}`` … Texts without two words in a row are taken for names, and left out.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RUNTIME = ROOT / "runtime" / "situ"
SOURCES = (
    "document/*.py",
    *(f"rehearse/{name}.py" for name in ("past", "reason", "telling", "ways", "why", "why_*")),
    *(f"rehearse/{name}.py" for name in ("parting", "recorded", "recording", "scenario")),
)
QUIET = {"schema.py", "locate.py", "writer.py"}
"""Files whose texts no person reads in the editor."""
SAID = re.compile(r"[a-z]{2,}'?,? +(?:[\w<\"“({[]|$)|\}[^\w{}]* [a-z]{2,}|^: [a-z]|[a-z]{2,}: \{")


WORDS = {"exists", "empty", "wide", "high", "lies", "lie", "and", "or"}
WORDS |= {"state", "event", "timeout", "button", "text", "image", "movie", "input", "list"}
WORDS |= {"nothing", "well", "badly", "back", "you"}
"""Single words that are said too."""
XML = re.compile(r"^<\w+ \w+=|^<\w+/>$|<param |^<choice>|\\[sd]|^\^|\n")
"""Pieces of schemas, and regular expressions."""


def templates() -> list[str]:
    """Every template of the sources, sorted, each once."""
    found: set[str] = set()
    for file in (file for pattern in SOURCES for file in RUNTIME.glob(pattern)):
        if file.name not in QUIET:
            found.update(_said(ast.parse(file.read_text(encoding="utf-8"))))
    return sorted(found)


def _said(tree: ast.Module) -> Iterator[str]:
    silent = {id(one) for node in ast.walk(tree) for one in _silent(node)}
    for node in ast.walk(tree):
        if id(node) in silent:
            continue
        if isinstance(node, ast.JoinedStr):
            text = _template(node)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            text = node.value
        else:
            continue
        if text in WORDS or (SAID.search(text) and not XML.search(text)):
            yield text


def _silent(node: ast.AST) -> Iterator[ast.AST]:
    """What of a node is said to nobody, or is said as part of the node: docstrings, annotations,
    the pieces of f-strings.
    """
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
        yield node.value
    if isinstance(node, ast.JoinedStr):
        yield from (one for one in node.values if isinstance(one, ast.Constant))
    for annotation in (getattr(node, "annotation", None), getattr(node, "returns", None)):
        if isinstance(annotation, ast.AST):
            yield from ast.walk(annotation)


def _template(node: ast.JoinedStr) -> str:
    made, number = "", 0
    for piece in node.values:
        if isinstance(piece, ast.Constant):
            made += str(piece.value)
        else:
            made += f"{{{number}}}"
            number += 1
    return made
