"""The rows of the outline twin: what stands in them, and what of it can be edited."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from situ.document import modules, rbd, spds
from situ_studio import kinds
from situ_studio.edits import words
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr, translated

Editable = dict[int, tuple[Place, str, str]]
"""Column to place, attribute and label of what is edited there."""


class Node:
    """One row: its value, its cells, and rows below that are made when they are asked for."""

    def __init__(
        self,
        place: Place,
        value: Any,
        icon: tuple[str, str],
        cells: tuple[str, ...],
        editable: Editable | None = None,
        below: Callable[[], list[Node]] | None = None,
        has_children: bool = True,
    ) -> None:
        self.place, self.value, self.icon, self.cells = place, value, icon, cells
        self.editable = editable or {}
        self.parent: Node | None = None
        self.row = 0
        self.has_children = below is not None and has_children
        self._below = below
        self._children: list[Node] | None = None

    @property
    def children(self) -> list[Node]:
        if self._children is None:
            self._children = self._below() if self._below is not None else []
            for row, child in enumerate(self._children):
                child.parent, child.row = self, row
        return self._children


def _icon(value: Any) -> tuple[str, str]:
    kind = kinds.kind_of(value)
    return (kind.icon, str(kind.tint)) if kind is not None else ("info", "text2")


def _seconds(timeout: rbd.Timeout) -> str:
    text = tr("{0} s idle") if timeout.idle else tr("{0} s")
    return text.format(f"{timeout.seconds:g}")


def _part_rows(document: rbd.Application, place: Place, part: Any) -> list[Node]:
    rows: list[Node] = []
    if part.screen is not None:
        at = (*place, "screen")
        rows.append(
            Node(
                at,
                part.screen,
                ("screen", "text2"),
                (tr("Screen"), "", "", part.screen.touched or ""),
                below=lambda: [
                    Node(
                        (*at, c.id),
                        c,
                        _icon(c),
                        (_title(c), c.id, getattr(c, "event", None) or "", _summary(c)),
                        {1: ((*at, c.id), "id", tr("Id"))},
                    )
                    for c in part.screen.components
                ],
            )
        )
    for index, action in enumerate(getattr(part, "actions", ())):
        rows.append(_action((*place, "action", str(index)), action))
    for index, event in enumerate(part.events):
        rows.append(_event(document, (*place, "event", str(index)), event))
    if part.timeout is not None:
        at = (*place, "timeout")
        rows.append(
            Node(
                at,
                part.timeout,
                ("timeout", "text2"),
                (
                    tr("Timeout"),
                    _seconds(part.timeout),
                    words.leads_to(document, part.timeout.next) if part.timeout.next else "",
                    "",
                ),
                {1: (at, "seconds", tr("Seconds")), 2: (at, "next", tr("Leads to"))},
            )
        )
    return rows


def _title(value: Any) -> str:
    kind = kinds.kind_of(value)
    return translated(kind.title) if kind is not None else ""


def _summary(value: Any) -> str:
    kind = kinds.kind_of(value)
    return kind.summary(value) if kind is not None else ""


def _action(place: Place, action: rbd.Action) -> Node:
    editable: Editable = {}
    if isinstance(action, rbd.Speech):
        editable = {1: (place, "text", tr("Text"))}
    ends = ", ".join(e for e in (action.done, action.failed) if e)
    return Node(
        place, action, _icon(action), (_title(action), _summary(action), ends, ""), editable
    )


def _event(document: rbd.Application, place: Place, event: rbd.Event) -> Node:
    guard = ""
    if event.when is not None:
        guard = tr("if {0}").format(words.condition_words(event.when))
    phrases = ", ".join(f"“{s.text}”" for s in event.says)
    details = "; ".join(w for w in (guard, phrases) if w)
    return Node(
        place,
        event,
        ("event", "text2"),
        (tr("Event"), event.name or "", words.leads_to(document, event.next), details),
        {1: (place, "name", tr("Event")), 2: (place, "next", tr("Leads to"))},
        partial(_below_event, place, event),
        event.when is not None or bool(event.actions),
    )


def _below_event(place: Place, event: rbd.Event) -> list[Node]:
    actions = [_action((*place, "action", str(i)), a) for i, a in enumerate(event.actions)]
    if event.when is None:
        return actions
    cells = (tr("Only if"), words.condition_words(event.when), "", "")
    return [Node((*place, "when"), event.when, ("guard", "condition"), cells), *actions]


def application_rows(document: rbd.Application) -> Iterator[Node]:
    always = document.always
    if always is not None:
        yield Node(
            ("always",),
            always,
            ("always", "text2"),
            (tr("In every state"), "", "", ""),
            below=lambda: _part_rows(document, ("always",), always),
        )
    for state in document.states:
        place = ("state", state.no)
        start = state.no == document.start_no
        speech = next((a.text for a in state.actions if isinstance(a, rbd.Speech)), "")
        yield Node(
            place,
            state,
            ("start", "start") if start else ("state", "state"),
            (state.no, state.name, "", " ".join(speech.split())),
            {0: (place, "no", tr("Number")), 1: (place, "name", tr("Name"))},
            partial(_part_rows, document, place, state),
            bool(state.screen or state.actions or state.events or state.timeout),
        )


def script_rows(document: spds.Spds) -> Iterator[Node]:
    for number, situation in enumerate(document.situations, start=1):
        place = ("situation", situation.name)
        holds = words.condition_words(situation.condition) or tr("always")
        yield Node(
            place,
            situation,
            ("situation", "situation"),
            (tr("Situation {0}").format(number), situation.name, situation.extends or "", holds),
            {1: (place, "name", tr("Name")), 2: (place, "extends", tr("Takes over"))},
            partial(_entries, place, situation),
            bool(situation.entries),
        )
    for module in document.modules:
        place = ("module", module.name)
        yield Node(
            place,
            module,
            ("module", "module"),
            (tr("Module"), module.name, "", " ".join(module.resources)),
            {1: (place, "name", tr("Name")), 3: (place, "resources", tr("Resources"))},
        )
    for data in document.observe:
        place = ("data", data.tag)
        about = kinds.type_words(data.type, data.unit)
        yield Node(
            place,
            data,
            ("data", "data"),
            (tr("Data"), data.tag, "", about),
            {1: (place, "tag", tr("Tag"))},
        )


def _entries(place: Place, situation: spds.Situation) -> list[Node]:
    return [
        Node(
            (*place, "entry", str(i)),
            e,
            ("module", "module"),
            (tr("Priority"), e.module, "", tr("none") if e.priority is None else str(e.priority)),
            {3: ((*place, "entry", str(i)), "priority", tr("Priority"))},
        )
        for i, e in enumerate(situation.entries)
    ]


def information_rows(document: modules.Modules) -> Iterator[Node]:
    for module in document.modules:
        place = ("module", module.name)
        yield Node(
            place,
            module,
            ("module", "module"),
            (tr("Module"), module.name, " ".join(module.resources), module.description),
            {
                1: (place, "name", tr("Name")),
                2: (place, "resources", tr("Resources")),
                3: (place, "description", tr("Does")),
            },
            partial(_needed_and_provided, place, module),
            bool(module.requires or module.provides),
        )


def _needed_and_provided(place: Place, module: modules.Module) -> list[Node]:
    return [
        *(
            Node(
                (*place, "requires", str(i)),
                r,
                ("link", "text2"),
                (tr("Needs"), r.data or r.module or "", "", "" if r.data else tr("module")),
            )
            for i, r in enumerate(module.requires)
        ),
        *(
            Node(
                (*place, "provides", str(i)),
                o,
                ("data", "data"),
                (tr("Provides"), o.data, "", kinds.type_words(o.type, o.unit)),
            )
            for i, o in enumerate(module.provides)
        ),
    ]
