"""Blocks and positions are kept when a program is edited as text."""

import pytest

from learnblock.language import Workspace, from_workspace, parse, to_workspace
from learnblock.language import format as format_program
from learnblock.language.workspace.blocks import Block, BlockComment, Input, Variable
from workspaces import CONFIGURATIONS, blocks, only, through_json

PROGRAM = """\
import "dance"

times = 0

# Drives along one side.
def side(length):
    function.move_straight(length)
    function.sleep(length / 40)  # there
    if function.is_any_tag():
        function.stop_bot()
    else:
        side(length - 1)
    end
end

when start:
    side(40)
end

main:
    while times < 4:
        side(200)
        function.turn(90)
        times += 1
    end
end
"""


@pytest.fixture
def before():
    """The workspace of the program, with each stack at its own position."""
    workspace = through_json(to_workspace(parse(PROGRAM), CONFIGURATIONS).workspace)
    for place, stack in enumerate(workspace.stacks):
        stack[0].x, stack[0].y = 10.0 * place, 100.0 * place
    return workspace


def edited(before, old, new):
    assert old in PROGRAM
    program = parse(PROGRAM.replace(old, new))
    workspace = to_workspace(program, CONFIGURATIONS, before).workspace
    assert program == from_workspace(workspace, CONFIGURATIONS).program
    return workspace


def ids(workspace):
    return {block.id for block in blocks(workspace)}


def places(workspace):
    return {stack[0].id: (stack[0].x, stack[0].y) for stack in workspace.stacks}


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("side(200)", "side(300)"),
        ("times < 4", "times < 5"),
        ("times < 4", "times > 4"),
        ("times = 0", "times = 10"),
        ("length / 40", "length / 41"),
        ('"dance"', '"waltz"'),
        ("# there", "# here"),
        ("# there", ""),
        ("# Drives along one side.", "# Drives."),
        ("when start", "when begin"),
        ("def side(length)", "def side(long)"),
        ("function.turn(90)\n", "function.turn(90)\n\n"),
    ],
)
def test_a_change_keeps_every_block_and_position(before, old, new):
    after = edited(before, old, new)
    assert ids(before) == ids(after)
    assert places(before) == places(after)
    assert before != after


def test_a_function_renamed_alone_keeps_all_but_its_calls(before):
    after = edited(before, "def side", "def edge")
    calls = {block.id for block in blocks(before) if block.type == "procedures_callnoreturn"}
    assert ids(before) - calls == ids(before) & ids(after)


def test_a_function_renamed_everywhere_keeps_every_block(before):
    program = parse(PROGRAM.replace("side", "edge"))
    after = to_workspace(program, CONFIGURATIONS, before).workspace
    assert ids(before) == ids(after)
    assert places(before) == places(after)


@pytest.mark.parametrize(
    ("line", "where"),
    [
        ("function.turn_left()\n", "function.turn(90)\n"),
        ("x = [1, 2]\n", "side(40)\n"),
        ("while True:\npass\nend\n", "while times < 4:\n"),
        ("def more():\npass\nend\n", "when start:\n"),
        ("def more():\npass\nend\n", "# Drives along"),
        ("when more:\npass\nend\n", "main:\n"),
        ("side(1)\n", "when start:\n"),
        ("side(1)\n", "times = 0\n"),
    ],
)
def test_adding_or_removing_a_line_keeps_all_others(before, line, where):
    more = edited(before, where, line + where)
    assert ids(before) < ids(more)
    assert places(before).items() <= places(more).items()
    less = to_workspace(parse(PROGRAM), CONFIGURATIONS, more).workspace
    assert before == less


def test_a_comment_at_the_end_is_a_comment_outside_of_any_hat(before):
    after = edited(before, PROGRAM, PROGRAM + "\n# bye\n")
    assert ["lb_comment"] == [block.type for block in after.stacks[-1]]
    assert PROGRAM + "\n# bye\n" == format_program(from_workspace(after, CONFIGURATIONS).program)


def test_a_comment_that_the_user_put_outside_stays_there_when_the_text_changes(before):
    note = Block("lb_comment", "note", x=500, y=20, fields={"TEXT": "look"})
    before.stacks.insert(0, [note])
    program = from_workspace(before, CONFIGURATIONS).program
    text = format_program(program)
    after = to_workspace(parse(text.replace("90", "80")), CONFIGURATIONS, before).workspace
    assert text.startswith("# look\n\nimport")
    assert [note] == after.stacks[0]
    assert places(before) == places(after)


