"""Errors as sentences for the page, which has no use for the form that scripts read."""

from learnblock.errors import Diagnostic, FileError


def sentence(error: Exception) -> str:
    """What is wrong and what to do."""
    if isinstance(error, FileError):
        return "; ".join(map(_placed, error.diagnostics))
    return str(error) or type(error).__name__


def _placed(diagnostic: Diagnostic) -> str:
    place = f"line {diagnostic.line}: " if diagnostic.line else ""
    return place + diagnostic.message
