"""Documents and inputs in few letters, for scenarios in which several rules meet."""

from __future__ import annotations

from typing import Any

END: dict[str, Any] = {"at": 100, "end": True}
STOP: dict[str, Any] = {"set": {"busy": True}}
GO_ON: dict[str, Any] = {"set": {"busy": False}}
AT = 'x="1" y="1" width="9" height="9"'


def state(no: str, actions: str = "", events: str = "", inside: str = "") -> str:
    return (
        f'<state no="{no}">{inside}<backgroundactions>{actions}</backgroundactions>'
        f"<expectedevents>{events}</expectedevents></state>"
    )


def text(name: str, written: str = "") -> str:
    shown = f'<text id="{name}" {AT}>{written or name}</text>'
    return f"<screen><components>{shown}</components></screen>"


def application(name: str, *states: str) -> str:
    return f'<application name="{name}">{"".join(states)}</application>'


def script(situations: str = "", **priorities: int) -> str:
    """A script in which all may ask for everything; the last situation has the priorities."""
    declared = "".join(
        f'<module name="{name}" resources="arm base head screen speech"/>' for name in priorities
    )
    given = "".join(f'<module name="{n}" priority="{p}"/>' for n, p in priorities.items())
    return f'<modules>{declared}</modules>{situations}<situation name="s">{given}</situation>'


def finish(at: float, action: str, name: str | None = None) -> dict[str, Any]:
    named = {} if name is None else {"name": name}
    return {"at": at, "finish": {"action": action, **named}}


def acquire(at: float, module: str, *resources: str, optional: str = "") -> dict[str, Any]:
    asked: dict[str, Any] = {"module": module, "resources": list(resources)}
    if optional:
        asked["optional"] = optional.split()
    return {"at": at, "acquire": asked}


def abandon(at: float, module: str, *resources: str) -> dict[str, Any]:
    return {"at": at, "abandon": {"module": module, "resources": list(resources)}}


NOD = '<robot resource="head" command="nod"/>'

GO = '<event name="go" next="2"/>'
