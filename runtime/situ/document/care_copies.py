"""Care with what is private: that it is not copied to where nobody takes it for that."""

from __future__ import annotations

from collections.abc import Iterator

from situ.document import names
from situ.document.analysis_data import placed_actions, screens
from situ.document.analysis_search import Search
from situ.document.aside import Aside
from situ.document.care_people import private_among
from situ.document.datatypes import shown
from situ.document.finding import Place
from situ.document.rbd import Add, Append, Application, Button, List, Set, Take


def copies(search: Search) -> None:
    """``private-copied``: an action, a button or a chosen entry puts a private value
    (``[privacy]``) into a tag that is not private.

    What stands there is hidden only as long as it is known to be private by its value
    (``situ.decide.masking``), and nobody who reads the tag's name takes care of it.
    """
    project = search.project
    if not project.private:
        return
    for file, application in project.flows.items():
        for tag, used, aside, place in _puts(application):
            secret = private_among(project, used)
            if secret is not None and private_among(project, (tag,)) is None:
                message = (
                    f"{shown(secret)} is private, and this copies it to {shown(tag)}, which is "
                    "not: make that private too ([privacy] private), or do without the copy"
                )
                search.warn(file, "private-copied", message, aside, place)


def _puts(application: Application) -> Iterator[tuple[str, tuple[str, ...], Aside, Place]]:
    """Each tag that something is put into, with the names of what is."""
    for action, place in placed_actions(application):
        if isinstance(action, (Set, Add, Append)):
            yield action.tag, tuple(names.references(action.text)), action.aside, place
        elif isinstance(action, Take):
            yield action.tag, (action.source,), action.aside, place
    for screen, place in screens(application):
        for component in screen.components:
            at = (*place, component.id)
            if isinstance(component, List) and component.tag is not None:
                yield component.tag, (component.items,), component.aside, at
            elif isinstance(component, Button) and component.tag is not None:
                used = tuple(names.references(component.value or ""))
                yield component.tag, used, component.aside, at
