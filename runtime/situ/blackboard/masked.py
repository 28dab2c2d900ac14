"""What a core shows those who may not see the project's private values (docs/security.md).

Nothing of it costs anything before the first of them has come.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import msgspec
from msgspec import Raw, Struct

from situ.blackboard import replies
from situ.blackboard.backlog import Backlog
from situ.decide.board import Board
from situ.decide.expected import Expectation
from situ.decide.masking import Mask
from situ.document.project import Project


class _Data(Struct):
    tag: str
    value: Any


_DATA = b'{"kind":"data"'
_data = msgspec.json.Decoder(_Data)


def learned(project: Project, board: Board, backlog: Backlog) -> Mask:
    """The mask of a project, which knows what stands on the board now and what the backlog has
    of what stood there before."""
    mask = Mask.of(project)
    for line in backlog:
        if line.startswith(_DATA):
            event = _data.decode(line)
            mask.know(event.tag, event.value)
    for tag, entry in board.state.items():
        mask.know(tag, entry.value)
    return mask


def events(mask: Mask, lines: Iterable[bytes]) -> tuple[Raw, ...]:
    """Trace events as JSON, the same without what is private."""
    shown = mask.step([msgspec.json.decode(line) for line in lines])
    return tuple(Raw(msgspec.json.encode(event)) for event in shown)


def entries(mask: Mask, found: Mapping[str, replies.Entry]) -> dict[str, replies.Entry]:
    return {
        tag: msgspec.structs.replace(entry, value=mask.shown(tag, entry.value, entry.writer or ""))
        for tag, entry in found.items()
    }


def expectations(mask: Mask, told: Mapping[str, Expectation]) -> dict[str, Expectation]:
    """What people may say may hold what was filled in."""
    return {
        name: msgspec.structs.replace(
            one,
            events=tuple(
                msgspec.structs.replace(event, says=tuple(map(mask.text, event.says)))
                for event in one.events
            ),
        )
        for name, one in told.items()
    }
