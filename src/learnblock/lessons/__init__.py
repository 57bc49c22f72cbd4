"""Lessons: what is in their files, checks of what programs did, hints, and grading a class."""
