"""The blackboard for module authors: three lines to be useful.

::

    with situ.connect("tcp://127.0.0.1:5570", module="nod", resources=["head"]) as board:
        with board.authority("head") as head:
            for change in board.watch("speech.acceptable"):
                head.command({"pitch": 10 if change.value else 0}, valid=0.5)

``connect`` blocks where it waits; ``connect_async`` has the same names to be awaited. Both
are drivers of one ``Dialog``, which keeps the session and takes it up again after every
loss. ``Link`` is that dialog with its sockets for loops of other kinds (Qt).
"""

from __future__ import annotations

import getpass
import os
from collections.abc import Iterable

from situ.blackboard.asynchronous import AsyncAuthority, AsyncBoard, AsyncFollowing
from situ.blackboard.blocking import PATIENCE, Authority, Board, Following
from situ.blackboard.calls import Call, Person
from situ.blackboard.curve import Curve
from situ.blackboard.dialog import Dialog
from situ.blackboard.driving import Driver
from situ.blackboard.feeds import Change, Messages, TraceFeed, Watch
from situ.blackboard.keys import client_keys
from situ.blackboard.link import Link
from situ.blackboard.notices import Message
from situ.blackboard.protocol import Need, Offer, Role
from situ.blackboard.replies import Entry, Files, ModuleState, ModuleStates, Wanted, Welcome
from situ.blackboard.serving import ServiceRequest

__all__ = [
    "AsyncAuthority",
    "AsyncBoard",
    "AsyncFollowing",
    "Authority",
    "Board",
    "Call",
    "Change",
    "Dialog",
    "Entry",
    "Files",
    "Following",
    "Link",
    "Message",
    "Messages",
    "ModuleState",
    "ModuleStates",
    "Need",
    "Offer",
    "Person",
    "ServiceRequest",
    "TraceFeed",
    "Wanted",
    "Watch",
    "Welcome",
    "client_keys",
    "connect",
    "connect_async",
    "person",
]

ENDPOINT = "tcp://127.0.0.1:5570"


def person(
    module: str | None = None,
    resources: Iterable[str] = (),
    *,
    role: Role | None = None,
    description: str = "",
    requires: Iterable[Need] = (),
    provides: Iterable[Offer] = (),
    keys: Curve | None = None,
) -> Person:
    """Who connects: with a module's name that module, with the keys of a viewer a viewer, else
    the operator at this machine."""
    if role is None and keys is not None and keys.role == "viewer":
        role = "viewer"
    role = role or ("module" if module is not None else "operator")
    return Person(
        role=role,
        module=module,
        user=_user() if role == "operator" else None,
        # A string is one or several, as in XML, and never its letters.
        resources=tuple(resources.split() if isinstance(resources, str) else resources),
        description=description,
        requires=tuple(requires),
        provides=tuple(provides),
    )


def _user() -> str | None:
    try:
        return getpass.getuser()
    except (KeyError, OSError):  # no name for this user's number
        return None


def connect(
    endpoint: str = ENDPOINT,
    module: str | None = None,
    resources: Iterable[str] = (),
    *,
    role: Role | None = None,
    description: str = "",
    requires: Iterable[Need] = (),
    provides: Iterable[Offer] = (),
    timeout: float = PATIENCE,
    keys: str | os.PathLike[str] | None = None,
) -> Board:
    """A blackboard that is connected; end it with ``close`` or by ``with``.

    module: this module's name; None for a person that looks and sets. resources: those
    it may ask for. timeout: seconds to wait, here and for each later answer. keys: the folder
    with this one's keys, for a robot that lets in only whom it knows; ``$SITU_KEYS`` unless
    given, else ``~/.config/situ/keys`` if it has this robot.

    Raises Unreachable when nobody answers, Refused when the core will not have it (the
    name is taken by another module that lives), UsageError for an address that is none.
    """
    curve = client_keys(endpoint, keys)
    who = person(
        module,
        resources,
        role=role,
        description=description,
        requires=requires,
        provides=provides,
        keys=curve,
    )
    return Board(Driver(Link(endpoint, who, keys=curve)), timeout)


def connect_async(
    endpoint: str = ENDPOINT,
    module: str | None = None,
    resources: Iterable[str] = (),
    *,
    role: Role | None = None,
    description: str = "",
    requires: Iterable[Need] = (),
    provides: Iterable[Offer] = (),
    timeout: float = PATIENCE,
    keys: str | os.PathLike[str] | None = None,
) -> AsyncBoard:
    """As ``connect``, for asyncio: ``async with connect_async(…) as board``."""
    curve = client_keys(endpoint, keys)
    who = person(
        module,
        resources,
        role=role,
        description=description,
        requires=requires,
        provides=provides,
        keys=curve,
    )
    return AsyncBoard(Link(endpoint, who, keys=curve), timeout)
