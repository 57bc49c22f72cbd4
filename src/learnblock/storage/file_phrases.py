"""Phrases that all kinds of files share."""

from collections.abc import Iterable

from learnblock.errors import nearest
from learnblock.i18n import Phrase


def place(path: str) -> Phrase:
    """Name a position in a file, such as ``wall[2]``; the file itself for an empty path."""
    return Phrase("file-place", path=path) if path else Phrase("file-itself")


def unknown_key(key: str, path: str, known_keys: Iterable[str]) -> Phrase:
    """Report an unknown key, with the nearest of the known keys or with all of them."""
    names = tuple(known_keys)
    suggestion = nearest(key, names)
    if suggestion is not None:
        return Phrase("file-unknown-key-like", key=key, place=place(path), suggestion=suggestion)
    if names:
        return Phrase("file-unknown-key-of", key=key, place=place(path), known=names)
    return Phrase("file-unknown-key", key=key, place=place(path))
