"""What the canvas uses of NodeGraphQt, imported in one place, quietly and fast.

The library asks ``distutils``, which Python has no longer, which Qt it runs on; ``setuptools``
would stand in for it, with as much to import as half of the studio. And it reaches Qt through
``Qt.py``, which imports whatever any Qt program may want. Here both get what is asked for.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType
from typing import Any

ASKED = ("QtCore", "QtGui", "QtSvg", "QtWidgets")
"""The parts of Qt that the library asks for."""


class _Version:
    """As much of ``distutils.version.LooseVersion`` as is asked for."""

    def __init__(self, text: str) -> None:
        self._numbers = [int(number) for number in text.split(".")]

    def __ge__(self, other: _Version) -> bool:
        return self._numbers >= other._numbers


@contextmanager
def _given(modules: dict[str, ModuleType]) -> Iterator[None]:
    """These can be imported meanwhile, in place of what is else found under their names."""
    before = {name: sys.modules.get(name) for name in modules}
    sys.modules.update(modules)
    try:
        yield
    finally:
        for name, module in before.items():
            if module is None:
                del sys.modules[name]
            else:
                sys.modules[name] = module


def _asked_of() -> dict[str, ModuleType]:
    version: Any = ModuleType("distutils.version")
    version.LooseVersion = _Version
    # Qt.py's own way of being told what is wanted of it.
    site: Any = ModuleType("QtSiteConfig")

    def update_members(members: dict[str, list[str]]) -> None:
        for name in set(members) - set(ASKED):
            del members[name]

    site.update_members = update_members
    return {
        "distutils": ModuleType("distutils"),
        "distutils.version": version,
        "QtSiteConfig": site,
    }


with warnings.catch_warnings(), _given(_asked_of()):
    warnings.simplefilter("ignore")
    from NodeGraphQt import BaseNode, NodeGraph
    from NodeGraphQt.base.commands import PortConnectedCmd, PortDisconnectedCmd
    from NodeGraphQt.base.port import Port
    from NodeGraphQt.qgraphics.node_abstract import AbstractNodeItem
    from NodeGraphQt.qgraphics.node_base import NodeItem
    from NodeGraphQt.qgraphics.pipe import PipeItem
    from NodeGraphQt.qgraphics.port import PortItem
    from NodeGraphQt.widgets.viewer import NodeViewer

__all__ = [
    "AbstractNodeItem",
    "BaseNode",
    "NodeGraph",
    "NodeItem",
    "NodeViewer",
    "PipeItem",
    "Port",
    "PortConnectedCmd",
    "PortDisconnectedCmd",
    "PortItem",
]
