"""Every error that Situ raises on purpose.

::

    SituError                 one line for the user: what, where, how to mend
    ├── UsageError            wrong usage, unreadable input: exit status 2
    │   └── ProjectError      a project with errors where none may be
    ├── ScenarioError         a scenario that can not be played: exit status 2
    └── BlackboardError       the blackboard refused or could not be reached
        ├── Refused           it answered no; ``str`` says why and what to do
        └── Unreachable       nobody answers at that address

Checks return problems (``situ.document.problem``); they never raise.
"""


class SituError(Exception):
    """The base. ``str(error)`` is one line that can be shown as it is."""


class UsageError(SituError):
    """Wrong usage or input that can not be read; the command line exits with 2."""


class ProjectError(UsageError):
    """A project has errors and the caller needs one that has none."""


class ScenarioError(UsageError):
    """A scenario breaks the rules of docs/formats (Scenarios); names its line."""


class BlackboardError(SituError):
    """The blackboard refused, or could not be reached."""


class Refused(BlackboardError):
    """The blackboard answered and refused; the message says why and what to do."""


class Unreachable(BlackboardError):
    """Nobody answered at the address in time."""
