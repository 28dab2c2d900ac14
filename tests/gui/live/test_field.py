"""Recordings from the field: counted beside the window, painted on the drawings, in a table."""

from __future__ import annotations

import csv
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest
from msgspec.structs import replace
from PySide6.QtCore import QEventLoop, QObject, QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from tests.gui.live.test_log import played
from tests.gui.live.test_recordings import PATIENCE, recording

from situ.document.ready import load_ready
from situ.rehearse.usage import Row
from situ.resources import examples
from situ_studio.live.field import Asked, Field, counted, painted, recordings_in, whole
from situ_studio.live.field_reading import FieldReading
from situ_studio.live.field_rows import by_column, cells
from situ_studio.live.log import TraceLog
from situ_studio.wording.lasting import lasting

LEFT = Qt.MouseButton.LeftButton
WALKED, KNOWN = "walked-away.jsonl", "known-user.jsonl"


def recorded(folder: Path, name: str, *scripts: str) -> list[Path]:
    where = Path(examples()[name])
    made = []
    for number, script in enumerate(scripts):
        file = folder / f"{number}" / f"{Path(script).stem}.mcap"
        file.parent.mkdir(parents=True)
        _, _, events = played(name, script)
        recording(file, events, where)
        # Each is a run of its own.
        file.write_bytes(file.read_bytes().replace(b'"runtime":"r"', b'"runtime":"%d"' % number))
        made.append(file)
    return made


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(0, "0 s"), (1.5, "1.5 s"), (119, "119 s"), (4844.5, "80.7 min"), (3 * 86400, "3 d")],
)
def test_how_long_it_was_is_told_in_the_unit_that_people_would_take(
    seconds: float, words: str
) -> None:
    assert lasting(seconds) == words


def test_what_was_counted_is_what_the_robots_did(tmp_path: Path) -> None:
    files = recorded(tmp_path, "reception", KNOWN, WALKED)
    assert recordings_in(tmp_path) == files
    *progress, field = counted(Asked(tuple(files)))
    assert isinstance(field, Field)
    # A folder stands for what is in it.
    *_, same = counted(Asked((tmp_path,)))
    assert same == field
    went = [one for one in progress if isinstance(one, float)]
    assert len(went) == len(progress)
    assert went == sorted(went)
    assert went[-1] == 1.0
    project = load_ready(Path(examples()["reception"]))
    shown: Any = painted(project, field)["reception.rbd.xml"]
    entered: dict[str, int] = {}
    for script in (KNOWN, WALKED):
        log = TraceLog()
        log.add(played("reception", script)[2])
        for no, times in log.now.applications["reception"].entered.items():
            entered[no] = entered.get(no, 0) + times
    assert {no: n for no, n in shown.counts.items() if n} == entered
    application = project.applications["reception.rbd.xml"]
    never = {state.no for state in application.states} - entered.keys()
    assert never
    assert all(shown.counts[no] == 0 for no in never)
    assert not any(shown.active)
    timeouts = {row.state: row.timeouts for row in field.rows if row.timeouts}
    assert timeouts
    assert shown.gave_up == timeouts
    taken = {way for way, times in shown.transitions.items() if times}
    assert ("5", "1") in shown.transitions.keys() - taken
    assert ("2", "0") in taken
    rows = whole(project, field)
    assert {row.state for row in rows if not row.times} >= never
    assert cells(next(row for row in rows if not row.times))[2] == "never"


