"""Trace events in plain words, for chains of causes, failures and reasons."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from situ.decide.values import in_text
from situ.document import words
from situ.document.names import RESERVED_ROOTS
from situ.document.project import Project
from situ.rehearse.recording import Fields
from situ.rehearse.ways import name_of_state


class Teller:
    """Tells events of one project; without a project states go by their numbers.

    me: the writer who is told of his own deeds, as *you*.
    """

    def __init__(self, project: Project | None = None, me: str | None = None) -> None:
        self._project = project
        self._me = me

    def tell(self, event: Fields) -> str:
        """The event in a few words: ``reception enters 5 verify initials``."""
        how = _TOLD.get(event["kind"])
        return f"{event['kind']}" if how is None else how(self, event)

    def line(self, event: Fields) -> str:
        """Time, seq and words: ``12.5 s  #37  reception enters 5 verify initials``."""
        return f"{moment(event['t'])}  #{event['seq']}  {self.tell(event)}"

    def origin(self, event: Fields) -> str:
        """Where an event without a cause comes from."""
        if event["cause"] is not None:
            return f"because of #{event['cause']}"
        started = event["t"] == 0 and event["kind"] not in ("acquire", "abandon", "event", "lost")
        return (
            "the start" if started and event.get("writer") in (None, "project") else "from outside"
        )

    def who(self, writer: str) -> str:
        """Who that is: ``operator ann``, a module by its name, or ``you``."""
        if self.is_me(writer):
            return "you"
        role, _, name = writer.partition(":")
        return f"operator {name}" if role == "operator" and name else writer

    def is_me(self, writer: str) -> bool:
        """Whether that is who is told of it."""
        return writer == self._me

    def state(self, application: str, no: str) -> str:
        """A state by number and name."""
        return no if self._project is None else name_of_state(self._project, application, no)


def moment(t: float) -> str:
    """A time: ``12.5 s``, to the microsecond."""
    return words.seconds(round(t, 6))


def value_words(value: Any) -> str:
    """A value in a line: ``true``, ``“Ann”``, ``nothing``."""
    if value is None:
        return "nothing"
    return words.quoted(value) if isinstance(value, str) else _short(in_text(value))


def _short(text: str) -> str:
    return text if len(text) <= words.LONGEST else text[: words.LONGEST - 1] + "…"


def action_words(event: Fields) -> str:
    """An action of the trace: ``speech “Hello”``, ``robot goto``."""
    kind, name = event["action"], event["name"]
    if kind == "speech" and isinstance(event.get("text"), str):
        return f"speech {words.quoted(event['text'])}"
    if kind == "sound" and isinstance(event.get("src"), str):
        return f"sound {event['src']}"
    if name is not None:
        resource = event.get("resource")  # which only a robot's actions have
        return f"robot {name} on {resource}" if resource else f"{kind} {name}"
    tag = event.get("tag") or event.get("topic")
    return f"{kind} {tag}" if tag else str(kind)


def _data(teller: Teller, event: Fields) -> str:
    tag, writer = event["tag"], event["writer"]
    value = None if event["value"] is None else value_words(event["value"])
    if teller.is_me(writer):
        return f"you delete {tag}" if value is None else f"you set {tag} to {value}"
    who = teller.who(writer)
    return f"{who} deletes {tag}" if value is None else f"{who} sets {tag} to {value}"


def _event(teller: Teller, event: Fields) -> str:
    name, application, writer = event["name"], event["application"], event.get("writer")
    if writer is None:
        return f"event {name} comes to {application}"
    return f"event {name} comes to {application}, raised by {teller.who(writer)}"


def _transition(teller: Teller, event: Fields) -> str:
    writer = event.get("writer")
    by = "an unnamed event" if writer is None else teller.who(writer)
    if event.get("timeout"):
        by = "the timeout"
    if event["event"] is not None:
        by = event["event"]
    source = teller.state(event["application"], event["from"])
    to = teller.state(event["application"], event["to"])
    return f"{event['application']} goes from {source} to {to} by {by}"


def _authority(teller: Teller, event: Fields) -> str:
    if event["to"] is None:
        return f"{event['from']} loses {event['resource']}, nobody holds it"
    if event["from"] is None:
        return f"{event['to']} gets {event['resource']}"
    return f"{event['to']} gets {event['resource']} from {event['from']}"


