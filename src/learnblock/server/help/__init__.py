"""Completion and help in both texts, in the user's language."""
