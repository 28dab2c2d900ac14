"""What a project's documents mention, and where: texts, events, tags, states, modules, media, and
what designers write beside them.

One table says which attribute of which value mentions what. Finding, *Find usages* and renaming
everywhere are made from it, so they agree. Pure; no Qt.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from msgspec import Struct

from situ.document import condition, drawing, modules, rbd, spds
from situ.document.aside import NOTHING
from situ.document.names import is_name, matches, references
from situ.document.project import Project
from situ_studio.edits import notes, places
from situ_studio.edits.edit import Document, Place

Role = Literal[
    "event", "tag", "state", "situation", "module", "resource", "media", "part", "text", "name"
]

How = Literal[
    "event",
    "tag",
    "field",  # a tag, or a tag and fields
    "pattern",  # of tags
    "state",
    "situation",
    "module",
    "resource",
    "media",
    "part",  # the file that a part runs
    "text",  # what people read, hear or say; may refer to tags
    "value",  # what machines read; may refer to tags
    "url",
    "name",  # a label
]

_ACTION: tuple[tuple[str, How], ...] = (("done", "event"), ("failed", "event"))
_ATTRIBUTES: dict[type, tuple[tuple[str, How], ...]] = {
    rbd.Application: (("name", "name"), ("start", "state")),
    rbd.State: (("no", "state"), ("name", "name"), ("flow", "part")),
    rbd.Timeout: (("next", "state"),),
    rbd.Event: (("name", "event"), ("next", "state")),
    rbd.Say: (("text", "text"),),
    rbd.Screen: (("touched", "event"),),
    rbd.Text: (("text", "text"),),
    rbd.Button: (("text", "text"), ("event", "event"), ("tag", "tag"), ("value", "value")),
    rbd.Image: (("src", "media"),),
    rbd.Movie: (("src", "media"), ("done", "event"), ("failed", "event")),
    rbd.Input: (("tag", "tag"), ("event", "event")),
    rbd.List: (("items", "field"), ("label", "text"), ("tag", "tag"), ("event", "event")),
    rbd.Speech: (("text", "text"), *_ACTION),
    rbd.Robot: (("resource", "resource"), ("command", "name"), *_ACTION),
    rbd.Service: (("name", "name"), ("url", "url"), *_ACTION),
    rbd.Message: (("topic", "name"), ("text", "value"), *_ACTION),
    rbd.Launch: (("program", "name"), *_ACTION),
    rbd.Sound: (("src", "media"), *_ACTION),
    rbd.Set: (("tag", "tag"), ("text", "value"), *_ACTION),
    rbd.Add: (("tag", "tag"), ("text", "value"), *_ACTION),
    rbd.Append: (("tag", "tag"), ("text", "value"), *_ACTION),
    rbd.Take: (("source", "field"), ("tag", "tag"), *_ACTION),
    rbd.Clear: (("tag", "pattern"), *_ACTION),
    rbd.Param: (("name", "name"), ("text", "value")),
    rbd.Result: (("tag", "tag"),),
    condition.Test: (("tag", "field"), ("value", "value")),
    spds.Observed: (("tag", "tag"),),
    spds.Declaration: (("name", "module"), ("resources", "resource")),
    spds.Situation: (("name", "situation"), ("extends", "situation")),
    spds.Entry: (("module", "module"),),
    modules.Module: (("name", "module"), ("resources", "resource"), ("description", "text")),
    modules.Requires: (("data", "field"), ("module", "module")),
    modules.Provides: (("data", "tag"),),
    drawing.Note: (("text", "text"),),
    drawing.Frame: (("title", "text"),),
}


NOTE = "note"
"""The attribute under which stands what is written about a value, in comments of the file."""


class Mention(Struct, frozen=True):
    """One attribute of one value, and what it mentions.

    text: as written. names: each with what it is: ``("event", "clickYes")``. A tag is as it is
    written there, fields included. whole: it is written where a whole tag stands, without fields.
    """

    place: Place
    attribute: str
    text: str
    names: tuple[tuple[Role, str], ...]
    whole: bool = False

    @property
    def is_text(self) -> bool:
        """Whether people read, hear or say it."""
        return ("text", self.text) in self.names


class Found(Struct, frozen=True):
    """A mention in one of the project's files."""

    file: str
    mention: Mention


def _names(how: How, text: str) -> tuple[tuple[Role, str], ...]:
    refs: tuple[tuple[Role, str], ...] = tuple(("tag", name) for name in references(text))
    match how:
        case "text":
            return (("text", text), *refs)
        case "value":
            return refs
        case "media":
            return refs or (("media", text),)
        case "url":
            head, _, rest = text.partition(":")
            if head == "board":
                return (("module", rest.partition("/")[0]), *refs)
            return (("media", rest), *refs) if head == "media" and not refs else refs
        case "pattern":
            return (("tag", text),) if is_name(text) else ()
        case "tag" | "field":
            return (("tag", text),)
        case "state":
            return () if text.startswith("#") else (("state", text),)
        case _:
            return ((how, text),)


