"""A panel that has nothing to show says what it will show, and how that comes there."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def test_a_list_without_rows_says_how_one_gets_some(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    window.bottom.choose("scenarios")
    used.settle()
    scenarios = window.scenarios.panel
    assert scenarios.hint.isVisible()
    assert scenarios.table.viewport().rect().contains(scenarios.hint.geometry())

    window.bottom.choose("find")
    used.settle()
    finding = window.finding.panel
    assert finding.hint.isVisible()
    used.fill(finding.field, "nothing is called so")
    assert finding.list.model().rowCount() == 0
    assert not finding.hint.isVisible()
    used.fill(finding.field, "greeting")
    assert finding.list.model().rowCount() > 0
    assert not finding.hint.isVisible()
    used.fill(finding.field, "")
    assert finding.hint.isVisible()


def test_a_button_that_can_do_nothing_yet_looks_so(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    used.window.bottom.choose("scenarios")
    used.settle()
    paint = used.window.scenarios.panel.paint
    before = paint.grab().toImage()
    paint.setEnabled(True)
    used.settle()
    assert paint.grab().toImage() != before