def test_a_comment_above_loose_blocks_is_no_part_of_the_program(before):
    loose = [Block("lb_comment", "note", fields={"TEXT": "later"}), Block("lb_pass", "pass")]
    program = from_workspace(before, CONFIGURATIONS).program
    before.stacks.append(loose)
    assert program == from_workspace(before, CONFIGURATIONS).program
    assert loose == to_workspace(program, CONFIGURATIONS, before).workspace.stacks[-1]


def test_the_page_chooses_the_position_of_a_new_stack(before):
    more = edited(before, "main:\n", "when more:\npass\nend\nmain:\n")
    new = [stack[0] for stack in more.stacks if stack[0].id not in ids(before)]
    assert [("lb_when", None, None)] == [(block.type, block.x, block.y) for block in new]


def test_a_value_put_into_another_stays_a_block(before):
    after = edited(before, "side(length - 1)", "side(abs(length - 1))")
    assert ids(before) < ids(after)


def test_a_function_moved_past_another_keeps_its_position(before):
    start = "when start:\n    side(40)\nend\n"
    moved = PROGRAM.replace(start, "").replace("# Drives", start + "\n# Drives")
    after = to_workspace(parse(moved), CONFIGURATIONS, before).workspace
    assert ids(before) == ids(after)
    assert places(before) == places(after)


def test_removing_one_of_many_equal_lines_keeps_the_others():
    text = "function.stop_bot()\n"
    before = to_workspace(parse(text * 9), CONFIGURATIONS).workspace
    after = to_workspace(parse(text * 8), CONFIGURATIONS, before).workspace
    assert ids(after) < ids(before)


def test_the_appearance_of_a_block_is_kept(before):
    loop = only(before, "controls_whileUntil")
    loop.collapsed, loop.inline = True, False
    function = only(before, "procedures_defnoreturn")
    function.comment = BlockComment("Drives along one side.", pinned=True, width=300, height=90)
    after = edited(before, "times < 4", "times < 5")
    assert (True, False) == (only(after, loop.type).collapsed, only(after, loop.type).inline)
    after = edited(before, "# Drives along one side.", "# Drives.")
    expected = BlockComment("Drives.", pinned=True, width=300, height=90)
    assert expected == only(after, function.type).comment


def test_two_stacks_of_statements_stay_two(before):
    start = before.stacks[0][0]
    second = Block("lb_start", "second", x=500, y=500)
    second.inputs["DO"] = Input(stack=[start.inputs["DO"].stack.pop()])
    before.stacks.insert(1, [second])
    after = edited(before, "times = 0", "times = 1\nx = 2")
    tops = [stack[0] for stack in after.stacks if stack[0].type == "lb_start"]
    assert [start.id, "second"] == [top.id for top in tops]
    assert [1, 2] == [len(top.inputs["DO"].stack) for top in tops]


def test_loose_blocks_and_empty_hats_stay(before):
    loose = [
        Block("lb_skill_turn", "loose", x=1, y=2),
        Block("variables_get", "get", fields={"VAR": {"id": "mine"}}),
    ]
    before.variables.append(Variable("mine", "mine"))
    before.stacks += [loose, [Block("lb_start", "empty")]]
    after = edited(before, "times < 4", "times < 5")
    assert before.stacks[-2:] == after.stacks[-2:]
    assert Variable("mine", "mine") in after.variables


def test_a_disabled_block_stays_below_the_one_above_it(before):
    body = only(before, "controls_whileUntil").inputs["DO"].stack
    off = Block("lb_skill_stop_bot", "off", disabledReasons=["MANUALLY_DISABLED"])
    body.insert(1, off)
    after = edited(before, "        function.turn(90)\n", "")
    kept = only(after, "controls_whileUntil").inputs["DO"].stack
    assert [body[0].id, "off", body[3].id] == [block.id for block in kept]
    gone = edited(before, "        side(200)\n", "")
    assert "off" == only(gone, "controls_whileUntil").inputs["DO"].stack[0].id


def test_a_disabled_function_is_kept_outside_the_program(before):
    stack = next(one for one in before.stacks if one[0].type == "lb_when")
    stack[0].disabledReasons = ["MANUALLY_DISABLED"]
    program = from_workspace(before, CONFIGURATIONS).program
    assert {} == program.whens
    assert stack in to_workspace(program, CONFIGURATIONS, before).workspace.stacks


