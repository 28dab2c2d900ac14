"""Situ: situated priorities and robot behaviour descriptions, executed.

The packages, each importing only those to its right:
``engine -> blackboard, rehearse -> decide -> document -> errors``.

For module authors: ``situ.connect`` and ``situ.connect_async`` (``situ.blackboard.client``),
loaded when first used.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.blackboard.client import connect as connect
    from situ.blackboard.client import connect_async as connect_async

__version__ = "0.1.0"


def __getattr__(name: str) -> Any:
    if name in ("connect", "connect_async"):
        from situ.blackboard import client

        return getattr(client, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
