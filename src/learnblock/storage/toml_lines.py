"""The lines and columns of keys in a TOML text."""

import re

from learnblock.storage.struct_types import KeyPath

_HEADER = re.compile(r"\s*\[\[?\s*([^\]]+?)\s*\]\]?\s*(#.*)?$")


def find_key(path: KeyPath, source: str) -> tuple[int, int, int]:
    """Find the line, column and end column of a key, or else of the header above it."""
    here: KeyPath = ()
    counts: dict[str, int] = {}
    best, best_depth = (0, 0, 0), 0
    for number, text in enumerate(source.splitlines(), start=1):
        header = _HEADER.match(text)
        if header:
            here = _header_path(header[1], counts, is_list=text.lstrip().startswith("[["))
        key = None if header else re.match(r"\s*([\w.-]+)\s*=", text)
        stop = header or key
        if stop is None:
            continue
        full = here if header else (*here, *stop[1].split("."))
        if best_depth == 0 and full[: len(path)] == path and path:
            return number, stop.start(1) + 1, stop.end(1) + 1
        if len(full) > best_depth and path[: len(full)] == full:
            best, best_depth = (number, stop.start(1) + 1, stop.end(1) + 1), len(full)
    return best


def _header_path(header: str, counts: dict[str, int], *, is_list: bool) -> KeyPath:
    """Read a header; ``[[line.part]]`` below the second ``[[line]]`` gives ``line, 1, part, n``."""
    path: KeyPath = ()
    parts = [part.strip() for part in header.split(".")]
    for depth, part in enumerate(parts):
        path = (*path, part)
        key = repr(path)
        if is_list and depth == len(parts) - 1:
            counts[key] = counts.get(key, -1) + 1
        if key in counts:
            path = (*path, counts[key])
    return path
