"""Problems of unfinished workspaces, and workspaces that no one could build."""

import json
import random
import sys

import msgspec
import pytest

from learnblock.errors import ProgramError
from learnblock.i18n import Phrase
from learnblock.language import Workspace, check, from_workspace, parse, to_python, to_workspace
from learnblock.language import format as format_program
from learnblock.language.workspace.blocks import Block, BlockComment, Input, Variable
from learnblock.language.workspace.statement_reader import STATEMENTS
from learnblock.language.workspace.value_reader import VALUES
from workspaces import CONFIGURATIONS, BlockTrees, as_json, blocks


def read(*statements, **workspace):
    """The text and the problems of blocks under the start block."""
    start = Block("lb_start", "start", inputs={"DO": Input(stack=list(statements))})
    found = from_workspace(Workspace([[start]], **workspace), CONFIGURATIONS)
    problems = [(block, problem.code) for block, problem in found.problems]
    return format_program(found.program), problems


def number(value, id="n", data=None):  # noqa: A002 - the block's id
    return Block("math_number", id, fields={"NUM": value}, data=data)


def shown(value):
    return Input(shadow=number(value))


def plugged(kind, **fields):
    return Input(block=Block(kind, kind, fields=fields))


X = [Variable("x", "x")]


def of_x(kind, name, value):
    return Block(kind, "b", fields={"VAR": {"id": "x"}}, inputs={name: value} if value else {})


@pytest.mark.parametrize(
    ("block", "text"),
    [
        (Block("controls_repeat_ext", "b"), "repeat 0:\n    pass\nend\n"),
        (Block("text_print", "b"), 'print("")\n'),
        (of_x("variables_set", "VALUE", None), "x = None\n"),
        (of_x("controls_forEach", "LIST", None), "for x in []:\n    pass\nend\n"),
    ],
)
def test_an_empty_input_is_a_problem_of_its_block_and_is_replaced(block, text):
    assert (text, [("b", "missing-value")]) == read(block, variables=X)


@pytest.mark.parametrize(
    ("block", "text"),
    [
        (Block("controls_if", "b"), "if False:\n    pass\nend\n"),
        (Block("controls_whileUntil", "b"), "while False:\n    pass\nend\n"),
        (
            of_x("variables_set", "VALUE", plugged("logic_negate")),
            "x = not False\n",
        ),
    ],
)
def test_an_empty_condition_is_false_with_a_warning(block, text):
    start = Block("lb_start", "start", inputs={"DO": Input(stack=[block])})
    found = from_workspace(Workspace([[start]], X), CONFIGURATIONS)
    assert format_program(found.program) == text
    ((_, problem),) = found.problems
    assert (problem.code, problem.severity) == ("missing-condition", "warning")


def test_a_disabled_value_counts_as_missing():
    off = Block("lb_skill_is_any_tag", "off", disabledReasons=["MANUALLY_DISABLED"])
    block = Block("controls_if", "b", inputs={"IF0": Input(block=off)})
    assert ("if False:\n    pass\nend\n", [("b", "missing-condition")]) == read(block)


@pytest.mark.parametrize(
    ("block", "problem"),
    [
        (Block("nonsense", "b"), "unknown-block"),
        (Block("math_number", "b"), "unknown-block"),
        (Block("lb_skill_nonsense", "b"), "unknown-skill"),
        (Block("lb_import", "b", fields={"MODULE": "../dance.py"}), "import-name"),
        (Block("lb_activate", "b", fields={"WHEN": "no name"}), "bad-name"),
        (Block("lb_activate", "b", fields={"WHEN": "end"}), "bad-name"),
        (Block("controls_flow_statements", "b", fields={"FLOW": "STOP"}), "unknown-choice"),
        (Block("lb_do", "b", inputs={"VALUE": plugged("logic_null")}), "no-effect"),
        (of_x("math_change", "DELTA", Input(block=number("many", "b"))), "bad-number"),
        (Block("math_change", "b", inputs={"DELTA": shown(1)}), "unknown-variable"),
    ],
)
def test_a_block_that_cannot_be_read_is_a_problem(block, problem):
    text, problems = read(block, variables=X)
    assert [("b", problem)] == problems
    assert text == format_program(parse(text))


def test_an_invalid_name_is_replaced_by_the_most_similar():
    variables = [Variable("mi variable 2º", "x")]
    text, problems = read(of_x("math_change", "DELTA", shown(1)), variables=variables)
    assert ("mi_variable_2o += 1\n", [("b", "bad-name")]) == (text, problems)


def test_a_second_main_is_a_problem_and_ignored():
    stop = Block("lb_skill_stop_bot", "s")
    mains = [
        [Block("lb_main", name, inputs={"DO": Input(stack=[stop])})] for name in ("one", "two")
    ]
    found = from_workspace(Workspace(mains), CONFIGURATIONS)
    assert "main:\n    function.stop_bot()\nend\n" == format_program(found.program)
    assert [("two", "second-main")] == [(block, one.code) for block, one in found.problems]


