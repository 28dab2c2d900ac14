"""What documents hold and what is made of them, as values: places, mentions, edits. No widgets."""
