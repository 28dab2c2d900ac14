"""What of an application is another than before, told as by a look at all of it."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document import drawing
from situ.document.aside import Aside
from situ.document.rbd import Always, Application, State
from situ_studio.canvas.projection import identified
from situ_studio.edits.exchanged import draws_the_same, exchanged


def test_it_is_told_what_stands_in_the_place_of_what() -> None:
    one, two, always = State("1"), State("2"), Always()
    before = Application("a", always=always, states=(one, two))
    named = replace(two, name="other")
    assert exchanged(before, before) == []
    assert exchanged(before, replace(before, states=(one, named))) == [(2, two, named)]
    other = Always()
    found = exchanged(before, replace(before, always=other))
    assert found == [(0, always, other)]
    assert found[0].new is other


def test_others_than_before_are_all_looked_at() -> None:
    one, two = State("1"), State("2")
    before = Application("a", states=(one, two))
    assert exchanged(None, before) is None
    assert exchanged(before, replace(before, states=(one,))) is None
    assert exchanged(before, replace(before, states=(two, one))) is None
    assert exchanged(before, replace(before, states=(one, State("3")))) is None
    assert exchanged(before, replace(before, always=Always())) is None


STATES = st.lists(
    st.builds(
        State,
        no=st.sampled_from("123"),
        name=st.sampled_from("ab"),
        aside=st.sampled_from((Aside(), Aside(before=("<!--x-->",)))),
    ),
    max_size=4,
)


@given(STATES, STATES, st.lists(st.booleans(), min_size=4, max_size=4))
def test_what_is_exchanged_is_what_is_not_the_very_same(
    some: list[State], others: list[State], kept: list[bool]
) -> None:
    before = Application("a", states=tuple(some))
    mixed = [a if keep else b for a, b, keep in zip(some, others, kept, strict=False)]
    now = Application("a", states=tuple(mixed))
    found = exchanged(before, now)
    old, new = [*identified(before)], [*identified(now)]
    if found is None:
        assert [uid for uid, _ in old] != [uid for uid, _ in new]
    else:
        assert [uid for uid, _ in old] == [uid for uid, _ in new]
        at = [i for i, (a, b) in enumerate(zip(old, new, strict=True)) if a[1] is not b[1]]
        assert [one.at for one in found] == at


def test_notes_are_read_again_where_one_came_went_or_is_another() -> None:
    note = drawing.Note(text="a")
    before = drawing.add(Application("a", states=(State("1"), State("2"))), note)
    named = replace(before, states=(State("1", name="other"), before.states[1]))
    assert draws_the_same(before, named)
    assert not draws_the_same(None, before)
    assert not draws_the_same(before, drawing.add(before, note))
    assert not draws_the_same(before, drawing.exchange(before, 0, drawing.Note(text="b")))
    above = State("1", aside=Aside(before=before.aside.inside))
    assert not draws_the_same(before, replace(before, states=(above, before.states[1])))
