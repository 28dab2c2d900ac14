"""What documents mention, and renaming it: no Qt."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document import codec, folder, rbd, spds
from situ.document.aside import Aside
from situ.document.condition import Condition
from situ.document.condition import Test as Asked
from situ.document.project import Project
from situ.resources import example
from situ_studio.edits import mentions, places, renames
from situ_studio.edits.mentions import Found, Index
from situ_studio.edits.notes import comments_on


@dataclass
class It:
    project: Project
    every: list[Found]


def project(*states: rbd.State, script: spds.Spds | None = None) -> It:
    application = rbd.Application(name="a", states=states)
    made = Project(
        root="/p",
        name="p",
        applications={"a.rbd.xml": application},
        spds=script,
        spds_file="s.spds.xml" if script is not None else None,
    )
    return It(made, list(Index().every(made)))


def reception() -> It:
    made, _ = folder.load(example("reception"))
    assert made is not None
    return It(made, list(Index().every(made)))


def test_every_place_that_is_mentioned_is_there() -> None:
    it = reception()
    documents = mentions.documents(it.project)
    assert len(it.every) > 300
    for found in it.every:
        value = places.get(documents[found.file], found.mention.place)
        if found.mention.attribute == mentions.NOTE:
            assert found.mention.text == comments_on(value)
            continue
        written = getattr(value, found.mention.attribute)
        assert found.mention.text == (" ".join(written) if isinstance(written, tuple) else written)


def test_the_index_is_the_same_after_an_edit_as_anew() -> None:
    it = reception()
    index = Index()
    list(index.every(it.project))
    file, before = next(iter(it.project.applications.items()))
    after = places.change(before, ("state", "2"), name="elsewhere")
    assert isinstance(after, rbd.Application)
    changed = replace(it.project, applications={file: after})
    assert list(index.every(changed)) == list(Index().every(changed))


def test_a_tag_is_renamed_with_its_fields_and_in_every_text() -> None:
    when = Condition((Asked("user.room", "is", "{user.bed}"),))
    it = project(
        rbd.State(
            no="1",
            actions=(
                rbd.Set(tag="user", text="{found}"),
                rbd.Speech(text="Hello {user.name}, not {username} {{user}}"),
            ),
            events=(rbd.Event(name="user", next="1", when=when),),
        )
    )
    done = renames.rename(it.project, it.every, "tag", "user", "guest")
    after = done.changed["a.rbd.xml"]
    assert isinstance(after, rbd.Application)
    state: Any = after.states[0]
    assert state.actions[0].tag == "guest"
    assert state.actions[1].text == "Hello {guest.name}, not {username} {{user}}"
    assert state.events[0].name == "user"
    assert state.events[0].when.children == (Asked("guest.room", "is", "{guest.bed}"),)
    assert done.count == 4


def test_a_longer_tag_that_begins_so_is_another_one() -> None:
    it = project(
        rbd.State(
            no="1",
            actions=(
                rbd.Set(tag="user", text="x"),
                rbd.Set(tag="user.name", text="y"),
                rbd.Speech(text="{user} {user.name.first} {user.room}"),
            ),
        )
    )
    done = renames.rename(it.project, it.every, "tag", "user", "guest")
    after = done.changed["a.rbd.xml"]
    assert isinstance(after, rbd.Application)
    actions: Any = after.states[0].actions
    assert actions[1].tag == "user.name"
    assert actions[2].text == "{guest} {user.name.first} {guest.room}"


def test_a_module_is_renamed_where_it_is_declared_asked_and_has_a_priority() -> None:
    script = spds.Spds(
        name="s",
        modules=(spds.Declaration(name="arm", resources=("arm",)),),
        situations=(spds.Situation(name="calm", entries=(spds.Entry("arm", 3),)),),
    )
    call = rbd.Service(name="x", url="board:arm/lift")
    it = project(rbd.State(no="1", actions=(call,)), script=script)
    done = renames.rename(it.project, it.every, "module", "arm", "lifter")
    after = done.changed["s.spds.xml"]
    assert isinstance(after, spds.Spds)
    assert after.modules == (spds.Declaration(name="lifter", resources=("arm",)),)
    assert after.situations[0].entries == (spds.Entry("lifter", 3),)
    application: Any = done.changed["a.rbd.xml"]
    assert application.states[0].actions[0].url == "board:lifter/lift"


def test_patterns_that_mean_the_tag_are_usages_and_stay() -> None:
    it = project(
        rbd.State(no="1", actions=(rbd.Set(tag="user.name", text="x"), rbd.Clear(tag="user.**")))
    )
    assert len(mentions.usages(it.every, "tag", "user.name")) == 2
    done = renames.rename(it.project, it.every, "tag", "user.name", "user.first")
    assert (done.count, done.left) == (1, 1)


def test_a_comment_that_reads_like_a_pattern_means_no_tag() -> None:
    clearing = rbd.Clear(tag="user.**", aside=Aside(before=("<!-- user.** -->",)))
    it = project(rbd.State(no="1", actions=(rbd.Set(tag="user.name", text="x"), clearing)))
    assert [f.mention.text for f in it.every].count("user.**") == 2
    assert len(mentions.usages(it.every, "tag", "user.name")) == 2
    assert renames.rename(it.project, it.every, "tag", "user.name", "user.first").left == 1


@pytest.mark.parametrize(
    ("role", "new", "said"),
    [
        ("tag", "Not a tag", "The tag is no tag"),
        ("module", "a/b", "The module cannot be"),
        ("event", " ", "The event is empty"),
        ("event", "go", "There is an event go already: choose another name."),
    ],
)
def test_a_new_name_that_means_nothing_or_is_taken_is_refused(
    role: mentions.Role, new: str, said: str
) -> None:
    it = project(rbd.State(no="1", events=(rbd.Event(name="go"), rbd.Event(name="stop"))))
    with pytest.raises(ValueError, match=said.split("(")[0]):
        renames.rename(it.project, it.every, role, "stop", new)


_ROLES: st.SearchStrategy[mentions.Role] = st.sampled_from(["event", "tag"])


@settings(max_examples=25, deadline=None)
@given(st.data())
def test_a_rename_and_its_opposite_leave_every_byte(data: st.DataObject) -> None:
    it = reception()
    role = data.draw(_ROLES)
    named = {n for f in it.every for r, n in f.mention.names if r == role}
    if role == "tag":
        named &= mentions.tags(it.every, it.project)
    old = data.draw(st.sampled_from(sorted(named)))
    done = renames.rename(it.project, it.every, role, old, "quite-new")
    assert done.changed
    documents = mentions.documents(it.project)
    project = replace(
        it.project,
        applications={f: done.changed.get(f, d) for f, d in it.project.applications.items()},
        parts={f: done.changed.get(f, d) for f, d in it.project.parts.items()},
        modules=done.changed.get(it.project.modules_file or "", it.project.modules),
    )
    every = list(Index().every(project))
    back = renames.rename(project, every, role, "quite-new", old)
    for file, document in back.changed.items():
        assert codec.write(document) == codec.write(documents[file])
    assert set(back.changed) == set(done.changed)
