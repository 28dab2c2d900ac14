"""``situ export --flat``: applications without ``flow`` and ``always`` that do the same.

formats.md, *Parts*: the flat form and the original give the same actions at the same times.

Each innermost state becomes one state named by its path (``5/q``), with the events of all
states around it and of their files' ``always``, the timeout that serves and the screens of
``always`` written into it. Where what a state does depends on how it was reached, it becomes
several (``5/q``, ``5/q~2``), found by following every way from the start:

- ``#back``: a flat application has one stack, the original one for each run of a part. With
  parts, a state is doubled by where its ``#back``, and those that may follow it, lead, and the
  copies name these states. Without parts the stack is the same, and ``#back`` stays.
- Kept screens: where other screens of ``always`` lie above a kept one, the copies show that
  screen again, each the one that is kept there.
- ``done.x``: the end of a part is an event with a name of its own, which the states of that
  part take as the state around them would, as far as it may still be told there. The last action
  of the end state raises it; where it has none that ends at once, one that clears
  ``flat-export.nothing``, which changes nothing, is added. It is the only action that is not in
  the original.

An event that an earlier one of its name always goes before is left out, but for its phrases.
Copies that cannot be told apart by what they do are one again in the end.

UsageError says in one line what cannot be written so: ways back of any length through parts,
a kept screen with a movie under another ``always``, a ``resumed`` that leaves a screen not yet
shown, a condition on the state's name where that state has copies. What is dropped because
nobody accepts it (``ignored``) is not traced alike, and events nobody accepts are not raised.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from msgspec.structs import replace

from situ.document import codec
from situ.document.condition import Condition, Test
from situ.document.flatten_levels import Level, Levels, serving, states_meant
from situ.document.flatten_states import bare, merged, retargeted
from situ.document.project import Project
from situ.document.rbd import (
    AGAIN,
    BACK,
    RESUMED,
    Action,
    Add,
    Append,
    Application,
    Clear,
    Component,
    Event,
    Message,
    Movie,
    Screen,
    Set,
    State,
    Take,
    Timeout,
)
from situ.document.texts import heard_as
from situ.errors import UsageError

LIMIT = 2_000
"""More copies of states than this are not looked at."""

NOTHING_TAG = "flat-export.nothing"
NEVER = Condition((Test(NOTHING_TAG, "exists", "true"),))
_AT_ONCE = (Set, Add, Append, Take, Clear, Message)


def flatten(project: Project) -> Project:
    """The same project without parts; its applications have no ``flow`` and no ``always``.

    The project must have no errors. Comments and foreign XML of applications are left out.
    """
    flat = {
        file: _Flattening(project, file, application).application()
        for file, application in project.applications.items()
    }
    return replace(project, applications=flat, parts={})


Shown = tuple[str | None, tuple[int, ...]]
"""The state whose own screen it is, and which screens of ``always`` lie above it."""


class _Node(NamedTuple):
    """An innermost state as it was reached.

    views: by level, where ``#back`` leads, the next first, as far as it can matter. raised: the
    ends that it tells. base, shown: the kept screen, and what is shown once it is entered;
    shows: whether it must say so.
    """

    path: str
    views: tuple[tuple[str, ...], ...]
    raised: tuple[tuple[str, str], ...]
    base: str | None
    shown: Shown | None
    shows: bool


class _Flattening:
    def __init__(self, project: Project, file: str, source: Application) -> None:
        self.project = project
        self.file = file
        self.source = source
        self.levels: dict[str, Levels] = {}
        self.screens: dict[int, Screen] = {}
        self.numbers: dict[_Node, int] = {}
        self.nodes: list[_Node] = []
        self.told: dict[tuple[str, str], set[str]] = {}
        self.native = self.is_native()
        self.has_always_screen = False
        self.start_shows_movie = self.start_again = False

    def is_native(self) -> bool:
        """Whether the stack and the kept screen of the flat form are those of the original: there
        are no parts, and the same screens of ``always`` lie above every state from the start on.
        """
        source = self.source
        shared = source.always.screen if source.always is not None else None
        if any(state.flow is not None for state in source.states):
            return False
        if shared is None or shared.is_empty:
            return True
        start = source.state(source.start_no or "")
        return (
            start is not None
            and start.screen is not None
            and all(state.always for state in source.states)
        )

    def application(self) -> Application:
        states, blocks = self.explore()
        if self.start_shows_movie and self.start_again:
            raise self.refuse("the movie of <always> would begin again with the start state")
        names = self.names(blocks)
        made: dict[int, State] = {}
        for number, state in enumerate(states):
            if blocks[number] not in made:
                made[blocks[number]] = retargeted(
                    replace(state, no=names[blocks[number]]),
                    lambda to: self.said(to, blocks, names),
                )
        flat = tuple(
            replace(one, final=one.final and one.is_end) for _, one in sorted(made.items())
        )
        application = Application(self.source.name, names[blocks[0]], None, flat)
        self.refuse_names(len(made))
        return application

    def refuse(self, why: str) -> UsageError:
        return UsageError(f"{self.file}: cannot be exported flat: {why}; leave --flat out")

    # -- ways from the start ---------------------------------------------------

    def explore(self) -> tuple[list[State], list[int]]:
        """Every state as reached, its targets written as numbers; and which are the same."""
        states: list[State] = []
        start = self.enter((), self.source, "", self.source.start_no or "")
        self.number(self.reach(start, 0, (), None, None))
        while len(states) < len(self.nodes):
            states.append(self.state(self.nodes[len(states)]))
            if len(self.nodes) > LIMIT:
                raise self.refuse(
                    f"it would have more than {LIMIT} states, because #back can lead back along "
                    "ways of any length, or parts hold very many states"
                )
        return states, merged([node.path for node in self.nodes], states)

    def number(self, node: _Node) -> int:
        number = self.numbers.setdefault(node, len(self.nodes))
        if number == len(self.nodes):
            self.nodes.append(node)
        elif number == 0:
            self.start_again = True
        return number

    def enter(self, around: Levels, file: Application, prefix: str, no: str) -> Levels:
        """A state of a file with the start of the part that it runs."""
        state = file.state(no)
        assert state is not None
        levels = (*around, Level(file, state, prefix))
        part = self.project.flow(state.flow) if state.flow is not None else None
        if part is None:
            self.levels[levels[-1].path] = levels
            return levels
        return self.enter(levels, part, f"{levels[-1].path}/", part.start_no or "")

    def reach(
        self,
        levels: Levels,
        entered: int,
        views: tuple[tuple[str, ...], ...],
        base: str | None,
        shown: Shown | None,
    ) -> _Node:
        """The node of an innermost state entered with all from level ``entered`` on.

        views: of the levels up to ``entered``; base, shown: before.
        """
        leaf = levels[-1]
        own, above = leaf.state.screen, tuple(id(one) for one in self.above(levels))
        if own is not None:
            base = None if own.is_empty else leaf.path
        wanted = None if base is None and not above else (base, above)
        shows = own is not None or wanted != shown
        views = (*views, *(() for _ in levels[len(views) :]))
        raised = tuple(self.raised(levels, entered))
        return _Node(leaf.path, views, raised, base, wanted, shows)

    def move(self, node: _Node, level: int, to: str) -> str | None:
        """What stands for a ``next`` of ``level``; None where there is nothing to go back to."""
        levels = self.levels[node.path]
        here, view = levels[level], node.views[level]
        if self.native and to in (AGAIN, BACK):
            return to
        if to == AGAIN:
            no = here.state.no
        elif to == BACK:
            if not view:
                return None
            no, view = view[0], view[1:]
        else:
            no, view = to, (here.state.no, *view)
        target = self.enter(levels[:level], here.file, here.prefix, no)
        if self.native or not target[level].goes_back or no == here.file.start_no:
            view = ()
        views = (*node.views[:level], view)
        return str(self.number(self.reach(target, level, views, node.base, node.shown)))

    # -- one state -------------------------------------------------------------

    def state(self, node: _Node) -> State:
        levels = self.levels[node.path]
        leaf = levels[-1].state
        events = [
            event
            for level, one in reversed(tuple(enumerate(levels)))
            for event in self.events(node, level, one.events)
        ]
        events += self.ends(node, levels)
        return State(
            no="",
            name=leaf.name,
            # The end of a part is meant to be one, in its file.
            final=leaf.final or (len(levels) > 1 and leaf.is_end),
            timeout=self.timeout(node, levels),
            screen=self.screen(node, levels),
            actions=self.actions(node, leaf),
            events=self.that_come_in_turn(events),
        )

    def that_come_in_turn(self, events: list[Event]) -> tuple[Event, ...]:
        """Without those whose name an earlier one without ``when`` always takes.

        Their phrases go to that one, unless one between them is taken for the same words.
        """
        kept: list[Event] = []
        always: dict[str | None, int] = {}
        for event in events:
            at = always.get(event.name)
            if at is None:
                if event.when is None:
                    always[event.name] = len(kept)
                kept.append(event)
            elif self.confused(event, kept[at + 1 :]):
                kept.append(event)
            else:
                kept[at] = replace(kept[at], says=(*kept[at].says, *event.says))
        return tuple(kept)

    def confused(self, event: Event, before: list[Event]) -> bool:
        """Whether one of these may be taken for what is said for the event."""
        here = self.phrases(event)
        there = [text for one in before if one.name != event.name for text in self.phrases(one)]
        # What a reference stands for may be anything.
        open_ended = any("{" in text for text in (*here, *there))
        same = {heard_as(text) for text in here} & {heard_as(text) for text in there}
        return bool(here and there and (open_ended or same))

    def phrases(self, event: Event) -> list[str]:
        """What is said for it, in every language."""
        texts = [say.text for say in event.says]
        return texts + [
            known[text] for known in self.project.texts.values() for text in texts if text in known
        ]

    def events(self, node: _Node, level: int, events: tuple[Event, ...]) -> Iterator[Event]:
        for event in events:
            to = None if event.next is None else self.move(node, level, event.next)
            if event.next is None or to is not None:
                if event.name == RESUMED and to is not None and node.shows:
                    self.check_resumed(node)
                yield bare(replace(event, next=to))
            elif event.name is not None:
                # Refused like a guard, but its phrases are listened for.
                yield Event(name=event.name, when=NEVER, says=bare(event.says))

    def ends(self, node: _Node, levels: Levels) -> Iterator[Event]:
        """What the states around it do when their parts end, where that may still be told."""
        for level, holder in enumerate(levels[:-1]):
            for end in levels[level + 1].file.states:
                if not end.is_end or node.path not in self.told_in(levels, level, end.no):
                    continue
                taken = (*holder.named(f"done.{end.no}"), *holder.named("done"))
                name = self.end_name(holder.path, end.no)
                for event in self.events(node, level, taken):
                    yield replace(event, name=name, says=())

    def told_in(self, levels: Levels, level: int, end: str) -> set[str]:
        """The innermost states in which an end of the part at ``level`` may be told: its own, and
        those to which the part may go on before the event's turn comes.
        """
        inside = levels[level + 1]
        key = (levels[level].path, end)
        if key in self.told:
            return self.told[key]
        found = self.told[key] = set[str]()
        waiting = [self.enter(levels[: level + 1], inside.file, inside.prefix, end)]
        while waiting:
            here = waiting.pop()
            if here[-1].path in found:
                continue
            found.add(here[-1].path)
            serves = serving(here)
            for at, one in enumerate(here[level + 1 :], level + 1):
                targets = {event.next for event in one.events}
                if serves is not None and serves[0] == at:
                    targets.add(serves[1].next)
                waiting += [
                    self.enter(here[:at], one.file, one.prefix, to)
                    for to in states_meant(one, targets)
                ]
        return found

    def raised(self, levels: Levels, entered: int) -> Iterator[tuple[str, str]]:
        """The ends that entering these levels tells, the innermost first."""
        for level in range(len(levels) - 1, max(entered, 1) - 1, -1):
            holder, state = levels[level - 1], levels[level].state
            if state.is_end and (holder.named(f"done.{state.no}") or holder.named("done")):
                yield holder.path, state.no

    def end_name(self, holder: str, no: str) -> str:
        return f"flat-export.done.{holder}/{no}"

    def actions(self, node: _Node, leaf: State) -> tuple[Action, ...]:
        actions = [bare(one) for one in leaf.actions]
        for number, (holder, no) in enumerate(node.raised):
            name = self.end_name(holder, no)
            last = actions[-1] if actions and not number else None
            if isinstance(last, _AT_ONCE) and last.done is None:
                actions[-1] = replace(last, done=name)
            else:
                actions.append(Clear(tag=NOTHING_TAG, done=name))
        return tuple(actions)

    def timeout(self, node: _Node, levels: Levels) -> Timeout | None:
        serves = serving(levels)
        if serves is None or serves[1].next is None:
            return None if serves is None else bare(serves[1])
        to = self.move(node, serves[0], serves[1].next)
        return None if to is None else bare(replace(serves[1], next=to))

    # -- screens ---------------------------------------------------------------

    def above(self, levels: Levels) -> list[Screen]:
        """The screens of ``always``, the innermost file's first."""
        found = [
            one.file.always.screen
            for one in reversed(levels)
            if one.state.always and one.file.always is not None
        ]
        screens = [one for one in found if one is not None and not one.is_empty]
        self.screens.update((id(one), one) for one in screens)
        self.has_always_screen = self.has_always_screen or bool(screens)
        return screens

    def screen(self, node: _Node, levels: Levels) -> Screen | None:
        if not node.shows:
            return None
        if node.shown is None:
            return Screen()
        base, above = node.shown
        own = None if base is None else self.levels[base][-1].state.screen
        layers = [*([] if own is None else [own]), *(self.screens[one] for one in above)]
        kept = levels[-1].state.screen is None
        components: list[Component] = []
        seen: set[str] = set()
        for layer in reversed(layers):
            here: list[Component] = []
            for component in layer.components:
                if kept and isinstance(component, Movie) and node == self.nodes[0]:
                    self.start_shows_movie = True
                elif kept and isinstance(component, Movie):
                    raise self.refuse(
                        f"the movie {component.id} is kept in state {node.path}, "
                        "where another screen of <always> lies above it"
                    )
                name, number = component.id, 1
                while component.id in seen:
                    if isinstance(component, Movie):
                        raise self.refuse(f"two components of state {node.path} are {name}")
                    number += 1
                    component = replace(component, id=f"{name}~{number}")
                here.append(bare(component))
            seen |= {one.id for one in here}
            components[:0] = here
        return Screen(
            next((one.background for one in layers if one.background is not None), None),
            next((one.touched for one in layers if one.touched is not None), None),
            tuple(components),
        )

    def check_resumed(self, node: _Node) -> None:
        if self.has_always_screen and self.project.spds is not None:
            raise self.refuse(
                f"the event resumed leaves state {node.path} before its screen was shown, "
                "and <always> has a screen"
            )

    # -- names -------------------------------------------------------------------

    def names(self, blocks: list[int]) -> dict[int, str]:
        found: dict[int, str] = {}
        taken = {node.path for node in self.nodes}
        first: set[str] = set()
        for node, block in zip(self.nodes, blocks, strict=True):
            if block in found:
                continue
            name, number = node.path, 1
            if name in first:
                while name in taken:
                    number += 1
                    name = f"{node.path}~{number}"
            first.add(name)
            taken.add(name)
            found[block] = name
        return found

    @staticmethod
    def said(to: str, blocks: list[int], names: dict[int, str]) -> str:
        return to if to in (AGAIN, BACK) else names[blocks[int(to)]]

    def refuse_names(self, count: int) -> None:
        if count == len({node.path for node in self.nodes}):
            return
        name = re.escape(f"application/{self.source.name}".encode())
        every: list[Any] = [*self.project.applications.values(), *self.project.parts.values()]
        for document in (*every, self.project.spds):
            if document is not None and re.search(name + rb"(?![\w-])", codec.write(document)):
                raise self.refuse(
                    f"application/{self.source.name} is used, and some of its states would "
                    "have several names"
                )
