"""Situ: situated priorities and robot behaviour descriptions, executed.

The packages, each importing only those to its right:
``engine -> blackboard, rehearse -> decide -> document -> errors``.

For module authors (docs/modules.md): ``situ.connect`` and ``situ.connect_async`` with what they
give and take (``situ.blackboard.client``), loaded when first used; ``situ.testing``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from situ.blackboard.client import AsyncAuthority as AsyncAuthority
    from situ.blackboard.client import AsyncBoard as AsyncBoard
    from situ.blackboard.client import Authority as Authority
    from situ.blackboard.client import Board as Board
    from situ.blackboard.client import Change as Change
    from situ.blackboard.client import Need as Need
    from situ.blackboard.client import Offer as Offer
    from situ.blackboard.client import connect as connect
    from situ.blackboard.client import connect_async as connect_async

__version__ = "0.1.0"

_CLIENT = (
    *("AsyncAuthority", "AsyncBoard", "Authority", "Board", "Change", "Need", "Offer"),
    *("connect", "connect_async"),
)


def __getattr__(name: str) -> Any:
    if name in _CLIENT:
        from situ.blackboard import client

        return getattr(client, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_CLIENT})
