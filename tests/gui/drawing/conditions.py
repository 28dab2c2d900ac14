"""Conditions, written into a form: tests and groups in the order of the file."""

from __future__ import annotations

from tests.gui.drawing.forms import FormFiller

from situ.document.condition import Condition, Group, Test
from situ.document.datatypes import write_number
from situ_studio.kinds import GROUPS, TESTS
from situ_studio.panels.test_box import listed

ADD = "Add a test"


class ConditionFiller(FormFiller):
    """A condition has a plus of its own, and so has each group in it, below that."""

    def condition(self, condition: Condition, above: int = 0) -> int:
        """above: how many pluses stand above it in the form. Returns how many stand above what
        comes next.
        """
        below = [above]
        for child in condition.children:
            self._child(child, above, below)
        return below[0] + 1

    def _child(self, child: Test | Group, plus: int, below: list[int]) -> None:
        """plus: that of the group in which it is. below: the lowest one."""
        if isinstance(child, Test):
            self.menu_in_form(ADD, "A test", plus)
            self.one_test(child)
            return
        self.menu_in_form(ADD, dict(GROUPS)[child.kind].capitalize(), plus)
        below[0] += 1
        own = below[0]
        for one in child.children:
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