def test_situations_and_parts_are_painted_too(tmp_path: Path) -> None:
    *_, field = counted(Asked(tuple(recorded(tmp_path, "conversation", "fig5.jsonl"))))
    assert isinstance(field, Field)
    project = load_ready(Path(examples()["conversation"]))
    script: Any = painted(project, field)["conversation.spds.xml"]
    _, _, events = played("conversation", "fig5.jsonl")
    current = [event["to"] for event in events if event["kind"] == "situation"]
    names = {one.name for one in project.spds.situations}  # type: ignore[union-attr]
    assert script.counts == {name: current.count(name) for name in names}
    assert 0 in script.counts.values()
    assert sum(script.times.values()) == pytest.approx(events[-1]["t"])
    *_, new = counted(Asked(tuple(recorded(tmp_path / "n", "reception", "new-user.jsonl"))))
    assert isinstance(new, Field)
    reception = load_ready(Path(examples()["reception"]))
    part: Any = painted(reception, new)["register.rbd.xml"]
    assert sum(part.counts.values()) == sum(
        row.times for row in new.rows if row.state.startswith("16/")
    )


def test_rows_are_sorted_by_what_they_mean_not_by_their_letters() -> None:
    used = [
        Row("p", "lobby", "desk", no, "", "state", times=times)
        for no, times in (("10", 2), ("5/2", 11), ("2", 9), ("5", 9))
    ]
    assert [one.state for one in by_column(used, 0, down=False)] == ["2", "5", "5/2", "10"]
    assert [one.times for one in by_column(used, 2, down=True)] == [11, 9, 9, 2]
    assert [one.state for one in by_column(used, 2, down=True)][1:3] == ["2", "5"]


def test_a_process_that_has_gone_is_told_of(qt: Any) -> None:
    owner, gone, loop = QObject(), [], QEventLoop()
    reading = FieldReading(owner, (sys.executable, "-c", "raise SystemExit(3)"))
    reading.gone.connect(lambda: gone.append(True))
    reading.gone.connect(loop.quit)
    late = QTimer()
    late.setSingleShot(True)
    late.timeout.connect(loop.quit)
    late.start(PATIENCE)
    reading.start(Asked(()))
    loop.exec()
    late.stop()
    assert gone
    reading.cancel()


def until_counted(it: Any) -> None:
    loop, late = QEventLoop(), QTimer()
    it.window.field.reading.counted.connect(loop.quit)
    late.setSingleShot(True)
    late.timeout.connect(loop.quit)
    late.start(PATIENCE)
    loop.exec()
    assert late.isActive(), "nothing was counted"
    late.stop()
    it.settle()


