"""The RELAX NG schemas: as shipped, as made from the table, and as strict as formats.md."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest
from lxml import etree

from situ.document import codec
from situ.document import schema as making
from situ.document.schema import FILES, schema
from situ.resources import examples, resource


def valid(file: str, data: bytes) -> bool:
    rules = etree.RelaxNG(etree.parse(str(resource("schema", file))))
    return bool(rules.validate(etree.fromstring(data)))


@pytest.mark.parametrize("file", FILES)
def test_the_shipped_schema_is_what_the_table_makes(file: str) -> None:
    assert resource("schema", file).read_bytes() == schema(FILES[file])


def test_the_schemas_are_made_by_running_the_module(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("situ.resources.resource", lambda *parts: tmp_path.joinpath(*parts[1:]))
    runpy.run_path(making.__file__, run_name="__main__")
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == {
        file: schema(root) for file, root in FILES.items()
    }


def test_the_documents_of_formats_are_valid_once_they_are_canonical(example: bytes) -> None:
    document, _ = codec.read(example, "a.xml")
    assert document is not None
    written = codec.write(document)
    assert [file for file in FILES if valid(file, written)] == [
        next(file for file, root in FILES.items() if root.key is type(document))
    ]


def test_the_examples_are_valid() -> None:
    for root in examples().values():
        for file in root.glob("*.xml"):
            kind = {".rbd": "rbd.rng", ".spds": "spds.rng"}.get(
                "".join(file.suffixes[:-1]), "modules.rng"
            )
            assert valid(kind, file.read_bytes()), file


STATE = '<application name="a"><state no="1">{}</state></application>'


@pytest.mark.parametrize(
    "text",
    [
        "<application/>",
        '<application name="a" nam="b"/>',
        STATE.format("<timout>5</timout>"),
        STATE.format("<timeout>0</timeout>"),
        STATE.format("<timeout>soon</timeout>"),
        STATE.format("<timeout>5</timeout><timeout>5</timeout>"),
        STATE.format("<expectedevents/><timeout>5</timeout>"),
        STATE.format("<backgroundactions><repeat/></backgroundactions>"),
        STATE.format('<backgroundactions><set tag="A b">1</set></backgroundactions>'),
        STATE.format('<expectedevents><event name="a"><speech>b</speech></event></expectedevents>'),
        STATE.format(
            '<expectedevents><event next="1"><when><data tag="a" is="1" isnot="2"/></when></event>'
            "</expectedevents>"
        ),
        STATE.format("hello"),
    ],
)
def test_what_is_misspelt_is_invalid(text: str) -> None:
    assert not valid("rbd.rng", text.encode())


def test_foreign_namespaces_are_valid_everywhere() -> None:
    text = STATE.format(
        '<x:a y="1"><b/>text</x:a><backgroundactions x:c="1"><x:a/><speech>Hi <x:a/></speech>'
        "<x:a/></backgroundactions><x:a/>"
    ).replace("<application", '<application xmlns:x="urn:x" x:z="1"')
    assert valid("rbd.rng", text.encode())
