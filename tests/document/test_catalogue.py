"""``texts/LANG.po`` and ``situ.toml`` as values that are changed entry by entry."""

from __future__ import annotations

from collections.abc import Mapping

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document import beside, catalogue, folder, texts
from situ.document.beside import Toml
from situ.document.catalogue import Catalogue, Translation
from situ.document.join import join_texts
from situ.document.project import Project
from situ.document.texts_update import update
from situ.resources import example, examples

_WORDS = st.text(st.sampled_from('ab "\\\n\té字\u2028\u0085{}%#~'), min_size=1, max_size=8)
_TOKENS = st.text("abc-", min_size=1, max_size=5).map(lambda word: f"f{word}")


@st.composite
def _translations(draw: st.DrawFn) -> Translation:
    said = draw(st.just("") | _WORDS)
    return Translation(
        text=draw(_WORDS),
        said=said,
        flags=tuple(draw(st.lists(_TOKENS, max_size=2, unique=True))),
        obsolete=(obsolete := draw(st.booleans())),
        # What is obsolete has no text that stands there now.
        was=None if obsolete else draw(st.none() | _WORDS),
        context=draw(st.none() | _WORDS),
    )


@settings(max_examples=60)
@given(st.lists(_translations(), max_size=4, unique_by=lambda one: (one.text, one.context)))
def test_what_is_written_is_read_again(found: list[Translation]) -> None:
    # A file has what is obsolete at its end.
    ordered = sorted(found, key=lambda one: one.obsolete)
    value = replace(catalogue.empty("p", "ja"), translations=tuple(ordered))
    assert catalogue.read(catalogue.write(value), "ja.po") == (value, [])


@pytest.mark.parametrize("name", examples())
def test_the_texts_of_the_examples_are_written_as_they_are_read(name: str) -> None:
    for file in example(name).glob("texts/*.po"):
        value, _ = catalogue.read(file.read_bytes(), file.name)
        assert value is not None
        assert catalogue.write(value) == file.read_bytes()
        assert value.used == texts.read(file.read_bytes(), file.name)[0]


def test_nothing_of_a_file_of_other_programs_is_lost() -> None:
    data = (
        '# Made by hand\n#\nmsgid ""\nmsgstr ""\n"X-Team: us\\n"\n"Language: ja\\n"\n\n'
        "#  from the ward\n#. state 1: speech\n#: a.rbd.xml b.rbd.xml\n#, fuzzy, c-format\n"
        '#| msgid "Hullo"\nmsgctxt "greeting"\nmsgid "Hello"\nmsgstr "やあ"\n\n'
        'msgid "one"\nmsgid_plural "many"\nmsgstr[0] "一"\nmsgstr[1] "多"\n\n'
        '#~ msgid "Gone"\n#~ msgstr "消"\n'
    ).encode()
    value, problems = catalogue.read(data, "ja.po")
    assert problems == []
    assert value is not None
    assert catalogue.write(value) == data


def test_a_file_that_is_none_is_told_with_its_line() -> None:
    value, problems = catalogue.read(b'msgid "a"\nmsgst "b"\n', "ja.po")
    assert value is None
    assert [(p.code, p.line) for p in problems] == [("malformed-po", 2)]


def test_a_translation_that_leaves_out_a_reference_lacks_it() -> None:
    assert catalogue.lacks("Hello {user.name}, {n} left", "{n} のこり") == ("user.name",)
    assert catalogue.lacks("Hello {user.name}", "") == ()
    assert catalogue.lacks("{{name}} is plain", "x") == ()


def _of(*entries: Translation) -> Catalogue:
    return Catalogue(translations=entries)


def test_what_a_person_translates_is_sure() -> None:
    entry = Translation("a", "x", flags=("fuzzy", "c-format"), was="b", obsolete=True)
    assert catalogue.translated(entry, "y") == Translation("a", "y", flags=("c-format",))


def test_a_new_entry_stands_behind_the_text_before_it() -> None:
    value = _of(Translation("a"), Translation("c"), Translation("old", "x", obsolete=True))
    new = {text: Translation(text, "x") for text in ("first", "b", "b2", "other")}
    found = catalogue.with_entries(value, new, ["first", "a", "b", "b2", "c"])
    texts = [one.text for one in found.translations]
    assert texts == ["first", "a", "b", "b2", "c", "old", "other"]
    twice = catalogue.with_entries(value, new, ["first", "a", "b", "a", "b", "b2", "c"])
    assert twice == found
    again = catalogue.with_entries(found, {"b": Translation("b", "y")}, ["c", "b"])
    assert [one.text for one in again.translations] == texts
    assert again.used == found.used | {"b": "y"}


