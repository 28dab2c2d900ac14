"""The form of a project: what ``situ.toml`` says, in a designer's words."""
