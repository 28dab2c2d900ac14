"""Robot behaviour description: one application as a value.

Seed 001 (HealthBots), Fig. 5; formats.md, *RBD*. Attributes that formats.md
names but Python reserves: ``from`` is ``source``, ``for`` is ``hold``.
All lengths of the screen are percent of the robot's screen, times are seconds.
"""

from __future__ import annotations

from typing import ClassVar, Literal

from msgspec import Struct

from situ.document.aside import NOTHING, Aside
from situ.document.condition import Condition

AGAIN = "#again"
BACK = "#back"

TIMED_OUT = "timeout"
"""The event that a timeout without ``next`` raises."""

RESUMED = "resumed"
"""The event that comes before all others when an application gets its resources back."""


class Param(Struct, frozen=True, gc=False):
    """``<param name="…">text</param>``; the text is a template (references, JSON)."""

    name: str
    text: str = ""
    aside: Aside = NOTHING


class Result(Struct, frozen=True, gc=False):
    """``<result tag="…" path="…"/>``: the part of a service's answer that goes to a tag."""

    tag: str
    path: str = ""
    aside: Aside = NOTHING


# -- screen ------------------------------------------------------------------

Align = Literal["left", "center", "right"]


class Component(Struct, frozen=True, gc=False, kw_only=True):
    """What all six components have. x, y, width, height: percent, origin top left.

    size: the text's height in percent of the screen's height; None: the page chooses.
    """

    element: ClassVar[str] = ""
    id: str
    x: float
    y: float
    width: float
    height: float
    size: float | None = None
    align: Align | None = None
    color: str | None = None
    fill: str | None = None
    aside: Aside = NOTHING


class Text(Component, frozen=True, kw_only=True):
    element: ClassVar[str] = "text"
    text: str = ""


class Button(Component, frozen=True, kw_only=True):
    """``event`` may be None: then it only sets ``tag`` to ``value``."""

    element: ClassVar[str] = "button"
    event: str | None = None
    tag: str | None = None
    value: str | None = None
    text: str = ""


class Image(Component, frozen=True, kw_only=True):
    element: ClassVar[str] = "image"
    src: str = ""


class Movie(Component, frozen=True, kw_only=True):
    """An action ``movie`` of its screen; ``done`` is raised when it ended, ``failed`` where the
    page can not play it."""

    element: ClassVar[str] = "movie"
    src: str = ""
    done: str | None = None
    failed: str | None = None


InputKind = Literal["text", "number", "date", "pin"]


class Input(Component, frozen=True, kw_only=True):
    element: ClassVar[str] = "input"
    tag: str = ""
    kind: InputKind = "text"
    max: int | None = None
    event: str | None = None


class List(Component, frozen=True, kw_only=True):
    element: ClassVar[str] = "list"
    items: str = ""
    label: str = "{item}"
    tag: str | None = None
    event: str | None = None


class Screen(Struct, frozen=True, gc=False):
    """``Screen()`` (``<screen/>``) clears and gives the resource back."""

    background: str | None = None
    touched: str | None = None
    components: tuple[Component, ...] = ()
    aside: Aside = NOTHING

    @property
    def is_empty(self) -> bool:
        """Whether it is ``<screen/>``."""
        return not (self.components or self.background or self.touched)


# -- actions -----------------------------------------------------------------


class Action(Struct, frozen=True, gc=False, kw_only=True):
    """What every action may carry: ``wait``, and the events ``done`` and ``failed``."""

    element: ClassVar[str] = ""
    wait: bool = False
    done: str | None = None
    failed: str | None = None
    aside: Aside = NOTHING


class Speech(Action, frozen=True, kw_only=True):
    element: ClassVar[str] = "speech"
    text: str = ""
    lang: str | None = None
    bargein: bool = False
    optional: bool = False


class Robot(Action, frozen=True, kw_only=True):
    element: ClassVar[str] = "robot"
    resource: str
    command: str
    params: tuple[Param, ...] = ()
    optional: bool = False


class Service(Action, frozen=True, kw_only=True):
    """``url`` is http(s)://…, ``board:module/request`` or ``media:path``."""

    element: ClassVar[str] = "service"
    name: str
    url: str
    method: str = "GET"
    params: tuple[Param, ...] = ()
    results: tuple[Result, ...] = ()
    keep: bool = False


