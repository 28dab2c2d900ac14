"""Reading and writing are inverse, canonical, and lose nothing (formats.md, first section)."""

from __future__ import annotations

import difflib
import gc
import itertools
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from lxml import etree
from msgspec import Struct
from msgspec.structs import fields, replace

from situ.document import check_values, codec, compiled
from situ.document.aside import Aside
from situ.document.check import structure
from situ.document.elements import ROOTS
from situ.document.project import Project
from situ.document.reader import MAX_ELEMENTS
from situ.document.schema import FILES
from situ.resources import resource

SEEDS = st.integers(0, 2**64)
MANY = settings(max_examples=150, deadline=None)


def read(data: bytes) -> Any:
    """The document in ``data``, which must have no problem."""
    document, problems = codec.read(data, "a.xml")
    assert problems == []
    return document


@given(seed=SEEDS)
@MANY
def test_what_is_written_reads_as_the_same_and_is_written_the_same(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document = make_document(seed)
    written = codec.write(document)
    again = read(written)
    assert again == document
    assert codec.write(again) == written
    assert sorted(_riding(again)) == sorted(_riding(document))


@given(seed=SEEDS)
@MANY
def test_what_is_written_is_valid_by_the_schema(
    make_document: Callable[[int], Any], seed: int
) -> None:
    document = make_document(seed)
    root = next(one for one in ROOTS if one.key is type(document))
    file = next(file for file, element in FILES.items() if element is root)
    schema = etree.RelaxNG(etree.parse(str(resource("schema", file))))
    tree = etree.fromstring(codec.write(document))
    assert schema.validate(tree), schema.error_log.last_error


@pytest.mark.parametrize("states", ["<state no='1'/>", "words", "<state no='1'>", "<x:y/>"])
def test_nothing_of_a_file_is_kept_once_it_is_read(
    rbd: Callable[[str], bytes], states: str
) -> None:
    data = rbd(states)
    gc.collect()
    gc.disable()
    try:
        codec.read(data, "a.xml")
        assert gc.collect() == 0
    finally:
        gc.enable()


def test_what_is_remembered_of_earlier_files_changes_nothing(
    monkeypatch: pytest.MonkeyPatch, rbd: Callable[[str], bytes]
) -> None:
    text = '<text {} id="t" width="5" y="7.25731" height="10" {}>a</text>'
    states = (
        f"<state no='x y'><screen><components>{text}</components></screen></state>"
        "<state no='final' final='true'/>"
    )

    def told(data: bytes) -> tuple[Any, list[str]]:
        application = read(data)
        whole = Project(root="nowhere", name="a", applications={"a.xml": application})
        return application, [problem.message for problem in structure(whole)]

    known = told(rbd(states.format('x="3.0625"', "")))
    assert len(known[1]) == 1
    assert told(rbd(states.format('x="3.0625"', ""))) == known
    for module, name in (
        (compiled, "_MOST_KNOWN"),
        (compiled, "_MOST_PLANS"),
        (check_values, "_MOST_JUDGED"),
    ):
        monkeypatch.setattr(module, name, 0)
    assert told(rbd(states.format("", 'x="3.0625"'))) == known
    other = rbd(states.replace("x y", "y x").format("", 'x="3.0626"'))
    first = told(other)
    assert first == told(other)
    assert first != known


def test_a_comment_may_hold_more_brackets_than_a_file_elements(
    rbd: Callable[[str], bytes],
) -> None:
    comment = f"<!--{'< ' * (MAX_ELEMENTS * 2)}-->"
    assert read(rbd(comment + "<state no='1'/>")).states[0].aside.before == (comment,)


def _riding(value: Any) -> Iterator[str]:
    """Every piece that rides along, wherever: fragments and attributes but declarations."""
    for one in _values(value):
        aside = one.aside
        asides = [aside, *(part for _, part in aside.parts)]
        for each in asides:
            yield from (*each.before, *each.inside, *each.after)
            yield from (f"{k}={v}" for k, v in each.attributes if "2000/xmlns" not in k)


def _values(value: Any) -> Iterator[Any]:
    if isinstance(value, tuple):
        for one in value:
            yield from _values(one)
    elif isinstance(value, Struct) and not isinstance(value, Aside):
        yield value
        for one in fields(value):
            yield from _values(getattr(value, one.name))


def test_saving_an_unchanged_document_changes_no_byte_after_the_first_save(example: bytes) -> None:
    document = read(example)
    first = codec.write(document)
    again = read(first)
    assert codec.write(again) == first
    assert again == document


def test_the_canonical_form_is_utf8_with_two_blanks_and_line_feeds(example: bytes) -> None:
    document = read(example.replace(b"\n", b"\r\n"))
    written = codec.write(document)
    assert written.startswith(b'<?xml version="1.0" encoding="UTF-8"?>\n<')
    assert written.endswith(b">\n")
    assert b"\r" not in written
    lines = written.decode().split("\n")
    assert all((len(line) - len(line.lstrip())) % 2 == 0 for line in lines)
    assert all(line == line.rstrip() for line in lines)


def test_each_edit_of_one_field_is_a_diff_of_one_line(example: bytes) -> None:
    document = read(example)
    before = codec.write(document).decode().splitlines()
    edits = 0
    for changed in _one_field_changed(document):
        after = codec.write(changed).decode().splitlines()
        diff = [line for line in difflib.ndiff(before, after) if line[0] in "+-"]
        assert [line[0] for line in diff] == ["-", "+"], diff
        edits += 1
    assert edits > 5


def _one_field_changed(value: Any) -> Iterator[Any]:
    """The value with one text, number or truth in it changed, for each of them."""
    for one in fields(value):
        held = getattr(value, one.name)
        if isinstance(held, Aside) or one.name in ("kind", "test", "align"):
            continue
        if isinstance(held, bool):
            yield replace(value, **{one.name: not held})
        elif isinstance(held, (int, float)):
            yield replace(value, **{one.name: held + 1.5 if isinstance(held, float) else held + 1})
        elif isinstance(held, str) and one.name != "type":
            yield replace(value, **{one.name: held + "x"})
        elif isinstance(held, Struct):
            for inner in _one_field_changed(held):
                yield replace(value, **{one.name: inner})
        elif isinstance(held, tuple):
            for index, member in enumerate(held):
                if isinstance(member, Struct):
                    for inner in _one_field_changed(member):
                        kept = (*held[:index], inner, *held[index + 1 :])
                        yield replace(value, **{one.name: kept})


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (10.0, "10"),
        (1.5, "1.5"),
        (-0.25, "-0.25"),
        (1e-7, "0.0000001"),
        (0.1, "0.1"),
        (1e21, "1" + "0" * 21),
    ],
)
def test_numbers_are_written_in_their_shortest_form(value: float, text: str) -> None:
    document = read(
        b'<application name="a"><state no="1"><timeout>7</timeout></state></application>'
    )
    state = document.states[0]
    changed = replace(
        document, states=(replace(state, timeout=replace(state.timeout, seconds=value)),)
    )
    assert f"<timeout>{text}</timeout>".encode() in codec.write(changed)


