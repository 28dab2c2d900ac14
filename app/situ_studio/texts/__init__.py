"""All texts of a project, spoken, shown and heard, as one table with a column a language."""
