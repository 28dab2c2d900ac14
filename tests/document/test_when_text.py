"""A condition as a text of its own, as a breakpoint is kept and sent with it."""

from __future__ import annotations

import pytest

from situ.document import when_text
from situ.document.condition import Condition, Group
from situ.document.condition import Test as One


@pytest.mark.parametrize(
    ("condition", "text"),
    [
        (Condition((One("a.b", "is", "true"),)), '<data tag="a.b" is="true"/>'),
        (
            Condition(
                (
                    Group(
                        "any",
                        (One("a", "exists", "true"), One("b", "is", "<&")),
                    ),
                )
            ),
            '<any>\n<data tag="a" exists="true"/>\n<data tag="b" is="&lt;&amp;"/>\n</any>',
        ),
    ],
)
def test_a_condition_is_written_as_what_stands_inside_its_when_and_read_as_it_was(
    condition: Condition, text: str
) -> None:
    assert when_text.write(condition) == text
    assert when_text.read(text) == condition
