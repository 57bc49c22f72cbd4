"""The reference page of all skills, ``docs/skills.md``, written from their source.

``python -m learnblock.blocks.reference docs/skills.md`` updates it.
"""

import ast
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from pathlib import Path

from learnblock.blocks.labels import label
from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter
from learnblock.blocks.schema.loading import builtin
from learnblock.storage import skill_files

_HEAD = """\
# Skills

Skills are the commands and questions for a robot. They are the same for every robot: in
Block-Text `function.NAME(...)`, in Python `robot.NAME(...)`. Speeds are in mm/s and degrees/s,
distances in mm, angles in degrees (clockwise, that is to the right, is positive) and times in
seconds.

A skill asks for a [sense](one-program-every-robot.md#senses). If nothing on the robot can serve it,
the skill does nothing: a question returns False, and a measurement returns None.

This page is generated: `scripts/docs`.
"""
_SECTION = re.compile(r"(Args|Raises):")
_ENTRY = re.compile(r"    (\w+): (.*)")


def reference() -> str:
    """The page, in Markdown."""
    documentation = dict(_documentation())
    categories = {
        category: tuple(blocks)
        for category, blocks in groupby(builtin().values(), key=lambda block: block.category)
    }
    parts = [_HEAD, _contents(categories)]
    for category, blocks in categories.items():
        parts.append(f"## {category}\n")
        parts += [_entry(block, documentation[block.name]) for block in blocks]
    return "\n".join(parts)


def _contents(categories: Mapping[str, Sequence[BlockConfiguration]]) -> str:
    """A table with the names of all skills, which lead to their entries."""
    rows = [
        f"| {category} | {', '.join(map(_link, blocks))} |"
        for category, blocks in categories.items()
    ]
    return "\n".join(["| tab | skills |", "|---|---|", *rows]) + "\n"


def _link(block: BlockConfiguration) -> str:
    anchor = re.sub(r"[^\w -]", "", _heading(block).lower()).replace(" ", "-")
    return f"[{block.name}](#{anchor})"


def _heading(block: BlockConfiguration) -> str:
    return f"`{block.name}({', '.join(map(_parameter, block.parameters))})`"


def _documentation() -> Iterator[tuple[str, str]]:
    """The name and docstring of each built-in skill."""
    for path in (Path(__file__).parents[1] / "skills").glob("*.py"):
        for function in skill_files.functions(
            skill_files.parse(path.read_text("utf-8"), str(path))
        ):
            yield function.name, ast.get_docstring(function) or ""


def _entry(block: BlockConfiguration, documentation: str) -> str:
    needs = ", ".join(f"`{need}`" for need in block.needed()) or "no device"
    kind = "A value" if block.returns_value else "A statement"
    return (
        f"### {_heading(block)}\n\n"
        f"{_markdown(documentation)}\n\n"
        f"{kind}; needs {needs}. {_labels(block)}\n"
    )


def _parameter(parameter: Parameter) -> str:
    return parameter.name if parameter.required else f"{parameter.name}={parameter.default!r}"


def _labels(block: BlockConfiguration) -> str:
    labels = [f"{language} *{label(block, language)}*" for language in block.languages]
    return f"On the block: {', '.join(labels)}."


def _markdown(docstring: str) -> str:
    """A docstring in Google style as Markdown: the entries of its sections become a list."""
    lines: list[str] = []
    prefix = ""
    for line in docstring.splitlines():
        section, entry = _SECTION.fullmatch(line), _ENTRY.fullmatch(line)
        if section:
            prefix = "raises " if section[1] == "Raises" else ""
        elif entry:
            lines.append(f"- {prefix}`{entry[1]}`: {entry[2]}")
        else:
            lines.append(line.removeprefix("      "))
    return re.sub(r"``(.+?)``", r"`\1`", "\n".join(lines)).strip()


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(reference(), "utf-8")
