"""Conditions, the same in an RBD's ``when`` and an SPDS's ``condition`` and ``until``.

formats.md, *Values, references, conditions*.
"""

from __future__ import annotations

from typing import Literal

from msgspec import Struct

from situ.document.aside import NOTHING, Aside

TestName = Literal["is", "isnot", "above", "below", "atleast", "atmost", "in", "exists"]
TESTS: tuple[TestName, ...] = (
    "is",
    "isnot",
    "above",
    "below",
    "atleast",
    "atmost",
    "in",
    "exists",
)
GroupName = Literal["all", "any", "none"]


class Test(Struct, frozen=True, gc=False):
    """``<data tag=… TEST=… within=… for=…/>``: one test of one name.

    tag: a name: a tag, or a tag and fields (``patients.0.room``).
    value: the test's text as written; in a ``when`` it may be one reference.
    within, hold: seconds above 0, or None (``hold`` is the attribute ``for``).
    """

    tag: str
    test: TestName
    value: str
    within: float | None = None
    hold: float | None = None
    aside: Aside = NOTHING


class Group(Struct, frozen=True, gc=False):
    """``<all>``, ``<any>``, ``<none>`` over any mix of tests and groups; valid: not empty."""

    kind: GroupName
    children: tuple[Test | Group, ...] = ()
    aside: Aside = NOTHING


class Condition(Struct, frozen=True, gc=False):
    """The content of ``when``, ``condition`` or ``until``: all of its children hold."""

    children: tuple[Test | Group, ...] = ()
    aside: Aside = NOTHING
