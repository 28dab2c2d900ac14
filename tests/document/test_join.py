"""What two people changed in one document is joined where they do not collide."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.document import codec
from situ.document.join import join

SEEDS = st.integers(0, 10**9)
TEXT = """<application name="a" start="1">
  <state no="1" name="one" ed:x="10" ed:y="10" xmlns:ed="urn:situ:editor">
    <timeout next="2">30</timeout>
    <expectedevents><event name="go" next="2"/></expectedevents>
  </state>
  <state no="2" name="two"/>
  <state no="3" name="three"/>
</application>"""
SCRIPT = """<spds name="s">
  <modules><module name="m" resources="speech"/></modules>
  <situation name="one"><condition><data tag="t" is="true"/></condition></situation>
</spds>"""


def read(text: str) -> Any:
    document, problems = codec.read(text.encode(), "a.xml")
    assert document is not None, problems
    return document


def joined(mine: tuple[str, str], theirs: tuple[str, str], text: str = TEXT) -> str | None:
    """The text after each replaced something in it; None where they collide."""
    assert mine[0] in text
    assert theirs[0] in text
    found = join(read(text), read(text.replace(*mine)), read(text.replace(*theirs)))
    return None if found is None else codec.write(found).decode()


@given(seed=SEEDS, other=SEEDS)
@settings(max_examples=25, deadline=None)
def test_where_one_changed_nothing_the_other_s_is_the_result(
    make_document: Callable[[int], Any], seed: int, other: int
) -> None:
    base = read(codec.write(make_document(seed)).decode())
    changed = read(codec.write(make_document(other)).decode())
    if type(base) is not type(changed):
        return
    again = read(codec.write(base).decode())
    for found in (join(base, changed, again), join(base, again, changed)):
        assert found is not None
        assert codec.write(found) == codec.write(changed)


@pytest.mark.parametrize(
    ("mine", "theirs"),
    [
        (('name="one"', 'name="first"'), ('name="two"', 'name="second"')),
        (('name="one"', 'name="first"'), (">30<", ">60<")),
        (('name="one"', 'name="first"'), ('<event name="go" next="2"/>', '<event name="go"/>')),
        (('<state no="3" name="three"/>', ""), ('name="one"', 'name="first"')),
        (
            ('<state no="2" name="two"/>', '<state no="2" name="two"/><state no="4"/>'),
            ('<state no="3" name="three"/>', '<state no="3" name="three"/><state no="5"/>'),
        ),
        (('ed:x="10"', 'ed:x="90"'), (">30<", ">60<")),
        (
            ('<event name="go" next="2"/>', '<event name="go" next="2"/><event name="no"/>'),
            ('name="go" next="2"', 'name="go" next="3"'),
        ),
    ],
)
def test_changes_of_different_things_are_both_kept(
    mine: tuple[str, str], theirs: tuple[str, str]
) -> None:
    expected = codec.write(read(TEXT.replace(*mine).replace(*theirs))).decode()
    assert joined(mine, theirs) == expected
    assert joined(theirs, mine) == expected


@pytest.mark.parametrize(
    ("mine", "theirs"),
    [
        (('name="one"', 'name="first"'), ('name="one"', 'name="start"')),
        ((">30<", ">60<"), (">30<", ">90<")),
        (('<state no="2" name="two"/>', ""), ('name="two"', 'name="second"')),
        (
            (
                '<state no="3" name="three"/>',
                '<state no="3" name="three"/><state no="4" name="x"/>',
            ),
            (
                '<state no="3" name="three"/>',
                '<state no="3" name="three"/><state no="4" name="y"/>',
            ),
        ),
    ],
)
def test_changes_of_the_same_thing_collide(mine: tuple[str, str], theirs: tuple[str, str]) -> None:
    assert joined(mine, theirs) is None
    assert joined(theirs, mine) is None


def test_the_same_change_of_both_is_no_collision() -> None:
    change = ('name="one"', 'name="first"')
    assert joined(change, change) == codec.write(read(TEXT.replace(*change))).decode()


def test_a_card_that_both_moved_stands_where_mine_is() -> None:
    found = joined(('ed:x="10"', 'ed:x="90"'), ('ed:x="10"', 'ed:x="50"'))
    assert found is not None
    assert 'ed:x="90"' in found


def test_comments_of_both_are_kept() -> None:
    mine, theirs = ('<state no="2"', '<!-- mine --><state no="2"'), ('name="three"', 'name="3rd"')
    found = joined(mine, theirs)
    assert found is not None
    assert "<!-- mine -->" in found
    assert 'name="3rd"' in found


def test_two_new_situations_at_one_place_collide_for_nobody_said_which_goes_first() -> None:
    new = '<situation name="{}"/>'
    mine, theirs = (("</spds>", new.format(name) + "</spds>") for name in "xy")
    assert joined(mine, theirs, SCRIPT) is None
    theirs = ("</modules>", "</modules>" + new.format("y"))
    found = joined(mine, theirs, SCRIPT)
    assert found is not None
    assert found.index('"y"') < found.index('"one"') < found.index('"x"')


SPOKEN = """<application name="a">
  <state no="1" name="one" xmlns:ed="urn:situ:editor" ed:x="10" ed:y="10" ed:accept="dead-end">
    <backgroundactions><speech>Hello</speech><speech>Bye</speech></backgroundactions>
  </state>
  <state no="2"/>
  <state no="3"/>
</application>"""
ONE, TWO, THREE = '<state no="1"', '<state no="2"/>', '<state no="3"/>'


def test_members_without_names_are_joined_one_by_one_where_there_are_as_many() -> None:
    found = joined(("Hello", "Hi"), ("Bye", "See you"), SPOKEN)
    assert found is not None
    assert "Hi" in found
    assert "See you" in found


def test_members_without_names_collide_where_one_has_more_of_them() -> None:
    more = ("<speech>Bye</speech>", "<speech>Bye</speech><speech>Bye</speech>")
    assert joined(("Hello", "Hi"), more, SPOKEN) is None


def test_what_one_took_off_a_card_is_gone_though_the_other_moved_it() -> None:
    found = joined(('ed:x="10"', 'ed:x="90"'), (' ed:accept="dead-end"', ""), SPOKEN)
    assert found is not None
    assert 'ed:x="90"' in found
    assert "ed:accept" not in found


def test_what_both_took_away_is_gone() -> None:
    found = joined((TWO, ""), (TWO + "\n  " + THREE, ""), SPOKEN)
    assert found is not None
    assert TWO not in found
    assert THREE not in found


def test_one_puts_them_in_another_order_and_the_other_adds() -> None:
    turned = (TWO + "\n  " + THREE, THREE + TWO)
    added = (THREE, THREE + '<state no="4"/>')
    for mine, theirs in ((turned, added), (added, turned)):
        found = joined(mine, theirs, SPOKEN)
        assert found is not None
        assert found.index('no="3"') < found.index('no="4"') < found.index('no="2"')


def test_two_other_orders_collide() -> None:
    text = SPOKEN.replace(THREE, THREE + '<state no="4"/>')
    mine = (TWO + "\n  " + THREE, THREE + TWO)
    assert joined(mine, (THREE + '<state no="4"/>', '<state no="4"/>' + THREE), text) is None