def canonical(text: str) -> str:
    written = codec.write(read(text.encode()))
    assert codec.write(read(written)) == written
    return written.decode()


def test_comments_and_instructions_stay_beside_their_element() -> None:
    written = canonical(
        """<!-- first --><?tool top?>
<application name="a"> <!-- before always --> <always/>
<!-- before 1 --><state no="1"><!-- before actions --><backgroundactions><!-- before say -->
<speech>a</speech><!-- behind say --></backgroundactions> <!-- in 1 --></state><!-- behind 1 -->
</application><!-- last -->"""
    )
    assert written == (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        "<!-- first -->\n"
        "<?tool top?>\n"
        '<application name="a">\n'
        "  <!-- before always -->\n"
        "  <always/>\n"
        "  <!-- before 1 -->\n"
        '  <state no="1">\n'
        "    <!-- before actions -->\n"
        "    <backgroundactions>\n"
        "      <!-- before say -->\n"
        "      <speech>a</speech>\n"
        "      <!-- behind say -->\n"
        "    </backgroundactions>\n"
        "    <!-- in 1 -->\n"
        "  </state>\n"
        "  <!-- behind 1 -->\n"
        "</application>\n"
        "<!-- last -->\n"
    )


def test_a_comment_moves_with_the_element_that_it_stands_before() -> None:
    data = (
        b'<application name="a"><!-- one --><state no="1"/><!-- two --><state no="2"/>'
        b"</application>"
    )
    document = read(data)
    turned = codec.write(replace(document, states=document.states[::-1])).decode()
    assert turned.index("<!-- two -->") < turned.index('no="2"') < turned.index("<!-- one -->")