def test_a_reworded_text_keeps_its_translation_unsure() -> None:
    found = catalogue.reworded(_of(Translation("Helo", "やあ")), "Helo", "Hello", stays=False)
    (entry,) = found.translations
    assert (entry.text, entry.said, entry.was, entry.is_used) == ("Hello", "やあ", "Helo", False)
    back = catalogue.reworded(found, "Hello", "Helo", stays=False)
    assert back == _of(Translation("Helo", "やあ"))


def test_a_text_that_stays_elsewhere_keeps_its_own_entry() -> None:
    before = _of(Translation("Yes", "はい"), Translation("No", "いいえ"))
    found = catalogue.reworded(before, "Yes", "Yes!", stays=True)
    assert [(e.text, e.is_used) for e in found.translations] == [
        ("Yes", True),
        ("Yes!", False),
        ("No", True),
    ]


def test_a_text_that_is_translated_already_takes_that() -> None:
    before = _of(Translation("Yes", "はい"), Translation("Sure", "ええ", obsolete=True))
    found = catalogue.reworded(before, "Yes", "Sure", stays=False)
    assert found.used == {"Sure": "ええ"}
    # What was translated once is kept for another time.
    assert [e.text for e in found.translations if e.obsolete] == ["Yes"]


def test_two_people_who_translate_different_texts_are_joined() -> None:
    base = _of(Translation("a", "x"), Translation("b", "y"))
    mine = _of(Translation("a", "X"), Translation("b", "y"))
    theirs = _of(Translation("a", "x"), Translation("b", "Y"), Translation("c", "z"))
    both = join_texts(base, mine, theirs)
    assert both is not None
    assert both.used == {"a": "X", "b": "Y", "c": "z"}
    assert join_texts(base, mine, _of(Translation("a", "o"), Translation("b", "y"))) is None


def test_a_word_that_is_a_text_too_is_joined_apart_from_it() -> None:
    base = catalogue.with_readings(_of(Translation("Dr.", "医師")), {"Dr.": "Doctor"})
    mine = catalogue.with_readings(base, {"Dr.": "Doktor"})
    theirs = catalogue.with_entries(base, {"b": Translation("b", "y")})
    both = join_texts(base, mine, theirs)
    assert both is not None
    assert both.used == {"Dr.": "医師", "b": "y"}
    assert both.readings == {"Dr.": "Doktor"}


def test_a_project_is_what_its_files_say_it_is() -> None:
    root = example("reception")
    project, _ = folder.load(root)
    assert project is not None
    values = {}
    for file in beside.files(project):
        if (root / file).exists():
            value, problems = beside.read((root / file).read_bytes(), file)
            assert value is not None
            assert problems == []
            assert beside.write(value) == (root / file).read_bytes()
            values[file] = value
    assert beside.settled(project, values) == project


def test_a_robots_own_file_lies_over_the_projects() -> None:
    project, _ = folder.load_texts({"situ.toml": ""}, "ward")
    assert project is not None
    values: dict[str, beside.Beside] = {
        "situ.toml": Toml('[project]\nname = "p"\nmedia = "../away"\n[tags]\na = 1\nb = 2\n'),
        "robot.local.toml": Toml("[tags]\nb = 3\n"),
    }
    found = beside.settled(project, values)
    assert (found.name, found.tags, found.media) == ("p", {"a": 1, "b": 3}, None)
    local = values["robot.local.toml"]
    (change,) = beside.compare(project, "robot.local.toml", local, Toml("[tags]\nb = 4\n"))
    assert change.text == "tag at the start b 3 → 4"


def test_readings_translate_nothing_and_stay() -> None:
    value = _of(Translation("Dr.", "医師"), Translation("old", "x", obsolete=True))
    found = catalogue.with_readings(value, {"Dr.": "Doctor", "山田": "やまだ"})
    assert found.readings == {"Dr.": "Doctor", "山田": "やまだ"}
    assert (found.used, found.by_text()["Dr."].said) == ({"Dr.": "医師"}, "医師")
    read, problems = catalogue.read(catalogue.write(found), "ja.po")
    assert (read, problems) == (found, [])
    data = catalogue.write(found)
    assert texts.read(data, "ja.po") == ({"Dr.": "医師"}, found.readings, [])
    assert catalogue.with_readings(found, {}) == value


