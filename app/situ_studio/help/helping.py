"""F1 and What is this: a window's part of the help."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF
from PySide6.QtGui import QAction, QHelpEvent, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QApplication, QMenu, QToolButton, QWhatsThis, QWidget

from situ.resources import tutorial
from situ_studio import kinds
from situ_studio.actions import command
from situ_studio.commands.keys import written
from situ_studio.commands.menus import translated
from situ_studio.edits import places
from situ_studio.edits.edit import Place
from situ_studio.help.help_topics import HELP, Topic, command_topic, topics
from situ_studio.help.help_window import CONTENTS, HelpWindow
from situ_studio.help.tutorial import TutorialWindow
from situ_studio.views.document_view import DocumentView
from situ_studio.wording.language import spoken

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow

_ASKED = (QEvent.Type.WhatsThis, QEvent.Type.QueryWhatsThis)


class HelpSide(QObject):
    """Finds the topic of what a person is at, and shows it.

    shown, tutorial: the help and the tutorial, once opened.
    """

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self.shown: HelpWindow | None = None
        self.tutorial: TutorialWindow | None = None
        for name, dock in window.docks.items():
            dock.widget().setProperty(HELP, f"panel/{name}")
            dock.titleBarWidget().setProperty(HELP, f"panel/{name}")
            dock.installEventFilter(self)
        for name in window.bottom.names:
            window.bottom.button(name).setProperty(HELP, f"panel/{name}")
        window.welcome.setProperty(HELP, "panel/welcome")
        window.sides.setProperty(HELP, "panel/tabs")
        window.installEventFilter(self)
        for menu in window.actions_.menus:
            menu.installEventFilter(self)
        self._topics: dict[str, Topic] = {}

    # -- asking ------------------------------------------------------------------------

    def open(self) -> None:
        """Explains the entry that is marked in an open menu; else what has the keyboard, or what is
        selected there.
        """
        menu = QApplication.activePopupWidget()
        marked = menu.activeAction() if isinstance(menu, QMenu) else None
        topic = self.topic_of_action(marked) if marked is not None else self.topic_at_focus()
        while (popup := QApplication.activePopupWidget()) is not None:
            popup.close()
        self.show_topic(topic)

    def ask(self) -> None:
        """The next click is explained, and does nothing else."""
        for action in self._window.actions_.actions.values():
            action.setWhatsThis(_told(*self._said(self.topic_of_action(action))))
        QWhatsThis.enterWhatsThisMode()

    def show_topic(self, id: str) -> None:
        """Shows a topic in the help's window; the contents where there is none."""
        window = self._window
        if self.shown is None:
            self.shown = HelpWindow(window.theme, window.settings, self.more, window)
        self.shown.set_theme(window.theme)
        self.shown.show_topic(id or CONTENTS)
        self.shown.show()
        self.shown.raise_()
        self.shown.activateWindow()
        self.shown.pages.setFocus()

    def show_tutorial(self) -> None:
        """Shows the tutorial, at the step where one left off."""
        window = self._window
        if self.tutorial is None:
            page = tutorial(spoken())
            self.tutorial = TutorialWindow(page, window.theme, window.settings, window)
        self.tutorial.show()
        self.tutorial.raise_()
        self.tutorial.activateWindow()
        self.tutorial.next.setFocus()

    def more(self, id: str) -> list[tuple[str, str]]:
        """Of a command: its menu, its keys, and why it can not be done now."""
        window = self._window
        sort, _, name = id.partition("/")
        if sort != "command":
            return []
        one, action = command(name), window.actions_.actions[name]
        window.actions_.refresh()
        rows = []
        if one.menu:
            path = " → ".join(translated(part) for part in one.menu.split("/"))
            rows.append((self.tr("Menu"), path))
        keys = written(action.shortcuts())
        if keys:
            rows.append((self.tr("Keys"), keys))
        reason = window.actions_.reason(one)
        if reason:
            rows.append((self.tr("Not now"), reason))
        return rows

    # -- what is at a place ------------------------------------------------------------

    def topic_at_focus(self) -> str:
        """The topic of what has the keyboard; "" where there is none."""
        focus = QApplication.focusWidget()
        return self.topic_of(focus) if focus is not None else ""

    def topic_of(self, widget: QWidget, at: QPoint | None = None) -> str:
        """The topic of a widget, or of what it lies in.

        at: where on the screen it was clicked; else what is selected in it counts.
        """
        above: QWidget | None = widget
        while above is not None:
            found = self._own_topic(above, at)
            if found:
                return found
            above = above.parentWidget()
        return ""

    def _own_topic(self, widget: QWidget, at: QPoint | None) -> str:
        if isinstance(widget, DocumentView):
            return self._topic_of_view(widget, at)
        if isinstance(widget, QToolButton) and widget.defaultAction() is not None:
            return self.topic_of_action(widget.defaultAction())
        if widget is self._window.bottom:
            return f"panel/{self._window.bottom.current}"
        named = widget.property(HELP)
        if named == "panel/inspector" and at is None:
            return self._topic_of_place(self._window.inspector.place) or str(named)
        return str(named or "")

    def topic_of_action(self, action: QAction) -> str:
        """The topic of a command; "" of what is none."""
        if action.objectName() not in self._window.actions_.actions:
            return ""
        return command_topic(command(action.objectName()))

    def _topic_of_view(self, view: DocumentView, at: QPoint | None) -> str:
        canvas = view.canvas
        place: Place = view.selected[0] if view.selected else ()
        if at is not None and view.mode == "graph" and canvas is not None:
            viewer = canvas.viewer
            place = canvas.place_at(QPointF(viewer.mapToScene(viewer.mapFromGlobal(at))))
        ways = {"graph": "panel/canvas", "matrix": "panel/matrix", "outline": "panel/outline"}
        return self._topic_of_place(place) or ways.get(view.mode, "page/screen")

    def _topic_of_place(self, place: Place) -> str:
        document = self._window.current_document
        if document is None or not place:
            return ""
        if place[-1] == "timeout":
            return "kind/timeout"
        kind = kinds.kind_of(places.get(document, places.nearest(document, place)))
        return f"kind/{kind.name}" if kind is not None else ""

    def words_at(self, widget: QWidget, at: QPoint) -> tuple[str, str]:
        """What is told of a widget that is clicked at a place of the screen: a title, and words."""
        title, words = self._said(self.topic_of(widget, at))
        own = widget.toolTip()
        return title, "\n".join(dict.fromkeys(filter(None, (own, words))))

    # -- What is this ------------------------------------------------------------------

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(watched, QMenu):
            return self._in_menu(event)
        if event.type() == QEvent.Type.StyleChange and watched is self._window:
            self._settle_theme()
        if event.type() not in _ASKED or not isinstance(event, QHelpEvent):
            return False
        at = event.globalPos()
        widget = QApplication.widgetAt(at) or self._window.childAt(self._window.mapFromGlobal(at))
        if widget is None:
            return False
        title, words = self.words_at(widget, at)
        if not words:
            return False
        event.accept()
        if event.type() == QEvent.Type.WhatsThis:
            QWhatsThis.showText(at, _told(title, words), widget)
        return True

    def _settle_theme(self) -> None:
        if self.shown is not None:
            self.shown.set_theme(self._window.theme)
        if self.tutorial is not None:
            self.tutorial.set_theme(self._window.theme)

    def _in_menu(self, event: QEvent) -> bool:
        """Shortcuts do not reach an open menu: its keys are listened to."""
        if event.type() != QEvent.Type.KeyPress or not isinstance(event, QKeyEvent):
            return False
        keys = self._window.actions_.actions["help"].shortcuts()
        if QKeySequence(event.keyCombination()) not in keys:
            return False
        self.open()
        return True

    def _said(self, id: str) -> tuple[str, str]:
        self._topics = self._topics or topics()
        topic = self._topics.get(id)
        return (topic.title, "\n".join(topic.paragraphs[:1])) if topic is not None else ("", "")


def _told(title: str, words: str) -> str:
    said = "<br>".join(escape(line) for line in words.split("\n") if line)
    return f"<b>{escape(title)}</b><br>{said}" if title else said
