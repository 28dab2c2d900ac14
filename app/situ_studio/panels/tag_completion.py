"""``{`` in a text offers the tags that are known; what is taken is written as ``{tag}``."""

from __future__ import annotations

import re

from PySide6.QtCore import QEvent, QObject, QRect, QStringListModel, Qt
from PySide6.QtGui import QKeyEvent, QTextCursor
from PySide6.QtWidgets import QAbstractItemView, QCompleter, QLineEdit, QPlainTextEdit

from situ_studio.looks.letters import px
from situ_studio.looks.theme import FORM, font

BEGUN = re.compile(r"\{([^{}\s]*)$")
"""A reference that is not closed yet, before the cursor."""
WIDE = 240
"""Px that the list of tags has."""


class TagCompletion(QObject):
    """Of one field, which gives its events to ``takes`` first. The list is filtered as a person
    types; Enter, Tab or a click takes a tag, Esc closes the list.
    """

    def __init__(self, field: QLineEdit | QPlainTextEdit) -> None:
        super().__init__(field)
        self._field = field
        self._tags: tuple[str, ...] = ()
        self._completer: QCompleter | None = None
        self._list: QAbstractItemView | None = None
        self._words = QStringListModel(self)
        if isinstance(field, QLineEdit):
            field.textEdited.connect(self._on_typed)
        else:
            field.textChanged.connect(self._on_typed)

    def offer(self, tags: tuple[str, ...]) -> None:
        if tags != self._tags:
            self._tags = tags
            self._words.setStringList(list(tags))

    @property
    def is_open(self) -> bool:
        return self._list is not None and self._list.isVisible()

    @property
    def offered(self) -> list[str]:
        """What stands in the list now."""
        if self._completer is None:
            return []
        model = self._completer.completionModel()
        return [model.index(row, 0).data() for row in range(model.rowCount())]

    def takes(self, event: QEvent) -> bool:
        """Whether it is a key that was meant for the list; then it is done."""
        if self._list is None or not self._list.isVisible():
            return False
        if not isinstance(event, QKeyEvent) or event.type() != QEvent.Type.KeyPress:
            return False
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab):
            tag = self._list.currentIndex().data()
            self._list.hide()
            if tag is not None:
                self._take(tag)
            return True
        if event.key() == Qt.Key.Key_Escape:
            self._list.hide()
            return True
        return False

    def _made(self) -> tuple[QCompleter, QAbstractItemView]:
        # Most fields never need one.
        if self._completer is None or self._list is None:
            made = self._completer = QCompleter(self._words, self)
            made.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
            made.setFilterMode(Qt.MatchFlag.MatchContains)
            made.setWidget(self._field)
            self._list = made.popup()
            assert self._list is not None
            self._list.setProperty("role", "completions")
            made.activated.connect(self._take)
        return self._completer, self._list

    def _before(self) -> str:
        """The line up to the cursor."""
        if isinstance(self._field, QLineEdit):
            return self._field.text()[: self._field.cursorPosition()]
        cursor = self._field.textCursor()
        return cursor.block().text()[: cursor.positionInBlock()]

    def _on_typed(self) -> None:
        begun = BEGUN.search(self._before())
        if begun is None or not self._tags or not self._field.hasFocus():
            if self._list is not None:
                self._list.hide()
            return
        completer, shown = self._made()
        completer.setCompletionPrefix(begun[1])
        if completer.completionCount() == 0:
            shown.hide()
            return
        # A window of its own: it has the looks of the field's only if it is given them.
        looks = self._field.window().styleSheet()
        if shown.styleSheet() != looks:
            shown.setStyleSheet(looks)
        shown.setFont(font(FORM))
        at = self._field.cursorRect()
        completer.complete(QRect(at.left(), at.top(), px(WIDE), at.height()))
        shown.setCurrentIndex(completer.completionModel().index(0, 0))

    def _take(self, tag: str) -> None:
        begun = BEGUN.search(self._before())
        if begun is None:
            return
        back = len(begun[0])
        if isinstance(self._field, QLineEdit):
            at = self._field.cursorPosition()
            closed = self._field.text()[at : at + 1] == "}"
            self._field.setSelection(at - back, back + closed)
            self._field.insert(f"{{{tag}}}")
            return
        cursor = self._field.textCursor()
        after = cursor.block().text()[cursor.positionInBlock() :][:1]
        cursor.movePosition(QTextCursor.MoveOperation.Left, QTextCursor.MoveMode.MoveAnchor, back)
        keep = QTextCursor.MoveMode.KeepAnchor
        cursor.movePosition(QTextCursor.MoveOperation.Right, keep, back + (after == "}"))
        cursor.insertText(f"{{{tag}}}")
        self._field.setTextCursor(cursor)
