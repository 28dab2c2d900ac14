"""The strip below the matrix: which situation is current and who holds what, for values that
somebody only supposes.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from html import escape, unescape
from typing import Any

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QMenu,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
    QWidgetAction,
)

from situ.decide.all_ask import Holding
from situ.document.spds import Spds
from situ.rehearse.what_if import Answer, Judged, answer, judge
from situ_studio.edits.words import listed
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.matrix.chips import Chip, Rows
from situ_studio.matrix.grid import Asking
from situ_studio.matrix.presets import presets, short, typed
from situ_studio.widgets.icon_widgets import Elided, IconButton, IconLabel, retheme
from situ_studio.widgets.layouts import rule
from situ_studio.wording.language import tr

LINES = 2
"""So many lines of values, and of modules, are seen at most."""


class WhatIf(QWidget):
    """Supposed values and who asks; nothing of it is in the document.

    answered: whenever the answer is another one; None while nothing is supposed.
    """

    answered = Signal(object)

    def __init__(self, theme: Theme, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._theme = theme
        self._script: Spds | None = None
        self._asking: Asking = {}
        self._presets: dict[str, tuple[Any, ...]] = {}
        self._kinds: dict[str, str | None] = {}
        self._start: dict[str, Any] = {}
        self._own: dict[str, Any] = {}
        self._known: tuple[Spds, str, Judged] | None = None
        self.silent: set[str] = set()
        """The modules that do not ask."""
        self.answer: Answer | None = None
        self._chips: dict[str, Chip] = {}
        self._modules: dict[str, Chip] = {}
        self.setProperty("role", "panel")
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(rule())
        body = QVBoxLayout()
        body.setContentsMargins(12, 7, 12, 8)
        body.setSpacing(6)
        column.addLayout(body)
        self._lines = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._lines.setSpacing(6)
        body.addLayout(self._lines)
        self._lines.addLayout(self._suppositions(), 0)
        self._lines.addLayout(self._result(), 1)
        self.who = Rows(LINES)
        self.who.setAccessibleName(self.tr("Modules that ask"))
        self.who.hide()
        body.addWidget(self.who)

    def _suppositions(self) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setSpacing(8)
        title = QLabel(self.tr("What if"))
        title.setProperty("role", "heading")
        title.setToolTip(
            self.tr(
                "Suppose values: each counts as set just now, and as having lasted long enough. "
                "What keeps a situation for a while is not counted. Nothing of this is saved.\n"
                "A right click or the down key gives other values."
            )
        )
        title.setFixedHeight(px(26))
        line.addWidget(title, 0, Qt.AlignmentFlag.AlignTop)
        self.data = Rows(LINES)
        self.data.setAccessibleName(self.tr("Supposed values"))
        line.addWidget(self.data, 1, Qt.AlignmentFlag.AlignTop)
        self.nothing = QLabel(self.tr("no situation looks at data yet"))
        self.nothing.setProperty("role", "hint")
        self.nothing.setFixedHeight(px(26))
        line.addWidget(self.nothing, 1, Qt.AlignmentFlag.AlignTop)
        return line

    def _result(self) -> QHBoxLayout:
        line = QHBoxLayout()
        line.setSpacing(6)
        head = QWidget()
        head.setFixedHeight(px(26))
        head.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        inside = QHBoxLayout(head)
        inside.setContentsMargins(0, 0, 0, 0)
        inside.setSpacing(6)
        self._then = IconLabel(self._theme, "right", "text3", 14)
        inside.addWidget(self._then)
        inside.addWidget(IconLabel(self._theme, "situation", "situation", 15))
        self.situation = QLabel()
        self.situation.setProperty("role", "strong")
        inside.addWidget(self.situation)
        inside.addWidget(IconLabel(self._theme, "right", "text3", 14))
        line.addWidget(head, 0, Qt.AlignmentFlag.AlignTop)
        self.holders = QLabel()
        self.holders.setTextFormat(Qt.TextFormat.RichText)
        self.holders.setWordWrap(True)
        self.holders.setMinimumHeight(px(26))
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.holders.setSizePolicy(policy)
        line.addWidget(self.holders, 1)
        self.holders_short = Elided()
        self.holders_short.setFixedHeight(px(26))
        self.holders_short.hide()
        line.addWidget(self.holders_short, 1)
        top = Qt.AlignmentFlag.AlignTop
        self.asks = Chip(self._theme, "", folds=True)
        self.asks.clicked.connect(lambda on: self.who.setVisible(on))
        line.addWidget(self.asks, 0, top)
        self.reset = IconButton(self._theme, "clear", self.tr("Suppose nothing"), "text3", 14)
        self.reset.clicked.connect(self.suppose_nothing)
        line.addWidget(self.reset, 0, top)
        return line

    def set_low(self, low: bool) -> None:
        """Where there is little height: one line of values, and one that says who holds what."""
        for rows in (self.data, self.who):
            rows.show_lines(1 if low else LINES)
        self.holders.setVisible(not low)
        self.holders_short.setVisible(low)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        for chip in (self.asks, *self._chips.values(), *self._modules.values()):
            chip.set_theme(theme)
        retheme(self, theme)

    # -- what is asked ----------------------------------------------------------------

    def show_script(
        self, script: Spds, asking: Asking, start: Mapping[str, Any] | None = None
    ) -> None:
        """Judges another script, for the same suppositions where they are still about it.

        start: the values that the project sets at the start.
        """
        start = dict(start or {})
        if script is self._script and asking == self._asking and start == self._start:
            return
        self._start = start
        before, self._script, self._asking = self._script, script, dict(asking)
        if before is None or not _looks_at_the_same(before, script):
            self._kinds = {observed.tag: observed.type for observed in script.observe}
            self._presets = presets(script)
            self._own = {n: v for n, v in self._own.items() if n in self._presets}
        self.silent &= set(asking)
        self._make_chips()
        self._judge()

    def suppose(self, name: str, value: Any) -> None:
        """The value of one name; None: it is missing."""
        if value == self._start.get(name) and type(value) is type(self._start.get(name)):
            self._own.pop(name, None)
        else:
            self._own[name] = value
        self._judge()

    def suppose_nothing(self) -> None:
        """As it is at the start: all modules ask."""
        self._own, self.silent = {}, set()
        self._judge()

    def _make_chips(self) -> None:
        if list(self._chips) != list(self._presets):
            self._chips = {name: self._datum(name) for name in self._presets}
            self.data.show_widgets(list(self._chips.values()))
        self.data.setVisible(bool(self._chips))
        self.nothing.setVisible(not self._chips)
        if list(self._modules) != list(self._asking):
            self._modules = {name: self._asker(name) for name in self._asking}
            self.who.show_widgets(list(self._modules.values()))

    def _datum(self, name: str) -> Chip:
        every = self._presets[name]
        either = len(every) == 2 and all(isinstance(value, bool) for value in every)
        chip = Chip(self._theme, name, more=not either)
        chip.clicked.connect(lambda: self._on_datum(name))
        chip.menu_asked.connect(lambda: self._open_menu(name))
        return chip

    def _on_datum(self, name: str) -> None:
        """A click: the first value, and nothing again."""
        self.suppose(name, None if name in self.values else self._presets[name][0])

    def _asker(self, name: str) -> Chip:
        chip = Chip(self._theme, name)
        chip.clicked.connect(lambda: self._on_asker(name))
        return chip

    def _on_asker(self, name: str) -> None:
        self.silent ^= {name}
        self._judge()

    def _open_menu(self, name: str) -> None:
        """All values that a name may have, and a line for any other."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        now = self.values.get(name)
        for value in (None, *self._presets[name]):
            action = menu.addAction(value_words(value).replace("&", "&&"))
            action.setCheckable(True)
            action.setChecked(type(value) is type(now) and value == now)
            action.triggered.connect(lambda _=False, v=value: self.suppose(name, v))
        if self._kinds.get(name) != "boolean":
            menu.addSeparator()
            menu.addAction(self._own_value(menu, name))
        chip = self._chips[name]
        menu.popup(chip.mapToGlobal(QPoint(0, chip.height() + 2)))

    def _own_value(self, menu: QMenu, name: str) -> QWidgetAction:
        line = QLineEdit()
        line.setPlaceholderText(self.tr("another value"))
        line.setAccessibleName(self.tr("Another value of {0}").format(name))
        line.setMinimumWidth(px(140))

        def take() -> None:
            self.suppose(name, typed(line.text(), self._kinds.get(name)))
            menu.close()

        line.returnPressed.connect(take)
        holder = QWidget()
        inside = QHBoxLayout(holder)
        inside.setContentsMargins(6, 2, 6, 4)
        inside.addWidget(line)
        action = QWidgetAction(menu)
        action.setDefaultWidget(holder)
        return action

    # -- what is answered ----------------------------------------------------------------

    def _judge(self) -> None:
        if self._script is None:
            return
        asking = {m: r for m, r in self._asking.items() if m not in self.silent}
        self.answer = answer(self._script, self._judged_now(self._script), asking)
        self._show()
        self.answered.emit(self.answer if self.supposes else None)

    def _judged_now(self, script: Spds) -> Judged:
        """Judged anew only where conditions or values are others: most edits change neither."""
        values = self.values
        # As text, in which true is not 1.
        text = json.dumps(values, sort_keys=True)
        if self._known is not None:
            of, before, judged = self._known
            if text == before and _looks_at_the_same(of, script):
                return judged
        judged = judge(script, values)
        self._known = script, text, judged
        return judged

    @property
    def supposes(self) -> bool:
        """Whether anything is supposed."""
        return bool(self._own or self.silent)

    @property
    def values(self) -> dict[str, Any]:
        """What is supposed, by name, of what conditions look at: what the project sets at the
        start, unless something else is. What is not in it is missing.
        """
        found = {name: self._start[name] for name in self._presets if name in self._start}
        return {n: v for n, v in (found | self._own).items() if v is not None}

    def _show(self) -> None:
        values = self.values
        for name, chip in self._chips.items():
            value = values.get(name)
            only = len(self._presets[name]) == 1 and value == self._presets[name][0]
            chip.show_state(value is not None, "" if value is None or only else short(value))
        for name, chip in self._modules.items():
            chip.show_state(name not in self.silent, "")
        told = len(self._modules) - len(self.silent)
        self.asks.name = (
            self.tr("{0} of {1} ask").format(told, len(self._modules))
            if self.silent
            else self.tr("all ask")
        )
        self.asks.show_state(self.asks.isChecked(), "")
        self.asks.setToolTip(self.tr("Which modules ask for what they can use"))
        self.reset.setEnabled(self.supposes)
        answer = self.answer
        assert answer is not None
        self.situation.setText(answer.situation or self.tr("no situation"))
        words = holders_words(answer.holdings)
        self.holders.setText(words)
        self.holders_short.setText(unescape(_plain(words)))
        self.data.row.place()
        self.who.row.place()
        self._settle()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._settle()

    def _settle(self) -> None:
        """The answer stands behind the suppositions where there is room, else below them."""
        words = self.fontMetrics().horizontalAdvance(_plain(self.holders.text()))
        result = self.situation.sizeHint().width() + words + 90
        values = self.data.row.wide if self._chips else self.nothing.sizeHint().width()
        asked = values + self.asks.sizeHint().width() + 140
        beside = asked + result <= self.width()
        ways = QBoxLayout.Direction
        self._lines.setDirection(ways.LeftToRight if beside else ways.TopToBottom)
        self._then.setVisible(beside)
        self.data.settle()
        self.who.settle()