def test_recordings_are_chosen_counted_painted_sorted_copied_and_exported(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    it = studio(project("reception"))
    window = it.window
    side, panel = window.field, window.field.panel
    files = recorded(tmp_path / "runs", "reception", KNOWN, WALKED)
    assert not panel.paint.isEnabled()
    # Given up, and begun again.
    it.answers.put("field_recordings", files)
    window.commands.count_recordings()
    window.status.work.cancel()
    assert window.status.work.going == []
    assert side.field is None
    it.answers.put("field_folder", tmp_path / "runs")
    QTest.mouseClick(panel.folder, LEFT)
    until_counted(it)
    assert window.status.work.going == []
    assert panel.summary.text().startswith("2 recordings · came to ")
    live = window.views["reception.rbd.xml"].canvas.look.live
    assert live.counts["1"] >= 2
    assert 0 in live.counts.values()
    graph = window.views["reception.rbd.xml"].canvas.graph
    drawn = {graph.pipe(id)._count() for id in graph.links if graph.pipe(id) is not None}
    assert drawn > {0, 1}
    assert panel.paint.isChecked()
    # A click on a head: what there is most of comes first.
    head = panel.table.horizontalHeader()
    QTest.mouseClick(head.viewport(), LEFT, pos=_middle(head, 2))
    times = [one.times for one in panel.table.used]
    assert times == sorted(times, reverse=True)
    QTest.mouseClick(head.viewport(), LEFT, pos=_middle(head, 2))
    assert [one.times for one in panel.table.used] == sorted(times)
    used = panel.table.used
    panel.table.setFocus()
    QTest.keyClick(panel.table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    lines = QApplication.clipboard().text().split("\n")
    assert lines[0].startswith("State\tPlace\tTimes")
    assert len(lines) == len(times) + 1
    assert "reception, 16 register" in "".join(lines)
    # On the screen as people say it, copied to be counted with.
    longest = max(panel.table.used, key=lambda one: one.seconds)
    panel.table.show_used([replace(longest, seconds=4844.5)])
    assert panel.table.rows.rows[0].cells[5] == "80.7 min"
    panel.table.copy()
    assert "\t4844.5 s\t" in QApplication.clipboard().text()
    panel.table.show_used(used)
    out = tmp_path / "usage.csv"
    it.answers.put("usage_file", out)
    QTest.mouseClick(panel.export, LEFT)
    table = list(csv.DictReader(out.read_text().splitlines()))
    assert [int(row["times"]) for row in table] == sorted(times)
    # By another tag it is counted anew, for each of its values.
    assert panel.place.text() == "pose.place"
    assert {one.place for one in panel.table.used} == {""}
    it.fill(panel.place, "no tag")
    assert "no tag is no tag" in window.status.said.text()
    it.fill(panel.place, "user.found")
    until_counted(it)
    assert {"true", "false"} & {one.place for one in panel.table.used}
    it.fill(panel.place, "")
    until_counted(it)
    assert panel.place.text() == "pose.place"
    assert {one.place for one in panel.table.used} == {""}
    QTest.mouseClick(head.viewport(), LEFT, pos=_middle(head, 2))
    # A row leads to its state.
    row = next(n for n, one in enumerate(panel.table.used) if one.state == "5")
    index = panel.table.model().index(row, 0)
    panel.table.scrollTo(index)
    QTest.mouseClick(panel.table.viewport(), LEFT, pos=panel.table.visualRect(index).center())
    it.settle()
    assert window.current_view.canvas.selection() == (("state", "5"),)
    QTest.mouseClick(panel.paint, LEFT)
    assert window.views["reception.rbd.xml"].canvas.look.live is None


def test_a_situation_says_how_often_and_how_long_it_was_current(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    it = studio(project("conversation"))
    it.window.open_file("conversation.spds.xml")
    it.window.field.count(recorded(tmp_path, "conversation", "fig5.jsonl"))
    until_counted(it)
    canvas = it.window.current_view.canvas
    live = canvas.look.live
    node = canvas.graph.nodes["situation called"].view

    def picture() -> Any:
        canvas.set_live(live)
        return canvas.viewer.grab(
            canvas.viewer.mapFromScene(node.sceneBoundingRect()).boundingRect()
        )

    counted_ = picture().toImage()
    assert counted_ == picture().toImage()
    live = msgspec.structs.replace(live, counts={**live.counts, "called": 7})
    more = picture().toImage()
    assert more != counted_
    live = msgspec.structs.replace(live, times={**live.times, "called": 77.0})
    assert picture().toImage() != more


def test_what_can_not_be_counted_is_told_of_and_the_rest_counts(
    studio: Callable[..., Any], project: Callable[[str], Path], tmp_path: Path
) -> None:
    it = studio(project("reception"))
    side = it.window.field
    bad = tmp_path / "bad.mcap"
    bad.write_bytes(b"no recording")
    side.count([bad, *recorded(tmp_path / "runs", "reception", KNOWN)])
    until_counted(it)
    assert "bad.mcap" in it.answers.told[0]
    assert side.panel.summary.text().startswith("1 recordings")
    side.go("reception", "99")
    assert "no such state" in it.window.status.said.text()
    empty = tmp_path / "empty"
    empty.mkdir()
    it.answers.put("field_folder", empty)
    side.choose_folder()
    until_counted(it)
    assert f"{empty}: there is no recording in it" in it.answers.told[1]
    assert side.panel.summary.text().startswith("1 recordings")


def _middle(head: Any, column: int) -> Any:
    return QPoint(head.sectionViewportPosition(column) + head.sectionSize(column) // 2, 8)
