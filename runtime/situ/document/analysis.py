"""What needs a search: mistakes that nobody sees by looking at a graph.

Each search says in its module what it claims; within that it gives no false alarm and
misses nothing. Conditions are decided as sets of values (``situ.document.satisfy``). What
did not come to an end in the time allowed is told as ``undecided``, never guessed.

All that is found here are warnings: errors come from ``situ.document.check.structure``.
"""

from __future__ import annotations

from collections.abc import Callable

from situ.document.analysis_active import runs_of
from situ.document.analysis_expected import search_expected
from situ.document.analysis_modules import search_modules
from situ.document.analysis_screens import search_screens
from situ.document.analysis_script import search_situations
from situ.document.analysis_search import Cancelled, Search
from situ.document.analysis_states import search_states
from situ.document.analysis_unwritten import search_unwritten
from situ.document.analysis_ways import Ways
from situ.document.project import Project

__all__ = ["Cancelled", "Search", "analyse"]


def analyse(project: Project, cancel: Callable[[], bool] | None = None) -> Search:
    """Searches a project; what is found stands in ``found``, file to findings, and ``toml``.

    Raises Cancelled where ``cancel``, asked now and then, becomes true; nothing else,
    whatever the documents hold.
    """
    search = Search(project, cancel)
    ways: dict[str, tuple[Ways, set[str]]] = {}
    for file, application in project.flows.items():
        search.go_on()
        found = search_states(search, file, application)
        if file in project.applications:
            ways[application.name] = found
    if project.spds is not None and project.spds_file is not None:
        current = search_situations(search, project.spds_file, project.spds)
        search_modules(search, project.spds_file, project.spds, current, ways)
    search_unwritten(search)
    runs = runs_of(search)
    search_expected(search, runs)
    search_screens(search, runs)
    return search
