"""The sections of the project form: each shows a part of ``situ.toml`` and tells changes of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from situ.document import names
from situ.document import toml_writing as writing
from situ.document.beside import Toml
from situ.document.project import SETTING_TYPES
from situ_studio.edits.edit import Place
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.panels.fields import Choice, Line, Number
from situ_studio.project_form.boxes import (
    LABEL,
    RowsSection,
    Tables,
    table_of,
    texts_of,
)
from situ_studio.project_form.checks import broker, free, named, once, pattern, tag, topic
from situ_studio.project_form.rows import Checked, Column
from situ_studio.project_form.values import ValueField
from situ_studio.texts.model import language_name
from situ_studio.wording.language import tr


class LanguagesSection(RowsSection):
    """The first is the one in which the documents are written."""

    movable = True
    language_asked = Signal()

    def __init__(self, theme: Theme) -> None:
        columns = (Column(title=""), Column(title="", share=3), Column(title="", share=3))
        super().__init__(
            theme,
            tr("Languages"),
            tr("The documents are written in the first one; the others have translations."),
            columns,
            tr("a language"),
        )
        self._codes: list[str] = []

    def show_tables(self, tables: Tables) -> None:
        self._codes = texts_of(table_of(tables, "project").get("languages"))
        self.show_values(
            [
                (code, language_name(code), "" if at else tr("written in"))
                for at, code in enumerate(self._codes)
            ]
        )

    def on_added(self) -> None:
        self.language_asked.emit()

    def on_removed(self, row: int) -> None:
        codes = [code for at, code in enumerate(self._codes) if at != row]
        words = tr("Remove {0}").format(language_name(self._codes[row]))
        self.tell(lambda toml: writing.put(toml, "project", "languages", codes or None), words)

    def on_moved(self, row: int, to: int) -> None:
        codes = list(self._codes)
        codes.insert(to, codes.pop(row))
        words = tr("Move {0}").format(language_name(self._codes[row]))
        self.tell(lambda toml: writing.put(toml, "project", "languages", codes), words)


class PatternsSection(RowsSection):
    """A list of tags and patterns at ``table.key``."""

    def __init__(self, theme: Theme, table: str, key: str, title: str, hint: str) -> None:
        self._table, self._key = table, key
        self._patterns: list[str] = []
        check = once(pattern, lambda: self._patterns)
        one = Column(
            title="",
            make=lambda _, parent: Checked(check, parent),
            help=tr("A tag, or several by a pattern: user.* is all that begin with user."),
        )
        super().__init__(theme, title, hint, (one,), tr("a tag or pattern"))

    def show_tables(self, tables: Tables) -> None:
        self._patterns = texts_of(table_of(tables, self._table).get(self._key))
        self.show_values([(one,) for one in self._patterns])

    def _put(self, wanted: list[str], words: str) -> None:
        self.tell(lambda toml: writing.put(toml, self._table, self._key, wanted), words)

    def on_changed(self, row: int, column: int, value: Any) -> None:
        wanted = list(self._patterns)
        wanted[row] = value
        self._put(wanted, tr("Change {0}").format(self._patterns[row]))

    def on_removed(self, row: int) -> None:
        wanted = [one for at, one in enumerate(self._patterns) if at != row]
        self._put(wanted, tr("Remove {0}").format(self._patterns[row]))

    def on_added(self) -> None:
        wanted = [*self._patterns, free("new.*", self._patterns)]
        self.added(lambda toml: writing.put(toml, self._table, self._key, wanted))


class TableSection(RowsSection):
    """A table whose keys are a designer's own: a name, and what stands there."""

    def __init__(
        self,
        theme: Theme,
        table: str,
        title: str,
        hint: str,
        columns: Sequence[Column],
        noun: str,
        check: Callable[[str], str],
    ) -> None:
        self._table = table
        self.values: dict[str, Any] = {}
        named = once(check, lambda: list(self.values))
        name = Column(
            title=tr("Name"),
            make=lambda _, parent: Checked(named, parent),
            share=2,
            help=self.name_help(),
        )
        super().__init__(theme, title, hint, (name, *columns), noun)

    def name_help(self) -> str:
        """What the tooltip of a row's name says."""
        raise NotImplementedError

    def row(self, value: Any) -> Sequence[Any]:
        """What the columns behind the name show of a value."""
        return (value,)

    def value(self, old: Any, column: int, typed: Any) -> Any:
        """The value after a column behind the name (from 0) was changed; ValueError, in a
        sentence, where that can not be.
        """
        return typed

    def beginning(self) -> tuple[str, Any]:
        """Name and value of a new row."""
        return "new", ""

    def table(self, tables: Tables) -> Mapping[str, Any]:
        """The table, of what the file says."""
        return table_of(tables, self._table)

    def put(self, toml: Toml, name: str, value: Any) -> Toml:
        """The file with another value of a name; None takes it out."""
        return writing.put(toml, self._table, name, value)

    def rename(self, toml: Toml, old: str, new: str) -> Toml:
        """The file with another name of a value."""
        return writing.rename(toml, self._table, old, new)

    def row_of(self, place: Place) -> int | None:
        return list(self.values).index(place[-1]) if place and place[-1] in self.values else None

    def show_tables(self, tables: Tables) -> None:
        self.values = dict(self.table(tables))
        self.show_again()

    def show_again(self) -> None:
        """Shows what the file says, whatever was typed."""
        self.show_values([(name, *self.row(value)) for name, value in self.values.items()])

    def on_changed(self, row: int, column: int, value: Any) -> None:
        name, old = list(self.values.items())[row]
        if column == 0:
            words = tr("Rename {0} to {1}").format(name, value)
            self.tell(lambda toml: self.rename(toml, name, value), words)
            return
        try:
            new = self.value(old, column - 1, value)
        except ValueError as wrong:
            self.refused.emit(str(wrong))
            self.show_again()
            return
        words = tr("Change {0}").format(name)
        self.tell(lambda toml: self.put(toml, name, new), words)

    def on_removed(self, row: int) -> None:
        name = list(self.values)[row]
        words = tr("Remove {0}").format(name)
        self.tell(lambda toml: self.put(toml, name, None), words)

    def on_added(self) -> None:
        name, value = self.beginning()
        name = free(name, self.values)
        self.added(lambda toml: self.put(toml, name, value))