def test_the_setup_of_the_robot_must_come_first():
    stop = Block("lb_skill_stop_bot", "s")
    setup = Block("lb_setup", "b", extraState={"arguments": 0, "keywords": ["world"]})
    setup.inputs["ARG0"] = Input(block=Block("text", "t", fields={"TEXT": "line"}))
    assert ('robot(world="line")\n\nfunction.stop_bot()\n', []) == read(setup, stop)
    assert ("function.stop_bot()\n", [("b", "misplaced-block")]) == read(stop, setup)


def test_a_stack_without_a_hat_is_not_part_of_the_program():
    loose = Workspace([[Block("nonsense", "b")], []])
    found = from_workspace(loose, CONFIGURATIONS)
    assert ("", ()) == (format_program(found.program), found.problems)


def test_main_is_written_last_wherever_its_stack_is():
    stop = Block("lb_skill_stop_bot", "s")
    main = Block("lb_main", "m", inputs={"DO": Input(stack=[stop])})
    start = Block("lb_start", "t", inputs={"DO": Input(stack=[stop])})
    program = from_workspace(Workspace([[main], [start]]), CONFIGURATIONS).program
    text = "function.stop_bot()\n\nmain:\n    function.stop_bot()\nend\n"
    assert text == format_program(program)


def test_the_setup_of_the_robot_may_be_drawn_below_main():
    setup = Block("lb_setup", "b", extraState={"arguments": 0, "keywords": ["world"]})
    setup.inputs["ARG0"] = Input(block=Block("text", "t", fields={"TEXT": "line"}))
    main = Block("lb_main", "m", inputs={"DO": Input(stack=[Block("lb_skill_stop_bot", "s")])})
    start = Block("lb_start", "u", inputs={"DO": Input(stack=[setup])})
    found = from_workspace(Workspace([[main], [start]]), CONFIGURATIONS)
    text = 'robot(world="line")\n\nmain:\n    function.stop_bot()\nend\n'
    assert (text, ()) == (format_program(found.program), found.problems)


# Blocks as the page creates them.


def skill(name, data=None, **inputs):
    return Block("lb_skill_" + name, "b", inputs=inputs, data=data)


@pytest.mark.parametrize(
    ("block", "text"),
    [
        (skill("move_straight", advSpeed=shown(40)), "move_straight()"),
        (skill("move_straight", advSpeed=shown(50)), "move_straight(50)"),
        (skill("move_straight", '{"given": 1}', advSpeed=shown(40)), "move_straight(40)"),
        (skill("turn", angle=shown(0)), "turn(0)"),
        (skill("move_left", advSpeed=shown(20), rotSpeed=shown(-15)), "move_left()"),
        (skill("move_left", advSpeed=shown(20), rotSpeed=shown(-9)), "move_left(rotSpeed=-9)"),
        (skill("move_left", advSpeed=shown(9), rotSpeed=shown(-9)), "move_left(9, -9)"),
    ],
)
def test_an_argument_at_its_default_is_omitted(block, text):
    assert (f"function.{text}\n", []) == read(block)


@pytest.mark.parametrize(
    ("block", "text"),
    [
        (plugged("lists_getIndex", MODE="GET", WHERE="FIRST"), "[][0]"),
        (plugged("lists_getIndex", MODE="GET", WHERE="LAST"), "[][-1]"),
        (plugged("lists_getIndex", MODE="GET", WHERE="RANDOM"), "choice([])"),
        (plugged("lists_getIndex", MODE="GET_REMOVE", WHERE="LAST"), "pop([])"),
        (plugged("math_single", OP="POW10"), "10 ** 0"),
        (plugged("math_single", OP="NEG"), "-0"),
        (plugged("math_number", NUM=-2.5), "-2.5"),
        (plugged("math_number", NUM=1e300), "1e+300"),
        (plugged("text", TEXT='"'), "'\"'"),
        (plugged("lb_python_value", CODE="{1: 2}"), "`{1: 2}`"),
        (plugged("lb_state", WHEN="seen"), "state_seen"),
    ],
)
def test_every_option_of_a_block_is_read(block, text):
    said, _ = read(of_x("variables_set", "VALUE", block), variables=X)
    assert f"x = {text}\n" == said


def test_until_is_read_as_while_not():
    block = Block("controls_whileUntil", "b", fields={"MODE": "UNTIL"})
    block.inputs["BOOL"] = plugged("logic_boolean", BOOL="TRUE")
    assert ("while not True:\n    pass\nend\n", []) == read(block)


def test_a_note_that_no_longer_matches_its_block_is_ignored():
    block = of_x("math_change", "DELTA", Input(block=number(7, data='{"number": "0xFF"}')))
    assert ("x += 7\n", []) == read(block, variables=X)
    block.inputs["DELTA"] = Input(block=number(255, data='{"number": "0xFF"}'))
    assert ("x += 0xFF\n", []) == read(block, variables=X)


@pytest.mark.parametrize("data", ["", "{", "[]", "null", '{"number": 5}', '{"ends": [9]}', "x"])
def test_foreign_data_is_ignored(data):
    block = of_x("math_change", "DELTA", shown(7))
    block.data = data
    assert ("x += 7\n", []) == read(block, variables=X)


