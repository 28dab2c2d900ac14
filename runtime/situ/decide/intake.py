"""What each input does at once; what follows from it is ``settling``'s.

formats.md, *Screen*, *Speech heard*, *SPDS* and *Scenarios*.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from msgspec import UNSET

from situ.decide import inputs, trace
from situ.decide.deploying import Deploying
from situ.decide.effects import Refuse
from situ.decide.hearing import event_for, phrases
from situ.decide.machine import Machine
from situ.decide.presence import Presence
from situ.decide.settling import Settling
from situ.decide.step import duration
from situ.decide.values import in_text, is_number, read, template
from situ.decide.world import World, refusal
from situ.document import names
from situ.document.rbd import Button, Input, List

CONFIDENT = 0.5
"""From this confidence on an utterance is taken for what was heard."""

NOT_UNDERSTOOD = "notunderstood"


class Intake:
    """Where the inputs of one robot come in, each by its row of ``ACCEPT``."""

    def __init__(
        self, world: World, presence: Presence, settling: Settling, deploying: Deploying
    ) -> None:
        self._world = world
        self._deploying = deploying
        self._presence = presence
        self._settling = settling
        self._machines = settling.machines
        self._by_name = {machine.name: machine for machine in settling.machines}
        world.board.listen(["heard"], self._on_heard)

    def _start(self, given: inputs.Start) -> None:
        world = self._world
        world.random.seed(given.seed)
        world.auto_finish = None if given.auto_finish is None else duration(given.auto_finish)
        self._presence.state.everyone = given.everyone
        tags = world.project.tags
        world.write({t: v for t, v in tags.items() if t not in given.restored}, "project", None)
        world.restore(given.restored)
        world.conditions.start()
        self._settling.listen()
        self._settling.observe()
        for machine in self._machines:
            machine.start()

    def _set(self, given: inputs.Set) -> None:
        for tag in given.tags:
            no = refusal(tag, given.writer)
            if no is None and not names.is_tag(tag):
                no = f"{tag or repr(tag)} is no tag: use words of a-z, 0-9, _ and - joined by dots"
            if no is not None:
                self._refuse(no, given.writer)
                return
        self._world.write(given.tags, given.writer, None)

    def _raise(self, given: inputs.Raise) -> None:
        application, settling = given.application, self._settling
        if application is None:
            machines = self._machines
        elif application in self._by_name:
            machines = [self._by_name[application]]
        else:
            self._refuse(f"there is no application {application}", given.event)
            return
        writer = given.writer if given.writer is not None else UNSET
        if len(machines) == 1 and settling.at_rest:
            # Nothing else can come first: it need not wait for its turn.
            settling.count += 1
            machines[0].judge(given.event, None, None, writer)
            return
        order = self._world.next_raise()
        for machine in machines:
            machine.raise_event(given.event, None, order, writer)

    def _shower(self) -> Machine | None:
        """The application whose screen is shown."""
        return self._by_name.get(self._world.priorities.holder("screen") or "")

    def _touch(self, given: inputs.Touch) -> None:
        machine = self._shower()
        if machine is None:
            return
        machine.attend()
        event = machine.display.touched()
        if event is not None:
            machine.raise_event(event, None, self._world.next_raise())

    def _attend(self, given: inputs.Attend) -> None:
        machine = self._shower()
        if machine is not None:
            machine.attend()

    def _use(self, given: inputs.Use) -> None:
        machine = self._shower()
        component = machine.display.component(given.component) if machine is not None else None
        if machine is None or not isinstance(component, (Button, Input, List)):
            self._world.step.warn(
                None, f"no button, input or list {given.component} is shown", "screen"
            )
            return
        machine.attend()
        value: Any = given.value
        if isinstance(component, Button):
            value = self._pressed(component)
        elif isinstance(component, Input) and value is not UNSET:
            value = typed(component, value)
            if value is None:
                self._world.step.warn(
                    None, f"{given.component} takes a number, not {given.value!r}", "screen"
                )
                return
        if component.tag and value is not UNSET:
            self._world.write({component.tag: value}, "screen", None)
        if component.event is not None:
            machine.raise_event(component.event, None, self._world.next_raise())

    def _pressed(self, button: Button) -> Any:
        """What a button sets: its ``value``, read like the text of a ``set``."""
        filled, look = template(button.value or ""), self._world.board.look
        for name in filled.missing(look):
            self._world.step.warn(None, f"{name} has no value", button.id)
        return filled.value(look)

    # -- modules -------------------------------------------------------------

    def _acquire(self, given: inputs.Acquire) -> None:
        if not self._may_ask(given.module, (*given.resources, *given.optional)):
            return
        self._presence.came(given.module)
        seq = self._world.priorities.ask(
            given.module, given.resources, given.optional, None, acquires=True
        )
        if seq is not None:
            self._settling.asked(given.module, seq)

    def _abandon(self, given: inputs.Abandon) -> None:
        if self._may_ask(given.module, given.resources):
            seq = self._world.priorities.abandon(given.module, given.resources)
            if seq is not None:
                self._settling.reassign(seq)

    def _command(self, given: inputs.Command) -> None:
        if self._may_ask(given.module, (given.resource,)):
            self._world.priorities.command(
                given.module, given.resource, given.value, given.valid, None
            )

    def _lost(self, given: inputs.Lost) -> None:
        no = self._presence.lose(given.module)
        if no is not None:
            self._refuse(no, given.module)
        else:
            self._settling.reassign(self._world.priorities.lost(given.module))

    def _connect(self, given: inputs.Connected) -> None:
        self._presence.connect(given.module, given.resources)
        self._world.step.trace(trace.Connected, None, given.module, tuple(sorted(given.resources)))

    def _may_ask(self, module: str, resources: tuple[str, ...]) -> bool:
        no = self._presence.refusal(module, resources)
        if no is not None:
            self._refuse(no, module)
        return no is None

    def _debug(self, given: inputs.Debugging) -> None:
        no = self._settling.debugger.accept(given)
        if no is not None:
            self._refuse(no, given.writer)

    def _deploy(self, given: inputs.Deploy) -> None:
        no = self._deploying.accept(given)
        if no is not None:
            self._refuse(no, given.writer)

    def _refuse(self, message: str, where: str) -> None:
        self._world.step.error(None, message, where)
        self._world.step.effects.append(Refuse(message))

    # -- what has ended, and what was heard ----------------------------------

    def _finish(self, given: inputs.Finish) -> None:
        for machine, running in self._fitting(given):
            status = None if given.status is UNSET else given.status
            action = machine.actions.state.running[running]
            seq = machine.finish(running, given.ok, given.result, given.error, status, None)
            if given.id is not None and not given.ok:
                # Who carried it out says so; in a scenario it was meant.
                what = f"{action.action} {action.name}" if action.name else action.action
                why = given.error or "nobody knows why"
                self._world.step.warn(seq, f"{what} failed: {why}", machine.name)
            return
        if given.id is None:
            what = " ".join(str(x) for x in (given.action, given.name) if x is not None)
            self._world.step.warn(None, f"no {what or 'action'} is running", "finish")

    def _fitting(self, given: inputs.Finish) -> list[tuple[Machine, int]]:
        found = []
        for machine in self._machines:
            if given.id is not None:
                if given.id in machine.actions.state.running:
                    return [(machine, given.id)]
            elif given.application in (None, machine.name):
                running = machine.actions.find(given.action, given.name)
                if running is not None:
                    found.append((machine, running.id))
        return sorted(found, key=lambda one: one[1])

    def _on_heard(self, tag: str, cause: int | None) -> None:
        """An utterance (formats.md, *Speech heard*)."""
        heard = self._world.board.look("heard")
        text = heard.get("text") if isinstance(heard, dict) else None
        listening = [machine for machine in self._machines if phrases(self._world, machine)]
        if not isinstance(text, str) or not listening:
            return
        confidence = heard.get("confidence", 1)
        sure = is_number(confidence) and confidence >= CONFIDENT
        meant = {m.name: event_for(self._world, m, text) for m in listening} if sure else {}
        understood = any(event is not None for event in meant.values())
        order = self._world.next_raise()
        for machine in listening:
            machine.attend()
            event = meant.get(machine.name) if understood else NOT_UNDERSTOOD
            if event is not None:
                machine.raise_event(event, cause, order)


def typed(field: Input, value: Any) -> str | int | float | None:
    """What an input writes for what was typed: no more than ``max`` characters, as text, or
    for ``number`` as a number. None: it is no number.
    """
    text = in_text(value)[: field.max]
    if field.kind != "number":
        return text
    number = read(text)
    return number if is_number(number) else None


ACCEPT: dict[type[inputs.Input], Callable[[Intake, Any], None]] = {
    inputs.Start: Intake._start,
    inputs.Set: Intake._set,
    inputs.Raise: Intake._raise,
    inputs.Touch: Intake._touch,
    inputs.Use: Intake._use,
    inputs.Attend: Intake._attend,
    inputs.Acquire: Intake._acquire,
    inputs.Abandon: Intake._abandon,
    inputs.Command: Intake._command,
    inputs.Lost: Intake._lost,
    inputs.Connected: Intake._connect,
    inputs.Finish: Intake._finish,
    inputs.Deploy: Intake._deploy,
    inputs.Break: Intake._debug,
    inputs.Unbreak: Intake._debug,
    inputs.Pause: Intake._debug,
    inputs.Resume: Intake._debug,
    inputs.Step: Intake._debug,
    inputs.Goto: Intake._debug,
}
