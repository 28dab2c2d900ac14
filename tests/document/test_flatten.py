"""``situ export --flat``: the flat form and the original give the same actions at the same times.

formats.md, *Parts*: laws over generated applications with parts, and the cases by themselves.
"""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, assume, example, given, settings
from hypothesis import strategies as st

from situ import cli
from situ.decide.trace import to_fields
from situ.document import codec
from situ.document.check import check
from situ.document.flatten import NOTHING_TAG, flatten
from situ.document.folder import load
from situ.document.project import Project
from situ.document.rbd import Application
from situ.document.spds import Spds
from situ.errors import UsageError
from situ.rehearse import scenario
from situ.rehearse.simulate import simulate

AT = 'x="1" y="1" width="9" height="9"'
SCRIPT = """<spds name="s">
  <observe><data tag="busy"/></observe>
  <modules><module name="app" resources="screen speech base"/></modules>
  <situation name="busy"><condition><data tag="busy" is="true"/></condition></situation>
  <situation name="calm"><module name="app" priority="1"/></situation></spds>"""


def read(text: str) -> Application:
    document, problems = codec.read(text.encode(), "a.rbd.xml")
    assert not problems, problems
    assert isinstance(document, Application)
    return document


def project(app: str, script: bool = False, **parts: str) -> Project:
    spds, _ = codec.read(SCRIPT.encode(), "s.spds.xml")
    assert isinstance(spds, Spds)
    made = Project(
        root=".",
        name="test",
        applications={"app.rbd.xml": read(f'<application name="app">{app}</application>')},
        parts={
            f"{name}.rbd.xml": read(f'<application name="{name}">{text}</application>')
            for name, text in parts.items()
        },
        spds=spds if script else None,
        spds_file="s.spds.xml" if script else None,
    )
    assert [str(one) for one in check(made) if one.severity == "error"] == []
    return made


def told(made: Project, lines: list[dict[str, Any]]) -> list[Any]:
    """Times and actions, what the resources are asked for, and what they carry out."""
    found: list[Any] = []

    def tell(events: list[Any]) -> None:
        for event in events:
            fields = to_fields(event)
            kind = fields["kind"]
            assert kind != "error", fields
            hidden = found and found[-1].get("tag") == NOTHING_TAG
            if hidden:
                found.pop()
                assert kind == "finished"
            elif kind in ("action", "finished", "cancelled", "mapping", "acquire", "abandon"):
                drop = ("seq", "cause", "state")
                found.append({key: v for key, v in fields.items() if key not in drop})

    text = "\n".join(map(repr, lines)).replace("'", '"').replace("True", "true")
    simulate(made, scenario.parse(text.replace("False", "false").encode(), "s", ["app"]), tell=tell)
    return found


def same(made: Project, lines: list[dict[str, Any]]) -> Application:
    """The flat application, having done the same."""
    flat = flatten(made)
    assert [str(one) for one in check(flat) if one.severity == "error"] == []
    assert flat.parts == {}
    (application,) = flat.applications.values()
    assert application.always is None
    assert all(state.flow is None for state in application.states)
    # What is exported is what is read again.
    assert codec.read(codec.write(application), "a")[0] == application
    assert told(flat, lines) == told(made, lines)
    return application


# -- generated applications ------------------------------------------------------

NAMES = ("a", "b", "c", "done", "done.1", "done.2", "resumed", "timeout")
TAGS = ("t", "u")


