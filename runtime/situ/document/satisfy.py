"""Whether conditions can hold at one moment, decided as sets of values per name.

What is claimed: ``possible`` says whether there is *a moment* at which all of some
conditions hold, whatever the values on the blackboard then are and however they got
there. Nothing is assumed about the order in which values come; two moments are never
looked at together. Names are judged as formats.md has them:

- A name has one value, of which each test leaves a set (``situ.document.value_sets``). A
  name and another that reaches into it (``patients``, ``patients.0``) are taken together:
  there is no first patient where there are no patients.
- ``within``: each name has an age, the time since it was last set, which is free beside
  its value, since setting the same value again counts. Tests of one name share its age.
- ``for``: a test that has lasted holds now, and so does every weaker test that must have
  lasted no longer. One that holds but has not lasted is possible where the value can have
  been another before: then the name was set in that time, or the robot started in it.
- A test that compares two names is taken as their order (less, equal, greater, or not to be
  compared), which must fit their values.

Where this does not suffice it is said: None, for *undecided*, comes where the search was
too long, or where three or more names are compared in a circle. With ``for``, a comparison
of two names counts as free while it does not hold; and the ages of a name and of one that
reaches into it count as free of each other. Both can only make something possible.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from situ.document.condition import Condition, Group, Test
from situ.document.satisfy_names import NO, YES, Spent, Variables
from situ.document.value_sets import ANY, Domain, refers

BUDGET = 20_000
"""Looks at a literal, for one question."""

LITERAL, ALL, ONE = range(3)


class Node:
    """A condition: a literal (one of the values ``mask`` of variable ``var``), or what all or
    one of ``children`` say. A node without children is what always (ALL) or never (ONE) holds.
    """

    __slots__ = ("children", "kind", "mask", "opposite", "var")

    def __init__(
        self, kind: int, children: tuple[Node, ...] = (), var: int = -1, mask: int = 0
    ) -> None:
        self.kind = kind
        self.children = children
        self.var = var
        self.mask = mask
        self.opposite: Node | None = None


ALWAYS = Node(ALL)
NEVER = Node(ONE)
ALWAYS.opposite, NEVER.opposite = NEVER, ALWAYS


def every(nodes: Iterable[Node]) -> Node:
    """All of them hold."""
    found = tuple(nodes)
    return found[0] if len(found) == 1 else Node(ALL, found)


class Moment:
    """Answers for ``conditions``: all that will be asked about must be among them.

    domain: what is known of a name's values beforehand. spent: the looks at a literal that
    the last question took.
    """

    def __init__(
        self, conditions: Iterable[Condition], domain: Callable[[str], Domain] = lambda _: ANY
    ) -> None:
        known = list(conditions)
        # Designers write the same test again and again: each is looked at once.
        given = dict.fromkeys(test for one in known for test in every_test(one))
        self.variables = Variables(given, domain)
        self.spent = 0
        self._implied: dict[int, Node] = {}
        self._nodes: dict[tuple[int, tuple[Node, ...], int, int], Node] = {}
        self._answers: dict[frozenset[Node], bool] = {}
        self._tests = {test: self._test(test) for test in given}
        self._conditions = {id(one): (one, self._all(one.children)) for one in known}

    def node(self, condition: Condition | None) -> Node:
        """The node of one of ``conditions``; of None, what always holds."""
        return ALWAYS if condition is None else self._conditions[id(condition)][1]

    def part(self, child: Test | Group) -> Node:
        """The node of a part of one of ``conditions``."""
        return self._one(child)

    def opposite(self, node: Node) -> Node:
        """What holds exactly where ``node`` does not."""
        found = node.opposite
        if found is None:
            if node.kind == LITERAL:
                found = self._literal(node.var, self.variables.full[node.var] & ~node.mask)
            else:
                children = tuple([self.opposite(child) for child in node.children])
                found = self._group(ONE if node.kind == ALL else ALL, children)
            node.opposite, found.opposite = found, node
        return found

    def possible(self, *nodes: Node, budget: int = BUDGET) -> bool | None:
        """Whether all of them can hold at one moment; None: undecided.

        What was decided once is known from then on.
        """
        asked = frozenset(nodes)
        found = self._answers.get(asked)
        self.spent = 0
        if found is not None:
            return found
        self.variables.left = budget
        try:
            found = self._search({}, list(nodes))
        except Spent:
            return None
        finally:
            self.spent = budget - self.variables.left
        if found is not None:
            self._answers[asked] = found
        return found

    # -- conditions as nodes, one for all that say the same ----------------------

    def _literal(self, var: int, mask: int) -> Node:
        key = (LITERAL, (), var, mask)
        found = self._nodes.get(key)
        if found is None:
            found = self._nodes[key] = Node(LITERAL, (), var, mask)
        return found

    def _group(self, kind: int, children: tuple[Node, ...]) -> Node:
        if len(children) == 1:
            return children[0]
        key = (kind, children, -1, 0)
        found = self._nodes.get(key)
        if found is None:
            found = self._nodes[key] = Node(kind, children)
        return found

    def _all(self, children: tuple[Test | Group, ...]) -> Node:
        return self._group(ALL, tuple([self._one(child) for child in children]))

    def _one(self, child: Test | Group) -> Node:
        if isinstance(child, Test):
            return self._tests[child]
        if child.kind == "all":
            return self._all(child.children)
        found = self._group(ONE, tuple([self._one(inner) for inner in child.children]))
        return found if child.kind == "any" else self.opposite(found)

    def _test(self, test: Test) -> Node:
        variables = self.variables
        other = refers(test)
        if other is not None:
            var, mask = variables.compared(test, other)
        else:
            var, mask = variables.var[test.tag], variables.values[test.tag].of(test)
        found = self._literal(var, mask)
        if test.hold is not None:
            lasting = variables.lasted(test.tag, var, mask, test.hold)
            self._implied[lasting] = found
            found = self._literal(lasting, YES)
        if test.within is not None:
            found = self._group(ALL, (found, self._literal(*variables.young(test))))
        return found

    # -- the search ------------------------------------------------------------

    def _search(self, chosen: dict[int, int], todo: list[Node]) -> bool | None:
        """Whether what is ``chosen`` (variable to values left) can go with all of ``todo``."""
        open_ = self._propagate(chosen, todo)
        if open_ is None:
            return False
        if not open_:
            return self.variables.fits(chosen)
        open_.sort(key=len)
        unsure = False
        first, rest = open_[0], [Node(ONE, tuple(one)) for one in open_[1:]]
        for child in first:
            found = self._search(dict(chosen), [child, *rest])
            if found:
                return True
            unsure = unsure or found is None
        return None if unsure else False

    def _propagate(self, chosen: dict[int, int], todo: list[Node]) -> list[list[Node]] | None:
        """Takes over what must be; gives what is open: lists of which one must hold. None: a
        contradiction.
        """
        variables = self.variables
        open_: list[list[Node]] = []
        while True:
            while todo:
                node = todo.pop()
                if node.kind == LITERAL:
                    variables.left -= 1
                    var = node.var
                    before = chosen.get(var, variables.full[var])
                    left = before & node.mask
                    if not left:
                        return None
                    if left != before or var not in chosen:
                        chosen[var] = left
                        if left == YES and var in self._implied:
                            todo.append(self._implied[var])
                elif node.kind == ALL:
                    todo.extend(node.children)
                else:
                    open_.append(list(node.children))
            if variables.left <= 0:
                raise Spent
            still: list[list[Node]] = []
            for several in open_:
                alive = []
                for child in several:
                    status = self._status(child, chosen)
                    if status is True:
                        break
                    if status is None:
                        alive.append(child)
                else:
                    if not alive:
                        return None
                    if len(alive) == 1:
                        todo.append(alive[0])
                    else:
                        still.append(alive)
            open_ = still
            if not todo:
                return open_

    def _status(self, node: Node, chosen: dict[int, int]) -> bool | None:
        """Whether a node is already so, or can not be; None: either."""
        if node.kind == LITERAL:
            self.variables.left -= 1
            left = chosen.get(node.var, self.variables.full[node.var])
            implied = self._implied.get(node.var)
            if implied is not None and left == NO | YES:
                left = NO if self._status(implied, chosen) is False else left
            if not left & node.mask:
                return False
            return True if not left & ~node.mask else None
        ends = node.kind == ONE
        found: bool | None = not ends
        for child in node.children:
            status = self._status(child, chosen)
            if status is ends:
                return ends
            if status is None:
                found = None
        return found


def every_test(condition: Condition | Group) -> Iterator[Test]:
    """Every test in a condition."""
    for child in condition.children:
        if isinstance(child, Test):
            yield child
        else:
            yield from every_test(child)
