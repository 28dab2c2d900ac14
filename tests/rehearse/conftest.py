"""``situ simulate`` as a person types it, in a folder of its own."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple, Protocol

import pytest
from tests.rehearse.asked import APP, DOOR, SCRIPT

from situ import cli
from situ.document import codec
from situ.document.check import check
from situ.document.project import Project
from situ.rehearse import scenario
from situ.rehearse.recording import Recording
from situ.rehearse.recording import record as recording_of

EVENTFUL = """<application name="reception">
  <state no="1">
    <timeout next="2">5</timeout>
    <screen touched="woken"><components>
      <button id="go" x="1" y="1" width="9" height="9" event="clickGo" tag="pressed"
        value="1">GO</button>
    </components></screen>
    <backgroundactions><speech done="said">Hello</speech>
      <service name="find" url="http://x/"><result tag="names" path="names"/></service>
      <launch program="game" done="closed"/></backgroundactions>
    <expectedevents><event name="clickGo" next="2"/></expectedevents>
  </state>
  <state no="2"/>
</application>
"""


class Run(NamedTuple):
    """What a run came to. trace: the events; told: standard error."""

    status: int
    trace: list[dict[str, Any]]
    raw: bytes
    told: str

    def of(self, kind: str, **fields: Any) -> list[dict[str, Any]]:
        wanted = {"kind": kind, **fields}
        return [e for e in self.trace if all(e.get(k) == v for k, v in wanted.items())]


class Simulate(Protocol):
    def __call__(
        self, scenario: str | bytes | Sequence[dict[str, Any]], *options: str, rbd: str = ...
    ) -> Run: ...


@pytest.fixture
def simulate(tmp_path: Path, capsysbinary: pytest.CaptureFixture[bytes]) -> Simulate:
    """Runs a scenario: a list of lines, or the text of the file as it is."""

    def run(
        scenario: str | bytes | Sequence[dict[str, Any]], *options: str, rbd: str = EVENTFUL
    ) -> Run:
        if not isinstance(scenario, (str, bytes)):
            scenario = "".join(json.dumps(line) + "\n" for line in scenario)
        if isinstance(scenario, str):
            scenario = scenario.encode()
        (tmp_path / "s.jsonl").write_bytes(scenario)
        (tmp_path / "app.rbd.xml").write_text(rbd, encoding="utf-8")
        status = cli.main(
            [
                "simulate",
                str(tmp_path / "app.rbd.xml"),
                "--script",
                str(tmp_path / "s.jsonl"),
                *options,
            ]
        )
        out, err = capsysbinary.readouterr()
        return Run(status, [json.loads(line) for line in out.splitlines()], out, err.decode())

    return run


class Make(Protocol):
    def __call__(
        self, rbd: str | Sequence[str] = ..., spds: str | None = ..., **more: Any
    ) -> Project: ...


@pytest.fixture(scope="session")
def make() -> Make:
    """A project of documents given as XML; it must have no error."""

    def read(text: str, file: str) -> Any:
        document, problems = codec.read(text.encode(), file)
        assert not problems, problems
        return document

    def made(rbd: str | Sequence[str] = (), spds: str | None = None, **more: Any) -> Project:
        files = {f"{n}.rbd.xml": x for n, x in enumerate([rbd] if isinstance(rbd, str) else rbd)}
        project = Project(
            root=".",
            name="test",
            applications={file: read(text, file) for file, text in files.items()},
            spds_file=None if spds is None else "s.spds.xml",
            spds=None if spds is None else read(spds, "s.spds.xml"),
            **more,
        )
        errors = [problem for problem in check(project) if problem.severity == "error"]
        assert not errors, errors
        return project

    return made


@pytest.fixture
def door(make: Make) -> Project:
    return make(DOOR)


@pytest.fixture
def lab(make: Make) -> Project:
    return make(APP, SCRIPT)


class Record(Protocol):
    def __call__(
        self, project: Project, *lines: dict[str, Any], alone: bool = ...
    ) -> Recording: ...


@pytest.fixture(scope="session")
def record() -> Record:
    """Plays scenario lines; ``alone``: only what the trace tells is kept."""

    def recorded(project: Project, *lines: dict[str, Any], alone: bool = False) -> Recording:
        text = "\n".join(map(json.dumps, lines)).encode()
        recording, _ = recording_of(project, scenario.parse(text, "s"))
        return Recording.of(recording.events) if alone else recording

    return recorded
