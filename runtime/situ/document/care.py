"""Care lints: what a nurse would say of a robot's behaviour before it meets anybody.

Each rule stands with the function that searches for it, its figures and where they come from:

- ``care_speech``: ``speech-over-timeout``, ``no-repeat``, ``language-without-voice``,
  ``language-without-texts``;
- ``care_screen``: ``small-target``, ``small-text``, ``low-contrast``;
- ``care_people``: ``no-way-back-by-hand``, ``private-spoken``, ``private-shown``,
  ``private-stays``;
- ``care_copies``: ``private-copied``;
- ``care_script``: ``nothing-stops``, ``isnot-without-exists``;
- ``care_calls``: ``suspended-call``.

All are warnings, told only where they are sure: values of references have no known length,
a guard may hold, a part may be served by what holds it. ``ed:accept`` silences what is meant.
No mend here is safe: each changes what people see, hear or wait for.
"""

from __future__ import annotations

from situ.document.analysis_search import Search
from situ.document.care_calls import suspended_calls
from situ.document.care_copies import copies
from situ.document.care_people import only_waiting, private_data
from situ.document.care_screen import low_contrast, small_targets, small_texts
from situ.document.care_script import isnot_alone, nothing_stops
from situ.document.care_speech import cut_off, languages, no_repeat
from situ.document.care_ways import every_way, handed


def search_care(search: Search) -> None:
    """Adds what the care lints find to what a search has found. Raises Cancelled."""
    project = search.project
    by_hand, along = handed(project), every_way(project)
    for file, application in project.flows.items():
        search.go_on()
        cut_off(search, file, application)
        no_repeat(search, file, application, by_hand)
        small_targets(search, file, application)
        small_texts(search, file, application)
        low_contrast(search, file, application)
        only_waiting(search, file, application, along[file])
    search.go_on()
    private_data(search, along)
    copies(search)
    languages(search)
    isnot_alone(search)
    nothing_stops(search)
    suspended_calls(search, along)