def test_a_users_comment_is_above_its_statement():
    block = of_x("math_change", "DELTA", shown(7))
    block.comment = BlockComment("  one \r\ntwo\0\n")
    assert ("# one\n# two\ufffd\n#\nx += 7\n", []) == read(block, variables=X)
    block.comment = BlockComment("")
    assert ("x += 7\n", []) == read(block, variables=X)


# Workspaces that no one could build.


def nested(depth):
    block = Block("lb_pass", "x")
    for level in range(depth):
        inputs = {"TIMES": shown(2), "DO": Input(stack=[block])}
        block = Block("controls_repeat_ext", f"b{level}", inputs=inputs)
    return block


def negated(depth):
    block = Block("logic_null", "x")
    for level in range(depth):
        block = Block("logic_negate", f"b{level}", inputs={"BOOL": Input(block=block)})
    return Block("lb_do", "do", inputs={"VALUE": Input(block=block)})


@pytest.mark.parametrize("block", [nested(150), negated(220)])
def test_too_deeply_nested_blocks_are_a_problem(block):
    text, problems = read(block)
    assert "too-deep" in {code for _, code in problems}
    parse(text)


@pytest.mark.parametrize("block", [nested(60), negated(120)])
def test_blocks_beyond_the_stack_of_python_are_a_program_error(block):
    depth, frame = 0, sys._getframe()
    while frame:
        depth, frame = depth + 1, frame.f_back
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(depth + 90)
    try:
        with pytest.raises(ProgramError) as error:
            read(block)
    finally:
        sys.setrecursionlimit(limit)
    assert [Phrase("workspace-too-deep")] == [one.message for one in error.value.diagnostics]


def test_absurd_numbers_of_inputs_are_handled_quickly():
    many = 10**9
    for kind, extra in (
        ("controls_if", {"elseIfCount": many}),
        ("lb_call", {"name": "f", "arguments": many, "keywords": []}),
    ):
        _, problems = read(Block(kind, "b", extraState=extra))
        assert 100 == len(problems)


JUNK = [
    None, "", 0, -1, 1.5, True, [], {}, "x", "my var", "end", "controls_if", "lb_main", "lb_when",
    "lb_setup", "variables_get", "math_number", 10**9, "\x00", "a\nb", [1, 2], {"id": "v1"},
    {"id": "nobody"}, "FROM_END", "LAST", "RANDOM", "FIRST", "GET_REMOVE", "INSERT", "UNTIL", "NEG",
    "function.end", "function.", "function.elapsedTime", '{"above":1}', '{"unfinished":true}',
    '{"given":5,"keywords":["x"]}', '{"blank":true}', ["MANUALLY_DISABLED"], [{"a": 1}],
]  # fmt: skip
TYPES = [*STATEMENTS, *VALUES]


def slots(value):
    """Every position in JSON: its container and its key."""
    found = []
    ahead = [value]
    while ahead:
        holder = ahead.pop()
        names = holder if isinstance(holder, dict) else range(len(holder))
        found += [(holder, name) for name in names]
        ahead += [holder[name] for name in names if isinstance(holder[name], dict | list)]
    return found


def broken(text, chance):
    """JSON with random damage."""
    value = json.loads(text)
    for _ in range(chance.randint(1, 6)):
        places = slots(value)
        holder, name = chance.choice(places)
        other, from_there = chance.choice(places)
        what = chance.random()
        if what < 0.3:
            holder[name] = json.loads(json.dumps(other[from_there]))
        elif what < 0.4 and isinstance(holder, dict):
            del holder[name]
        elif what < 0.7:
            holder[name] = json.loads(json.dumps(chance.choice(JUNK)))
        elif isinstance(holder, list):
            chance.shuffle(holder)
        elif "type" in holder:
            holder["type"] = chance.choice(TYPES)
    return value


def decodable(seed):
    """A random damaged workspace that can still be decoded."""
    chance = random.Random(seed)  # noqa: S311 - no secret
    program = BlockTrees(seed).program()
    text = as_json(to_workspace(program, CONFIGURATIONS).workspace)
    for _ in range(100):
        try:
            return msgspec.convert(broken(text, chance), Workspace)
        except (msgspec.ValidationError, ValueError, IndexError):
            continue
    raise AssertionError("nothing can be decoded")


@pytest.mark.parametrize("start", range(0, 200, 50))
def test_any_decodable_workspace_can_be_written_and_edited(start):
    for seed in range(start, start + 50):
        workspace = decodable(seed)
        program = from_workspace(workspace, CONFIGURATIONS).program
        # A program of raw Python alone is written unchanged.
        if len(program.items) > 1:
            assert program == parse(format_program(program))
        to_python(program)
        check(program, CONFIGURATIONS)
        for edited in (program, BlockTrees(seed + 1).program()):
            after = to_workspace(edited, CONFIGURATIONS, workspace).workspace
            assert edited == from_workspace(after, CONFIGURATIONS).program
            assert len({block.id for block in blocks(after)}) == len(blocks(after))
            as_json(after)
