"""What the canvas uses of NodeGraphQt, imported in one place and quietly.

The library imports ``distutils`` (through setuptools where Python has none any
more), which warns; the studio's warnings are errors under test.
"""

from __future__ import annotations

import warnings

with warnings.catch_warnings():
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
