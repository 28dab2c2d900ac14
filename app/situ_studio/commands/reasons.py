"""Why a command can not be done now, by its ``when``: what there must be first."""

from __future__ import annotations

from situ_studio.wording.language import tr


def reasons() -> dict[str, str]:
    """A short line for everything in a ``when`` of ``actions.COMMANDS``, in the user's language."""
    application = tr("only in an application")
    graph = tr("only in the graph")
    card = tr("select a state first")
    part = tr("select a state, or something of a script, first")
    cards = tr("select two states first")
    exit = tr("select a transition first")
    either = tr("select a state or transition first")
    selection = tr("select something first")
    inside = tr("select a state that runs a part first")
    return {
        "can_align": cards,
        "can_begin_script": tr("the project has a script already"),
        "can_ask_why": tr("follow a robot or open a recording first"),
        "can_auto_layout": graph,
        "can_compare": tr("follow a robot or open a recording first"),
        "can_copy": part,
        "compares": tr("compare two runs first"),
        "can_break": tr("select a state, transition or situation first"),
        "can_deploy": tr("connect to a robot first"),
        "can_save_recording": tr("connect to a robot first"),
        "can_duplicate": part,
        "can_enter_part": inside,
        "can_find_usages": selection,
        "can_follow": selection,
        "can_go_to": card,
        "can_have_another": tr("a project has one script, and one file with module information"),
        "can_insert_action": card,
        "can_insert_application": application,
        "can_insert_drawing": graph,
        "can_insert_modules": tr("only in the list of modules"),
        "can_insert_screen": card,
        "can_insert_script": tr("only in a script"),
        "can_lead": tr("select what it shall lead from first"),
        "can_leave_part": tr("you are in no part"),
        "can_make_part": card,
        "can_order": tr("select a component first"),
        "can_paste": tr("only where states or situations are drawn"),
        "can_redo": tr("nothing was undone"),
        "can_rename_everywhere": tr("select an event, tag or module first"),
        "can_reopen_tab": tr("no tab was closed"),
        "can_space": tr("select three states first"),
        "can_step_exit": either,
        "can_undo": tr("nothing was changed"),
        "may_operate": tr("only an operator may: your key lets you look only"),
        "has_document_file": tr("open a document of a project first"),
        "has_breakpoints": tr("there is no breakpoint"),
        "has_cells": tr("only in the matrix of a script"),
        "has_data": tr("select data in the graph first"),
        "has_designer": tr("only in the screen designer"),
        "has_guides": tr("there is no guide yet: drag one out of a ruler"),
        "has_document": tr("open a document first"),
        "has_drawn_exit": exit,
        "has_exit": exit,
        "has_group": tr("select a group of tests first"),
        "has_found": tr("find something first"),
        "has_graph": tr("this has no graph"),
        "has_one_state": card,
        "has_priority": tr("select a priority first"),
        "has_recording": tr("no recording is open"),
        "has_problems": tr("there is no problem"),
        "has_project": tr("open a project first"),
        "has_pages": tr("open a project first, no document alone"),
        "has_tabs": tr("no document is open"),
        "has_selection": selection,
        "has_situation": tr("select a situation in the graph first"),
        "has_tests": tr("select tests of a condition first"),
        "has_two_cards": cards,
        "is_application": application,
        "is_rehearsing": tr("only while you rehearse"),
        "can_take_in": tr("only while you rehearse something else than is drawn"),
        "can_go_back": tr("no changes were taken into a rehearsal"),
        "is_script": tr("only in a script"),
        "on_application": tr("only in the graph of an application"),
        "on_graph": graph,
        "on_script": tr("only in the graph of a script"),
    }