def test_readings_that_are_not_in_use_are_kept_until_somebody_says_them() -> None:
    unsure = Translation("St.", "Street", flags=("fuzzy",), context="reading")
    retired = Translation("Mt.", "Mount", obsolete=True, context="reading")
    found = catalogue.with_readings(_of(unsure, retired), {"Dr.": "Doctor"})
    assert {unsure, retired} < set(found.translations)
    assert found.readings == {"Dr.": "Doctor"}
    said = catalogue.with_readings(found, {"St.": "Saint"})
    assert [e.said for e in said.translations if e.text == "St."] == ["Saint"]
    assert said.readings == {"St.": "Saint"}


def test_situ_texts_leaves_readings_as_they_are() -> None:
    project, _ = folder.load(example("conversation"))
    assert project is not None
    before = catalogue.with_readings(catalogue.empty("c", "ja"), {"山田": "やまだ"})
    made, _ = update(project, "ja", catalogue.write(before), "ja.po")
    assert made is not None
    assert texts.read(made.data, "ja.po")[1] == {"山田": "やまだ"}
    again, _ = update(project, "ja", made.data, "ja.po")
    assert again is not None
    assert again.data == made.data


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Dr. Who, Dr.", "Doctor Who, Doctor"),
        ("XDr. and Dress", "XDr. and Dress"),
        ("A SPO2 and SPO", "A oxygen and S P O"),
        ("山田さん", "やまださん"),
        ("nothing", "nothing"),
    ],
)
def test_a_voice_says_whole_words_as_their_readings_say(text: str, said: str) -> None:
    words = {"Dr.": "Doctor", "SPO": "S P O", "SPO2": "oxygen", "山田": "やまだ"}
    assert texts.read_out(text, words, "en") == said
    assert texts.read_out(text, {}, "en") == text


def test_another_reading_is_told_as_a_change() -> None:
    project, _ = folder.load_texts({"situ.toml": '[project]\nlanguages = ["en"]\n'}, "ward")
    assert project is not None
    before = catalogue.empty("ward", "en")
    after = catalogue.with_readings(before, {"Dr.": "Doctor"})
    (change,) = beside.compare(project, "texts/en.po", before, after)
    assert change.text == "in en, “Dr.” is said as written → “Doctor”"


def test_of_several_entries_of_a_text_the_one_in_use_counts() -> None:
    found = _of(
        Translation("Yes", "ええ", obsolete=True),
        Translation("Yes", "はい"),
        Translation("Yes", "うん", obsolete=True),
    )
    assert found.by_text() == {"Yes": Translation("Yes", "はい")}
    assert found.entry("Yes") == Translation("Yes", "はい")


def test_a_reworded_text_without_a_translation_is_the_new_text() -> None:
    found = catalogue.reworded(_of(Translation("Helo")), "Helo", "Hello", stays=False)
    assert found == _of(Translation("Hello"))


@pytest.mark.parametrize("before", [_of(), _of(Translation("Helo", "やあ", obsolete=True))])
def test_rewording_what_is_not_in_use_changes_nothing(before: Catalogue) -> None:
    assert catalogue.reworded(before, "Helo", "Hello", stays=False) is before


@pytest.mark.parametrize("stays", [True, False])
def test_a_text_that_becomes_one_that_is_there_leaves_no_second_entry(stays: bool) -> None:
    before = _of(Translation("Helo"), Translation("Hello", "やあ"))
    found = catalogue.reworded(before, "Helo", "Hello", stays=stays)
    assert found.used == {"Hello": "やあ"}
    assert [e.text for e in found.translations] == (["Helo", "Hello"] if stays else ["Hello"])


def test_a_single_document_has_no_files_beside_it() -> None:
    alone, _ = folder.load_texts({"a.rbd.xml": '<application name="a" start="1"/>'}, "ward")
    assert alone is not None
    assert beside.files(alone) == []
    assert [beside.is_beside(file) for file in ("situ.toml", "texts/ja.po", "a.rbd.xml")] == [
        True,
        True,
        False,
    ]


def test_a_project_file_that_can_not_be_read_says_why() -> None:
    value, problems = beside.read(b"[project", "situ.toml")
    assert value is None
    assert [p.code for p in problems] == ["malformed-toml"]


