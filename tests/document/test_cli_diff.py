"""``situ diff`` as a person types it."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.document.described import pills

from situ.cli import main


def _saved(folder: Path, text: str) -> str:
    folder.mkdir(exist_ok=True)
    file = folder / "a.rbd.xml"
    file.write_text(text, encoding="utf-8")
    return str(file)


def test_exit_0_where_nothing_differs_or_things_only_moved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    one = _saved(tmp_path / "one", pills())
    namespace = 'xmlns:ed="urn:situ:editor" name="a"'
    moved = pills().replace('name="a"', namespace).replace('no="2"', 'no="2" ed:x="1" ed:y="2"')
    two = _saved(tmp_path / "two", moved)
    assert main(["diff", one, one]) == 0
    assert capsys.readouterr().out == "No differences.\n"
    assert main(["diff", one, two]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "The robot acts the same; only what people see of the project changed:",
        "state done: moved in the drawing",
    ]


def test_exit_1_where_the_robot_may_act_differently(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    one, two = (_saved(tmp_path / n, pills(seconds=n)) for n in ("30", "60"))
    assert main(["diff", one, two]) == 1
    assert capsys.readouterr().out == "state Take pills: timeout 30 → 60 s\n"
    assert main(["diff", "--json", one, two]) == 1
    out = capsys.readouterr().out
    assert '"place": [\n      "state",\n      "1",\n      "timeout"\n    ]' in out
    assert '"behaviour": true' in out


@pytest.mark.parametrize("broken", [None, "<application", "<application name='a'><stat/>"])
def test_exit_2_where_one_can_not_be_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], broken: str | None
) -> None:
    one = _saved(tmp_path / "one", pills())
    two = str(tmp_path / "none") if broken is None else _saved(tmp_path / "two", broken)
    assert main(["diff", one, two]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1


def test_many_moved_things_are_summed_up(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    states = "".join(f'<state no="{n}" ed:x="{{x}}" ed:y="1"/>' for n in range(5))
    text = f'<application name="a" xmlns:ed="urn:situ:editor">{states}</application>'
    one, two = (_saved(tmp_path / x, text.format(x=x)) for x in ("1", "2"))
    assert main(["diff", one, two]) == 0
    assert capsys.readouterr().out.splitlines()[1:] == ["5 things moved in the drawing"]