def _walk(value: Any, place: Place) -> Iterator[tuple[Place, Any]]:
    yield place, value
    for words, member in places.members(value):
        yield from _walk(member, (*place, *words))


def _of(value: Any, place: Place) -> Iterator[Mention]:
    for at, one in _walk(value, place):
        yield from own(one, at)


def own(value: Any, place: Place) -> Iterator[Mention]:
    """What a value mentions itself, without its members."""
    for attribute, how in _ATTRIBUTES.get(type(value), ()):
        written = getattr(value, attribute)
        if isinstance(written, tuple):
            if written:
                names = tuple(name for text in written for name in _names(how, text))
                yield Mention(place, attribute, " ".join(written), names)
        elif written:
            yield Mention(place, attribute, written, _names(how, written), how == "tag")
    aside = getattr(value, "aside", NOTHING)
    if aside.before or aside.inside or aside.parts or aside.after:
        told = notes.comments_on(value)
        if told:
            yield Mention(place, NOTE, told, ())


def _drawn(document: Document) -> Iterator[Mention]:
    """The notes and frames of an application."""
    every = drawing.drawn(document) if isinstance(document, rbd.Application) else ()
    for kind, type_ in places.DRAWN.items():
        for index, value in enumerate(one for one in every if isinstance(one, type_)):
            yield from own(value, (kind, str(index)))


def mentions(document: Document) -> Iterator[Mention]:
    """Everything that a document mentions, in its order."""
    yield from _of(document, ())
    yield from _drawn(document)


class Index:
    """The mentions of successive values of a project; only members that changed are read anew."""

    def __init__(self) -> None:
        self._known: dict[int, tuple[Any, tuple[Mention, ...]]] = {}

    def every(self, project: Project) -> Iterator[Found]:
        """Everything that the project's documents mention: applications, parts, script, modules."""
        kept: dict[int, tuple[Any, tuple[Mention, ...]]] = {}
        for file, document in documents(project).items():
            for mention in own(document, ()):
                yield Found(file, mention)
            for words, member in places.members(document):
                known = self._known.get(id(member))
                if known is None or known[0] is not member:
                    known = member, tuple(_of(member, words))
                kept[id(member)] = known
                for mention in known[1]:
                    yield Found(file, mention)
            for mention in _drawn(document):
                yield Found(file, mention)
        self._known = kept


def documents(project: Project) -> dict[str, Document]:
    """File to document, in the order in which the studio lists them."""
    found: dict[str, Document] = {**project.applications, **project.parts}
    if project.spds is not None and project.spds_file is not None:
        found[project.spds_file] = project.spds
    if project.modules is not None and project.modules_file is not None:
        found[project.modules_file] = project.modules
    return found


def names_of(document: Document, place: Place) -> tuple[tuple[Role, str], ...]:
    """What can be looked for everywhere of what stands at a place: ``("event", "clickYes")``.

    What the value is itself comes first, then what it mentions; texts and labels are no names.
    """
    value = places.get(document, place)
    found: dict[tuple[Role, str], None] = {}
    for mention in own(value, place):
        for role, name in mention.names:
            if role not in ("text", "name"):
                found[role, name] = None
    return tuple(found)


def tags(every: list[Found], project: Project) -> frozenset[str]:
    """Every tag that something writes or declares, or that is set before the start."""
    return frozenset({*project.tags, *(f.mention.text for f in every if f.mention.whole)})


def tag_of(name: str, known: frozenset[str]) -> str:
    """The tag that a name means: the longest known one that begins it, else its first word."""
    words = name.split(".")
    for end in range(len(words), 0, -1):
        if ".".join(words[:end]) in known:
            return ".".join(words[:end])
    return words[0]


def usages(every: list[Found], role: Role, name: str, file: str = "") -> list[Found]:
    """Where something is mentioned by exactly that name.

    Of a tag: its fields too, and patterns that mean it. ``file``: whose state is meant, as states
    are known in their own document only.
    """
    return [
        found
        for found in every
        if (role != "state" or found.file == file)
        and (
            any(r == role and _means(role, n, name) for r, n in found.mention.names)
            or (role == "tag" and _is_pattern_for(found.mention, name))
        )
    ]


def _means(role: Role, written: str, name: str) -> bool:
    return written == name or (role == "tag" and written.startswith(f"{name}."))


def _is_pattern_for(mention: Mention, name: str) -> bool:
    written = "*" in mention.text and not mention.names and mention.attribute != NOTE
    return written and matches(mention.text, name)