def test_a_comment_inside_a_text_survives_and_the_text_stays_whole() -> None:
    data = (
        b'<application name="a"><state no="1"><backgroundactions><speech>Hello <!-- x -->there'
        b"</speech></backgroundactions></state></application>"
    )
    document = read(data)
    assert document.states[0].actions[0].text == "Hello there"
    assert "<speech>Hello there<!-- x --></speech>" in canonical(data.decode())


def test_foreign_namespaces_survive_with_their_prefixes() -> None:
    written = canonical(
        """<application name="a" xmlns:ed="urn:situ:editor" xmlns:my="urn:mine" ed:zoom="0.5">
<state no="1" my:owner="Ann" ed:x="10" ed:y="20"><ed:note x="1">a &lt; b</ed:note>
<my:thing><my:inner ed:seen="1"/><plain/></my:thing></state>
<state no="2"><b:c xmlns:b="urn:deep" b:d="1"/><alone xmlns="urn:alone"/></state></application>"""
    )
    assert '<application name="a" xmlns:ed="urn:situ:editor" xmlns:my="urn:mine"' in written
    assert ' ed:zoom="0.5">' in written
    assert '<state no="1" my:owner="Ann" ed:x="10" ed:y="20">' in written
    assert '    <ed:note x="1">a &lt; b</ed:note>\n' in written
    assert '    <my:thing><my:inner ed:seen="1"/><plain/></my:thing>\n' in written
    assert 'b:d="1"/>' in written
    assert '<alone xmlns="urn:alone"/>' in written
    etree.fromstring(written.encode())


def test_more_different_values_than_are_remembered_are_read_and_judged_all_the_same() -> None:
    names = ("id", "x", "y", "width", "height", "size")
    orders = list(itertools.islice(itertools.permutations(names), 300))
    rows = []
    for number in range(5000):
        given = dict.fromkeys(names, str(number / 8)) | {"id": f"t{number}"}
        order = orders[number % len(orders)]
        rows.append("<text " + " ".join(f'{name}="{given[name]}"' for name in order) + "/>")
    source = (
        '<application name="a"><state no="1" final="true"><screen><components>'
        + "\n".join(rows)
        + "</components></screen></state></application>"
    )
    document = read(source.encode())
    components = document.states[0].screen.components
    assert [one.x for one in components] == [number / 8 for number in range(5000)]
    files = {"a.rbd.xml": replace(document, name="a")}
    assert structure(Project(root="nowhere", name="a", applications=files)) == []
    wrong = replace(components[-1], width=-1.0)
    screen = replace(document.states[0].screen, components=(*components[:-1], wrong))
    states = (replace(document.states[0], screen=screen),)
    files = {"a.rbd.xml": replace(document, states=states)}
    (problem,) = structure(Project(root="nowhere", name="a", applications=files))
    assert problem.place == ("state", "1", "screen", "t4999")


