"""What a form's rows say of the members of a list."""

from __future__ import annotations

from typing import Any

from situ.document import rbd
from situ_studio import kinds
from situ_studio.edits.edit import Document
from situ_studio.edits.words import condition_words, leads_to
from situ_studio.panels.rows import Row
from situ_studio.wording.language import tr, translated


def action_row(action: rbd.Action, mark: str = "") -> Row:
    """An action: its kind and what it does; a service's values and results below."""
    kind = kinds.kind_of(action)
    assert kind is not None
    under: list[tuple[str, str]] = []
    if isinstance(action, rbd.Service):
        under += [(p.name, p.text) for p in action.params]
        under += [
            (tr("result"), f"{r.tag} ← {r.path}" if r.path else r.tag) for r in action.results
        ]
    return Row(
        icon=kind.icon,
        title=translated(kind.title),
        detail=kind.summary(action),
        under=tuple(under),
        mark=mark,
    )


def component_row(component: rbd.Component, mark: str = "") -> Row:
    """A component: its text or file, and its id."""
    kind: Any = kinds.kind_of(component)
    return Row(icon=kind.icon, title=component.id, detail=kind.summary(component), mark=mark)


def event_row(document: Document, event: rbd.Event, mark: str = "") -> Row:
    """An event: its name, its phrases, where it leads, and its guard."""
    guard = ""
    if event.when is not None:
        guard = tr("if {0}").format(condition_words(event.when))
    phrases = ", ".join(f"“{s.text}”" for s in event.says)
    return Row(
        icon="event",
        title=event.name or tr("at once"),
        under=((tr("said as"), phrases),) if phrases else (),
        target=leads_to(document, event.next),
        guard=guard,
        mark=mark,
    )
