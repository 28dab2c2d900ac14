"""Templates of screens: large enough, without a problem, and put on a state in one piece."""

from __future__ import annotations

import shutil
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from situ.document import rbd
from situ.document.check import check
from situ.document.project import Project
from situ.errors import UsageError
from situ_studio.screens.media_import import file_of
from situ_studio.screens.own_templates import FILE, FOLDER, OwnTemplates
from situ_studio.screens.templates import applied, raised, read, templates, title, written

# A template waits for its ways, its pictures and the values that it reads.
WAITS = {"dead-end", "unreachable-state", "missing-media"}


def test_no_template_has_a_problem_of_its_own_not_even_for_old_eyes_and_fingers() -> None:
    for name, state in templates().items():
        events = tuple(replace(event, next="2") for event in state.events)
        shown = replace(state, no="1", events=events)
        application = rbd.Application(name=name, states=(shown, rbd.State(no="2", name="end")))
        project = Project(root=".", name=name, applications={"a.rbd.xml": application})
        found = [p for p in check(project) if p.place[:2] == ("state", "1")]
        assert [p for p in found if p.code not in WAITS] == []


def test_every_template_has_a_title_and_fills_the_screen_it_is_put_on() -> None:
    start = rbd.State(no="1", screen=rbd.Screen(background="lobby.png"), events=(
        rbd.Event(name="clickYes", next="1"),
    ))  # fmt: skip
    application = rbd.Application(name="a", states=(start,))
    for name, wanted in templates().items():
        assert title(name) != name
        after = applied(application, ("state", "1"), wanted).states[0]
        assert after.screen is not None
        assert wanted.screen is not None
        assert after.screen.background == "lobby.png"
        assert after.screen.components == wanted.screen.components
        raised = {
            getattr(c, "event", None) or getattr(c, "done", None) for c in after.screen.components
        }
        assert raised - {None} <= {event.name for event in after.events}
        # What was there leads where it led.
        assert after.events[0] == start.events[0]
        assert len({event.name for event in after.events}) == len(after.events)


def test_one_s_own_are_kept_by_name_in_a_file_that_any_window_reads(tmp_path: Path) -> None:
    own = OwnTemplates(tmp_path / "settings")
    assert own.all() == ()
    shown = templates()["two-answers"].screen
    assert shown is not None
    own.keep("welcome", replace(shown, background="lobby.png"), no_file)
    own.keep("Ask", shown, no_file)
    own.keep("welcome", replace(shown, components=shown.components[:1]), no_file)
    kept = OwnTemplates(tmp_path / "settings").all()
    assert [one.name for one in kept] == ["Ask", "welcome"]
    assert [event.name for event in kept[0].events] == list(raised(shown))
    assert kept[1].screen is not None
    assert len(kept[1].screen.components) == 1
    # Where it lies the background of its state stays.
    assert kept[0].screen is not None
    assert kept[0].screen.background is None
    own.remove("Ask")
    assert [one.name for one in own.all()] == ["welcome"]
    (tmp_path / "settings" / FILE).write_bytes(b"<broken")
    assert own.all() == ()


def test_pictures_go_along_into_any_project_in_which_a_template_is_used(tmp_path: Path) -> None:
    """Each file once, however often it is shown, and none that nothing shows any more."""
    settings, ward, other = (tmp_path / name for name in ("settings", "ward", "other"))
    (ward / "media").mkdir(parents=True)
    (ward / "media" / "robot.png").write_bytes(b"the robot")
    (other / "media").mkdir(parents=True)
    (other / "media" / "robot.png").write_bytes(b"another robot")
    first = Project(root=str(ward), name="ward", media="media")
    second = Project(root=str(other), name="other", media="media")
    box: dict[str, Any] = {"x": 5.0, "y": 5.0, "width": 40.0, "height": 40.0}
    screen = rbd.Screen(
        components=(
            rbd.Image(id="a", src="robot.png", **box),
            rbd.Image(id="b", src="robot.png", **box),
            rbd.Movie(id="c", src="gone.webm", **box),
        )
    )
    own = OwnTemplates(settings)
    own.keep("robots", screen, partial(file_of, first))
    shutil.rmtree(ward)
    (kept,) = own.all()
    assert [file.read_bytes() for file in (settings / FOLDER).iterdir()] == [b"the robot"]

    used = own.brought(kept, second)
    assert used.screen is not None
    assert [getattr(c, "src", "") for c in used.screen.components] == [
        "robot-2.png",
        "robot-2.png",
        "gone.webm",
    ]
    assert (other / "media" / "robot-2.png").read_bytes() == b"the robot"
    assert own.brought(used, second) is used
    stock = templates()["picture"]
    assert own.brought(stock, second) is stock
    # What a drag of another program names lies nowhere else than there.
    (settings / "secret.png").write_bytes(b"secret")
    for src in (f"{FOLDER}/../secret.png", f"{FOLDER}/..", FOLDER, "/etc/hostname"):
        odd = replace(kept, screen=rbd.Screen(components=(rbd.Image(id="a", src=src, **box),)))
        assert own.brought(odd, second) is odd

    own.remove("robots")
    assert list((settings / FOLDER).iterdir()) == []


def test_what_leads_out_of_a_project_is_no_picture_of_it(tmp_path: Path) -> None:
    (tmp_path / "ward" / "media").mkdir(parents=True)
    (tmp_path / "ward" / "a.png").write_bytes(b"a")
    (tmp_path / "outside.png").write_bytes(b"b")
    with_folder = Project(root=str(tmp_path / "ward"), name="ward", media="media")
    without = Project(root=str(tmp_path / "ward"), name="ward")
    assert file_of(without, "a.png") == (tmp_path / "ward" / "a.png").resolve()
    assert file_of(with_folder, "a.png") is None
    assert file_of(with_folder, "../../outside.png") is None
    assert file_of(with_folder, "") is None


def no_file(src: str) -> None:
    """The screen shows none."""


def test_where_they_can_not_be_written_it_is_said_in_one_line(tmp_path: Path) -> None:
    shown = templates()["two-answers"].screen
    assert shown is not None
    taken = tmp_path / "settings"
    taken.write_text("a file", encoding="utf-8")
    with pytest.raises(UsageError) as told:
        OwnTemplates(taken).keep("welcome", shown, no_file)
    assert "\n" not in str(told.value)
    assert str(taken) in str(told.value)


def test_what_a_drag_carries_is_the_template_and_nothing_else_is_taken_for_one() -> None:
    for wanted in templates().values():
        found = read(written(wanted))
        assert found is not None
        assert found.screen is not None
        assert wanted.screen is not None
        assert [c.id for c in found.screen.components] == [c.id for c in wanted.screen.components]
    for other in (b"", b"<a/>", written(rbd.State(no="1"))):
        assert read(other) is None