def test_what_is_wrong_in_a_file_by_itself_is_told() -> None:
    project, _ = folder.load_texts({"situ.toml": ""}, "ward")
    assert project is not None
    wrong = Toml('[project]\nnaem = "p"\napplications = ["b.rbd.xml", "a.rbd.xml"]\n')
    found = beside.problems(project, "situ.toml", wrong)
    assert [p.code for p in found] == ["unknown-key", "missing-file", "missing-file"]
    assert beside.problems(project, "texts/ja.po", _of()) == []
    assert beside.applications(wrong) == ["b.rbd.xml", "a.rbd.xml"]


def _ward(*applications: str) -> Project:
    """A project of these; ``a`` calls ``b``, which calls ``c``."""
    state = '<state no="1" final="true">{}</state>'
    calls = {"a": '<flow src="b.rbd.xml"/>', "b": '<flow src="c.rbd.xml"/>', "c": ""}
    files = {
        f"{name}.rbd.xml": f'<application name="{name}">{state.format(call)}</application>'
        for name, call in calls.items()
    }
    project, _ = folder.load_texts({"situ.toml": _naming(*applications).text, **files}, "ward")
    assert project is not None
    return project


def _naming(*applications: str) -> Toml:
    files = ", ".join(f'"{name}.rbd.xml"' for name in applications)
    return Toml(f'[project]\nname = "p"\napplications = [{files}]\n')


def _named(files: Mapping[str, object]) -> str:
    return "".join(file.partition(".")[0] for file in files)


def test_an_application_that_stands_twice_is_told_and_one_that_is_there_is_not() -> None:
    found = beside.problems(_ward("a"), "situ.toml", _naming("a", "a"))
    assert [(p.code, p.line) for p in found] == [("duplicate-file", 3)]


@pytest.mark.parametrize(
    ("before", "named", "applications", "parts", "gone"),
    [
        ("abc", "cab", "cab", "", ""),  # in the order of the file
        ("abc", "ab", "ab", "c", ""),  # c is called by b
        ("abc", "a", "a", "bc", ""),  # and what a part calls stays too
        ("ac", "a", "a", "bc", ""),  # where it was a part before as well
        ("abc", "c", "c", "", "ab"),  # nobody calls a and b
        ("abc", "ax", "a", "bc", ""),  # x is not there
    ],
)
def test_what_is_named_no_more_stays_where_a_flow_leads_to_it(
    before: str, named: str, applications: str, parts: str, gone: str
) -> None:
    project, left = beside.grouped(_ward(*before), _naming(*named), {})
    found = (_named(project.applications), _named(project.parts), _named(left))
    assert found == (applications, parts, gone)


def test_what_is_named_again_is_what_it_was() -> None:
    ward = _ward("a", "b", "c")
    without, gone = beside.grouped(ward, _naming("c"), {})
    assert beside.grouped(without, _naming("a", "b", "c"), gone) == (ward, {})


def test_a_part_that_is_named_becomes_an_application() -> None:
    project, gone = beside.grouped(_ward("a"), _naming("a", "b"), {})
    assert (_named(project.applications), _named(project.parts), gone) == ("ab", "c", {})


def test_what_changes_nothing_of_the_robot_is_told_as_such() -> None:
    text = '[project]\nlanguages = ["en", "ja"]\n'
    project, _ = folder.load_texts({"situ.toml": text}, "ward")
    assert project is not None
    (change,) = beside.compare(project, "situ.toml", Toml(text), Toml("# why\n" + text))
    assert (change.text, change.behaviour) == ("comments or layout", False)
    noted = _of(Translation("Yes", "はい", note="to a guest"))
    (change,) = beside.compare(project, "texts/ja.po", _of(Translation("Yes", "はい")), noted)
    assert change.text == "notes, or what is not used"


def test_readings_that_stay_are_no_change() -> None:
    project, _ = folder.load_texts({"situ.toml": '[project]\nlanguages = ["en"]\n'}, "ward")
    assert project is not None
    before = catalogue.with_readings(catalogue.empty("ward", "en"), {"Dr.": "Doctor"})
    after = catalogue.with_readings(before, {"Dr.": "Doctor", "St.": "Street"})
    (change,) = beside.compare(project, "texts/en.po", before, after)
    assert "St." in change.text


def test_a_project_is_read_with_its_readings() -> None:
    data = catalogue.write(
        catalogue.with_readings(catalogue.empty("ward", "en"), {"Dr.": "Doctor"})
    )
    files = {"situ.toml": '[project]\nlanguages = ["en"]\n', "texts/en.po": data.decode()}
    project, _ = folder.load_texts(files, "ward")
    assert project is not None
    assert project.readings == {"en": {"Dr.": "Doctor"}}
