"""``situ.toml`` changed value by value: everything else stays as it was written."""

from __future__ import annotations

import tomllib
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from situ.document import toml_writing as writing
from situ.document.beside import Toml

TEXT = """# Ours
[project]
name = "p"   # as on the door
applications = [
  "a.rbd.xml",  # first
  "b.rbd.xml",
]
languages = ["en", "ja"]

[tags]
"services.records" = "http://127.0.0.1" # at home
visits = 3

# Who may change what
[[setting]]
tag = "a.b"
label = "One" # shown
strange = 1
[[setting]]
tag = "c"

[mqtt]
in = { "a/+" = "event:x" }
"""


def lines(after: Toml) -> tuple[list[str], list[str]]:
    """The lines that went and those that came."""
    old, new = TEXT.splitlines(), after.text.splitlines()
    return [line for line in old if line not in new], [line for line in new if line not in old]


def test_one_value_is_one_line_and_its_comment_stays() -> None:
    after = writing.put(Toml(TEXT), "project", "name", "front desk")
    assert lines(after) == (
        ['name = "p"   # as on the door'],
        ['name = "front desk"   # as on the door'],
    )
    assert writing.put(after, "project", "name", "p") == Toml(TEXT)


def test_lists_keep_their_lines_and_comments() -> None:
    after = writing.put(
        Toml(TEXT), "project", "applications", ["a.rbd.xml", "b.rbd.xml", "c.rbd.xml"]
    )
    assert '  "a.rbd.xml",  # first\n' in after.text
    assert tomllib.loads(after.text)["project"]["applications"][2] == "c.rbd.xml"
    fewer = writing.put(Toml(TEXT), "project", "languages", ["ja"])
    assert 'languages = ["ja"]\n' in fewer.text
    turned = writing.put(Toml(TEXT), "project", "languages", ("ja", "en"))
    assert 'languages = ["ja", "en"]\n' in turned.text


def test_what_is_taken_out_is_gone_and_a_table_that_lacks_is_made() -> None:
    assert lines(writing.put(Toml(TEXT), "tags", "visits", None)) == (["visits = 3"], [])
    after = writing.put(Toml(TEXT), "durable", "tags", ["a.*"])
    assert after.text == TEXT + '\n[durable]\ntags = ["a.*"]\n'
    assert writing.put(Toml(""), "project", "name", "p") == Toml('[project]\nname = "p"\n')


def test_another_name_leaves_place_value_and_comment() -> None:
    after = writing.rename(Toml(TEXT), "tags", "services.records", "services.files")
    assert lines(after) == (
        ['"services.records" = "http://127.0.0.1" # at home'],
        ['"services.files" = "http://127.0.0.1" # at home'],
    )


def test_tables_in_a_line_are_changed_too() -> None:
    after = writing.put_in(Toml(TEXT), "mqtt", "in", "b/#", "tag:y")
    found = {"a/+": "event:x", "b/#": "tag:y"}
    assert tomllib.loads(after.text)["mqtt"]["in"] == found
    other = writing.rename_in(after, "mqtt", "in", "a/+", "c")
    assert list(tomllib.loads(other.text)["mqtt"]["in"]) == ["c", "b/#"]
    assert writing.put_in(after, "mqtt", "in", "b/#", None) == Toml(TEXT)
    first = writing.put_in(Toml(""), "mqtt", "in", "a", "event:x")
    assert tomllib.loads(first.text) == {"mqtt": {"in": {"a": "event:x"}}}


def test_settings_are_added_changed_and_removed() -> None:
    more = writing.add_setting(Toml(TEXT), {"tag": "d", "type": "time"})
    assert [one["tag"] for one in tomllib.loads(more.text)["setting"]] == ["a.b", "c", "d"]
    after = writing.put_setting(Toml(TEXT), 0, "label", "Two")
    assert lines(after) == (['label = "One" # shown'], ['label = "Two" # shown'])
    assert lines(writing.put_setting(after, 0, "label", None))[1] == []
    fewer = writing.remove_setting(Toml(TEXT), 1)
    assert [one["tag"] for one in tomllib.loads(fewer.text)["setting"]] == ["a.b"]
    assert "strange = 1" in fewer.text
    none = writing.remove_setting(fewer, 0)
    assert "setting" not in tomllib.loads(none.text)
    again = writing.add_setting(none, {"tag": "e"})
    assert tomllib.loads(again.text)["setting"] == [{"tag": "e"}]


def test_taking_out_what_is_not_there_leaves_the_file_as_it_is() -> None:
    assert writing.put_in(Toml(TEXT), "mqtt", "in", "b/#", None) == Toml(TEXT)
    assert writing.put_setting(Toml(TEXT), 1, "choices", None) == Toml(TEXT)


@pytest.mark.parametrize(
    ("text", "between"),
    [("", ""), ("a = 1\n", "\n"), ("a = 1\n\n", "")],
)
def test_one_empty_line_stands_before_the_first_setting_and_none_in_an_empty_file(
    text: str, between: str
) -> None:
    after = writing.add_setting(Toml(text), {"tag": "a"})
    assert after == Toml(f'{text}{between}[[setting]]\ntag = "a"\n')


