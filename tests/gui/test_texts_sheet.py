"""What typing into the table of texts makes of documents and translations, without a window."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec.structs import replace

from situ.document import beside, codec
from situ.document.beside import Beside
from situ.document.catalogue import Catalogue, Translation
from situ.document.project import Project, Setting
from situ.document.rbd import Application
from situ_studio.texts.sheet import Refused, Sheet, Typed, changed

DOCUMENT = b"""<application name="a"><state no="1"><screen><components>
<text id="t" x="1" y="1" width="9" height="9">Yes {n}</text>
<button id="b" x="1" y="30" width="9" height="9" event="go">Yes</button>
<list id="l" x="1" y="50" width="9" height="9" items="i" label="{item}" tag="c"/>
</components></screen><backgroundactions><speech>Yes</speech><speech lang="ja">x</speech>
</backgroundactions><expectedevents><event name="go" next="1"><say>Yes</say></event>
</expectedevents></state></application>"""
JA = Catalogue(translations=(Translation("Yes", "1"), Translation("No", "2", obsolete=True)))


def _sheet() -> Sheet:
    application, problems = codec.read(DOCUMENT, "a")
    assert isinstance(application, Application)
    assert problems == []
    project = Project(
        root=".",
        name="a",
        toml="situ.toml",
        applications={"a": application},
        languages=("en", "ja"),
    )
    return Sheet(project, {"ja": JA})


def _after(sheet: Sheet, files: dict[str, object]) -> Sheet:
    """The table of the project with these files in place of the ones before."""
    flows = {f: one for f, one in files.items() if isinstance(one, Application)}
    catalogues = dict(sheet.catalogues)
    for file, one in files.items():
        language = beside.language_of(file)
        if language is not None and isinstance(one, Catalogue):
            catalogues[language] = one
    project = Project(
        root=".",
        name="a",
        toml="situ.toml",
        applications=sheet.project.applications | flows,
        languages=sheet.project.languages,
    )
    return Sheet(project, catalogues)


_STEPS = st.lists(
    st.tuples(st.integers(0, 4), st.booleans(), st.sampled_from(("Yes", "No", "Maybe {n}", "é "))),
    max_size=6,
)


@settings(max_examples=60)
@given(_STEPS)
def test_what_was_typed_stands_there_and_nothing_else_is_lost(
    steps: list[tuple[int, bool, str]],
) -> None:
    sheet = _sheet()
    for at, translate, text in steps:
        row = sheet.rows[at]
        if row.lang is not None:
            continue
        language = "ja" if translate else None
        sheet = _after(sheet, dict(changed(sheet, [Typed(row, language, text)])))
        cell = sheet.cell(sheet.rows[at], language)
        assert cell.text == text.strip()
        assert cell.standing in ("written", "done", "lacking")
        # Whatever was translated once is still in the file, used or not.
        said = {one.said for one in sheet.catalogues["ja"].translations}
        assert not translate or text.strip() in said
        read, problems = beside.read(beside.write(sheet.catalogues["ja"]), "texts/ja.po")
        assert problems == []
        assert isinstance(read, Catalogue)
        assert read.used == sheet.catalogues["ja"].used


def test_one_text_in_several_places_is_translated_once_and_leaves_with_one_of_them() -> None:
    sheet = _sheet()
    button, speech = (
        next(r for r in sheet.rows if r.kind == k and r.text == "Yes") for k in ("shown", "spoken")
    )
    assert sheet.places_of("Yes") == 3
    assert {sheet.cell(row, "ja").text for row in (button, speech)} == {"1"}
    after = _after(sheet, dict(changed(sheet, [Typed(button, None, "YES")])))
    other = next(r for r in after.rows if r.text == "YES")
    cell = after.cell(other, "ja")
    assert (cell.text, cell.standing, cell.was) == ("1", "unsure", "Yes")
    assert after.cell(speech, "ja").standing == "done"


def test_text_and_translation_pasted_together_belong_together() -> None:
    sheet = _sheet()
    button = next(r for r in sheet.rows if r.kind == "shown" and r.text == "Yes")
    typed = [Typed(button, None, "Sure"), Typed(button, "ja", "9")]
    after = _after(sheet, dict(changed(sheet, typed)))
    row = next(r for r in after.rows if r.text == "Sure")
    assert (after.cell(row, "ja").text, after.cell(row, "ja").standing) == ("9", "done")
    assert after.cell(next(r for r in after.rows if r.text == "Yes"), "ja").text == "1"


def test_what_an_old_text_was_said_as_comes_back_with_it() -> None:
    sheet = _sheet()
    rows = [r for r in sheet.rows if r.text == "Yes"]
    away = _after(sheet, dict(changed(sheet, [Typed(r, None, "No") for r in rows])))
    files: dict[str, Beside] = {"texts/ja.po": away.catalogues["ja"]}
    assert away.catalogues["ja"].used == {"No": "2"}
    assert b'#~ msgstr "1"' in beside.write(files["texts/ja.po"])
    back = _after(
        away, dict(changed(away, [Typed(r, None, "Yes") for r in away.rows if r.text == "No"]))
    )
    assert back.cell(next(r for r in back.rows if r.text == "Yes"), "ja").text == "1"


def test_a_text_that_becomes_several_at_once_takes_its_translation_to_each() -> None:
    sheet = _sheet()
    rows = [row for row in sheet.rows if row.text == "Yes"]
    assert len(rows) == 3
    words = ("Yes, please", "Yes, thanks", "Yes!")
    files = changed(sheet, [Typed(r, None, text) for r, text in zip(rows, words, strict=True)])
    after = _after(sheet, dict(files))
    for row in after.rows:
        if row.text in words:
            assert (after.cell(row, "ja").text, after.cell(row, "ja").standing) == ("1", "unsure")
    assert after.entry(rows[0], "ja") is None


def test_one_text_is_not_given_two_translations_in_one_paste() -> None:
    sheet = _sheet()
    first, second, _ = (row for row in sheet.rows if row.text == "Yes")
    with pytest.raises(Refused, match=r"Yes stands at several places .* A or B"):
        changed(sheet, [Typed(first, "ja", "A"), Typed(second, "ja", "B")])
    same = changed(sheet, [Typed(first, "ja", "A"), Typed(second, "ja", " A ")])
    assert _after(sheet, dict(same)).cell(second, "ja").text == "A"


def test_a_setting_is_not_changed_where_its_file_can_not_be_read() -> None:
    sheet = _sheet()
    asked = Sheet(replace(sheet.project, settings=(Setting("voice", "Voice"),)), {})
    row = asked.rows[-1]
    with pytest.raises(Refused, match=r"situ\.toml has errors"):
        changed(asked, [Typed(row, None, "Speech")])
