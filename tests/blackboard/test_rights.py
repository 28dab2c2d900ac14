"""Who may do what with which key (docs/security.md)."""

from __future__ import annotations

from typing import Any, get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ.blackboard import protocol
from situ.blackboard.identity import ROBOT, Identity, KeyRole
from situ.blackboard.protocol import AnyRequest, Hello, Request
from situ.blackboard.rights import ALLOWED, Rights
from situ.document.modules import Module, Modules, Provides
from situ.document.names import is_tag
from situ.document.project import Project

PROJECT = Project(
    root="/",
    name="lab",
    modules=Modules(
        modules=(
            Module(name="face", provides=(Provides(data="face.visible"),)),
            Module(name="nod", resources=("head",)),
        )
    ),
)
RIGHTS = Rights(PROJECT)

VIEWER = Identity("tablet", "viewer")
FACE = Identity("face", "module", ("gaze.*", "mood"))
ANN = Identity("ann", "operator")
ARM = Identity("arm", "service")
CORE = Identity(ROBOT, "service")

LOOKING = (
    "heartbeat",
    "get",
    "watch",
    "unwatch",
    "trace",
    "progress",
    "history",
    "documents",
    "expected",
    "modules",
    "bye",
)
CHANGING = {
    "set": "module operator service scenario",
    "publish": "module operator scenario",
    "use": "operator service scenario",
    "touch": "operator service scenario",
    "attend": "operator service scenario",
    "finish": "operator service scenario",
    "acquire": "module operator scenario",
    "abandon": "module operator scenario",
    "command": "module operator scenario",
    "serve": "module",
    "answer": "module",
    "disclose": "module",
    "perform": "service",
    "bundle": "service",
    "fetch": "service",
    **dict.fromkeys(("stage", "piece", "deploy", "rollback"), "operator"),
    **dict.fromkeys(("break", "unbreak", "pause", "resume", "step", "goto"), "operator"),
}
KINDS: dict[str, type[Request]] = {
    str(kind.__struct_config__.tag): kind for kind in get_args(AnyRequest)
}


@pytest.mark.parametrize("role", get_args(protocol.Role))
def test_each_role_may_ask_for_what_the_table_says_and_nothing_else(role: protocol.Role) -> None:
    wanted = {*LOOKING, *(do for do, roles in CHANGING.items() if role in roles.split())}
    assert {do for do, kind in KINDS.items() if kind in ALLOWED[role]} == wanted


def test_every_request_has_its_row() -> None:
    assert {*LOOKING, *CHANGING, "hello"} == set(KINDS)


def test_a_request_that_no_role_was_given_is_refused() -> None:
    class Reboot(Request, frozen=True, kw_only=True):
        pass

    for role in get_args(protocol.Role):
        why = RIGHTS.request(ANN, role, Reboot(id=1))
        assert why is not None
        assert "reboot" in why


@pytest.mark.parametrize(
    ("who", "said"),
    [
        (VIEWER, {"role": "viewer"}),
        (FACE, {"role": "module", "module": "face"}),
        (FACE, {"role": "viewer"}),
        (ANN, {"role": "operator"}),
        (ANN, {"role": "operator", "user": "ann"}),
        (ANN, {"role": "viewer"}),
        (ARM, {"role": "service"}),
        (CORE, {"role": "scenario"}),
    ],
)
def test_who_says_what_his_key_says_is_welcome(who: Identity, said: dict[str, Any]) -> None:
    assert RIGHTS.greeting(who, Hello(id=1, version=1, **said)) is None


@pytest.mark.parametrize(
    ("who", "said"),
    [
        (VIEWER, {"role": "operator"}),
        (VIEWER, {"role": "module", "module": "tablet"}),
        (FACE, {"role": "module", "module": "nod"}),
        (FACE, {"role": "module"}),
        (FACE, {"role": "operator", "user": "face"}),
        (ANN, {"role": "operator", "user": "bob"}),
        (ANN, {"role": "module", "module": "ann"}),
        (ANN, {"role": "service"}),
        (ANN, {"role": "scenario"}),
        (ARM, {"role": "operator"}),
        (ARM, {"role": "scenario"}),
        (CORE, {"role": "operator"}),
    ],
)
def test_who_says_more_than_his_key_is_refused(who: Identity, said: dict[str, Any]) -> None:
    why = RIGHTS.greeting(who, Hello(id=1, version=1, **said))
    assert why is not None
    assert who.name in why


@pytest.mark.parametrize(
    "tag", ["face.visible", "gaze.left", "mood", "module/face/head", "module/face/head/x"]
)
def test_a_module_sets_what_it_provides_and_what_its_key_says(tag: str) -> None:
    assert RIGHTS.writes(FACE, tag)


@pytest.mark.parametrize(
    "tag",
    [
        "face",
        "face.hidden",
        "gaze",
        "gaze.left.far",
        "mood.now",
        "situation",
        "listen",
        "clock.time",
        "robot/head",
        "module/nod/head",
        "module/faces/head",
        "application/desk",
        "service/records",
    ],
)
def test_a_module_sets_nothing_else(tag: str) -> None:
    assert not RIGHTS.writes(FACE, tag)


@pytest.mark.parametrize(
    "tag",
    ["robot/head", "module/nod/head", "application/desk", "situation", "listen", "clock.date"],
)
def test_not_even_every_pattern_reaches_what_the_runtime_keeps(tag: str) -> None:
    assert not RIGHTS.writes(Identity("any", "module", ("**",)), tag)


def test_one_tag_too_many_refuses_the_whole_write() -> None:
    request = protocol.Set(id=1, tags={"mood": 1, "user.name": "Ann"})
    why = RIGHTS.request(FACE, "module", request)
    assert why is not None
    assert "user.name" in why
    assert RIGHTS.request(FACE, "module", protocol.Set(id=1, tags={"mood": 1})) is None


def test_what_a_module_discloses_gives_it_no_rights() -> None:
    told = Hello(
        id=1,
        version=1,
        module="nod",
        provides=(protocol.Offer(data="user.name"),),
    )
    nod = Identity("nod", "module")
    assert RIGHTS.greeting(nod, told) is None
    assert not RIGHTS.writes(nod, "user.name")


_words = st.sampled_from(
    ["*", "**", "robot", "module", "face", "nod", "situation", "clock", "head"]
)
_patterns = st.lists(_words, min_size=1, max_size=4).map(".".join)
_kept = st.builds(
    lambda root, parts: "/".join((root, *parts)),
    st.sampled_from(["robot", "module", "application", "service"]),
    st.lists(st.sampled_from(["face", "nod", "head", "face head"]), min_size=1, max_size=3),
) | st.sampled_from(["situation", "listen", "clock.time", "clock.date", "clock.weekday"])


@given(st.lists(_patterns, max_size=5), _kept)
def test_whatever_a_key_may_write_what_is_kept_stays_out_of_reach(
    write: list[str], tag: str
) -> None:
    assert is_tag(tag)
    own = tag.startswith("module/face/")
    assert RIGHTS.writes(Identity("face", "module", tuple(write)), tag) == own


@pytest.mark.parametrize("role", get_args(KeyRole))
def test_as_a_viewer_nobody_writes(role: KeyRole) -> None:
    who = Identity("any", role, ("**",))
    assert RIGHTS.request(who, "viewer", protocol.Set(id=1, tags={"mood": 1})) is not None
