"""The robot's side: what drives ``Robot.step`` and carries out its effects.

Only this package (and ``situ.blackboard``) knows clocks, sockets, processes and screens.
"""
