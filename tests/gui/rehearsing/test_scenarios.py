"""Scenarios in a window: all are run, what failed is looked at, what they came through painted."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtTest import QSignalSpy

from situ.document.ready import load_ready
from situ.rehearse.suite import run_suite, scenarios
from situ.resources import examples
from situ_studio.canvas.live import LiveScript, LiveView
from situ_studio.rehearsing.painting import painted

Start = Callable[..., Any]
Copy = Callable[[str], Path]


def ran(used: Any, click: Any) -> Any:
    """Runs all of them; the rows of the panel."""
    used.window.bottom.choose("scenarios")
    used.settle()
    used.click(click)
    run = used.window.scenarios.run_
    if len(run.ran) < len(run.files):
        ended = QSignalSpy(run.ended)
        assert ended.wait(20000)
    used.settle()
    return used.window.scenarios.panel.table.rows.rows


def test_all_are_run_and_what_failed_is_looked_at_where_it_failed(
    studio: Start, project: Copy, glowing: Any
) -> None:
    root = project("conversation")
    wrong = root / "scenarios" / "a wrong one.jsonl"
    wrong.write_text(
        '{"at":2,"use":{"component":"yes"}}\n'
        '{"at":3,"expect":{"kind":"enter","state":"6"}}\n'
        '{"at":30,"use":{"component":"yes"}}\n'
        '{"at":31,"end":true}\n'
    )
    used = studio(root)
    window = used.window
    panel = window.scenarios.panel
    rows = ran(used, panel.run)
    by_file = {row.cells[0]: row for row in rows if row.key.startswith("ran")}
    assert "✗" in by_file["scenarios/a wrong one.jsonl"].cells[1]
    assert "line 2, 3 s" in by_file["scenarios/a wrong one.jsonl"].cells[3]
    assert "✓" in by_file["scenarios/fig5.jsonl"].cells[1]
    assert not window.status.work.going

    # A click on what failed: every view shows that moment.
    used.click_row(panel.table, used.row_with(panel.table, "scenarios/a wrong one.jsonl"))
    viewing = window.robot.follower.viewing
    assert viewing.t == 3
    assert viewing.moment().applications["converse"].state == "2"
    assert glowing(window) == {"2"}
    window.commands.close_recording()

    # Painted, the drawing tells how often they came through each state.
    used.click(panel.paint)
    counts = window.current_view.canvas.look.live.counts
    assert counts["1"] >= len(by_file)
    assert set(counts) == {state.no for state in window.current_document.states}
    used.click(panel.paint)
    assert window.current_view.canvas.look.live is None

    # A click on what none came through goes there.
    lacking = [row for row in rows if row.key.startswith("lacks")]
    assert lacking[0].cells[3] == "converse, 1 hello – clickNo → 6 goodbye"
    used.click_row(panel.table, panel.table.model().index(rows.index(lacking[0]), 0))
    (selected,) = window.current_view.selected
    assert window.current_file == "converse.rbd.xml"
    assert (selected[:2], selected[2]) == (("state", "1"), "event")
    assert window.current_document.states[0].events[int(selected[3])].name == "clickNo"


def test_a_run_is_cancelled_and_what_was_played_stays(studio: Start, project: Copy) -> None:
    used = studio(project("reception"))
    window = used.window
    window.commands.run_scenarios()
    (work,) = window.status.work.going
    work.cancel()
    used.settle()
    assert not window.status.work.going
    assert len(window.scenarios.run_.ran) < len(window.scenarios.run_.files)


def test_another_project_that_is_opened_has_not_been_run(studio: Start, project: Copy) -> None:
    used = studio(project("conversation"))
    window = used.window
    panel = window.scenarios.panel
    ran(used, panel.run)
    used.click(panel.paint)
    window.open_project(project("reception"))
    used.settle()
    assert panel.table.rows.rows == []
    assert not panel.paint.isEnabled()
    assert not panel.paint.isChecked()
    # What goes on is ended as well.
    window.commands.run_scenarios()
    window.open_project(window.session.root)
    used.settle()
    assert not window.status.work.going
    assert panel.table.rows.rows == []


def test_what_is_painted_is_what_the_suite_counted() -> None:
    for name in ("conversation", "reception"):
        found = load_ready(Path(examples()[name]))
        coverage = run_suite(found, scenarios(found)).coverage
        drawn = painted(found, coverage)
        views = [one for one in drawn.values() if isinstance(one, LiveView)]
        entered = sum(sum(view.counts.values()) for view in views)
        assert entered == sum(seen.times for seen in coverage.states.values())
        if found.spds_file is not None:
            script = drawn[found.spds_file]
            assert isinstance(script, LiveScript)
            assert script.holds == {n for n, s in coverage.situations.items() if s.covered}