def test_an_empty_input_stays_empty(before):
    loop = only(before, "controls_whileUntil")
    del loop.inputs["BOOL"]
    program = from_workspace(before, CONFIGURATIONS).program
    after = to_workspace(program, CONFIGURATIONS, before).workspace
    assert before == after
    text = PROGRAM.replace("times < 4", "False").replace("turn(90)", "turn(91)")
    after = to_workspace(parse(text), CONFIGURATIONS, before).workspace
    assert "BOOL" not in only(after, "controls_whileUntil").inputs


def test_a_name_typed_letter_by_letter_leaves_no_variables_behind():
    workspace = Workspace(variables=[Variable("mine", "mine")])
    for name in ("c", "co", "cou", "count"):
        workspace = to_workspace(parse(f"{name} = 1\n"), CONFIGURATIONS, workspace).workspace
    assert ["mine", "count"] == [variable.name for variable in workspace.variables]
    assert 1 == len(workspace.stacks)


def test_a_shadow_of_the_page_shows_another_number_of_the_text():
    zero = Input(shadow=Block("math_number", "zero", fields={"NUM": 0}))
    change = Block("variables_set", "set", fields={"VAR": {"id": "x"}}, inputs={"VALUE": zero})
    start = Block("lb_start", "start", inputs={"DO": Input(stack=[change])})
    before = Workspace([[start]], [Variable("x", "x")])
    text = format_program(from_workspace(before, CONFIGURATIONS).program)

    after = to_workspace(parse(text.replace("0", "5")), CONFIGURATIONS, before).workspace

    shown = only(after, "variables_set").inputs["VALUE"]
    assert (None, "zero", {"NUM": 5}) == (shown.block, shown.shadow.id, shown.shadow.fields)


def test_a_state_block_comes_with_its_when():
    before = to_workspace(parse("x = state_seen\n"), CONFIGURATIONS).workspace
    assert {"variables_set", "variables_get", "lb_start"} == {one.type for one in blocks(before)}
    text = "x = state_seen\nwhen seen:\npass\nend\n"
    after = to_workspace(parse(text), CONFIGURATIONS, before).workspace
    assert "seen" == only(after, "lb_state").fields["WHEN"]


def test_a_loop_with_true_in_its_slot_stays_one_when_its_inside_changes():
    always = Block("logic_boolean", "true", fields={"BOOL": "TRUE"})
    inputs = {"BOOL": Input(always), "DO": Input(stack=[Block("lb_pass", "p")])}
    loop = Block("controls_whileUntil", "loop", fields={"MODE": "WHILE"}, inputs=inputs)
    before = Workspace([[Block("lb_main", "main", inputs={"DO": Input(stack=[loop])})]])
    text = format_program(from_workspace(before, CONFIGURATIONS).program)

    program = parse(text.replace("pass", "break"))
    after = to_workspace(program, CONFIGURATIONS, before).workspace

    assert "main:\n    forever:\n        pass\n    end\nend\n" == text
    assert "loop" == only(after, "controls_whileUntil").id
    assert "true" == only(after, "logic_boolean").id


@pytest.mark.parametrize(("old", "new"), [("forever", "while x > 3"), ("while x > 3", "forever")])
def test_a_loop_that_gets_or_loses_its_condition_keeps_what_is_inside(old, new):
    text = f"x = 1\n{old}:\n    x = 2\n    x += 3\nend\n"
    before = to_workspace(parse(text), CONFIGURATIONS).workspace

    program = parse(text.replace(old, new))
    after = to_workspace(program, CONFIGURATIONS, before).workspace

    assert only(before, "math_change") == only(after, "math_change")


def joined(*parts):
    """Return a workspace that prints a text of the given blocks."""
    inputs = {f"ADD{place}": Input(part) for place, part in enumerate(parts)}
    text = Block("text_join", "j", inputs=inputs, extraState={"itemCount": len(parts)})
    printed = Block("text_print", "p", inputs={"TEXT": Input(text)})
    return Workspace([[Block("lb_main", "main", inputs={"DO": Input(stack=[printed])})]])


def word(text, key):
    return Block("text", key, fields={"TEXT": text})


def test_texts_side_by_side_are_one_and_stay_blocks_when_something_else_changes():
    two = Block("math_number", "n", fields={"NUM": 2})
    before = joined(word("a", "1"), word("{b}", "2"), two, word("", "3"))
    text = format_program(from_workspace(before, CONFIGURATIONS).program)

    after = to_workspace(parse(text + "x = 1\n"), CONFIGURATIONS, before).workspace

    assert 'main:\n    print(f"a{{b}}{2}")\nend\n' == text
    assert only(before, "text_join") == only(after, "text_join")


