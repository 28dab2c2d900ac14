"""What the care lints do to a document at a click."""

from __future__ import annotations

from typing import Any

from situ.document.analysis_search import Search
from situ.document.finding import Place
from situ.document.mend import change, of
from situ.document.place import Path, follow
from situ.document.problem import Mend


def path_to(search: Search, file: str, place: Place, value: Any) -> Path | None:
    """The path to a value; None where its place is also another's: two have the same name."""
    found = follow(of(search.project, file), place)
    return found[0] if found is not None and found[1][-1] is value else None


def puts(
    search: Search, file: str, place: Place, value: Any, said: str, **fields: Any
) -> Mend | None:
    """The mend that gives fields of a value other values; ``said``: what it does."""
    path = path_to(search, file, place, value)
    if path is None:
        return None
    changes = [change(path, value, field, to) for field, to in fields.items()]
    return search.mend(file, said, *changes)
