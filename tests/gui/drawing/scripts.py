"""A script of situations, drawn by hand: data, modules, situations in their precedence."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from tests.gui.drawing.conditions import ConditionFiller

from situ.document.condition import Condition
from situ.document.datatypes import write_number
from situ.document.spds import Declaration, Entry, Observed, Situation, Spds
from situ_studio.edits.notes import note_of
from situ_studio.kinds import TYPES


class ScriptDrawer(ConditionFiller):
    """Draws scripts into the tab that is open: as a new script is, with every application."""

    def draw_script(self, wanted: Spds) -> None:
        for observed in wanted.observe:
            self.data(observed)
        there = {one.name for one in self.script.modules}
        for name in there - {one.name for one in wanted.modules}:
            # Of the application that a new project begins with.
            self.click_card(name)
            self.key(Qt.Key.Key_Delete)
        for module in wanted.modules:
            self.module(module, module.name in there)
        *others, last = wanted.situations
        (begun,) = self.script.situations
        self.click_card(begun.name)
        self.fill_form({"Name": last.name})
        self.priorities(last.entries)
        for situation in others:
            self.click_card(last.name)
            self.press("Situation")
            self.situation(situation)
        for situation in wanted.situations:
            if situation.extends is not None:
                self.click_card(situation.name)
                self.fill_form({"Takes over": situation.extends})
            if note_of(situation):
                self.click_card(situation.name)
                self.fill_form({"Note": note_of(situation)})
        self.click_card(last.name)
        self.key(Qt.Key.Key_Escape)
        self.fill_form({"Name": wanted.name, "Note": note_of(wanted)})

    @property
    def script(self) -> Spds:
        """As it is by now; only looked at."""
        found = self.window.current_document
        assert isinstance(found, Spds)
        return found

    def data(self, observed: Observed) -> None:
        self.press("Data")
        kind = dict(TYPES).get(observed.type or "", "not said")
        self.fill({"Tag": observed.tag, "Type": kind, "Unit": observed.unit or ""})

    def module(self, module: Declaration, is_there: bool) -> None:
        if is_there:
            self.click_card(module.name)
            self.fill_form({"Resources": " ".join(module.resources)})
        else:
            self.press("Module")
            self.fill({"Name": module.name, "Resources": " ".join(module.resources)})

    def situation(self, situation: Situation) -> None:
        """Into the form of a new one, which has a test to begin with."""
        self.fill(
            {
                "Name": situation.name,
                "Stays": "" if situation.dwell is None else write_number(situation.dwell),
                "Ends": "" if situation.limit is None else write_number(situation.limit),
            }
        )
        below = 0
        for condition in (situation.condition or Condition(), situation.until or Condition()):
            below = self.condition(condition, below)
        self.press_in_form("Remove this test")
        self.priorities(situation.entries)

    def priorities(self, wanted: Sequence[Entry]) -> None:
        """Those that are there stay where their order is the wanted one."""
        name = self.window.inspector.place[1]
        every = (one.entries for one in self.script.situations if one.name == name)
        there = [one.module for one in next(every)]
        stay = [one.module for one in wanted]
        if [one for one in there if one in stay] != stay:
            stay = []
        for at in reversed(range(len(there))):
            if there[at] not in stay:
                self.press_in_form("Remove", at)
        for at, entry in enumerate(wanted):
            if entry.module not in stay:
                self.press_in_form("Add a priority")
                self.write(self.focus(), entry.module)
                self.key(Qt.Key.Key_Tab)
            else:
                self.press_in_form("Priority", at)
            self.write(self.focus(), "" if entry.priority is None else str(entry.priority))
            self.key(Qt.Key.Key_Tab)
