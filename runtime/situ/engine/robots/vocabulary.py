"""Reading what stands at ``robot/<resource>``: the vocabulary of the bundled adapters.

``base`` {vx, vy} in m/s and {turn} in deg/s, ``head`` {yaw, pitch} in degrees, or a
command {command, params} (docs/adapters.md). ``whose`` names robot and resource in an error,
as in "the simulated robot's base".
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

Place = tuple[float, float, float]
"""x and y in metres, heading in degrees."""

_T = TypeVar("_T")


class NotUnderstood(Exception):
    """A value that the robot can not carry out; ``str`` says why, in one line."""


def fields(value: Any, whose: str) -> dict[str, Any]:
    """``value`` where it is an object. Raises NotUnderstood."""
    if not isinstance(value, dict):
        raise NotUnderstood(f"{whose} takes an object, not {value!r}")
    return value


def command(value: Any) -> str | None:
    """The command's name; None for a value that is no command."""
    if isinstance(value, dict) and "command" in value:
        return str(value["command"])
    return None


def params(value: dict[str, Any]) -> dict[str, Any]:
    """A command's parameters; none where they are no object."""
    found = value.get("params")
    return found if isinstance(found, dict) else {}


def chosen(whose: str, name: str, commands: Mapping[str, Callable[[], _T]]) -> _T:
    """What the command of that name makes. Raises NotUnderstood naming those known."""
    if name not in commands:
        raise NotUnderstood(f"{whose} can not {name}; it knows {', '.join(commands)}")
    return commands[name]()


def number(
    of: dict[str, Any], name: str, default: float | None = None, limit: float = math.inf
) -> float:
    """A number, cut down to ``limit`` on either side. Raises NotUnderstood."""
    value = of.get(name, default)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise NotUnderstood(f"{name} has to be a number, not {value!r}")
    return float(min(max(value, -limit), limit))


def only(value: dict[str, Any], whose: str, *names: str) -> None:
    """Raises NotUnderstood where there is a field of another name."""
    for name in value:
        if name not in names:
            raise NotUnderstood(f"{whose} knows {', '.join(names)}, not {name!r}")


def place(places: Mapping[str, Place], of: dict[str, Any]) -> Place:
    """Where ``place`` is, by the project. Raises NotUnderstood naming the places there are."""
    name = of.get("place")
    if isinstance(name, str) and name in places:
        return places[name]
    known = ", ".join(sorted(places)) or "none"
    raise NotUnderstood(f"there is no place {name!r} in [places] of situ.toml; there are: {known}")
