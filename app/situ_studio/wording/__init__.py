"""The studio's languages, and the words for what the runtime says, values and durations."""
