"""Copy and paste, within a document, from one to another and from project to project."""
