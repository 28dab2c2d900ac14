"""The texts of the studio: all are translated, none is forgotten, and none is cut."""

from __future__ import annotations

import re
import runpy
import shutil
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from lxml import etree
from PySide6.QtCore import (
    QAbstractItemModel,
    QAbstractListModel,
    QModelIndex,
    QSettings,
    Qt,
    QTranslator,
)
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QComboBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QToolButton,
    QWidget,
)
from tests.gui.conftest import Studio

from situ.document.rbd import Always, Application, Event, State
from situ.resources import resource
from situ_studio import kinds
from situ_studio.canvas.menu import FollowMenu
from situ_studio.canvas.script_nodes import WORD
from situ_studio.canvas.style import Label
from situ_studio.edits.mentions import Found, mentions
from situ_studio.finding.search import search
from situ_studio.looks.theme import LIGHT
from situ_studio.widgets.icon_widgets import Elided
from situ_studio.wording import language

ROOT = Path(__file__).resolve().parents[2]
HOLES = re.compile(r"\{\d*\}|%n|%\d")


def messages(file: Path) -> Iterator[tuple[str, str, str]]:
    """(context, English, translation) of a .ts file; nothing for what is not translated."""
    for context in etree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            done = translation is not None and translation.get("type") is None
            yield (
                context.findtext("name") or "",
                message.findtext("source") or "",
                (translation.text or "") if done and translation is not None else "",
            )


JAPANESE = list(messages(resource("i18n", "studio_ja.ts")))


def test_every_text_has_its_japanese() -> None:
    assert [text for _, text, said in JAPANESE if not said] == []


def test_a_translation_has_the_values_of_its_text() -> None:
    other = [
        (text, said)
        for _, text, said in JAPANESE
        if sorted(HOLES.findall(text)) != sorted(HOLES.findall(said))
    ]
    assert other == []


def test_the_files_for_translators_are_those_of_the_sources(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    there = resource("i18n")
    for file in there.iterdir():
        shutil.copy(file, tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path, str(ROOT / "packaging")])
    runpy.run_path(str(ROOT / "packaging" / "texts.py"))["renew"](tmp_path)
    made = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    for file in there.iterdir():
        assert made[file.name] == file.read_bytes(), f"{file.name}: run python packaging/texts.py"


# -- a language that says everything in brackets ---------------------------------------------


class Brackets(QTranslator):
    """Says ``⟦Save⟧`` for Save: whatever has no brackets was never asked for."""

    def translate(
        self, context: Any, sourceText: Any, disambiguation: Any = None, n: int = -1
    ) -> str:
        return f"⟦{sourceText}⟧" if sourceText else ""

    def isEmpty(self) -> bool:
        return False


@pytest.fixture
def brackets(qt: QApplication) -> Iterator[None]:
    translator = Brackets()
    qt.installTranslator(translator)
    language._runtime.cache_clear()
    yield
    qt.removeTranslator(translator)
    language._runtime.cache_clear()


ASIDE = {"Situ", "Studio", "Ctrl", "Alt", "Shift", "Del", "Enter", "Return", "Tab", "Esc", "Home"}
ASIDE |= {"English", "PgUp", "PgDown", "Space", "NodeGraph", "Nodes"}
"""Keys, names, and the menus of NodeGraphQt, which are never shown."""


def own_words(folder: Path) -> set[str]:
    """Every word that a person wrote into the project, and the names of its files."""
    found: set[str] = set()
    for file in (folder, *folder.rglob("*")):
        found |= words(str(file.name))
        if file.suffix == ".xml":
            for element in etree.parse(file).iter():
                texts = [element.text, element.tail, *map(str, element.attrib.values())]
                found |= {word for text in texts for word in words(text or "")}
        elif file.suffix == ".toml":
            found |= words(file.read_text())
    return found


def words(text: str) -> set[str]:
    return set(re.findall(r"[A-Za-z]{2,}", text))


