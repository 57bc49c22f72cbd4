"""Stub files: the skills of robots, with types and help, for editors and type checkers."""