def _looks_at_the_same(before: Spds, script: Spds) -> bool:
    """Whether conditions and observed data are the very same values."""
    if before.observe is not script.observe or len(before.situations) != len(script.situations):
        return False
    pairs = zip(before.situations, script.situations, strict=True)
    return all(a.condition is b.condition and a.until is b.until for a, b in pairs)


def value_words(value: Any) -> str:
    """A value in a list of choices."""
    if value is None:
        return tr("not set")
    if isinstance(value, bool):
        return tr("yes") if value else tr("no")
    return short(value)


def holders_words(holdings: dict[str, Holding]) -> str:
    """Who holds each resource, as rich text: ``head: nod, speech and screen: converse``."""
    by_holder: dict[str, list[str]] = {}
    # What somebody holds comes first.
    for resource, held in sorted(holdings.items(), key=lambda pair: pair[1].module is None):
        several = [_bold(name) for name in (held.module, *held.rivals) if name]
        who = tr(" or ").join(several) if several else tr("nobody")
        if held.rivals:
            who = tr("a tie, {0}").format(who)
        by_holder.setdefault(who, []).append(escape(resource))
    if not by_holder:
        return tr("nobody asks")
    parts = [tr("{0}: {1}").format(listed(resources), who) for who, resources in by_holder.items()]
    return tr(", ").join(parts)


_BOLD = ('<span style="font-weight:600">', "</span>")
"""Not <b>: the typeface has no bolder weight, and Qt would smear the letters."""


def _bold(text: str) -> str:
    return escape(text).join(_BOLD)


def _plain(text: str) -> str:
    for mark in _BOLD:
        text = text.replace(mark, "")
    return text
