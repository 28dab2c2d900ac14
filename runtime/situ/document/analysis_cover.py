"""Whether something can hold while none of many others does, without looking at all of them.

Situations stand in precedence: each is current only where those above it do not hold. What
stands above is kept as conditions that must all be possible together; a question about one
more takes only those of them that have to do with it, for the others are possible already.
"""

from __future__ import annotations

from situ.document.analysis_search import Search
from situ.document.satisfy import LITERAL, Node


class Cover:
    """What must hold: nodes added one by one. ``is_possible``: whether all of them can."""

    def __init__(self, search: Search) -> None:
        self.is_possible: bool | None = True
        self._search = search
        self._group = search.moment.variables.groups()
        self._nodes: list[tuple[Node, set[int]]] = []
        self._by_group: dict[int, list[int]] = {}

    def possible(self, *nodes: Node) -> bool | None:
        """Whether ``nodes`` can hold together with all that was added; None: undecided."""
        if self.is_possible is not True:
            return self.is_possible
        return self._search.possible(*nodes, *self._relevant(nodes))

    def add(self, node: Node) -> None:
        """From now on ``node`` must hold, too."""
        if self.is_possible is not False:
            self.is_possible = self.possible(node)
        groups = self._groups(node)
        for group in groups:
            self._by_group.setdefault(group, []).append(len(self._nodes))
        self._nodes.append((node, groups))

    def core(self, *nodes: Node, among: list[Node]) -> list[int]:
        """The positions of as few of ``among`` as already exclude ``nodes``."""
        for at, one in enumerate(among):
            if self._search.possible(*nodes, one) is False:
                return [at]
        left = list(range(len(among)))
        for at in range(len(among)):
            rest = [one for one in left if one != at]
            if self._search.possible(*nodes, *(among[one] for one in rest)) is False:
                left = rest
        return left

    def _relevant(self, nodes: tuple[Node, ...]) -> list[Node]:
        """Those that share names with ``nodes``, those that share names with these, and so on."""
        waiting = [group for node in nodes for group in self._groups(node)]
        seen = set(waiting)
        taken: set[int] = set()
        while waiting:
            for at in self._by_group.get(waiting.pop(), ()):
                if at not in taken:
                    taken.add(at)
                    new = self._nodes[at][1] - seen
                    seen |= new
                    waiting += new
        return [self._nodes[at][0] for at in sorted(taken)]

    def _groups(self, node: Node) -> set[int]:
        if node.kind == LITERAL:
            return {self._group[node.var]}
        return {group for child in node.children for group in self._groups(child)}
