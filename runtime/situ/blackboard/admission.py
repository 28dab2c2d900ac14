"""Whether a client may have the session that its ``hello`` asks for."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from situ.blackboard.acting import No, Session
from situ.blackboard.core import Core
from situ.blackboard.protocol import Hello
from situ.blackboard.services import SERVICES
from situ.document import names
from situ.document.names import LONGEST


def check(
    hello: Hello, core: Core, sessions: Iterable[Session], own: Collection[str], *, scripted: bool
) -> None:
    """sessions: those there are; own, scripted: as in ``Sessions``. Raises ``No``."""
    if hello.role == "scenario" and not scripted:
        raise No("role", "a scenario is played only by situ run --script")
    if (hello.module is not None) != (hello.role == "module"):
        raise No("role", "a module gives its name, and only a module does")
    if bool(hello.services) != (hello.role == "service"):
        raise No("role", "a service says what it carries out, and only a service does")
    if hello.module is not None:
        _check_name(hello.module, core)
    if hello.services:
        carried_out = {service for one in sessions for service in one.services}
        _check_services(hello.services, carried_out, own)


def writer(hello: Hello) -> str:
    """In whose name it will write (formats.md, *Trace*: the writers)."""
    if hello.role == "operator":
        return f"operator:{hello.user or 'unknown'}"
    return hello.module or hello.role


def _check_name(name: str, core: Core) -> None:
    if len(name) > LONGEST or not names.is_tag(f"module/{name}/x") or "/" in name:
        raise No(
            "name", f"{name[:LONGEST]!r} can be no module's name: use letters, digits, - and _"
        )
    if any(one.name == name for one in core.project.applications.values()):
        raise No("name", f"{name} is an application of this project: choose another name")
    if name in core.modules:
        raise No("name", f"a module {name} is connected already: end it, or choose another name")


def _check_services(
    services: Iterable[str], carried_out: Collection[str], own: Collection[str]
) -> None:
    for service in services:
        if service not in SERVICES:
            raise No("name", f"{service[:LONGEST]!r} is no service: {', '.join(SERVICES)}")
        if service in own:
            raise No("name", f"{service} is carried out in the core's own process: leave it out")
        if service in carried_out:
            raise No("name", f"{service} is carried out by another program already: end that first")
