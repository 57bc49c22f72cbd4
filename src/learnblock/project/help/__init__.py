"""Completion and help for Block-Text and Python, in the user's language."""
