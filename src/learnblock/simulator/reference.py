"""The tables of keys in ``docs/simulator.md``, written from the descriptions of the files.

``python -m learnblock.simulator.reference docs/simulator.md`` updates them in the page: each is
below the heading of its table, such as ``[[wall]]``. The rest of the page is written by hand.
"""

import re
import sys
from collections.abc import Iterator
from pathlib import Path

import msgspec
from msgspec import inspect

from learnblock.simulator.robot_description import RobotFile
from learnblock.simulator.world_description import WorldFile
from learnblock.storage.struct_types import alternatives, bare, describe
from learnblock.storage.toml_values import written

#: A heading, and the text below it.
_SECTION = re.compile(r"^### `(\[.+\])`\n((?:(?!#).*\n)*)", re.MULTILINE)
_TABLE = re.compile(r"^(?:\|.*\n)+", re.MULTILINE)


def reference(page: str) -> str:
    """Return a page with the table of each heading as the code has it today.

    Args:
        page: the text of ``docs/simulator.md``.
    """
    known = tables()

    def section(match: re.Match[str]) -> str:
        heading, text = match.groups()
        written_by_hand = _TABLE.split(text, maxsplit=1)[-1]
        return _section(heading, known[heading]) + written_by_hand

    return _SECTION.sub(section, page)


def tables() -> dict[str, inspect.StructType]:
    """Return the tables of the files of worlds and robots, each by its heading in such a file."""
    files = (inspect.type_info(file) for file in (WorldFile, RobotFile))
    return {heading: table for file in files for heading, table in _tables(file, "")}


def _tables(table: inspect.Type, path: str) -> Iterator[tuple[str, inspect.StructType]]:
    """The tables that a table contains, those of tables in them included."""
    if not isinstance(table, inspect.StructType):
        return
    for field in table.fields:
        for kind in alternatives(field.type):
            key = f"{path}{field.name}"
            inner = bare(kind.item_type) if isinstance(kind, inspect.VarTupleType) else kind
            if not isinstance(inner, inspect.StructType):
                continue
            if _has_keys(inner):
                yield (f"[{key}]" if inner is kind else f"[[{key}]]"), inner
            yield from _tables(inner, f"{key}.")


def _has_keys(table: inspect.StructType) -> bool:
    """Whether a table has keys of its own, unlike ``[goal]``, which only groups other tables."""
    return any(not isinstance(bare(field.type), inspect.VarTupleType) for field in table.fields)


def _section(heading: str, table: inspect.StructType) -> str:
    rows = [
        f"| `{field.name}` | {describe(field.type)} | {_default(field)} |" for field in table.fields
    ]
    lines = ["| key | value | default |", "|---|---|---|", *rows]
    purpose = (table.cls.__doc__ or "").strip()
    return f"### `{heading}`\n\n{purpose}\n\n" + "\n".join(lines) + "\n"


def _default(field: inspect.Field) -> str:
    if field.required:
        return "required"
    if field.default is None:
        return "none"
    value = field.default_factory() if field.default is msgspec.NODEFAULT else field.default
    return f"`{written(value, '{:g}'.format)}`"


if __name__ == "__main__":
    page = Path(sys.argv[1])
    page.write_text(reference(page.read_text("utf-8")), "utf-8")
