"""Which service carries out an effect: ``engine``, ``robot`` and ``screen`` beside the core.

They may live in the core's process or in others, on other machines too (docs/architecture.md,
*Services apart*).
"""

from __future__ import annotations

from situ.decide.effects import Begin, Cancel, Map

SERVICES = ("engine", "robot", "screen")

PATIENCE = 30.0
"""Seconds that a service has to answer an application, of the web or of a module."""

Carried = Map | Begin | Cancel
"""The effects that are carried out outside of the core."""


def carried_by(effect: Carried) -> tuple[str, ...]:
    """The services that an effect is for. A message is the blackboard's own, what a module is
    asked the core's; a cancel is for whoever carries that action out."""
    if isinstance(effect, Map):
        return _BY_RESOURCE.get(effect.resource, _ROBOT)
    if isinstance(effect, Cancel):
        return SERVICES
    return () if effect.action == "message" or asked_of(effect) is not None else _ENGINE


def asked_of(begun: Begin) -> tuple[str, str] | None:
    """The module and the request of a service ``board:module/request``; None for all others."""
    if begun.action != "service":
        return None
    scheme, _, rest = str(begun.fields.get("url", "")).partition(":")
    if scheme.lower() != "board":
        return None
    module, _, request = rest.strip("/").partition("/")
    return module, request


def may_repeat(begun: Begin) -> bool:
    """Whether it does no harm if it was done already, or in part."""
    return begun.action != "service" or str(begun.fields.get("method") or "GET").upper() in _SAFE


_ENGINE, _ROBOT = ("engine",), ("robot",)
_BY_RESOURCE = {"speech": _ENGINE, "screen": ("screen",)}
_SAFE = ("GET", "HEAD")
