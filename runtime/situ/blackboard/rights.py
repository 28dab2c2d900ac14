"""Who may do what, once there are keys (docs/security.md has the table).

Pure: an identity, what it asks, and why not. What is not allowed here is refused, whatever it
is; what is allowed must still be so by the rules of the blackboard.
"""

from __future__ import annotations

from typing import get_args

from situ.blackboard import protocol
from situ.blackboard.identity import ROBOT, Identity
from situ.blackboard.protocol import Request
from situ.decide.world import untraced
from situ.document import names
from situ.document.project import Project

_LOOKING = frozenset[type[Request]](
    {
        protocol.Heartbeat,
        protocol.Get,
        protocol.Watch,
        protocol.Unwatch,
        protocol.Trace,
        protocol.Progress,
        protocol.History,
        protocol.Documents,
        protocol.Expected,
        protocol.Modules,
        protocol.Bye,
    }
)
ALLOWED: dict[protocol.Role, frozenset[type[Request]]] = {
    "viewer": _LOOKING,
    "module": _LOOKING
    | {
        protocol.Set,
        protocol.Publish,
        protocol.Acquire,
        protocol.Abandon,
        protocol.Command,
        protocol.Serve,
        protocol.Answer,
        protocol.Disclose,
    },
    "operator": _LOOKING
    | {
        protocol.Set,
        protocol.Publish,
        protocol.Use,
        protocol.Touch,
        protocol.Attend,
        protocol.Finish,
        # For the module operator.
        protocol.Acquire,
        protocol.Abandon,
        protocol.Command,
        *get_args(protocol.Debugging),
        protocol.Stage,
        protocol.Piece,
        protocol.Deploy,
        protocol.Rollback,
    },
    "service": _LOOKING
    | {
        protocol.Set,
        protocol.Use,
        protocol.Touch,
        protocol.Attend,
        protocol.Perform,
        protocol.Bundle,
        protocol.Fetch,
        protocol.Finish,
    },
    # Only the robot itself plays scenarios, and they play everything.
    "scenario": _LOOKING
    | {
        protocol.Set,
        protocol.Publish,
        protocol.Use,
        protocol.Touch,
        protocol.Attend,
        protocol.Finish,
        protocol.Acquire,
        protocol.Abandon,
        protocol.Command,
    },
}


class Rights:
    """The rights at a robot that runs this project.

    A module may set what the project's module information says that it provides: what it
    discloses of itself gives it nothing.
    """

    def __init__(self, project: Project) -> None:
        declared = project.modules.modules if project.modules is not None else ()
        self._provides = {m.name: tuple(one.data for one in m.provides) for m in declared}

    def greeting(self, who: Identity, hello: protocol.Hello) -> str | None:
        """Why he may not say this hello; None where he may."""
        if hello.role == "viewer":
            return None
        if hello.role == "scenario":
            return None if who.name == ROBOT else f"{who.name} may not play a scenario"
        if hello.role != who.role:
            return f"the key of {who.name} is for the role {who.role}, not {hello.role}"
        if hello.role == "module" and hello.module != who.name:
            return f"the key of {who.name} is not the module {hello.module}'s"
        if hello.user not in (None, who.name):
            return f"the key of {who.name} is not {hello.user}'s"
        return None

    def request(self, who: Identity, role: protocol.Role, request: Request) -> str | None:
        """Why he may not ask this in this role; None where he may."""
        if type(request) not in ALLOWED[role]:
            what = request.__struct_config__.tag
            return f"{who.name} is a {role} here and may not ask to {what}"
        if role == "module" and isinstance(request, protocol.Set):
            for tag in request.tags:
                if not self.writes(who, tag):
                    return (
                        f"{who.name} may not set {tag}: its module information does not say that "
                        "it provides it, nor does its key's write"
                    )
        return None

    def writes(self, who: Identity, tag: str) -> bool:
        """Whether this module may set the tag."""
        if tag.startswith(f"module/{who.name}/"):
            return True
        if "/" in tag or untraced(tag):
            return False
        granted = (*self._provides.get(who.name, ()), *who.write)
        return any(names.matches(pattern, tag) for pattern in granted)
