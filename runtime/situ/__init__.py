"""Situ: situated priorities and robot behaviour descriptions, executed.

The packages, each importing only those to its right:
``engine -> blackboard, rehearse -> decide -> document -> errors``.
"""

__version__ = "0.1.0"
