"""What is to be remembered about a thing, a field of most kinds (``situ_studio.edits.notes``)."""

from __future__ import annotations

from situ_studio.kinds.kind import Field, Section

NOTED = Field(
    attribute="note",
    label="Note",
    editor="note",
    help="What is to be remembered about it; the robot does not see it.",
    empty="",
)
MORE = Section(title="More", help="What is seldom needed.", fields=(NOTED,))
