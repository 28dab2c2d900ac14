"""The result of a suite as JUnit XML, which continuous integration reads."""

from __future__ import annotations

import re
from xml.etree import ElementTree as Tree

from situ.document.project import Project
from situ.rehearse.suite import Suite, details

_FORBIDDEN = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML cannot hold."""


def junit(suite: Suite, project: Project) -> bytes:
    """One test case a scenario; ``time`` is its virtual time in seconds."""
    failures = sum(bool(one.failed) for one in suite.played)
    errors = sum(one.unreadable is not None for one in suite.played)
    counts = {
        "name": _text(suite.project),
        "tests": str(len(suite.played)),
        "failures": str(failures),
        "errors": str(errors),
        "time": f"{sum(one.seconds for one in suite.played):g}",
    }
    root = Tree.Element("testsuites", counts)
    group = Tree.SubElement(root, "testsuite", {**counts, "skipped": "0"})
    for one in suite.played:
        case = Tree.SubElement(
            group,
            "testcase",
            {
                "classname": _text(suite.project),
                "name": _text(one.file),
                "time": f"{one.seconds:g}",
                "assertions": str(one.expectations),
            },
        )
        if one.unreadable is not None:
            wrong = Tree.SubElement(case, "error", {"message": _text(one.unreadable)})
            wrong.set("type", "unreadable")
        elif one.failed:
            told = [details(failed, project) for failed in one.failed]
            message = f"{len(one.failed)} of {one.expectations} expectations failed: {told[0][0]}"
            wrong = Tree.SubElement(case, "failure", {"message": _text(message)})
            wrong.set("type", "expectation")
            wrong.text = _text("\n".join(line for lines in told for line in lines))
    Tree.indent(root)
    return bytes(Tree.tostring(root, encoding="utf-8", xml_declaration=True)) + b"\n"


def _text(text: str) -> str:
    return _FORBIDDEN.sub("\ufffd", text)