class TagsSection(TableSection):
    """Values on the blackboard before the start."""

    def __init__(self, theme: Theme, hint: str) -> None:
        value = Column(
            title=tr("Value"),
            make=ValueField,
            share=4,
            help=tr("What stands there when the robot starts."),
        )
        super().__init__(
            theme, "tags", tr("Values at the start"), hint, (value,), tr("a value"), tag
        )

    def name_help(self) -> str:
        return tr("Its tag: words with dots between, such as user.name.")


class PlacesSection(TableSection):
    """Places in the robot's map."""

    def __init__(self, theme: Theme) -> None:
        numbers = (
            Column(
                title="x",
                make=lambda _, parent: Number(parent, "m"),
                help=tr("Metres along the map's x axis."),
            ),
            Column(
                title="y",
                make=lambda _, parent: Number(parent, "m"),
                help=tr("Metres along the map's y axis."),
            ),
            Column(
                title=tr("Heading"),
                make=lambda _, parent: Number(parent, "°"),
                help=tr("Where it looks when it stands there: degrees, 0 is along the x axis."),
            ),
        )
        super().__init__(
            theme,
            "places",
            tr("Places"),
            tr("Where the robot can be sent: metres and degrees in its map."),
            numbers,
            tr("a place"),
            named,
        )

    def name_help(self) -> str:
        return tr("What actions call the place.")

    def row(self, value: Any) -> Sequence[Any]:
        good = isinstance(value, list) and len(value) == 3
        return [one if isinstance(one, (int, float)) else 0 for one in value] if good else (0, 0, 0)

    def value(self, old: Any, column: int, typed: Any) -> Any:
        return [typed or 0 if at == column else one for at, one in enumerate(self.row(old))]

    def beginning(self) -> tuple[str, Any]:
        return "place", [0.0, 0.0, 0.0]


class MqttSection(TableSection):
    """What messages from outside mean here."""

    def __init__(self, theme: Theme) -> None:
        columns = (
            Column(
                title=tr("Means"),
                make=_means,
                share=1,
                help=tr("Whether a message is an event, or the new value of a tag."),
            ),
            Column(
                title=tr("Event or tag"),
                make=lambda _, p: Checked(named, p),
                share=2,
                help=tr("The event that happens, or the tag that gets the value."),
            ),
        )
        super().__init__(
            theme,
            "mqtt",
            tr("Messages from outside"),
            tr("Devices such as fall sensors and call buttons, by an MQTT broker."),
            columns,
            tr("a topic"),
            topic,
        )
        self.broker = Checked(broker)
        self.broker.setPlaceholderText("mqtt://127.0.0.1:1883")
        self.broker.setAccessibleName(tr("Broker"))
        self.broker.set_help(tr("Where the messages come from; nothing is heard without one."))
        self.broker.refused.connect(self.refused)
        self.broker.committed.connect(
            lambda value: self.tell(
                lambda toml: writing.put(toml, "mqtt", "url", value or None), tr("Change broker")
            )
        )
        line = QHBoxLayout()
        label = QLabel(tr("Broker"))
        label.setProperty("role", "label")
        label.setMinimumWidth(px(LABEL))
        label.setBuddy(self.broker)
        label.setToolTip(self.broker.toolTip())
        line.addWidget(label)
        line.addWidget(self.broker, 1)
        self.body.insertLayout(2, line)

    def name_help(self) -> str:
        return tr("The topic whose messages count.")

    def show_tables(self, tables: Tables) -> None:
        url = table_of(tables, "mqtt").get("url")
        self.broker.show_value(url if isinstance(url, str) else "")
        super().show_tables(tables)

    def table(self, tables: Tables) -> Mapping[str, Any]:
        return table_of(table_of(tables, "mqtt"), "in")

    def put(self, toml: Toml, name: str, value: Any) -> Toml:
        return writing.put_in(toml, "mqtt", "in", name, value)

    def rename(self, toml: Toml, old: str, new: str) -> Toml:
        return writing.rename_in(toml, "mqtt", "in", old, new)

    def row(self, value: Any) -> Sequence[Any]:
        kind, _, name = str(value).partition(":")
        return kind, name

    def value(self, old: Any, column: int, typed: Any) -> Any:
        was = self.row(old)
        kind, name = (typed, was[1]) if column == 0 else (was[0], typed)
        if kind == "tag" and not names.is_tag(name):
            raise ValueError(tr("A tag is words of a to z, 0 to 9, _ and - with dots between."))
        return f"{kind}:{name}"

    def beginning(self) -> tuple[str, Any]:
        return "room/topic", "event:called"


