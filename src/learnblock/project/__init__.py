"""A project: its files and their history, its program in three views, and help with that."""
