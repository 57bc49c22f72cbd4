"""The skills of each robot for type checkers: the stub file of `learnblock.client.skill_sets`.

``python -m learnblock.stubs.skill_sets src/learnblock/client`` writes it. Skills with the same
needs are a class, and a robot has the classes whose needs it serves.
"""

import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from pathlib import Path

from learnblock import robots
from learnblock.blocks.schema.configuration import BlockConfiguration
from learnblock.blocks.schema.loading import builtin
from learnblock.senses import is_decoration, served_by
from learnblock.stubs.methods import Method, methods_of

#: Several sets of needs, one of which must be served.
Needs = tuple[tuple[str, ...], ...]

#: No needs.
NOTHING: Needs = ((),)

_HEAD = '"""The skills of each robot, written from their source: `scripts/docs`."""'
_EVERY = "EverySkill"
#: The module whose stub has the user's own skills; LearnBlock's has none.
OWN = "learnblock_home.own_skills"


def stub() -> str:
    """The text of the stub file."""
    groups = grouped(built_in_methods())
    texts = [_group(needs, group) for needs, group in groups.items()]
    texts += [_robot(class_name(name), name, groups) for name in robots.built_in()]
    texts.append(_class(_EVERY, "Every skill, for hints: a robot of any kind.", groups))
    imports = import_lines(method for group in groups.values() for method in group)
    own = f"from {OWN} import OwnSkills"
    return "\n\n".join([_HEAD, f"{imports}\n{own}", *texts]) + "\n"


def built_in_methods() -> Iterator[Method]:
    """LearnBlock's own skills, from their source."""
    for path in sorted((Path(__file__).parents[1] / "skills").glob("*.py")):
        for method in methods_of(path.read_text("utf-8"), str(path)):
            if method.name in builtin():
                yield method


def grouped(methods: Iterable[Method]) -> Mapping[Needs, tuple[Method, ...]]:
    """Built-in skills by what they need."""
    blocks = builtin()

    def needs(method: Method) -> Needs:
        return needs_of(blocks[method.name])

    return {key: tuple(group) for key, group in groupby(sorted(methods, key=needs), key=needs)}


def needs_of(block: BlockConfiguration) -> Needs:
    """What a robot must serve to have a skill; what only decorates is no need."""
    own = [parameter.needs for parameter in block.parameters if parameter.needs]
    choices: list[tuple[str, ...]] = [(need,) for need in own] or [block.needed()]
    needs = (tuple(need for need in choice if not is_decoration(need)) for choice in choices)
    return tuple(dict.fromkeys(needs))


def serves(equipment: frozenset[str] | None, needs: Needs) -> bool:
    """Whether a robot serves one of the sets of needs; one with unknown devices serves all."""
    return equipment is None or any(
        all(served_by(need, equipment) for need in choice) for choice in needs
    )


def class_name(robot: str) -> str:
    """The name of the class with the skills of a built-in robot.

    >>> class_name("sim-ebo")
    'SimEbo'
    """
    return robot.title().replace("-", "")


def group_name(needs: Needs) -> str:
    """The name of the class of the skills with these needs.

    >>> group_name((("Base", "heading"),)), group_name(((),))
    ('_NeedsBaseHeading', '_NeedsNothing')
    """
    words = "Or".join("".join(map(_camel, choice)) for choice in needs)
    return f"_Needs{words or 'Nothing'}"


def import_lines(methods: Iterable[Method]) -> str:
    """The imports of methods, by module."""
    lines = sorted({line for method in methods for line in method.imports})
    whole = [line for line in lines if line.startswith("import ")]
    modules: dict[str, list[str]] = {}
    for line in lines:
        if line not in whole:
            module, _, name = line.removeprefix("from ").partition(" import ")
            modules.setdefault(module, []).append(name)
    return "\n".join(
        [*whole, *(f"from {module} import {', '.join(names)}" for module, names in modules.items())]
    )


def _camel(need: str) -> str:
    return "".join(part[:1].upper() + part[1:] for part in re.split(r"\W+", need))


def _group(needs: Needs, methods: Iterable[Method]) -> str:
    words = " or ".join(" and ".join(f"`{need}`" for need in choice) for choice in needs)
    summary = f"Skills that need {words or 'nothing'}."
    return "\n\n".join(
        [f'class {group_name(needs)}:\n    """{summary}"""', *(each.text for each in methods)]
    )


def _robot(name: str, robot: str, groups: Iterable[Needs]) -> str:
    equipment = robots.find(robot).load().known_equipment()
    served = [needs for needs in groups if serves(equipment, needs)]
    return _class(name, f"The skills of `{robot}`.", served)


def _class(name: str, summary: str, groups: Iterable[Needs]) -> str:
    bases = ["OwnSkills", *map(group_name, groups)]
    rows = "".join(f"    {base},\n" for base in bases)
    return f'class {name}(\n{rows}):\n    """{summary}"""'


if __name__ == "__main__":
    (Path(sys.argv[1]) / "skill_sets.pyi").write_text(stub(), "utf-8")