def _mapping(teller: Teller, event: Fields) -> str:
    if event["value"] is None:
        return f"{event['resource']} stops and holds"
    shown = event["value"] if isinstance(event["value"], dict) else {}
    components = shown.get("components")
    # What a module commands may have any form.
    if isinstance(components, list) and all(isinstance(one, dict) for one in components):
        texts = [str(one["text"]) for one in components if one.get("text")]
        if texts:
            return f"{event['module']} shows {words.quoted(texts[0])} on the {event['resource']}"
        return f"{event['module']} shows something else on the {event['resource']}"
    if shown.get("text"):
        return f"{event['module']} says {words.quoted(in_text(shown['text']))}"
    return f"{event['module']} moves {event['resource']}: {_short(in_text(event['value']))}"


def _ignored(teller: Teller, event: Fields) -> str:
    application, name = event["application"], event["name"]
    if event["reason"] == "suspended":
        return f"{application} ignores {name}: it is suspended"
    if event["reason"] == "guard":
        return f"{application} ignores {name}: it has no guard for it that holds"
    if event["reason"] == "unexpected":
        return f"{application} ignores {name}: it does not expect it here"
    return f"{application} ignores {name}: it {event['reason']}"


def _finished(teller: Teller, event: Fields) -> str:
    what = action_words(event)
    return f"{what} ends well" if event["ok"] else f"{what} ends badly: {event.get('error')}"


def _who(teller: Teller, event: Fields) -> str:
    """The operator, or the breakpoint where nobody else did it."""
    writer = event.get("writer")
    return f"breakpoint {event['breakpoint']}" if writer is None else teller.who(writer)


def _condition(teller: Teller, event: Fields) -> str:
    if event["holds"]:
        return f"the condition of situation {event['situation']} holds"
    return f"the condition of situation {event['situation']} no longer holds"


def _situation(teller: Teller, event: Fields) -> str:
    if event["from"] is None:
        return f"situation {event['to']}"
    return f"situation {event['to']} after {event['from']}"


def _deployed(teller: Teller, event: Fields) -> str:
    version, writer = event["version"], teller.who(event["writer"])
    if not event["files"]:
        return f"version {version} takes over, deployed by {writer}"
    changed = words.listed(event["files"])
    return f"version {version} takes over, deployed by {writer}; changed: {changed}"


def _in(teller: Teller, event: Fields) -> str:
    """The state that an event is about."""
    return teller.state(event["application"], event["state"])


_TOLD: dict[str, Callable[[Teller, Fields], str]] = {
    "data": _data,
    "condition": _condition,
    "situation": _situation,
    "acquire": lambda teller, e: f"{e['module']} asks for {words.listed(_asked(e)) or 'nothing'}",
    "abandon": lambda teller, e: f"{e['module']} gives back {words.listed(e['resources'])}",
    "lost": lambda teller, e: f"{e['module']} is lost",
    "connected": lambda teller, e: f"{e['module']} connects",
    "authority": _authority,
    "mapping": _mapping,
    "event": _event,
    "ignored": _ignored,
    "exit": lambda teller, e: f"{e['application']} leaves {_in(teller, e)}",
    "enter": lambda teller, e: f"{e['application']} enters {_in(teller, e)}",
    "transition": _transition,
    "screen": lambda teller, e: f"{e['application']} shows the screen of {_in(teller, e)}",
    "action": lambda teller, e: f"{e['application']} begins {action_words(e)}",
    "finished": _finished,
    "cancelled": lambda teller, e: f"{action_words(e)} is cancelled",
    "suspend": lambda teller, e: (
        f"{e['application']} is suspended: it does not hold {words.listed(e['missing'])}"
    ),
    "resume": lambda teller, e: f"{e['application']} goes on",
    "paused": lambda teller, e: (
        f"{e['application']} is paused in {_in(teller, e)} by {_who(teller, e)}"
    ),
    "resumed": lambda teller, e: f"{e['application']} is no longer paused, by {_who(teller, e)}",
    "deployed": _deployed,
    "warning": lambda teller, e: f"warning: {e['message']}",
    "error": lambda teller, e: f"error: {e['message']}",
}


def _asked(event: Fields) -> list[str]:
    return [*event["resources"], *event.get("optional", ())]


def kept_by_runtime(tag: str) -> bool:
    """Whether a tag is written by the runtime itself, so that nobody sets it."""
    return tag.startswith((*RESERVED_ROOTS, "clock.")) or tag in ("situation", "listen")
