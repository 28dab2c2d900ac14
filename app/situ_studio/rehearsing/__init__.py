"""Rehearsals: the project as it is drawn runs in virtual time inside the editor."""
