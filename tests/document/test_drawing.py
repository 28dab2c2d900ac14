"""Notes and frames: kept in the file, without a meaning to the robot (formats.md)."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document import codec
from situ.document.drawing import Drawn, Frame, Note, add, drawn, exchange, kept
from situ.document.export import without_editor
from situ.document.rbd import Application
from situ.resources import example

FILE = """<application name="a" xmlns:ed="urn:situ:editor">
  <ed:note x="1" y="2.5" width="80" height="40" color="#0a5a4c">one &amp; &lt;two&gt;</ed:note>
  <state no="1">
    <ed:note x="7">inside of a state</ed:note>
  </state>
  <!-- a comment -->
  <ed:frame title="Vital &quot;signs&quot;" x="-3" y="4"/>
  <state no="2"/>
  <ed:other x="1"/>
  <ed:note x="nonsense" y="nan"/>
</application>
"""


def read(text: str | bytes) -> Application:
    data = text.encode() if isinstance(text, str) else text
    document, problems = codec.read(data, "a.rbd.xml")
    assert not problems, problems
    assert isinstance(document, Application)
    return document


def test_notes_and_frames_are_read_wherever_they_stand_among_the_states() -> None:
    assert drawn(read(FILE)) == (
        Note(1, 2.5, 80, 40, "one & <two>", "#0a5a4c"),
        Frame(-3, 4, title='Vital "signs"'),
        Note(),
    )


def test_an_exchanged_one_stays_where_it_stood_in_the_file() -> None:
    before = read(FILE)
    after = exchange(before, 1, Frame(0, 8, 100, 50, "Vital", "#123456"))
    lines = codec.write(before).decode().splitlines()
    changed = codec.write(after).decode().splitlines()
    different = [new for old, new in zip(lines, changed, strict=True) if old != new]
    assert different == [
        '  <ed:frame title="Vital" color="#123456" x="0" y="8" width="100" height="50"/>'
    ]


@pytest.mark.parametrize("index", [0, 1, 2])
def test_one_taken_away_leaves_the_others_and_all_comments(index: int) -> None:
    before = read(FILE)
    after = exchange(before, index, None)
    kept = [one for at, one in enumerate(drawn(before)) if at != index]
    assert list(drawn(after)) == kept
    written = codec.write(after)
    assert b"a comment" in written
    assert b"ed:other" in written


text = st.text(st.characters(codec="utf-8", exclude_categories=("Cs", "Cc")) | st.just("\n"))
number = st.integers(-9000, 90000).map(lambda n: n / 10)
size = st.integers(8, 4000).map(float)
things = st.one_of(
    st.builds(
        Note, number, number, size, size, text.map(str.strip), st.sampled_from(["", "#0a5a4c"])
    ),
    st.builds(Frame, number, number, size, size, text, st.sampled_from(["", "#0a5a4c"])),
)


@settings(max_examples=40)
@given(st.lists(things, max_size=3))
def test_what_is_added_is_read_again_from_the_file(values: list[Drawn]) -> None:
    application = read('<application name="a"><state no="1"/></application>')
    for value in values:
        application = add(application, value)
    written = codec.write(application)
    again = read(written)
    assert list(drawn(again)) == values
    assert codec.write(again) == written


def test_they_are_no_difference_and_do_not_go_to_the_robot() -> None:
    application = read(FILE)
    more = add(application, Note(text="x"))
    assert more == application
    assert drawn(without_editor(more)) == ()


def test_the_example_has_a_frame_and_a_note() -> None:
    application = read((example("reception") / "reception.rbd.xml").read_bytes())
    titles = [one.title for one in drawn(application) if isinstance(one, Frame)]
    assert titles == ["Vital signs"]


def test_one_before_what_every_state_has_is_read_and_exchanged_there() -> None:
    before = read(
        '<application name="a" xmlns:ed="urn:situ:editor" xmlns:my="urn:mine">'
        '<ed:note x="1">one</ed:note><my:note/>'
        '<always><timeout next="1">3</timeout></always><state no="1"/></application>'
    )
    after = exchange(before, 0, Note(2, text="two"))
    assert (drawn(before), drawn(after)) == ((Note(1, text="one"),), (Note(2, text="two"),))
    written = codec.write(after)
    assert written.index(b"two") < written.index(b"<always")
    assert b"<my:note/>" in written


def test_what_can_not_be_read_draws_nothing_and_stays() -> None:
    before = read(FILE)
    broken = replace(before, aside=replace(before.aside, inside=("<ed:note>", "<ed:note/>")))
    assert drawn(broken)[-1:] == (Note(),)
    assert len(drawn(broken)) == len(drawn(before))


def test_what_stands_before_a_state_stays_when_that_goes() -> None:
    before = read(FILE)
    after = kept(before, "2")
    assert sorted(map(repr, drawn(after))) == sorted(map(repr, drawn(before)))
    assert drawn(replace(after, states=after.states[:1])) == drawn(after)
    assert b"a comment" in codec.write(after)
    assert kept(after, "2") is after
