"""Random programs for blocks, and workspaces as the page sends and receives them."""

import msgspec

from learnblock.blocks import builtin
from learnblock.language import Workspace
from learnblock.language.tree.nodes import Number, SkillCall
from trees import Trees

CONFIGURATIONS = builtin()
#: Every skill, and words that are none.
SKILLS = (*sorted(CONFIGURATIONS), "class", "end")
NUMBERS = ("0", "1", "2.5", "1e3", "0xFF", ".5", "5.", "00", "1_000", "40", "40.0", "0.50", "8")
NUMBERS += ("12345678901234567890", "1e999", "20")


class BlockTrees(Trees):
    """Random programs with existing skills, and with numbers that no field can show."""

    def __init__(self, seed):
        super().__init__(seed)
        # Half of the calls of skills are of one, so that four thousand programs have all of them.
        self.skills = (*SKILLS, *[SKILLS[seed % len(SKILLS)]] * len(SKILLS))

    def number(self, _):
        return Number(self.choice(NUMBERS))

    def call(self, depth=2):
        return self.choice((super().call, self.skill_call))(depth)

    def skill_call(self, depth=2):
        """A call of a skill; most of them have a value for each parameter of its block."""
        call = super().skill_call(depth)
        skill = CONFIGURATIONS.get(call.name)
        if skill is None or self.random.random() < 0.25:
            return call
        return SkillCall(call.name, tuple(self.expression(depth) for _ in skill.parameters))


def as_json(workspace):
    return msgspec.json.encode(workspace).decode()


def through_json(workspace):
    """Return a workspace as the page sends it."""
    return msgspec.json.decode(as_json(workspace), type=Workspace)


def blocks(workspace, shadows=True):
    """Return every block, a parent before its children."""
    result = [block for stack in workspace.stacks for block in stack]
    for block in result:
        for plug in block.inputs.values():
            result += plug.stack
            result += [inner for inner in (plug.block, shadows and plug.shadow) if inner]
    return result


def only(workspace, kind):
    """Return the only block of a type."""
    (match,) = (block for block in blocks(workspace) if block.type == kind)
    return match
