"""Runs of a project's program, and reports of them to its pages."""