def test_a_value_that_no_f_string_can_have_is_added_to_the_text():
    items = {"ADD0": Input(word("\\", "s"))}
    upper = Block("text_changeCase", "u", fields={"CASE": "UPPERCASE"})
    upper.inputs["TEXT"] = Input(Block("text_join", "i", inputs=items, extraState={"itemCount": 1}))

    found = from_workspace(joined(word("a ", "1"), upper), CONFIGURATIONS)

    assert 'main:\n    print("a " + str(upper(f"\\\\")))\nend\n' == format_program(found.program)


def test_an_empty_slot_in_a_text_is_reported_and_counts_as_no_text():
    before = joined(word("a", "1"))
    only(before, "text_join").extraState = {"itemCount": 2}
    found = from_workspace(before, CONFIGURATIONS)
    assert 'main:\n    print(f"a")\nend\n' == format_program(found.program)
    assert ["missing-value"] == [problem.code for _, problem in found.problems]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("x = {}\ny = x[z]\n", "lb_dictionary_get"),
        ('y = x["a"]\n', "lb_dictionary_get"),
        ("y = x[z]\n", "lists_getIndex"),
        ("x = {}\nx[z] = 1\n", "lb_dictionary_set"),
        ('x["a"] += 1\n', "lb_dictionary_change"),
        ("x[1] += 1\n", "lb_change_index"),
        ('pop(x, "a")\n', "lb_dictionary_remove"),
        ("pop(x, 1)\n", "lists_getIndex"),
        ('y = pop(x, "a")\n', "lb_call_value"),
        ("y = keys(x)\n", "lb_dictionary_keys"),
    ],
)
def test_a_key_has_a_block_of_dictionaries_and_a_position_one_of_lists(text, kind):
    found = to_workspace(parse(text), CONFIGURATIONS).workspace
    assert kind == only(found, kind).type
    assert text == format_program(from_workspace(found, CONFIGURATIONS).program)


def test_an_entry_of_a_dictionary_without_a_variable_is_reported():
    block = Block("lb_dictionary_set", "s")
    before = Workspace([[Block("lb_main", "main", inputs={"DO": Input(stack=[block])})]])
    problems = from_workspace(before, CONFIGURATIONS).problems
    assert ["s"] * 3 == [block for block, _ in problems]


HAT = "when near = function.is_front_obstacle(150):\n    function.stop_bot()\nend\n"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("(150)", "(200)"),
        ("when near", "when close"),
        ("function.is_front_obstacle(150)", "function.is_bumped()"),
        ("function.is_front_obstacle(150)", "not function.is_bumped()"),
    ],
)
def test_an_event_keeps_its_place_and_its_blocks_whatever_its_condition_becomes(old, new):
    before = to_workspace(parse(HAT), CONFIGURATIONS).workspace
    before.stacks[0][0].x = 70.0
    program = parse(HAT.replace(old, new))
    after = to_workspace(program, CONFIGURATIONS, before).workspace
    (was,), (hat,) = before.stacks[0], after.stacks[0]
    assert program == from_workspace(after, CONFIGURATIONS).program
    assert (was.id, was.x, was.inputs["DO"]) == (hat.id, hat.x, hat.inputs["DO"])


def test_an_event_that_was_made_with_a_condition_does_not_become_a_ready_hat():
    condition = Block("lb_skill_is_bumped", "asked")
    event = Block(
        "lb_when",
        "own",
        fields={"NAME": "ouch"},
        inputs={"CONDITION": Input(block=condition)},
        extraState={"condition": True},
    )
    own = Workspace([[event]], [])
    program = parse("when oh = function.is_bumped():\n    pass\nend\n")
    assert "lb_when" == to_workspace(program, CONFIGURATIONS, own).workspace.stacks[0][0].type
    assert "lb_when_is_bumped" == to_workspace(program, CONFIGURATIONS).workspace.stacks[0][0].type


def test_what_a_call_begins_with_stays_with_a_function_whose_text_changes(before):
    side = next(stack[0] for stack in before.stacks if stack[0].type == "procedures_defnoreturn")
    side.extraState["params"][0]["sample"] = 25
    after = edited(before, "length / 40", "length / 41")
    (parameter,) = only(after, "procedures_defnoreturn").extraState["params"]
    assert ("length", 25) == (parameter["name"], parameter["sample"])
