"""The grammar of tags, names, patterns and references (formats.md, *Values, references*)."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from situ.document import names

WORDS = st.from_regex(r"[a-z][a-z0-9_-]{0,4}", fullmatch=True)
TAGS = st.lists(WORDS, min_size=1, max_size=5).map(".".join)


@pytest.mark.parametrize("tag", ["a", "user.name", "a-b.c_2", "robot/head", "module/m/head"])
def test_a_tag_is_dotted_words_or_a_path_under_a_reserved_root(tag: str) -> None:
    assert names.is_tag(tag)
    assert names.is_name(tag)
    assert names.is_pattern(tag)


@pytest.mark.parametrize(
    "text", ["", "A", "a.B", "a..b", ".a", "a.", "1a", "a.0", "a b", "a/b", "robot/", "robot//x"]
)
def test_anything_else_is_no_tag(text: str) -> None:
    assert not names.is_tag(text)


def test_none_is_longer_than_500_characters() -> None:
    longest = "a." * 249 + "ab"
    for is_one in (names.is_tag, names.is_name, names.is_pattern):
        assert is_one(longest)
        assert not is_one(longest + "c")
    assert names.references(f"{{{longest}}} {{{longest}c}}") == (longest,)


@pytest.mark.parametrize("name", ["patient.room", "patients.0.roomNumber", "service/Find.ok"])
def test_a_name_may_go_on_with_fields_and_places(name: str) -> None:
    assert names.is_name(name)


@pytest.mark.parametrize("text", ["", "Patient.room", "0.a", "a b", "a.", "a,b"])
def test_what_begins_with_no_tag_is_no_name(text: str) -> None:
    assert not names.is_name(text)


@pytest.mark.parametrize(
    ("pattern", "tag", "fits"),
    [
        ("user.name", "user.name", True),
        ("user.name", "user.names", False),
        ("face.*", "face.visible", True),
        ("face.*", "face", False),
        ("face.*", "face.a.b", False),
        ("*", "a", True),
        ("*", "a.b", False),
        ("user.**", "user", True),
        ("user.**", "user.name.first", True),
        ("user.**", "users", False),
        ("**", "robot/head", True),
        ("**.b", "b", True),
        ("**.b", "a.c.b", True),
        ("a.**.c", "a.c", True),
        ("a.**.c", "a.b.d", False),
        ("**.a.**.b", "x.a.y.a.b", True),
        ("robot/*", "robot/head", True),
        ("module/**", "module/m/head", True),
    ],
)
def test_a_star_is_one_word_and_two_are_any_number(pattern: str, tag: str, fits: bool) -> None:
    assert names.is_pattern(pattern)
    assert names.matches(pattern, tag) is fits


@pytest.mark.parametrize("text", ["a*", "***", "a.", "A.*", "*/a", "x/*"])
def test_a_star_stands_for_whole_words_only(text: str) -> None:
    assert not names.is_pattern(text)


@given(TAGS, st.data())
def test_replacing_words_by_stars_still_fits(tag: str, data: st.DataObject) -> None:
    words = tag.split(".")
    starred = [data.draw(st.sampled_from([word, "*", "**"])) for word in words]
    assert names.matches(".".join(starred), tag)
    assert names.matches(".".join([*starred, "**"]), tag)


@pytest.mark.parametrize(
    ("text", "pieces"),
    [
        ("", ()),
        ("Hello", (("Hello", None),)),
        ("Hello {user.name}!", (("Hello ", "user.name"), ("!", None))),
        ("{a}{b.0.C}", (("", "a"), ("", "b.0.C"))),
        ("{{a}}", (("{a}", None),)),
        ("{{{a}}}", (("{", "a"), ("}", None))),
        ("{} {A} {a b} {", (("{} {A} {a b} {", None),)),
        ('{"a": {b}}', (('{"a": ', "b"), ("}", None))),
    ],
)
def test_braces_that_hold_no_name_are_plain_text(
    text: str, pieces: tuple[tuple[str, str | None], ...]
) -> None:
    assert names.split(text) == pieces


@given(st.text(alphabet="{}ab. 0", max_size=12))
def test_every_text_is_a_template(text: str) -> None:
    pieces = names.split(text)
    assert all(literal or name for literal, name in pieces)
    assert names.references(text) == tuple(name for _, name in pieces if name)


@given(st.lists(st.text(alphabet="xyz {}", max_size=5) | TAGS.map(lambda t: (t,)), max_size=5))
def test_escaped_text_and_references_come_apart_again(parts: list[str | tuple[str]]) -> None:
    text = "".join(
        f"{{{part[0]}}}" if isinstance(part, tuple) else part.replace("{", "{{").replace("}", "}}")
        for part in parts
    )
    wanted = [part[0] for part in parts if isinstance(part, tuple)]
    assert list(names.references(text)) == wanted
    assert "".join(literal for literal, _ in names.split(text)) == "".join(
        part for part in parts if isinstance(part, str)
    )


@pytest.mark.parametrize(
    ("text", "name"),
    [(" {a.b}\n", "a.b"), ("{a}.", None), ("a", None), ("", None), ("{a}{b}", None)],
)
def test_a_text_may_be_exactly_one_reference(text: str, name: str | None) -> None:
    assert names.only_reference(text) == name


def test_the_names_in_a_template_are_changed_and_nothing_else() -> None:
    text = "{user} {{user}} {user.name} {no name} {}"
    assert names.with_references(text, lambda name: f"x.{name}") == (
        "{x.user} {{user}} {x.user.name} {no name} {}"
    )


@given(st.text())
def test_a_template_whose_names_stay_stays_as_it_is(text: str) -> None:
    assert names.with_references(text, lambda name: name) == text
