"""What can be put into a document: a command for each kind of the palette."""

from __future__ import annotations

from situ_studio import kinds
from situ_studio.actions.command import Command, row

_CONTEXTS = {
    "state": "ground",
    "part": "ground",
    "always": "ground",
    "note": "ground",
    "frame": "ground states",
    "event": "state always",
    "timeout": "state always",
}
"""Where a new thing of a kind is offered in a context menu."""

INSERT: tuple[Command, ...] = tuple(
    row(
        f"insert.{kind.name}",
        kind.title,
        "insert",
        icon=kind.icon,
        menu="Insert",
        when=f"can_insert_{part}",
        shown=f"offers_{part}",
        argument=kind.name,
        rule=index == 0 and part != "application",
        tip=kind.help,
        contexts="screen" if part == "screen" else _CONTEXTS.get(kind.name, ""),
    )
    for part in ("application", "action", "screen", "drawing", "script", "modules")
    for index, kind in enumerate(k for k in kinds.KINDS if k.palette == part)
)