_KEYS = st.sampled_from(("visits", "services.records", "new", "user.name", "x-y"))
_VALUES = st.one_of(
    st.booleans(),
    st.integers(-9, 9),
    st.text('aé"\\\n# ', max_size=5),
    st.lists(st.sampled_from(("a", "b #", '"')), max_size=2),
)


@settings(max_examples=20)
@given(st.lists(st.tuples(_KEYS, st.none() | _VALUES), max_size=5))
def test_the_file_says_what_was_put_and_keeps_every_comment(
    steps: list[tuple[str, Any]],
) -> None:
    toml, wanted = Toml(TEXT), dict(tomllib.loads(TEXT)["tags"])
    for key, value in steps:
        toml = writing.put(toml, "tags", key, value)
        if value is None:
            wanted.pop(key, None)
        else:
            wanted[key] = value
    found = tomllib.loads(toml.text)
    assert found.get("tags", {}) == wanted
    assert {k: v for k, v in found.items() if k != "tags"} == {
        k: v for k, v in tomllib.loads(TEXT).items() if k != "tags"
    }
    for comment in ("# Ours", "# as on the door", "# first", "# Who may change what", "# shown"):
        assert comment in toml.text


@pytest.mark.parametrize(
    ("text", "table", "key"),
    [
        ("tags = 3\n[robot]\nadapter = 'sim'\n", "tags", "a"),
        ("mqtt = []\n[robot]\nadapter = 'sim'\n", "mqtt", "url"),
        ("[tags]\na = 1\n[robot]\nadapter = 'sim'\n[tags.b]\nc = 1\n", "tags", "a"),
    ],
)
def test_a_value_is_put_and_taken_out_also_where_its_table_is_none_or_in_pieces(
    text: str, table: str, key: str
) -> None:
    put = writing.put(Toml(text), table, key, "x")
    found = tomllib.loads(put.text)
    assert (found[table][key], found["robot"]) == ("x", {"adapter": "sim"})
    out = tomllib.loads(writing.put(put, table, key, None).text)
    assert key not in out.get(table, {})


def test_what_stands_in_the_place_of_topics_or_settings_and_is_none_makes_room_for_them() -> None:
    for text in ("mqtt = 3\n", "[mqtt]\nin = 3\n"):
        put = writing.put_in(Toml(text), "mqtt", "in", "a/b", "event:x")
        assert tomllib.loads(put.text) == {"mqtt": {"in": {"a/b": "event:x"}}}
    added = writing.add_setting(Toml("setting = 3\n"), {"tag": "a"})
    assert tomllib.loads(added.text) == {"setting": [{"tag": "a"}]}


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("[tags]\na = 1 # one\n[robot]\nadapter = 'sim'\n[tags.b]\nc = 1\n", "a"),
        ("[tags]\na = 1 # one\n[robot]\nadapter = 'sim'\n[tags.b]\nc = 1\n", "b"),
        ("[tags.a]\nx = 1\n[robot]\nadapter = 'sim'\n[tags.b]\nc = 1 # one\n", "b"),
        ("[tags]\nb.x = 1\nb.y = 2\na = 3\n[robot]\nadapter = 'sim'\n", "b"),
        ("tags.a = 1 # one\ntags.b = 2\n[robot]\nadapter = 'sim'\n", "b"),
        ("tags = { a = 1, b = 2 } # one\n", "a"),
    ],
)
def test_another_name_is_given_also_in_a_table_in_pieces_or_of_dotted_keys(
    text: str, name: str
) -> None:
    before, after = tomllib.loads(text), writing.rename(Toml(text), "tags", name, "new")
    found = tomllib.loads(after.text)
    assert found == before | {
        "tags": {("new" if key == name else key): v for key, v in before["tags"].items()}
    }
    assert after.text.count("# one") == text.count("# one")


def test_a_topic_is_given_another_name_also_where_its_table_stands_apart_from_the_broker() -> None:
    text = """[mqtt]
url = "mqtt://x" # at home
[robot]
adapter = "sim"
[mqtt.in]
"a/b" = "event:x" # the door
"""
    after = writing.rename_in(Toml(text), "mqtt", "in", "a/b", "c/d")
    assert after == Toml(text.replace("a/b", "c/d"))


def test_a_table_itself_is_given_another_name_where_it_stands() -> None:
    text = "[project]\n[tgs] # ours\na = 1\n[robot]\nadapter = 'sim'\n"
    named = writing.rename_at(Toml(text), ("tgs",), "tags").text
    assert named.replace("\n\n", "\n") == text.replace("tgs", "tags")
    many = "[[settings]]\ntag = 'a'\n[robot]\n[[settings]]\ntag = 'b'\n"
    with_two = "[[settings]]\ntag = 'a'\n[[settings]]\ntag = 'b'\n"
    for one in (many, with_two):
        after = tomllib.loads(writing.rename_at(Toml(one), ("settings",), "setting").text)
        assert after["setting"] == [{"tag": "a"}, {"tag": "b"}]
