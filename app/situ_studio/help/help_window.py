"""The window of the help: a field to search, a topic, links from one to the next."""

from __future__ import annotations

from collections.abc import Callable
from html import escape
from typing import Any

from PySide6.QtCore import QSettings, QSize, Qt, QUrl
from PySide6.QtGui import QHideEvent, QKeyEvent
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QTextBrowser, QVBoxLayout, QWidget

from situ_studio.help.help_topics import Topic, topics
from situ_studio.looks.letters import px
from situ_studio.looks.theme import Theme
from situ_studio.widgets.icon_widgets import IconButton, retheme

SCHEME = "topic"
CONTENTS = "contents"
SEARCH = "search/"
GEOMETRY = "help_geometry"
SORTS = ("page", "kind", "panel", "status", "command", "field")
"""What is found stands in this order."""


class Pages(QTextBrowser):
    """Shows what ``page`` makes of an address, and knows the way back."""

    def __init__(self, page: Callable[[str], str]) -> None:
        super().__init__()
        self._page = page
        self.setOpenExternalLinks(False)
        self.document().setDocumentMargin(16)

    def loadResource(self, type: int, name: QUrl | str) -> Any:
        return self._page(QUrl(name).path())


class HelpWindow(QWidget):
    """Beside the window that it explains; Esc closes it.

    more: lines about a topic that hold now, such as a command's keys. settings: where it was.
    """

    def __init__(
        self,
        theme: Theme,
        settings: QSettings,
        more: Callable[[str], list[tuple[str, str]]],
        parent: QWidget,
    ) -> None:
        super().__init__(parent, Qt.WindowType.Tool)
        self._theme, self._settings, self._more = theme, settings, more
        self._topics = topics()
        self.setProperty("role", "help")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setWindowTitle(self.tr("Help"))
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 8, 0, 0)
        column.setSpacing(8)
        line = QHBoxLayout()
        line.setContentsMargins(8, 0, 8, 0)
        line.setSpacing(4)
        self.back = IconButton(theme, "left", self.tr("Back to what was read before"), "text2")
        self.home = IconButton(theme, "list", self.tr("What the help has"), "text2")
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Search the help"))
        self.field.setAccessibleName(self.tr("Search the help"))
        self.field.setToolTip(self.tr("A word of what you want to know"))
        self.field.setClearButtonEnabled(True)
        for widget in (self.back, self.home):
            line.addWidget(widget)
        line.addWidget(self.field, 1)
        column.addLayout(line)
        self.pages = Pages(self._html)
        self.pages.setAccessibleName(self.tr("Help"))
        self.pages.setFrameShape(QTextBrowser.Shape.NoFrame)
        column.addWidget(self.pages, 1)
        self.back.clicked.connect(self.pages.backward)
        self.back.setEnabled(False)
        self.pages.backwardAvailable.connect(self.back.setEnabled)
        self.home.clicked.connect(lambda: self.show_topic(CONTENTS))
        self.field.textChanged.connect(self._on_search)
        self.field.returnPressed.connect(self._open_first)
        kept = settings.value(GEOMETRY)
        if kept is None or not self.restoreGeometry(kept):
            self.resize(px(420), 560)
            right = parent.mapToGlobal(parent.rect().topRight())
            self.move(right.x() - self.width() - 24, right.y() + 96)

    def sizeHint(self) -> QSize:
        return QSize(px(420), px(560))

    @property
    def topic(self) -> str:
        """What is shown."""
        return self.pages.source().path()

    def show_topic(self, id: str) -> None:
        """Shows a topic, or the contents where there is none of that name."""
        known = id in self._topics or id.startswith(SEARCH)
        address = QUrl()
        address.setScheme(SCHEME)
        address.setPath(id if known else CONTENTS)
        self.pages.setSource(address)

    def set_theme(self, theme: Theme) -> None:
        self._theme = theme
        retheme(self, theme)
        self.pages.reload()

    def hideEvent(self, event: QHideEvent) -> None:
        """Where it was is kept for the next time."""
        super().hideEvent(event)
        self._settings.setValue(GEOMETRY, self.saveGeometry())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        back = event.modifiers() & Qt.KeyboardModifier.AltModifier
        if event.key() == Qt.Key.Key_Escape:
            self.close()
        elif event.key() == Qt.Key.Key_Left and back:
            self.pages.backward()
        else:
            super().keyPressEvent(event)

    # -- searching ---------------------------------------------------------------------

    def _on_search(self, text: str) -> None:
        self.show_topic(f"{SEARCH}{text.strip()}" if text.strip() else CONTENTS)

    def _open_first(self) -> None:
        found = self.found(self.field.text())
        if found:
            self.show_topic(found[0].id)

    def found(self, text: str) -> list[Topic]:
        """The topics that have every word of ``text``; those whose title has them first."""
        wanted = text.casefold().split()
        ranked: list[tuple[bool, int, int, Topic]] = []
        for topic in self._topics.values():
            rows = " ".join(f"{name} {said}" for name, said in topic.rows)
            whole = f"{topic.title} {' '.join(topic.paragraphs)} {rows}".casefold()
            if wanted and all(word in whole for word in wanted):
                elsewhere = not all(word in topic.title.casefold() for word in wanted)
                ranked.append((elsewhere, SORTS.index(topic.sort), len(ranked), topic))
        return [topic for *_, topic in sorted(ranked, key=lambda one: one[:3])]

    # -- pages -------------------------------------------------------------------------

    def _html(self, id: str) -> str:
        if id.startswith(SEARCH):
            found = self.found(id.removeprefix(SEARCH))
            body = "".join(self._entry(topic) for topic in found[:40])
            return self._page(self.tr("Found"), body or f"<p>{escape(self.tr('Nothing.'))}</p>")
        topic = self._topics.get(id)
        return self._page(topic.title, self._body(topic)) if topic is not None else self._contents()

    def _body(self, topic: Topic) -> str:
        made = [f"<p>{escape(text)}</p>" for text in topic.paragraphs if text]
        rows = [*self._more(topic.id), *topic.rows]
        lines = "".join(
            f"<tr><td class='name'>{escape(name)}</td><td>{escape(said)}</td></tr>"
            for name, said in rows
        )
        if lines:
            made.append(f"<table cellspacing='0' cellpadding='0'>{lines}</table>")
        see = [self._topics[id] for id in topic.see if id in self._topics]
        if see:
            made.append(f"<h3>{escape(self.tr('See also'))}</h3>")
            made.append(f"<p>{' · '.join(map(_link, see))}</p>")
        return "".join(made)

    def _contents(self) -> str:
        heads = {
            "page": self.tr("Pages"),
            "kind": self.tr("What is drawn"),
            "panel": self.tr("Panels"),
            "command": self.tr("Commands"),
        }
        made = []
        for sort, head in heads.items():
            made.append(f"<h3>{escape(head)}</h3>")
            every = [topic for topic in self._topics.values() if topic.sort == sort]
            if sort == "page":
                made += [f"<p class='row'>{_link(topic)}</p>" for topic in every]
            else:
                made.append(f"<p>{' · '.join(map(_link, every))}</p>")
        return self._page(self.tr("Help"), "".join(made))

    def _entry(self, topic: Topic) -> str:
        first = escape(topic.paragraphs[0]) if topic.paragraphs else ""
        return f"<p>{_link(topic)}<br><span class='dim'>{first}</span></p>"

    def _page(self, title: str, body: str) -> str:
        theme = self._theme
        style = (
            f"body {{ color: {theme.text}; font-size: 13px; line-height: 145%; }}"
            f"h2 {{ font-size: 18px; font-weight: 600; margin: 0 0 8px 0; }}"
            f"h3 {{ font-size: 13px; font-weight: 600; margin: 16px 0 4px 0; }}"
            f"p {{ margin: 0 0 8px 0; }} p.row {{ margin: 0 0 4px 0; }}"
            f"a {{ color: {theme.accent}; text-decoration: none; }}"
            f".dim {{ color: {theme.text2}; }} td {{ vertical-align: top; padding: 3px 0; }}"
            f"td.name {{ color: {theme.text2}; padding-right: 16px; }}"
        )
        return f"<html><head><style>{style}</style></head><body><h2>{escape(title)}</h2>{body}"


def _link(topic: Topic) -> str:
    return f'<a href="{SCHEME}:{topic.id}">{escape(topic.title)}</a>'
