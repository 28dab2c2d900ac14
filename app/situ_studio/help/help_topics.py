"""Everything that the help explains, joined from the tables of kinds, commands and views.

A topic goes by ``page/script``, ``kind/state``, ``field/state.timeout``, ``command/save``,
``panel/problems`` or ``status/link``.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct
from PySide6.QtWidgets import QWidget

from situ_studio import actions, kinds
from situ_studio.actions import Command
from situ_studio.commands.menus import told
from situ_studio.help.help_texts import PAGES, PANELS, explained, helped
from situ_studio.kinds import Field, Kind
from situ_studio.wording.language import translated

HELP = "help"
"""The property of a widget that names its topic."""


class Topic(Struct, frozen=True, kw_only=True):
    """What is said of one thing, in the user's language.

    paragraphs: its text. rows: what belongs to it, each with its explanation. see: other topics.
    """

    id: str
    title: str
    paragraphs: tuple[str, ...]
    rows: tuple[tuple[str, str], ...] = ()
    see: tuple[str, ...] = ()

    @property
    def sort(self) -> str:
        """``page``, ``kind``, ``field``, ``command``, ``panel`` or ``status``."""
        return self.id.partition("/")[0]


def topics() -> dict[str, Topic]:
    """All of them by their ids, pages first."""
    found = [*_pages(), *_kinds(), *_panels(), *_commands()]
    return {topic.id: topic for topic in found}


def field_topic(kind: Kind, field: Field) -> str:
    """The id of a field's topic."""
    return f"field/{kind.name}.{field.attribute}"


def explain(widget: QWidget, kind: str, attribute: str) -> None:
    """Gives a widget the tip and the topic of a field of the table of kinds.

    KeyError, or StopIteration, where there is no such field.
    """
    row = kinds.kind(kind)
    field = next(one for one in row.fields if one.attribute == attribute)
    widget.setToolTip(translated(field.help))
    widget.setProperty(HELP, field_topic(row, field))


def command_topic(command: Command) -> str:
    """The id of a command's topic: what inserts a kind is explained with that."""
    if command.handler == "insert":
        return f"kind/{command.argument}"
    return f"command/{command.id}"


def _pages() -> Iterator[Topic]:
    for page in PAGES:
        texts = tuple(map(helped, page.paragraphs))
        yield Topic(
            id=f"page/{page.id}", title=helped(page.title), paragraphs=texts, see=page.about
        )


def _read_more(id: str) -> tuple[str, ...]:
    """The pages that explain a topic."""
    return tuple(f"page/{page.id}" for page in PAGES if id in page.about)


def _kinds() -> Iterator[Topic]:
    for kind in kinds.KINDS:
        id = f"kind/{kind.name}"
        inner = tuple(field for section in kind.sections for field in section.fields)
        every = (*kind.fields, *inner)
        lists = tuple(s for s in kind.sections if s.help)
        yield Topic(
            id=id,
            title=translated(kind.title),
            paragraphs=(translated(kind.help),),
            rows=tuple((translated(f.label), translated(f.help)) for f in every)
            + tuple((translated(s.title), translated(s.help)) for s in lists),
            see=_read_more(id),
        )
        for field in every:
            title = f"{translated(kind.title)}: {translated(field.label)}"
            text = translated(field.help)
            yield Topic(id=field_topic(kind, field), title=title, paragraphs=(text,), see=(id,))


def _panels() -> Iterator[Topic]:
    for id, panel in PANELS.items():
        title, text = helped(panel.title), helped(panel.text)
        yield Topic(id=id, title=title, paragraphs=(text,), see=_read_more(id))


def _commands() -> Iterator[Topic]:
    for command in actions.COMMANDS:
        id = command_topic(command)
        if id.startswith("command/"):
            text = explained(command)
            yield Topic(id=id, title=told(command), paragraphs=(text,), see=_read_more(id))
