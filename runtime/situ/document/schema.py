"""RELAX NG schemas of the three documents, made from the table of elements.

``python -m situ.document.schema`` writes them to ``resources/schema``. They
prescribe the order in which children are written (any order costs ten times as
much to validate); reading accepts any. Elements and attributes of foreign
namespaces are allowed everywhere but inside numbers.
"""

from __future__ import annotations

from pathlib import Path

from lxml import etree

from situ.document.datatypes import SOME, TEXT
from situ.document.elements import APPLICATION, MODULES, SPDS
from situ.document.grammar import Attribute, Element, Slot
from situ.resources import resource

FILES = {"rbd.rng": APPLICATION, "spds.rng": SPDS, "modules.rng": MODULES}

_HEAD = """\
<grammar xmlns="http://relaxng.org/ns/structure/1.0"
         datatypeLibrary="http://www.w3.org/2001/XMLSchema-datatypes" ns="">
"""
_FOREIGN = """\
<define name="_attributes">
  <zeroOrMore>
    <attribute><anyName><except><nsName ns=""/></except></anyName></attribute>
  </zeroOrMore>
</define>
<define name="_elements"><zeroOrMore><ref name="_element"/></zeroOrMore></define>
<define name="_element">
  <element>
    <anyName><except><nsName ns=""/></except></anyName>
    <ref name="_anything"/>
  </element>
</define>
<define name="_anything">
  <zeroOrMore>
    <choice>
      <text/>
      <attribute><anyName/></attribute>
      <element><anyName/><ref name="_anything"/></element>
    </choice>
  </zeroOrMore>
</define>
"""


def schema(root: Element) -> bytes:
    """The RELAX NG schema, in XML, of the document with this root; always the same bytes."""
    grammar = _Grammar(root)
    text = f"{_HEAD}{grammar.text()}{_FOREIGN}</grammar>"
    tree = etree.fromstring(text.encode(), etree.XMLParser(remove_blank_text=True))
    etree.indent(tree)
    note = "<!-- Made from situ.document.elements by python -m situ.document.schema. -->\n"
    head = '<?xml version="1.0" encoding="UTF-8"?>\n' + note
    return head.encode() + bytes(etree.tostring(tree)) + b"\n"


def main() -> None:
    """Writes the schemas to where they are shipped from."""
    for file, root in FILES.items():
        Path(resource("schema"), file).write_bytes(schema(root))


class _Grammar:
    """One ``define`` an element; elements of one name are told apart by a number."""

    def __init__(self, root: Element) -> None:
        self._names: dict[int, str] = {}
        self._defines: list[str] = []
        start = self._ref(root)
        self._start = f"<start>{start}</start>"

    def text(self) -> str:
        return self._start + "".join(self._defines)

    def _ref(self, element: Element) -> str:
        name = self._names.get(id(element))
        if name is None:
            taken = set(self._names.values())
            name, number = element.name, 2
            while name in taken:
                name, number = f"{element.name}.{number}", number + 1
            self._names[id(element)] = name
            place = len(self._defines)
            self._defines.append("")
            self._defines[place] = (
                f'<define name="{name}"><element name="{element.name}">'
                f"{self._content(element)}</element></define>"
            )
        return f'<ref name="{name}"/>'

    def _content(self, element: Element) -> str:
        made = "".join(_attribute(one) for one in element.attributes if not one.alternative)
        alternatives = [_pattern(one) for one in element.attributes if one.alternative]
        if alternatives:
            made += f"<choice>{''.join(alternatives)}</choice>"
        made += '<ref name="_attributes"/>'
        kind = element.text[1] if element.text is not None else None
        if kind is not None and kind not in (TEXT, SOME):
            return made + kind.schema
        inner = '<ref name="_elements"/>' + "".join(self._slot(slot) for slot in element.slots)
        return made + (inner if kind is None else f"<mixed>{inner}</mixed>")

    def _slot(self, slot: Slot) -> str:
        children = "".join(self._ref(one) for one in slot.elements)
        if slot.many:
            return f'<zeroOrMore><choice>{children}<ref name="_element"/></choice></zeroOrMore>'
        return f'<optional>{children}</optional><ref name="_elements"/>'


def _pattern(one: Attribute) -> str:
    return f'<attribute name="{one.name}">{one.type.schema}</attribute>'


def _attribute(one: Attribute) -> str:
    return _pattern(one) if one.required else f"<optional>{_pattern(one)}</optional>"


if __name__ == "__main__":
    main()