def shown(window: QWidget) -> Iterator[tuple[str, str]]:
    """(where, text) of everything that the widgets of a window say, to eyes and ears."""
    for widget in (window, *window.findChildren(QWidget)):
        name = type(widget).__name__
        for what in (
            "text", "title", "placeholderText", "toolTip", "windowTitle", "accessibleName",
            "accessibleDescription", "whatsThis",
        ):  # fmt: skip
            ask = getattr(widget, what, None)
            if callable(ask) and not (what == "text" and hasattr(widget, "cursorPosition")):
                yield f"{name}.{what}", str(ask())
        if isinstance(widget, QComboBox):
            yield from ((f"{name} entry", widget.itemText(i)) for i in range(widget.count()))
        if isinstance(widget, QAbstractItemView) and widget.model() is not None:
            yield from cells(name, widget.model())
    for action in window.findChildren(QAction):
        yield "a command", action.text()
        yield "a command's hint", action.toolTip()


def cells(name: str, model: QAbstractItemModel) -> Iterator[tuple[str, str]]:
    def columns(parent: QModelIndex) -> range:
        # A list has one, and lets nobody ask.
        return range(1 if isinstance(model, QAbstractListModel) else model.columnCount(parent))

    for column in columns(QModelIndex()):
        yield f"{name} heading", str(model.headerData(column, Qt.Orientation.Horizontal) or "")
    waiting = [QModelIndex()]
    while waiting:
        parent = waiting.pop()
        for row in range(model.rowCount(parent)):
            for column in columns(parent):
                index = model.index(row, column, parent)
                for role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ToolTipRole):
                    yield f"{name} row", str(index.data(role) or "")
            waiting.append(model.index(row, 0, parent))


PLACES: dict[str, list[tuple[str, ...]]] = {
    "reception": [
        (), ("always",), ("state", "1"), ("state", "7"), ("state", "16"), ("state", "7", "screen"),
        ("state", "7", "event", "2"), ("state", "7", "timeout"), ("state", "7", "action", "1"),
        ("state", "4", "screen", "confirm"), ("note", "0"), ("frame", "0"),
    ],
    "conversation": [
        (), ("situation", "invited"), ("situation", "sound"), ("module", "nod"),
        ("data", "sound.slap"), ("data", "hand.waving"),
    ],
}  # fmt: skip


@pytest.mark.parametrize("name", PLACES)
def test_nothing_is_said_in_english_only(
    brackets: None, studio: Callable[..., Studio], project: Callable[[str], Path], name: str
) -> None:
    folder = project(name)
    known = own_words(folder) | ASIDE
    window = studio(folder).window
    window.open_file("conversation.spds.xml" if name == "conversation" else "reception.rbd.xml")
    english: dict[str, str] = {}
    for mode in ("graph", "outline"):
        window.show_mode(mode)
        for place in PLACES[name]:
            window.select(place)
            QApplication.processEvents()
            english |= {
                text: where
                for where, text in shown(window)
                if words(re.sub(r"⟦.*⟧", "", text.replace(str(folder), ""), flags=re.DOTALL))
                - known
            }

    assert "\n".join(f"{where}: {text}" for text, where in english.items()) == ""


def test_where_something_is_found_is_said_in_the_users_language(brackets: None) -> None:
    events = (Event("go", next="1"),)
    talk = Application(
        "talk", states=(State("1", name="greet", events=events),), always=Always(events=events)
    )
    found = [Found("talk", mention) for mention in mentions(talk)]
    several = [search({"talk": talk}, found, query).hits for query in ("go", "state: 1")]
    places = {hit.where for hits in several for hit in hits}
    assert any("⟦state 1 greet⟧" in where for where in places)
    assert any("⟦every state⟧" in where for where in places)
    assert {re.sub(r"⟦[^⟧]*⟧|[,: ]", "", where) for where in places} == {""}


def test_what_a_menu_asks_to_type_is_said_in_the_users_language(brackets: None) -> None:
    parent = QWidget()
    menu = FollowMenu((), LIGHT, parent, "Which?")
    assert menu.field.placeholderText() == "⟦Which? Type to filter⟧"
    parent.deleteLater()


def test_what_one_label_calls_a_tag_it_calls_nowhere_a_value() -> None:
    """A language has one word for a label: *to* a tag is where it goes, *to* a value is not."""
    fields = [
        f for k in kinds.KINDS for f in (*k.fields, *(g for s in k.sections for g in s.fields))
    ]
    tags = {field.label for field in fields if field.editor == "tag"}
    assert tags & {field.label for field in fields if field.editor != "tag"} == set()


