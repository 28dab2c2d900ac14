"""Holds sessions to their keys: what their rights refuse, and what of it all is written down."""

from __future__ import annotations

from typing import get_args

from msgspec.structs import replace

from situ.blackboard import protocol
from situ.blackboard.acting import No
from situ.blackboard.audit import Audit
from situ.blackboard.identity import Identity
from situ.blackboard.rights import Rights

_CHANGING = (
    protocol.Set,
    protocol.Publish,
    protocol.Use,
    protocol.Touch,
    protocol.Finish,
    *get_args(protocol.Debugging),
    protocol.Stage,
    protocol.Deploy,
    protocol.Rollback,
)


class Guard:
    """For sessions of a core with keys. Nothing passes that the ``rights`` do not allow."""

    def __init__(self, rights: Rights, audit: Audit) -> None:
        self.rights = rights
        self._audit = audit

    def greet(self, who: Identity | None, hello: protocol.Hello) -> protocol.Hello:
        """The hello, said in the name of the key. Raises ``No``."""
        why = self.rights.greeting(_known(who), hello)
        if why is not None:
            raise No("denied", why)
        return replace(hello, user=_known(who).name) if hello.role == "operator" else hello

    def check(
        self, who: Identity | None, role: protocol.Role, request: protocol.Request
    ) -> Identity:
        """Who may ask this. Raises ``No``."""
        identity = _known(who)
        why = self.rights.request(identity, role, request)
        if why is not None:
            raise No("denied", why)
        return identity

    def done(self, who: Identity, role: protocol.Role, request: protocol.Request) -> None:
        """What people change is written down."""
        if role == "operator" and isinstance(request, (*_CHANGING, protocol.Command)):
            self._audit.tell("changed", name=who.name, do=_do(request), what=_what(request))

    def refused(self, who: Identity | None, request: protocol.Request, no: No) -> None:
        """So is whoever was refused something that he may not do."""
        if isinstance(request, (protocol.Hello, *_CHANGING)) or no.code in ("denied", "role"):
            name = who.name if who is not None else "nobody"
            self._audit.refuse(
                "refused", name=name, do=_do(request), what=_what(request), why=str(no)
            )


def _known(who: Identity | None) -> Identity:
    if who is None:
        raise No("denied", "nobody who is known has this key; situ keys list tells who is")
    return who


def _do(request: protocol.Request) -> str:
    return str(request.__struct_config__.tag)


def _what(request: protocol.Request) -> str:
    if isinstance(request, protocol.Set):
        return ",".join(request.tags)
    if isinstance(request, protocol.Publish):
        return request.event
    if isinstance(request, protocol.Command):
        return request.resource
    if isinstance(request, protocol.Break):
        at = (request.application, request.state, request.source, request.to, request.situation)
        return ",".join(one for one in at if one is not None)
    if isinstance(request, protocol.Goto):
        return request.state
    if isinstance(request, protocol.Rollback):
        return "" if request.version is None else str(request.version)
    if isinstance(request, protocol.Stage):
        return f"{len(request.files)} files"
    if isinstance(request, (protocol.Pause, protocol.Resume, protocol.Step)):
        return request.application or ""
    if isinstance(request, protocol.Use):
        return request.component
    if isinstance(request, protocol.Hello):
        return request.module or request.user or request.role
    return ""