def test_what_stands_in_foreign_elements_stays_in_them() -> None:
    written = canonical(
        '<application name="a" xmlns:my="urn:mine"><state no="1" xml:lang="en">'
        "<my:thing><!-- a --><?b c?></my:thing></state></application>"
    )
    assert "<my:thing><!-- a --><?b c?></my:thing>" in written
    assert '<state no="1" xml:lang="en">' in written


def test_a_namespace_may_hold_a_brace() -> None:
    written = canonical(
        '<application name="a" xmlns:my="urn:{mine}"><state no="1" my:owner="Ann"/></application>'
    )
    assert 'xmlns:my="urn:{mine}"' in written
    assert '<state no="1" my:owner="Ann"/>' in written


def test_a_state_copied_into_another_document_keeps_its_namespaces_bound() -> None:
    source = read(
        b'<application name="a" xmlns:my="urn:mine"><state no="1" my:a="1"><my:b/></state>'
        b"</application>"
    )
    target = read(b'<application name="b" xmlns:my="urn:other" my:c="2"/>')
    written = codec.write(replace(target, states=source.states))
    tree = etree.fromstring(written)
    assert tree[0].attrib["{urn:mine}a"] == "1"
    assert tree[0][0].tag == "{urn:mine}b"
    assert tree.attrib["{urn:other}c"] == "2"


def test_the_editor_may_write_its_own_elements_without_declaring_the_prefix() -> None:
    document = read(b'<application name="a"><state no="1"/></application>')
    state = replace(
        document.states[0], aside=Aside(before=('<ed:frame title="x"/>',)).at(10.04, -3)
    )
    tree = etree.fromstring(codec.write(replace(document, states=(state,))))
    assert [child.tag for child in tree] == ["{urn:situ:editor}frame", "state"]
    assert tree[1].attrib["{urn:situ:editor}x"] == "10"


def test_children_in_another_order_are_read_and_written_in_theirs() -> None:
    written = canonical(
        '<application name="a"><state no="1"><expectedevents/><backgroundactions><sound src="a"/>'
        "</backgroundactions><timeout>5</timeout></state><always/></application>"
    )
    assert written.index("<always/>") < written.index("<state")
    assert written.index("<timeout>") < written.index("<backgroundactions>")
    assert "expectedevents" not in written


def test_text_keeps_what_stands_in_it_but_white_space_at_its_ends() -> None:
    data = (
        '<application name="a"><state no="1"><backgroundactions><speech>\n  a\n  b\u00a0 </speech>'
        "</backgroundactions></state></application>"
    )
    document = read(data.encode())
    assert document.states[0].actions[0].text == "a\n  b\u00a0"


def test_json_in_an_attribute_is_written_with_single_quotes() -> None:
    assert """in='["arrived", "failed"]'""" in canonical(
        '<spds name="a"><situation name="s"><condition>'
        '<data tag="a" in=\'[&quot;arrived&quot;, "failed"]\'/></condition></situation></spds>'
    )


def test_characters_that_xml_cannot_hold_are_replaced() -> None:
    document = read(b'<application name="a"/>')
    again = read(codec.write(replace(document, name="a\0b\ud800")))
    assert again.name == "a\ufffdb\ufffd"


def test_what_is_no_document_is_not_written() -> None:
    with pytest.raises(TypeError, match="not a document: State"):
        codec.write(read(b'<application name="a"><state no="1"/></application>').states[0])


def test_an_element_is_found_by_its_place_in_the_file() -> None:
    data = (
        '<application name="ä">\n <state no="1"/><ed:x xmlns:ed="u"><ed:y/></ed:x>\n'
        '  <state no="2"/></application>'
    ).encode()
    document = read(data)
    assert codec.locate(data, document.aside.index) == (1, 1)
    assert codec.locate(data, document.states[0].aside.index) == (2, 2)
    assert codec.locate(data, document.states[1].aside.index) == (3, 3)
    assert codec.locate(data, 99) == (0, 0)