# -- room ------------------------------------------------------------------------------------


def cut(window: QWidget, ours: set[str]) -> Iterator[str]:
    """What does not have the room that its text needs. ours: texts of the studio, which must never
    be shortened; what a person wrote may be.
    """
    for widget in window.findChildren(QWidget):
        if not widget.isVisibleTo(window) or widget.visibleRegion().isEmpty():
            continue
        name = type(widget).__name__
        if isinstance(widget, QLabel | QAbstractButton | QLineEdit | QComboBox):
            told = widget.currentText() if isinstance(widget, QComboBox) else widget.text()
            high = widget.fontMetrics().tightBoundingRect(told).height()
            if high > widget.height():
                yield f"{name}: {told}, {high} px into {widget.height()} of height"
        if isinstance(widget, Elided):
            if widget.text() and widget.text() in ours and widget.toolTip():
                yield f"{name}: {widget.text()}, {widget.width()} px"
        elif isinstance(widget, QLabel) and widget.text() and widget.pixmap().isNull():
            room, wanted = widget.contentsRect(), widget.sizeHint()
            if widget.wordWrap():
                if widget.heightForWidth(widget.width()) > widget.height() + 1:
                    yield f"{name}: {widget.text()}"
            elif widget.fontMetrics().horizontalAdvance(widget.text()) > room.width() + 1:
                yield f"{name}: {widget.text()}, {wanted.width()} px into {widget.width()}"
        elif isinstance(widget, QAbstractButton) and widget.text():
            shows = not isinstance(widget, QToolButton) or (
                widget.toolButtonStyle() != Qt.ToolButtonStyle.ToolButtonIconOnly
            )
            needed = widget.fontMetrics().horizontalAdvance(widget.text().replace("&", ""))
            if shows and needed > widget.width():
                yield f"{name}: {widget.text()}, {needed} px into {widget.width()}"
        elif isinstance(widget, QHeaderView) and widget.orientation() == Qt.Orientation.Horizontal:
            for column in range(widget.count()):
                if widget.sectionSizeHint(column) > widget.sectionSize(column) > 0:
                    text = widget.model().headerData(column, Qt.Orientation.Horizontal)
                    yield f"heading {text}"


@pytest.mark.usefixtures("qt")
def test_what_joins_tests_is_whole_in_the_strip_of_its_card() -> None:
    words = {text: said for context, text, said in JAPANESE if not context}
    for text in ("until", "all", "any", "none"):
        for one in (text, words[text]):
            assert not Label(one, 11, 600, WORD).cut, f"{one} is too long: say {text} shorter"


FILES = {"reception": "reception.rbd.xml", "conversation": "conversation.spds.xml"}


@pytest.mark.parametrize(("code", "size"), [("en", 100), ("ja", 100), ("en", 150), ("ja", 150)])
@pytest.mark.parametrize("name", PLACES)
def test_no_text_is_cut(
    studio: Callable[..., Studio],
    project: Callable[[str], Path],
    qt: QApplication,
    settings: QSettings,
    name: str,
    code: str,
    size: int,
) -> None:
    speaking = qt.findChild(language.Speaking) or language.Speaking(qt)
    # The windows speak what the settings say.
    settings.setValue("language", code)
    settings.setValue("letters", size)
    try:
        made = studio(project(name))
        window = made.window
        assert speaking.code == code
        ours = {said if code == "ja" else text for _, text, said in JAPANESE}
        found: set[str] = set()
        for page in ("situ.toml", "texts", "media/"):
            window.open_file(page)
            made.settle()
            found.update(cut(window, ours))
        window.open_file(FILES[name])
        for mode in ("graph", "outline"):
            window.show_mode(mode)
            for place in PLACES[name]:
                window.select(place)
                made.settle()
                found.update(cut(window, ours))
        if name == "reception":
            window.show_mode("screen")
            window.select(("state", "5"))
            made.settle()
            found.update(cut(window, ours))
        window.welcoming.show()
        made.settle()
        found.update(cut(window, ours))
        assert sorted(found) == []
        assert window.welcome.horizontalScrollBar().maximum() == 0
    finally:
        speaking.use("en")
