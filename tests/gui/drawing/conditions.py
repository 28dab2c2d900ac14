"""Conditions, written into a form: tests and groups in the order of the file."""

from __future__ import annotations

from collections.abc import Sequence

from tests.gui.drawing.forms import FormFiller

from situ.document.condition import Condition, Group, Test
from situ.document.datatypes import write_number
from situ_studio.kinds import GROUPS, TESTS
from situ_studio.panels.test_box import listed

ADD = "Add a test"


class ConditionFiller(FormFiller):
    """A condition has a plus of its own, and so has each group in it, below that."""

    def condition(self, condition: Condition, above: Sequence[int] = (0, 0)) -> list[int]:
        """above: how many pluses and tests stand above it in the form. Returns how many stand
        above what comes next.
        """
        below = list(above)
        for child in condition.children:
            self._child(child, above[0], below)
        return [below[0] + 1, below[1]]

    def _child(self, child: Test | Group, plus: int, below: list[int]) -> None:
        """plus: that of the group in which it is. below: the lowest one, and how many tests."""
        if isinstance(child, Test):
            self.menu_in_form(ADD, "A test", plus)
            self.one_test(child)
            below[1] += 1
            return
        self.menu_in_form(ADD, dict(GROUPS)[child.kind].capitalize(), plus)
        begun = below[1]
        below[0] += 1
        below[1] += 1
        own = below[0]
        first, *others = child.children
        if isinstance(first, Test):
            self.one_test(first)
        else:
            self._child(first, own, below)
            # A group begins with a test, and is never empty.
            self.press_in_form("Remove this test", begun)
            below[1] -= 1
        for one in others:
            self._child(one, own, below)

    def one_test(self, test: Test) -> None:
        """Into the fields of a test, from its tag on."""
        missing = test.test == "exists" and test.value == "false"
        fields: dict[str, str | bool] = {"Tag": test.tag}
        fields["Test"] = "is missing" if missing else dict(TESTS)[test.test]
        if test.test != "exists":
            fields["Value"] = listed(test.value) if test.test == "in" else test.value
        if test.within is not None:
            fields["within"] = write_number(test.within)
        if test.hold is not None:
            fields["for"] = write_number(test.hold)
        self.fill(fields)
