"""The questions, one per file. Each offers `question()`."""