class SettingsSection(RowsSection):
    """What those who use the robot may change, on its settings page."""

    def __init__(self, theme: Theme) -> None:
        columns = (
            Column(
                title=tr("Label"),
                make=lambda _, parent: Checked(str, parent),
                share=3,
                help=tr("What stands beside the field."),
            ),
            Column(
                title=tr("Value"),
                make=lambda _, parent: Checked(tag, parent),
                share=3,
                help=tr("The tag that is changed; it outlives a restart of the robot."),
            ),
            Column(
                title=tr("Kind"),
                make=_setting_kind,
                share=2,
                help=tr("What can be put in there."),
            ),
            Column(
                title=tr("Choices"),
                make=lambda _, parent: _Choices(parent),
                share=3,
                help=tr("For a choice: two or more, with commas between."),
            ),
        )
        super().__init__(
            theme,
            tr("Settings for those who use the robot"),
            tr("Each is a field on the robot's settings page and changes a value there."),
            columns,
            tr("a setting"),
        )
        self._settings: list[dict[str, Any]] = []

    def show_tables(self, tables: Tables) -> None:
        listed = tables.get("setting")
        self._settings = (
            [one for one in listed if isinstance(one, dict)] if isinstance(listed, list) else []
        )
        self.show_values([self._row(one) for one in self._settings])
        for row, one in enumerate(self._settings):
            self.rows.field(row, 3).setEnabled(one.get("type") == "choice")

    def _row(self, one: dict[str, Any]) -> Sequence[Any]:
        kind = one.get("type", "text")
        return one.get("label", ""), one.get("tag", ""), kind, texts_of(one.get("choices"))

    def on_changed(self, row: int, column: int, value: Any) -> None:
        one = self._settings[row]
        words = tr("Change the setting {0}").format(one.get("label") or one.get("tag", ""))

        def change(toml: Toml) -> Toml:
            key = ("label", "tag", "type", "choices")[column]
            toml = writing.put_setting(toml, row, key, value or None)
            if key == "type" and value == "choice" and not one.get("choices"):
                usual = [tr("first"), tr("second")]
                return writing.put_setting(toml, row, "choices", usual)
            if key == "type" and value != "choice":
                return writing.put_setting(toml, row, "choices", None)
            return toml

        self.tell(change, words)

    def on_removed(self, row: int) -> None:
        one = self._settings[row]
        words = tr("Remove the setting {0}").format(one.get("label") or one.get("tag", ""))
        self.tell(lambda toml: writing.remove_setting(toml, row), words)

    def on_added(self) -> None:
        name = free("setting.new", [one.get("tag", "") for one in self._settings])
        values = {"tag": name, "label": tr("New setting"), "type": "text"}
        self.added(lambda toml: writing.add_setting(toml, values))


class _Choices(Line):
    """The choices of a setting, with commas between."""

    def written(self, value: Any) -> str:
        return ", ".join(value or ())

    def read(self, text: str) -> Any:
        found = [one.strip() for one in text.split(",") if one.strip()]
        if len(found) < 2 or len(set(found)) < len(found):
            raise ValueError(self.tr("Two or more, each once, with commas between."))
        return found


def _setting_kind(theme: Theme, parent: QWidget) -> Choice:
    words = {
        "text": tr("Text"),
        "number": tr("Number"),
        "time": tr("Time"),
        "date": tr("Date"),
        "boolean": tr("Yes or no"),
        "choice": tr("Choice"),
    }
    made = Choice(theme, parent)
    made.offer(tuple((kind, words.get(kind, kind)) for kind in SETTING_TYPES))
    return made


def _means(theme: Theme, parent: QWidget) -> Choice:
    made = Choice(theme, parent)
    made.offer((("event", tr("an event")), ("tag", tr("a value"))))
    return made
