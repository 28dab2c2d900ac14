"""The records of a small ward: residents, what was measured, who was called. SQLite and HTTP."""
