"""Transitions between states, and where the application starts."""

from __future__ import annotations

from situ_studio.actions.command import Command, row

TRANSITIONS: tuple[Command, ...] = (
    row(
        "lead_to",
        "Lead to…",
        "ask_where_to",
        icon="lead",
        shortcut="Ctrl+E",
        menu="Insert",
        when="can_lead",
        rule=True,
        contexts="state exit always thing",
        tip="A new transition of the selected state, another target of the selected one; or what "
        "selected data, a situation or a module leads to.",
    ),
    row(
        "turn_pipe",
        "Draw the folded pipe, or fold it",
        "on_view",
        icon="fold",
        argument="turn_pipe",
        menu="Arrange",
        when="has_drawn_exit",
        contexts="exit",
        tip="Long pipes are folded into a chip with the number of the state.",
    ),
    row(
        "connect_states",
        "Connect one after the other",
        "on_view",
        icon="chain",
        argument="connect_selected",
        menu="Insert",
        when="has_two_cards",
        contexts="states",
    ),
    row(
        "guard",
        "Guard",
        "guard",
        icon="guard",
        menu="Insert",
        when="has_exit",
        contexts="exit",
        tip="When the selected transition may be taken.",
    ),
    row(
        "mark_start",
        "Start here",
        "mark_start",
        icon="start",
        menu="Insert",
        when="has_one_state",
        contexts="state",
    ),
)
