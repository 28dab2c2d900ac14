"""Priority management and mapping (seed 000, 5.1; formats.md, *SPDS*).

Who holds which resource, and whose command stands at ``robot/<resource>``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from msgspec import Struct

from situ.decide import trace
from situ.decide.effects import Map
from situ.decide.step import VALIDITY, Step, duration
from situ.decide.values import equal

RUNTIME = "situ"
"""The writer of what the runtime itself keeps."""


class Request(Struct):
    """What a module asks for; order: its place in time, kept when it asks again."""

    resources: tuple[str, ...]
    optional: tuple[str, ...]
    order: int


class Standing(Struct):
    """A module's command for a resource.

    until: µs, None for one that is good while the module holds the resource.
    mapped: whether it may move the robot; token: its timer's. cause: what made it: an action,
    or else the mapping by which it began to move the robot.
    """

    value: Any
    until: int | None
    mapped: bool
    token: int
    cause: int | None
    actions: tuple[int, ...] = ()


class PrioritiesState(Struct):
    requests: dict[str, Request] = {}
    holders: dict[str, str] = {}
    commands: dict[str, dict[str, Standing]] = {}
    robot: dict[str, Any] = {}
    actions: dict[str, tuple[int, ...]] = {}
    count: int = 0


Write = Callable[[str, Any, str, int | None], None]
"""(tag, value, writer, cause): how what stands at ``module/`` and ``robot/`` is written."""


class Priorities:
    """The priority management service of one robot."""

    def __init__(self, step: Step, write: Write) -> None:
        self.state = PrioritiesState()
        self._step = step
        self._write = write

    def holds(self, module: str, resource: str) -> bool:
        return self.state.holders.get(resource) == module

    def holder(self, resource: str) -> str | None:
        return self.state.holders.get(resource)

    def request(self, module: str) -> Request | None:
        return self.state.requests.get(module)

    # -- requests ------------------------------------------------------------

    def ask(
        self,
        module: str,
        resources: tuple[str, ...],
        optional: tuple[str, ...],
        cause: int | None,
        acquires: bool = False,
    ) -> int | None:
        """Replaces the module's request; traced only when it changes, as ``abandon`` where
        it only gives back, unless the module said that it ``acquires``. Gives the seq of
        that event. ``assign`` must follow.
        """
        old = self.state.requests.get(module)
        wanted = tuple(sorted(set(resources)))
        able = tuple(sorted(set(optional) - set(wanted)))
        before = (old.resources, old.optional) if old is not None else ((), ())
        if (wanted, able) == before:
            return None
        given_back = tuple(sorted({*before[0], *before[1]} - {*wanted, *able}))
        if wanted or able:
            self.state.count += old is None
            order = self.state.count if old is None else old.order
            self.state.requests[module] = Request(wanted, able, order)
        else:
            del self.state.requests[module]
        if not acquires and set(wanted) <= set(before[0]) and set(able) <= set(before[1]):
            seq = self._step.trace(trace.Abandon, cause, module, given_back)
        elif able:
            seq = self._step.trace(trace.Acquire, cause, module, wanted, able)
        else:
            seq = self._step.trace(trace.Acquire, cause, module, wanted)
        for resource in given_back:
            self._drop(module, resource, seq, remap=False)
        return seq

    def abandon(
        self, module: str, resources: tuple[str, ...], cause: int | None = None
    ) -> int | None:
        """Gives back some (or, with none named, all) of what it asks for; its commands for
        them end, also those for what it did not ask for.
        """
        seq: int | None = None
        old = self.state.requests.get(module)
        if old is not None:
            gone = set(resources) or {*old.resources, *old.optional}
            kept = tuple(r for r in old.resources if r not in gone)
            able = tuple(r for r in old.optional if r not in gone)
            seq = self.ask(module, kept, able, cause)
        for resource in resources or tuple(self.state.commands.get(module, ())):
            self._drop(module, resource, seq if seq is not None else cause, remap=False)
        return seq

    def lost(self, module: str) -> int:
        """The module is gone: its request and its commands end."""
        old = self.state.requests.pop(module, None)
        resources = tuple(sorted({*old.resources, *old.optional})) if old is not None else ()
        seq = self._step.trace(trace.Lost, None, module, resources)
        for resource in list(self.state.commands.get(module, ())):
            self._drop(module, resource, seq, remap=False)
        return seq

    # -- authority -----------------------------------------------------------

    def assign(self, priorities: Mapping[str, int], cause: int | None) -> dict[str, int]:
        """Grants anew by ``priorities``, those of modules now: from the highest down, all of a
        request's resources or none.

        Traces every change of holder, each followed by the mapping that it changed.
        Gives resource to the seq of its ``authority`` event.
        """
        before = self.state.holders
        after = granted(self.state.requests, before, priorities)
        changed: dict[str, int] = {}
        if after == before:
            return changed
        self.state.holders = after
        for resource in sorted(before.keys() | after.keys()):
            old, new = before.get(resource), after.get(resource)
            if old == new:
                continue
            seq = self._step.trace(trace.Authority, cause, resource, old, new)
            changed[resource] = seq
            if old is not None:
                standing = self.state.commands.get(old, {}).get(resource)
                if standing is not None and standing.until is None:
                    self._drop(old, resource, seq, remap=False)
            self._map(resource, seq)
        return changed

    # -- commands and mapping ------------------------------------------------

    def command(
        self,
        module: str,
        resource: str,
        value: Any,
        valid: float | None,
        cause: int | None,
        actions: tuple[int, ...] = (),
    ) -> None:
        """A command of a module. ``valid``: seconds from now that it is good for, or None."""
        self.state.count += 1
        token = self.state.count
        holding = self.holds(module, resource)
        until = None if valid is None else self._step.now + duration(valid)
        standing = Standing(value, until, holding or until is not None, token, cause, actions)
        commands = self.state.commands.setdefault(module, {})
        before = commands.get(resource)
        if cause is None and before is not None and equal(before.value, value):
            standing.cause = before.cause
        commands[resource] = standing
        self._write(f"module/{module}/{resource}", value, module, cause)
        if until is not None:
            self._step.at(until, VALIDITY, f"command:{module}/{resource}", token)
        if holding:
            self._map(resource, cause)

    def end_command(self, module: str, resource: str, cause: int | None) -> None:
        """The module no longer commands the resource."""
        self._drop(module, resource, cause)

    def is_live(self, name: str, token: int) -> bool:
        """Whether the command that a timer was set for still stands (``module/resource``)."""
        module, _, resource = name.partition("/")
        standing = self.state.commands.get(module, {}).get(resource)
        return standing is not None and standing.token == token

    def due(self, name: str) -> None:
        """The validity of a command that still stands ends."""
        module, _, resource = name.partition("/")
        self._drop(module, resource, self.state.commands[module][resource].cause)

    def _drop(self, module: str, resource: str, cause: int | None, remap: bool = True) -> None:
        if self.state.commands.get(module, {}).pop(resource, None) is None:
            return
        self._write(f"module/{module}/{resource}", None, module, cause)
        if remap and self.holds(module, resource):
            self._map(resource, cause)

    def _map(self, resource: str, cause: int | None) -> None:
        """Puts the holder's valid command at ``robot/<resource>``; traced when it changes."""
        holder = self.state.holders.get(resource)
        standing = self.state.commands.get(holder or "", {}).get(resource)
        value: Any = None
        actions: tuple[int, ...] = ()
        if standing is not None and standing.mapped:
            value, actions = standing.value, standing.actions
        before = self.state.robot.get(resource)
        if equal(value, before):
            if actions and actions != self.state.actions.get(resource):
                self.state.actions[resource] = actions
                self._step.effects.append(Map(resource, holder, value, actions))
            return
        self.state.robot[resource] = value
        self.state.actions[resource] = actions
        seq = self._step.trace(trace.Mapping, cause, resource, holder, value)
        if standing is not None and standing.mapped and standing.cause is None:
            standing.cause = seq
        self._write(f"robot/{resource}", value, holder or RUNTIME, seq)
        self._step.effects.append(Map(resource, holder, value, actions))


def granted(
    requests: Mapping[str, Request], before: Mapping[str, str], priorities: Mapping[str, int]
) -> dict[str, str]:
    """Resource to the module that holds it: from the highest priority down, all of a request's
    resources or none; at equal priorities who held (``before``) any of them, then who asked first.
    """
    asking = []
    for module, request in requests.items():
        priority = priorities.get(module)
        if priority is not None:
            has = any(before.get(r) == module for r in (*request.resources, *request.optional))
            asking.append((-priority, not has, request.order, module, request))
    asking.sort(key=lambda one: one[:3])
    after: dict[str, str] = {}
    for _, _, _, module, request in asking:
        if any(r in after for r in request.resources):
            continue
        for resource in request.resources:
            after[resource] = module
        for resource in request.optional:
            after.setdefault(resource, module)
    return after
