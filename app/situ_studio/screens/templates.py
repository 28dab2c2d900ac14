"""Screens to begin with, as ``resources/screens/templates.rbd.xml`` has them."""

from __future__ import annotations

from functools import cache

from msgspec.structs import replace

from situ.document import codec, rbd
from situ.errors import UsageError
from situ.resources import resource
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.wording.language import tr

FILE = ("screens", "templates.rbd.xml")
TEMPLATE = "application/x-situ-template"
"""What is dragged: the template, as ``written``."""


@cache
def templates() -> dict[str, rbd.State]:
    """Name to template: a state with nothing but a screen and the events that it raises."""
    path = resource(*FILE)
    document, problems = codec.read(path.read_bytes(), str(path))
    if not isinstance(document, rbd.Application) or problems:
        raise UsageError(tr("{0} is damaged: install situ again").format(path))
    return {state.name: state for state in document.states}


def title(name: str) -> str:
    """What a template is called, in the user's language."""
    return {
        "two-answers": tr("Two answers"),
        "list": tr("List"),
        "entry": tr("Entry"),
        "pin": tr("PIN"),
        "video": tr("Video"),
        "message": tr("Message"),
        "four-choices": tr("Four choices"),
        "picture": tr("Picture"),
    }.get(name, name)


def raised(screen: rbd.Screen) -> tuple[str, ...]:
    """The events that its components raise, each once, in their order."""
    every = (getattr(c, "event", None) or getattr(c, "done", None) for c in screen.components)
    return tuple(dict.fromkeys(event for event in every if event))


def written(template: rbd.State) -> bytes:
    """A template as a drag carries it: a file with one state."""
    return codec.write(rbd.Application(name="template", states=(template,)))


def read(data: bytes) -> rbd.State | None:
    """What ``written`` wrote; None where it is anything else."""
    document, _ = codec.read(data, "template") if data.strip() else (None, [])
    if not isinstance(document, rbd.Application) or len(document.states) != 1:
        return None
    return document.states[0] if document.states[0].screen is not None else None


def applied(application: rbd.Application, place: Place, template: rbd.State) -> rbd.Application:
    """The application in which the state at ``place`` has the template's components.

    Its background stays. Events that the new screen raises and the state does not expect yet
    are added, leading nowhere; none is taken away.
    """
    part = places.get(application, place)
    assert template.screen is not None
    screen = replace(part.screen or rbd.Screen(), components=template.screen.components)
    known = {event.name for event in part.events}
    events = tuple(event for event in template.events if event.name not in known)
    return places.change(application, place, screen=screen, events=(*part.events, *events))
