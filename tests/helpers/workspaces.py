"""Random programs for blocks, and workspaces as the page sends and receives them."""

import msgspec

from learnblock.blocks import builtin
from learnblock.language import Workspace
from learnblock.language.tree.nodes import Number, SkillCall
from trees import Trees

CONFIGURATIONS = builtin()
SKILLS = ("is_tag", "turn", "class", "end", "move_left", "set_move", "move_straight", "say_Text")
SKILLS += ("get_image", "stop_bot", "is_any_tag", "sleep", "set_orientation")
#: What programs need besides: ways that end, a person who holds the robot, keys, time, notes, pen.
NEWER_SKILLS = ("drive_distance", "drive_arc", "go_to", "wait_until_still", "is_bumped")
NEWER_SKILLS += ("is_shaken", "is_tilted", "get_light", "get_line_position", "is_key_pressed")
NEWER_SKILLS += ("get_obstacle_direction", "get_timer", "reset_timer", "show_text", "show_number")
NEWER_SKILLS += ("play_note", "rest", "set_tempo", "pen_down", "pen_up", "set_pen_color")
NEWER_SKILLS += ("send", "received", "message_value")
SKILLS += NEWER_SKILLS
NUMBERS = ("0", "1", "2.5", "1e3", "0xFF", ".5", "5.", "00", "1_000", "40", "40.0", "0.50", "8")
NUMBERS += ("12345678901234567890", "1e999", "20")


class BlockTrees(Trees):
    """Random programs with existing skills, and with numbers that no field can show."""

    skills = SKILLS

    def number(self, _):
        return Number(self.choice(NUMBERS))

    def skill_call(self, depth=2):
        """A call of a skill; half of them have a value for each parameter of its block."""
        call = super().skill_call(depth)
        skill = CONFIGURATIONS.get(call.name)
        if skill is None or self.random.random() < 0.5:
            return call
        return SkillCall(call.name, tuple(self.expression(depth) for _ in skill.parameters))


def as_json(workspace):
    return msgspec.json.encode(workspace).decode()


def through_json(workspace):
    """Return a workspace as the page sends it."""
    return msgspec.json.decode(as_json(workspace), type=Workspace)


def blocks(workspace, shadows=True):
    """Return every block, a parent before its children."""
    found = [block for stack in workspace.stacks for block in stack]
    for block in found:
        for plug in block.inputs.values():
            found += plug.stack
            found += [one for one in (plug.block, shadows and plug.shadow) if one]
    return found


def only(workspace, kind):
    """Return the only block of a type."""
    (found,) = (block for block in blocks(workspace) if block.type == kind)
    return found