class Maker:
    """One project and its scenario, drawn from ``rng``."""

    def __init__(self, rng: random.Random) -> None:
        self.rng = rng
        self.ids = 0
        self.back = rng.random() < 0.6

    def maybe(self, chance: float, text: str) -> str:
        return text if self.rng.random() < chance else ""

    def next(self, count: int) -> str:
        special = ["#again", *(["#back"] * 2 if self.back else [])]
        choice = self.rng.choice([*map(str, range(1, count + 1)), *special])
        return f' next="{choice}"'

    def when(self) -> str:
        tag, value = self.rng.choice(TAGS), self.rng.randrange(3)
        extra = self.maybe(0.2, f' within="{self.rng.choice((1, 2.5))}"')
        extra = extra or self.maybe(0.2, ' for="1.5"')
        return f'<when><data tag="{tag}" is="{value}"{extra}/></when>'

    def quick(self) -> str:
        done = self.maybe(0.3, f' done="{self.rng.choice("abc")}"')
        tag = self.rng.choice(TAGS)
        return self.rng.choice(
            (
                f'<set tag="{tag}"{done}>{self.rng.randrange(3)}</set>',
                f'<add tag="n"{done}>1</add>',
                f'<service name="s{self.rng.randrange(3)}" url="http://x/"{done}/>',
                f'<service name="k" url="http://x/" keep="true"{done}/>',
            )
        )

    def visible(self) -> str:
        done = self.maybe(0.4, f' done="{self.rng.choice("abc")}"') + self.maybe(0.3, ' wait="true"')
        more = self.maybe(0.2, ' optional="true"')
        self.ids += 1
        return self.rng.choice(
            (
                f"<speech{done}{more}>say {self.ids}</speech>",
                f'<robot resource="base" command="c{self.ids}"{done}{more}/>',
            )
        )

    def event(self, count: int) -> str:
        if self.rng.random() < 0.15:
            return f"<event{self.next(count)}>{self.when()}</event>"
        inside = self.maybe(0.4, self.when()) + self.maybe(0.1, "<say>yes</say>")
        inside += self.maybe(0.3, self.quick())
        if self.rng.random() < 0.75:
            to = self.next(count)
        else:
            to, inside = "", inside + self.maybe(0.3, "<repeat/>")
        return f'<event name="{self.rng.choice(NAMES)}"{to}>{inside}</event>'

    def events(self, count: int, most: int) -> str:
        found = "".join(self.event(count) for _ in range(self.rng.randrange(most + 1)))
        return f"<expectedevents>{found}</expectedevents>" if found else ""

    def timeout(self, count: int) -> str:
        to = self.next(count) if self.rng.random() < 0.7 else ""
        idle = self.maybe(0.3, ' idle="true"')
        return f"<timeout{to}{idle}>{self.rng.choice((0.5, 1, 1.5, 4))}</timeout>"

    def screen(self) -> str:
        self.ids += 1
        kind = self.rng.random()
        if kind < 0.15:
            return "<screen/>"
        one = (
            f'<button id="i{self.ids}" {AT} event="{self.rng.choice("abc")}">{{t}}</button>'
            if kind < 0.9
            else f'<movie id="i{self.ids}" {AT} src="m.webm" done="{self.rng.choice("abc")}"/>'
        )
        touched = self.maybe(0.3, f' touched="{self.rng.choice("abc")}"')
        return f"<screen{touched}><components>{one}</components></screen>"

    def file(self, parts: tuple[str, ...]) -> str:
        rng = self.rng
        count = rng.choice((2, 2, 3))
        text = ""
        if rng.random() < 0.6:
            text += "<always>" + self.maybe(0.3, self.timeout(count)) + self.maybe(
                0.4, self.screen()
            ) + self.events(count, 2) + "</always>"  # fmt: skip
        for no in range(1, count + 1):
            more = self.maybe(0.15, ' always="false"')
            if parts and rng.random() < 0.45:
                inside = f'<flow src="{rng.choice(parts)}.rbd.xml"/>'
            else:
                actions = self.maybe(0.5, self.visible()) + self.maybe(0.3, self.quick())
                actions += self.maybe(0.2, self.visible())
                inside = self.maybe(0.3, self.timeout(count)) + self.maybe(0.4, self.screen())
                inside += f"<backgroundactions>{actions}</backgroundactions>" if actions else ""
            text += f'<state no="{no}"{more}>{inside}{self.events(count, 3)}</state>'
        return text

    def project(self) -> Project:
        q = self.file(())
        p = self.file(("q",))
        return project(self.file(("p", "q")), self.rng.random() < 0.4, p=p, q=q)

    def lines(self) -> list[dict[str, Any]]:
        rng, found, at = self.rng, [], 0.0
        for _ in range(rng.randrange(5, 25)):
            at += rng.choice((0, 0.25, 0.5, 1, 2))
            verb = rng.choice(
                (
                    {"event": rng.choice(NAMES[:4])},
                    {"event": rng.choice("abc")},
                    {"set": {rng.choice(TAGS): rng.randrange(3)}},
                    {"set": {"busy": rng.random() < 0.4}},
                    {"touch": True},
                    {"finish": {"action": rng.choice(("speech", "robot", "service", "movie"))}},
                    {"set": {"heard": {"text": "yes"}}},
                )
            )
            found.append({"at": at, **verb})
        return [*found, {"at": at + 5, "end": True}]


@settings(
    max_examples=120,
    deadline=None,
    suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow],
)
@given(st.integers(0, 2**32))
def test_flat_and_original_give_the_same_actions_at_the_same_times(seed: int) -> None:
    maker = Maker(random.Random(seed))
    made, lines = maker.project(), maker.lines()
    try:
        told(made, lines)
    except AssertionError as error:
        assume("livelock" not in str(error))
    try:
        flatten(made)
    except UsageError:
        assume(False)
    same(made, lines)