class Message(Action, frozen=True, kw_only=True):
    """With params an object is sent, else the text as a value."""

    element: ClassVar[str] = "message"
    topic: str
    text: str = ""
    params: tuple[Param, ...] = ()


class Launch(Action, frozen=True, kw_only=True):
    element: ClassVar[str] = "launch"
    program: str
    params: tuple[Param, ...] = ()
    keep: bool = False


class Sound(Action, frozen=True, kw_only=True):
    element: ClassVar[str] = "sound"
    src: str
    optional: bool = False


class Set(Action, frozen=True, kw_only=True):
    element: ClassVar[str] = "set"
    tag: str
    text: str = ""


class Add(Action, frozen=True, kw_only=True):
    element: ClassVar[str] = "add"
    tag: str
    text: str = ""


class Append(Action, frozen=True, kw_only=True):
    element: ClassVar[str] = "append"
    tag: str
    text: str = ""


class Take(Action, frozen=True, kw_only=True):
    """Moves one entry of the list at ``source`` to ``tag``: the first, or a random one."""

    element: ClassVar[str] = "take"
    source: str
    tag: str
    order: Literal["first", "random"] = "first"


class Clear(Action, frozen=True, kw_only=True):
    """Deletes the tags that match the pattern ``tag``; never reserved roots."""

    element: ClassVar[str] = "clear"
    tag: str


class Repeat(Action, frozen=True, kw_only=True):
    """``<repeat/>``: only in an event without ``next``."""

    element: ClassVar[str] = "repeat"


VISIBLE_ACTIONS: tuple[type[Action], ...] = (Speech, Robot, Sound)
"""Those that use a resource of the robot; they belong to states, never to events."""


def resource_of(action: Action) -> str | None:
    """The resource that an action uses."""
    if isinstance(action, Robot):
        return action.resource
    return "speech" if isinstance(action, (Speech, Sound)) else None


# -- states ------------------------------------------------------------------


class Say(Struct, frozen=True, gc=False):
    """``<say>phrase</say>``: an utterance that means its event."""

    text: str
    aside: Aside = NOTHING


class Event(Struct, frozen=True, gc=False):
    """One expected event. Without ``name`` it is unnamed, without ``next`` internal.

    next: a state's number, ``#again``, ``#back``, or None.
    """

    name: str | None = None
    next: str | None = None
    when: Condition | None = None
    says: tuple[Say, ...] = ()
    actions: tuple[Action, ...] = ()
    aside: Aside = NOTHING


class Timeout(Struct, frozen=True, gc=False):
    """seconds above 0. Without ``next`` it raises the event ``timeout``."""

    seconds: float
    next: str | None = None
    idle: bool = False
    aside: Aside = NOTHING


class State(Struct, frozen=True, gc=False):
    """``no`` is unique in the application; ``name`` is the label designers see."""

    no: str
    name: str = ""
    flow: str | None = None
    always: bool = True
    final: bool = False
    timeout: Timeout | None = None
    screen: Screen | None = None
    actions: tuple[Action, ...] = ()
    events: tuple[Event, ...] = ()
    aside: Aside = NOTHING

    @property
    def is_end(self) -> bool:
        """Whether none of its own events and no timeout of its own leaves it."""
        timeout = self.timeout.next if self.timeout is not None else None
        return timeout is None and all(event.next is None for event in self.events)


class Always(Struct, frozen=True, gc=False):
    """What is part of every state of the file."""

    timeout: Timeout | None = None
    screen: Screen | None = None
    events: tuple[Event, ...] = ()
    aside: Aside = NOTHING


class Application(Struct, frozen=True, gc=False):
    """One ``*.rbd.xml``. ``start`` None: the first state starts."""

    name: str
    start: str | None = None
    always: Always | None = None
    states: tuple[State, ...] = ()
    aside: Aside = NOTHING

    @property
    def start_no(self) -> str | None:
        """The number of the start state; None only where there is no state."""
        if self.start is not None:
            return self.start
        return self.states[0].no if self.states else None

    def state(self, no: str) -> State | None:
        """The state of that number (the first, if a faulty file has two)."""
        return next((s for s in self.states if s.no == no), None)

    def always_in(self, state: State) -> Always | None:
        """What of ``always`` is part of one of its states: all of it, or nothing."""
        return self.always if state.always else None
