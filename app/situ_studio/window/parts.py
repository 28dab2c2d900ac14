"""A window's parts: the way into them and back, and making them.

A tab shows its own document, or a part in it, of which the way is kept; each document keeps its
selection and what is seen of it while another is shown.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QPointF

from situ.document.aside import NOTHING
from situ.document.dissolve import dissolve
from situ.document.part import NoPart, make_part, part_file_of
from situ.document.project import Project
from situ.document.rbd import Application, Event, State
from situ_studio.edits import changes, places
from situ_studio.edits.edit import Place
from situ_studio.finding.looking import scenarios_with
from situ_studio.panels.project_tree import stem
from situ_studio.wording.language import said

if TYPE_CHECKING:
    from situ_studio.window.main_window import MainWindow
    from situ_studio.window.sides import Group


class PartsSide(QObject):
    """What a window does with parts."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window
        self._session = window.session
        window.sides.chosen.connect(self._on_tab)
        window.sides.level_asked.connect(self._on_asked)

    def is_part(self, file: str) -> bool:
        """Whether the project has that file only as a part of others."""
        project = self._session.project
        return project is not None and file in project.parts

    # -- the way in and back ----------------------------------------------------------

    @property
    def _ways(self) -> dict[str, tuple[str, ...]]:
        """Of the current group of tabs."""
        return self._window.sides.current.ways

    @property
    def way(self) -> tuple[str, ...]:
        """The files from the tab's own to the one that is shown."""
        tab = self._window.tabs.chosen_file
        return self._ways.get(tab, (tab,)) if tab is not None else ()

    def way_of(self, tab: str, group: Group | None = None) -> tuple[str, ...]:
        """The files from that tab's own to the one that is shown in it.

        group: of tabs, in place of the current one.
        """
        way = (group.ways if group is not None else self._ways).get(tab, (tab,))
        while len(way) > 1 and self._session.document(way[-1]) is None:
            way = way[:-1]
        return way

    def _on_tab(self, file: str) -> None:
        self.show_way(self.way_of(file))

    def show_way(self, way: tuple[str, ...]) -> None:
        """Shows the last file of a way, whose first one is that of the chosen tab."""
        self._ways[way[0]] = way
        self._window.open_files.show(way[-1])
        self._window.crumbs.show_way(tuple(stem(file) for file in way))

    def reach(self, file: str) -> bool:
        """Shows a file that lies on the way into the part that is shown; False for any other."""
        way = self.way
        if file not in way:
            return False
        self.show_way(way[: way.index(file) + 1])
        return True

    def forget(self, file: str) -> None:
        """The tab of that file begins with its own document again."""
        self._ways.pop(file, None)

    def can_enter(self) -> bool:
        """Whether the one thing selected is a state that runs a part."""
        return self._chosen_part() is not None

    def _chosen_part(self) -> str | None:
        view, document = self._window.current_view, self._window.current_document
        if view is None or document is None or len(view.selected) != 1:
            return None
        state = places.get(document, places.root(view.selected[0]))
        return state.flow if isinstance(state, State) else None

    def enter(self) -> None:
        """Shows the part that the selected state runs, in the same tab."""
        flow = self._chosen_part()
        if flow is None:
            return
        if self._session.document(flow) is None:
            self._window.say(self.tr("{0} is not in this project.").format(flow))
            return
        if not self.reach(flow):
            self.show_way((*self.way, flow))
        self._focus()

    def can_leave(self) -> bool:
        return len(self.way) > 1

    def leave(self) -> None:
        """Shows the application around the part that is shown."""
        if self.can_leave():
            self.show_way(self.way[:-1])
            self._focus()

    def _on_asked(self, level: int) -> None:
        self.show_way(self.way[: level + 1])
        self._focus()

    def _focus(self) -> None:
        view = self._window.current_view
        if view is not None:
            view.current_view().setFocus()

    # -- making parts ------------------------------------------------------------------

    def _numbers(self) -> list[str]:
        view = self._window.current_view
        chosen = view.selected if view is not None else ()
        return list(dict.fromkeys(p[1] for p in chosen if p[:1] == ("state",)))

    def can_make(self) -> bool:
        """Whether there are selected states of an application."""
        return isinstance(self._window.current_document, Application) and bool(self._numbers())

    def make(self) -> None:
        """Makes the selected states a part, under a name that a person gives; one step."""
        window, file, project = self._window, self._window.current_file, self._session.project
        view = window.current_view
        if file is None or project is None or view is None:
            return
        numbers = self._numbers()
        try:
            # What can not be done is said before a name is asked for.
            make_part(project, file, numbers, "part", self._free(project, file, "part"))
            name = window.dialogs.name(self.tr("Make a part"), self.tr("Name of the part"), "part")
            if name is None:
                return
            part_file = self._free(project, file, name)
            after = make_part(project, file, numbers, name, part_file)
        except NoPart as refused:
            window.say(said(str(refused)))
            return
        source, part = after.flows[file], after.flows[part_file]
        begin = part.start_no or ""
        if self._commit({file: source, part_file: part}, self.tr("Make a part: {0}").format(name)):
            window.select(("state", begin))
            view.call("bring_into_view", (("state", begin),))
            ends = sum(1 for state in part.states if state.no not in numbers)
            told = self.tr(
                "{0} has {1} states and {2} ways out: double-click it to look inside."
            ).format(name, len(numbers), ends)
            old = scenarios_with(Path(project.root), numbers, file in project.parts)
            if old:
                told = self.tr(
                    "{0} is a part now; in scenarios its states are {1}/… from here: {2}."
                )
                told = told.format(name, begin, ", ".join(old))
            window.say(told)

    def dissolve(self) -> None:
        """The states of the part that the selected state runs stand in its place again."""
        window, file, project = self._window, self._window.current_file, self._session.project
        if file is None or project is None or not self.can_enter():
            return
        assert window.current_view is not None
        no = window.current_view.selected[0][1]
        flow = self._chosen_part()
        try:
            after = dissolve(project, file, no).flows[file]
        except NoPart as refused:
            window.say(said(str(refused)))
            return
        if self._commit({file: after}, self.tr("Dissolve part {0}").format(stem(flow or ""))):
            window.select(("state", no))

    def insert(self, at: QPointF | None = None, link: Place = ()) -> None:
        """A state that runs a part, which a person names: one that there is, or a new one.

        at: its corner in the scene, None for a free place. link: the exit into whose pipe it goes.
        """
        window, file, project = self._window, self._window.current_file, self._session.project
        document, view = window.current_document, window.current_view
        if file is None or project is None or view is None or not isinstance(document, Application):
            return
        known = [f for f in project.flows if f != file and not _runs(project, f, file)]
        answer = window.dialogs.part([stem(f) for f in known])
        if answer is None:
            return
        flow = next((f for f in known if stem(f) == answer), None)
        changed: dict[str, Application] = {}
        if flow is None:
            if any(stem(f) == answer for f in project.flows):
                window.say(
                    self.tr("{0} runs this application: it can not be a part of it.").format(answer)
                )
                return
            flow = self._free(project, file, answer)
            first = State(no="1", name="start", aside=NOTHING.at(24, 52))
            changed[flow] = Application(name=stem(flow), states=(first,))
        spot = at if at is not None else view.call("free_spot")
        after, no = with_part(document, answer, flow, spot, link)
        if self._commit({file: after, **changed}, self.tr("Add part {0}").format(answer)):
            window.select(("state", no))

    def _free(self, project: Project, file: str, name: str) -> str:
        """A file for a new part that neither the project nor the disk has."""
        taken = set(self._session.files)
        found = part_file_of(file, name, taken)
        while (self._session.root / found).exists():
            taken.add(found)
            found = part_file_of(file, name, taken)
        return found

    def _commit(self, changed: dict[str, Application], text: str) -> bool:
        window = self._window
        view = window.current_view
        selected = view.selected if view is not None else ()
        looking = view.call("looking") if view is not None else None
        if self._session.commit_all(changed, text, selected, looking):
            return True
        window.say(
            self.tr("{0} has errors: it can be read, not changed.").format(
                stem(next(iter(changed)))
            )
        )
        return False


def with_part(
    application: Application,
    name: str,
    flow: str,
    spot: QPointF | None,
    link: Place = (),
) -> tuple[Application, str]:
    """The application with one more state that runs ``flow``, and that state's number.

    link: an exit that leads to it then; ``done`` leads on to where the exit led.
    """
    no = changes.free_number(application)
    leaving = places.get(application, link) if link else None
    events: tuple[Event, ...] = ()
    if leaving is not None and leaving.next is not None:
        events = (Event(name="done", next=leaving.next),)
        application = places.change(application, link, next=no)
    aside = NOTHING.at(spot.x(), spot.y()) if spot is not None else NOTHING
    holder = State(no=no, name=name, flow=flow, events=events, aside=aside)
    return places.change(application, (), states=(*application.states, holder)), no


def _runs(project: Project, file: str, other: str) -> bool:
    """Whether the application ``file`` runs ``other``, directly or in its parts."""
    seen: set[str] = set()
    waiting = [file]
    while waiting:
        here = project.flow(waiting.pop())
        for state in here.states if here is not None else ():
            if state.flow == other:
                return True
            if state.flow is not None and state.flow not in seen:
                seen.add(state.flow)
                waiting.append(state.flow)
    return False
