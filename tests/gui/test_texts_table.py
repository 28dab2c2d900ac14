"""All texts of a project as one table: translating, finding what is left to do, to and from a
translator.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QAbstractItemModel, QModelIndex, QPoint, Qt
from PySide6.QtGui import QAccessible, QInputMethodEvent
from PySide6.QtTest import QAbstractItemModelTester, QSignalSpy, QTest
from PySide6.QtWidgets import QApplication

from situ.document import catalogue, folder
from situ.document.catalogue import Catalogue
from situ_studio.texts.listening import Listening
from situ_studio.texts.model import CELL, STATE, WHAT, WRITTEN, language_name
from situ_studio.texts.sheet import Sheet, Typed, changed
from situ_studio.texts.table import TextsTable

Start = Callable[..., Any]
CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
JA, FILE = "texts/ja.po", "reception.rbd.xml"
JAPANESE = WRITTEN + 1


@pytest.fixture
def used(studio: Start, project: Callable[[str], Path]) -> Any:
    """The reception with its texts open, by the key."""
    made = studio(project("reception"))
    made.key(Qt.Key.Key_7, CONTROL)
    return made


def page(used: Any) -> Any:
    return used.window.pages.page("texts")


def table(used: Any) -> TextsTable:
    found: TextsTable = page(used).table
    assert found.isVisible()
    return found


def at(used: Any, text: str, column: int = JAPANESE) -> QModelIndex:
    """The cell of the first row with that text as written."""
    model = table(used).model()
    for row in range(model.rowCount()):
        if model.index(row, WRITTEN).data() == text:
            return model.index(row, column)
    raise AssertionError(f"no text {text!r}")


def go(used: Any, index: QModelIndex) -> None:
    """A click into a cell."""
    view = table(used)
    view.scrollTo(index)
    QTest.mouseClick(
        view.viewport(), Qt.MouseButton.LeftButton, pos=view.visualRect(index).center()
    )
    used.settle()
    assert view.currentIndex() == index


def said(used: Any, text: str, language: str = "ja") -> str | None:
    found = used.session.project.texts.get(language, {}).get(text)
    return found if found is None else str(found)


def test_typing_translates_enter_goes_on_and_undo_takes_it_back(used: Any) -> None:
    go(used, at(used, "Home"))
    used.type("G")
    used.type("enkan")
    used.key(Qt.Key.Key_Return)
    assert said(used, "Home") == "Genkan"
    assert used.session.undo_text == "Translate “Home” into 日本語"
    assert table(used).currentIndex() == at(used, "Repeat")
    # The tab stays, with its mark, while things are undone.
    assert used.window.tabs.bar.tabText(used.window.tabs.bar.currentIndex()) == "Texts •"
    used.key(Qt.Key.Key_Z, CONTROL)
    assert said(used, "Home") == "最初へ"
    assert at(used, "Home").data() == "最初へ"
    assert used.window.tabs.chosen_file == "texts"
    assert used.session.dirty == []


def _send(event: QInputMethodEvent) -> None:
    focus = QApplication.focusWidget()
    assert focus is not None
    QApplication.sendEvent(focus, event)


def test_an_input_method_begins_a_cell_as_a_letter_does(used: Any) -> None:
    go(used, at(used, "Home"))
    # Composed first, as on most systems; the focus stays until something is written.
    written = QInputMethodEvent()
    written.setCommitString("玄関")
    for event in (QInputMethodEvent("げんかん", []), written):
        _send(event)
        used.settle()
    used.key(Qt.Key.Key_Return)
    assert said(used, "Home") == "玄関"
    # Written at once, and what is typed then goes on after it.
    assert table(used).currentIndex() == at(used, "Repeat")
    written.setCommitString("再")
    _send(written)
    used.settle()
    used.type("X")
    used.key(Qt.Key.Key_Return)
    assert said(used, "Repeat") == "再X"
    # A place is not written into.
    go(used, at(used, "Home", WHAT))
    before = used.session.project
    _send(written)
    used.settle()
    assert used.session.project is before
    assert QApplication.focusWidget() is table(used)


def test_the_first_language_changes_the_document_and_takes_translations_along(used: Any) -> None:
    go(used, at(used, "Repeat", WRITTEN))
    used.key(Qt.Key.Key_F2)
    used.key(Qt.Key.Key_A, CONTROL)
    used.type("Once more")
    used.key(Qt.Key.Key_Return)
    application = used.session.document(FILE)
    assert "Once more" in [c.text for c in application.always.screen.components]
    assert used.session.dirty == [FILE, JA]
    cell = at(used, "Once more").data(CELL)
    assert (cell.text, cell.standing, cell.was) == ("もう一度", "unsure", "Repeat")
    assert said(used, "Once more") is None
    go(used, at(used, "Once more"))
    used.click(page(used).confirm)
    assert said(used, "Once more") == "もう一度"
    for _ in range(2):
        used.key(Qt.Key.Key_Z, CONTROL)
    assert used.window.tabs.chosen_file == "texts"
    assert used.session.dirty == []
    assert at(used, "Repeat").data(CELL).standing == "done"


def test_what_is_missing_unsure_or_lacks_a_tag_is_marked_counted_and_filtered(used: Any) -> None:
    texts = page(used)
    greeting = "Hello {user.name}"
    before = texts.sheet.counts("ja")
    go(used, at(used, "Home"))
    used.key(Qt.Key.Key_Delete)
    go(used, at(used, greeting))
    used.type("Y")
    used.key(Qt.Key.Key_Tab)
    assert at(used, "Home").data(CELL).standing == "missing"
    assert at(used, greeting).data(CELL).lacks == ("user.name",)
    assert "leaves out {user.name}" in at(used, greeting).data(Qt.ItemDataRole.ToolTipRole)
    counts = texts.sheet.counts("ja")
    assert (counts.missing, counts.lacking) == (before.missing + 1, before.lacking + 1)
    assert "1 missing, 1 without a tag" in texts.counts.text()
    used.click(texts.open, QPoint(8, texts.open.height() // 2))
    shown = {table(used).model().index(r, WRITTEN).data() for r in range(2)}
    assert shown == {"Home", greeting}
    assert {row.text for row in table(used).texts.shown} == shown
    # What is done stays until another filter is asked for: Enter goes on to the next.
    go(used, at(used, "Home"))
    used.type("H")
    used.key(Qt.Key.Key_Return)
    assert at(used, "Home").data(CELL).standing == "done"
    assert table(used).currentIndex().row() == at(used, "Home").row() + 1
    used.click(texts.open, QPoint(8, texts.open.height() // 2))
    used.click(texts.open, QPoint(8, texts.open.height() // 2))
    assert {row.text for row in table(used).texts.shown} == {greeting}
    used.click(texts.open, QPoint(8, texts.open.height() // 2))
    used.click(texts.kinds.button("heard"))
    assert {row.kind for row in table(used).texts.shown} == {"heard"}
    used.fill(texts.search, "goodb")
    assert {row.text for row in table(used).texts.shown} == {"goodbye"}
    used.fill(texts.search, "nothing like it")
    assert texts.nothing.isVisible()


def test_cells_go_to_a_spreadsheet_and_come_back_as_one_step(used: Any) -> None:
    view, first = table(used), at(used, "stop")
    go(used, first)
    used.key(Qt.Key.Key_Down, SHIFT)
    used.key(Qt.Key.Key_C, CONTROL)
    assert QApplication.clipboard().text() == "やめます\nさようなら\n"
    data = QApplication.clipboard().mimeData()
    assert data.html() == ("<table><tr><td>やめます</td></tr><tr><td>さようなら</td></tr></table>")
    QApplication.clipboard().setText("とまれ\nまたね\n")
    go(used, first)
    used.key(Qt.Key.Key_V, CONTROL)
    assert (said(used, "stop"), said(used, "goodbye")) == ("とまれ", "またね")
    assert used.session.undo_text == "Change 2 texts"
    used.key(Qt.Key.Key_Z, CONTROL)
    assert (said(used, "stop"), said(used, "goodbye")) == ("やめます", "さようなら")
    # One cell fills all that are selected; what has no room is told.
    QApplication.clipboard().setText("x")
    go(used, first)
    used.key(Qt.Key.Key_Down, SHIFT)
    used.key(Qt.Key.Key_V, CONTROL)
    assert (said(used, "stop"), said(used, "goodbye")) == ("x", "x")
    QApplication.clipboard().setText("y\tz\n")
    go(used, first)
    used.key(Qt.Key.Key_V, CONTROL)
    assert said(used, "stop") == "y"
    assert "1 cells had no room" in used.window.status.said.text()
    assert view.currentIndex() == first
    # Where nothing was copied nothing happens.
    QApplication.clipboard().clear()
    used.key(Qt.Key.Key_V, CONTROL)
    assert said(used, "stop") == "y"


def test_a_click_on_the_place_shows_it_and_control_enter_too(used: Any) -> None:
    view = table(used)
    index = at(used, "Touch the screen to begin", STATE)
    view.scrollTo(index)
    QTest.mouseClick(
        view.viewport(), Qt.MouseButton.LeftButton, pos=view.visualRect(index).center()
    )
    used.settle()
    assert used.window.current_file == FILE
    assert used.window.current_view.selected[0][:2] == ("state", "1")
    used.window.open_file("texts")
    go(used, at(used, "Home"))
    used.key(Qt.Key.Key_Return, CONTROL)
    assert used.window.current_view.selected == (("always", "screen", "home"),)


def test_a_text_that_is_left_empty_is_refused(used: Any) -> None:
    go(used, at(used, "Home", WRITTEN))
    used.key(Qt.Key.Key_Delete)
    assert used.session.dirty == []
    assert "can not be left empty" in used.window.status.said.text()


def test_a_translators_file_is_taken_in_and_told_in_words(used: Any, tmp_path: Path) -> None:
    came = tmp_path / "from-translator.po"
    came.write_text(
        'msgid ""\nmsgstr "Language: ja\\n"\n\nmsgid "Home"\nmsgstr "玄関"\n\n'
        'msgid "Repeat"\nmsgstr "もう一度"\n\nmsgid "Nowhere"\nmsgstr "ない"\n\n'
        '#, fuzzy\nmsgid "stop"\nmsgstr "?"\n'
    )
    used.answers.put("translations_from", str(came))
    used.click(page(used).take_in)
    ((words, details),) = used.answers.details_told
    assert words == (
        "日本語 from from-translator.po: 1 changed, 1 the same as before, "
        "1 to be looked at, not used yet, 1 unknown to this project, kept aside."
    )
    assert "Unknown to this project, kept in the file as obsolete\n  Nowhere" in details
    assert (said(used, "Home"), said(used, "stop")) == ("玄関", "やめます")
    used.window.actions_.actions["save"].trigger()
    saved = (used.session.root / JA).read_text()
    assert '#~ msgid "Nowhere"\n#~ msgstr "ない"' in saved
    used.key(Qt.Key.Key_Z, CONTROL)
    assert said(used, "Home") == "最初へ"
    # What says that it is another language, or is no such file, changes nothing.
    came.write_text('msgid ""\nmsgstr "Language: de\\n"\n\nmsgid "Home"\nmsgstr "Anfang"\n')
    used.answers.put("translations_from", str(came))
    used.click(page(used).take_in)
    came.write_text("nothing")
    used.answers.put("translations_from", str(came))
    used.click(page(used).take_in)
    assert len(used.answers.told) == 2
    assert said(used, "Home") == "最初へ"


def test_a_translator_gets_every_text(used: Any, tmp_path: Path) -> None:
    go(used, at(used, "Home"))
    used.key(Qt.Key.Key_Delete)
    out = tmp_path / "out.po"
    used.answers.put("translations_to", str(out))
    used.click(page(used).give_out)
    value, problems = catalogue.read(out.read_bytes(), "out.po")
    assert problems == []
    assert value is not None
    by_text = value.by_text()
    assert by_text["Home"].said == ""
    assert by_text["Repeat"].said == "もう一度"
    assert {row.text for row in page(used).sheet.rows if row.is_to_translate} <= set(by_text)


def test_a_language_is_added_from_nothing_and_its_texts_begun(
    studio: Start, tmp_path: Path
) -> None:
    (tmp_path / "situ.toml").write_text(
        '[project]\nname = "p"\napplications = ["a.rbd.xml"] # one\n'
    )
    (tmp_path / "a.rbd.xml").write_text(
        '<application name="a"><state no="1" final="true"><backgroundactions>'
        "<speech>Hello</speech></backgroundactions></state></application>"
    )
    used = studio(tmp_path)
    used.key(Qt.Key.Key_7, CONTROL)
    assert "one language only" in page(used).counts.text()
    used.answers.put("name", "no code")
    used.click(page(used).more)
    assert used.session.dirty == []
    used.answers.put("name", "mi")
    used.click(page(used).more)
    assert used.session.project.languages == ("en", "mi")
    go(used, at(used, "Hello"))
    used.type("K")
    used.type("ia ora")
    used.key(Qt.Key.Key_Return)
    used.key(Qt.Key.Key_S, CONTROL)
    assert (tmp_path / "situ.toml").read_text() == (
        '[project]\nname = "p"\napplications = ["a.rbd.xml"] # one\nlanguages = ["en", "mi"]\n'
    )
    project, problems = folder.load(tmp_path)
    assert project is not None
    assert project.texts == {"mi": {"Hello": "Kia ora"}}
    assert [p for p in problems if p.severity == "error"] == []


def test_the_table_is_read_out_and_can_be_left_by_keys(used: Any) -> None:
    go(used, at(used, "Home"))
    used.key(Qt.Key.Key_Delete)
    role = Qt.ItemDataRole.AccessibleTextRole
    assert at(used, "Home").data(role) == "日本語: missing"
    assert at(used, "Home", STATE).data(role) == "Where: reception: In every state, Button home"
    interface = QAccessible.queryAccessibleInterface(table(used))
    assert interface.text(QAccessible.Text.Name) == "Texts"
    used.key(Qt.Key.Key_PageUp, CONTROL)
    assert used.window.tabs.chosen_file != "texts"
    used.key(Qt.Key.Key_7, CONTROL)
    used.key(Qt.Key.Key_W, CONTROL)
    assert "texts" not in used.window.tabs.files()
    used.key(Qt.Key.Key_T, CONTROL | SHIFT)
    assert used.window.tabs.chosen_file == "texts"


def test_the_tree_opens_the_texts(used: Any) -> None:
    used.key(Qt.Key.Key_W, CONTROL)
    tree = used.window.project_tree.tree
    used.click_row(tree, used.row_with(tree, "texts"))
    assert table(used).isVisible()


@pytest.fixture
def model(qt: QApplication, project: Callable[[str], Path]) -> Iterator[TextsTable]:
    """A table of its own over the reception."""
    from situ_studio.looks.theme import LIGHT

    made = TextsTable(LIGHT, tuple)
    yield made
    made.deleteLater()


def _sheet(root: Path) -> Sheet:
    found, _ = folder.load(root)
    assert found is not None
    value, _ = catalogue.read((root / JA).read_bytes(), JA)
    assert isinstance(value, Catalogue)
    return Sheet(found, {"ja": value})


def test_the_model_keeps_qts_rules_and_its_rows(
    model: TextsTable, project: Callable[[str], Path]
) -> None:
    sheet = _sheet(project("reception"))
    mode = QAbstractItemModelTester.FailureReportingMode.Warning
    inner: QAbstractItemModel = model.texts
    QAbstractItemModelTester(inner, mode, model)
    model.texts.show_sheet(sheet)
    assert model.texts.rowCount() == len(sheet.rows)
    reset, told = QSignalSpy(inner.modelReset), QSignalSpy(inner.dataChanged)
    row = sheet.rows[0]
    (after,) = changed(sheet, [Typed(row, "ja", "other")]).values()
    assert isinstance(after, Catalogue)
    # A translation changes no row's place: the view stays where it is.
    model.texts.show_sheet(Sheet(sheet.project, {"ja": after}))
    assert (reset.count(), told.count()) == (0, 1)
    assert model.texts.index(0, JAPANESE).data() == "other"


def test_languages_are_called_as_their_speakers_call_them() -> None:
    names = [language_name(code) for code in ("ja", "en", "mi", "pt-BR", "de", "x-y")]
    assert names == ["日本語", "English", "Māori", "Português (Brasil)", "Deutsch", "x-y"]


def test_a_text_is_heard_and_silenced(qt: QApplication, tmp_path: Path) -> None:
    heard = tmp_path / "heard"
    voice = tmp_path / "voice"
    # Speaks for as long as nobody ends it, unless it is told to fail.
    voice.write_text(
        f'#!/bin/sh\necho "$@" > {heard}.new; cat >> {heard}.new; mv {heard}.new {heard}\n'
        'case "$2" in xx) echo "no such voice" >&2; exit 1;; mi) exit 0;; esac\nexec sleep 60\n'
    )
    voice.chmod(0o755)
    listening: Any = Listening(qt, str(voice))
    ended, failed = QSignalSpy(listening.changed), QSignalSpy(listening.failed)
    listening.toggle("Kia ora {user.name}, haere mai", "mi")
    while listening.going:
        assert ended.wait(20_000)
    assert heard.read_text() == "-v mi --stdin\nKia ora  … , haere mai"
    listening.toggle("Hello", "en-GB")
    assert listening.going
    listening.toggle("Hello", "en-GB")
    assert not listening.going
    listening.toggle("Hello", "xx")
    assert failed.wait(20_000)
    assert "no such voice" in failed.at(0)[0]
    listening.deleteLater()


def test_places_are_cut_only_where_texts_need_the_room(used: Any) -> None:
    view = table(used)
    narrow = [view.columnWidth(column) for column in range(WRITTEN)]
    used.window.resize(2560, 1200)
    used.settle()
    measure = view.fontMetrics().horizontalAdvance
    for column in range(WRITTEN):
        rows = range(view.model().rowCount())
        words = max((str(view.model().index(r, column).data()) for r in rows), key=measure)
        assert narrow[column] < measure(words) + 20 < view.columnWidth(column)
    assert view.columnWidth(WRITTEN) > 2 * view.columnWidth(0)
    used.window.resize(1280, 800)
    used.settle()
    assert [view.columnWidth(column) for column in range(WRITTEN)] == narrow
