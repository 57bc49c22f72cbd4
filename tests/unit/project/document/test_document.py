import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from learnblock import language, robots, running
from learnblock.blocks import builtin
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.language.tree.nodes import Raw
from learnblock.language.workspace.blocks import Block, Input, Workspace
from learnblock.project.document.document import Document
from learnblock.project.document.views import Place
from places import ROOT, TESTS
from trees import Trees
from workspaces import blocks

EBO = "learnblock.robots.sim_ebo"
THYMIO = "learnblock.robots.sim_thymio"
PROGRAMS = sorted([*(ROOT / "examples").glob("*.bt"), *(TESTS / "cases").glob("*/program.bt")])
SQUARE = """\
times = 0
while times < 4:
    function.move_straight()
    function.turn(90)
    times += 1
end
"""


def document(text=SQUARE, **more):
    return Document.from_text(text, EBO, builtin(), **more)


def shown(one):
    return one.blocktext, one.python, one.workspace


def of_view(one, view):
    return [problem for problem in one.problems if problem.view == view]


def types(workspace):
    return [block.type for stack in workspace.stacks for block in stack]


# The views.


def test_a_program_opens_in_three_notations():
    one = document()
    assert one.blocktext == SQUARE
    assert "    robot.turn(90)\n" in one.python
    assert types(one.workspace) == ["lb_start"]
    assert (one.problems, one.stale, one.first_error) == ((), (), None)


def test_block_text_stays_as_it_was_typed_and_the_others_follow():
    one = document().with_text("blocktext", "x   =  1   # one")
    assert one.blocktext == "x   =  1   # one"
    assert one.python.endswith("\nx = 1  # one\n")
    assert one.origin == "blocktext"


def test_python_stays_as_it_was_typed_and_the_others_follow():
    text = document().python.replace("times += 1", "times+=2 # two")
    one = document().with_text("python", text)
    assert one.python == text
    assert "    times += 2  # two\n" in one.blocktext
    assert one.origin == "python"


def test_a_byte_order_mark_in_python_is_dropped():
    edited = document().with_text("python", "\ufeff" + document().python)
    assert edited.program("mine").python == document().python


def test_blocks_keep_their_positions_and_the_texts_follow():
    other = document("function.turn(45)\n").workspace
    other.stacks[0][0].x, other.stacks[0][0].y = 40.0, 50.0
    one = document().with_blocks(other)
    assert one.workspace is other
    assert one.blocktext == "function.turn(45)\n"
    assert one.python.endswith("\nrobot.turn(45)\n")


def test_a_block_that_is_only_moved_changes_no_text():
    by_hand = document().python.replace("times += 1", "times+=1")
    one = document("times   = 0\n" + SQUARE.partition("\n")[2]).with_text("python", by_hand)
    moved = document().workspace
    moved.stacks[0][0].x = 300.0
    two = one.with_blocks(moved)
    assert (two.blocktext, two.python) == (one.blocktext, by_hand)
    assert two.workspace.stacks[0][0].x == 300.0


def test_spaces_in_one_text_change_neither_the_other_text_nor_the_blocks():
    by_hand = document().python.replace("times += 1", "times+=1")
    one = document().with_text("python", by_hand)
    two = one.with_text("blocktext", SQUARE.replace("times = 0", "times=0"))
    assert (two.python, two.workspace) == (by_hand, one.workspace)


def test_blocks_keep_their_ids_and_positions_through_an_edit_of_the_text():
    one = document()
    one.workspace.stacks[0][0].x = 120.0
    two = one.with_text("blocktext", SQUARE.replace("90", "45"))
    assert two.workspace.stacks[0][0].x == 120.0
    assert {place.block for place in one.places} == {place.block for place in two.places}


def test_an_edit_creates_a_new_document_and_keeps_the_old_one():
    one = document()
    one.with_text("blocktext", "x = 1\n")
    assert one.blocktext == SQUARE


# Mistakes.


@pytest.mark.parametrize(
    ("notation", "stale"),
    [("blocktext", ("blocks", "python")), ("python", ("blocks", "blocktext"))],
)
def test_a_stale_view_keeps_the_last_good_program(notation, stale):
    before = document()
    text = getattr(before, notation) + "while (\n"
    one = before.with_text(notation, text)
    assert getattr(one, notation) == text.removeprefix("\ufeff")
    assert one.stale == stale
    assert one.workspace == before.workspace
    assert one.first_error
    assert {problem.view for problem in one.problems} == {notation}


def test_a_mistake_names_its_block():
    before = document()
    one = before.with_text("blocktext", SQUARE.replace("turn(90)", "turn(90"))
    turn = next(place.block for place in before.places if place.blocktext == 4)
    assert [problem.block for problem in one.problems if problem.line == 4][:1] == [turn]


def test_an_undone_mistake_is_no_longer_reported():
    one = document().with_text("blocktext", SQUARE + "if\n").with_text("blocktext", SQUARE)
    assert (one.stale, one.problems, shown(one)) == ((), (), shown(document()))


def test_editing_another_view_continues_from_the_last_good_program():
    broken = document().with_text("python", "x = (\n")
    one = broken.with_text("blocktext", "y = 2\n")
    assert one.python.endswith("\ny = 2\n")
    assert one.stale == ()


def test_a_block_moved_while_a_text_has_mistakes_does_not_change_that_text():
    broken = document().with_text("blocktext", SQUARE + "if (\n")
    moved = document().workspace
    moved.stacks[0][0].x = 300.0
    one = broken.with_blocks(moved)
    assert one.blocktext == broken.blocktext
    assert one.problems == broken.problems
    assert one.workspace.stacks[0][0].x == 300.0


def half(one):
    """Return blocks of which one has no value yet."""
    body = [*one.workspace.stacks[0][0].inputs["DO"].stack, Block("controls_repeat_ext", "i")]
    return Workspace(
        [[Block("lb_start", "s", inputs={"DO": Input(stack=body)})]], one.workspace.variables
    )


def with_half(one):
    return one.with_blocks(half(one))


def test_a_block_without_its_value_keeps_the_texts():
    before = document()
    workspace = half(before)
    one = before.with_blocks(workspace)
    assert one.workspace is workspace
    assert one.stale == ("blocktext", "python")
    assert [(problem.view, problem.block) for problem in one.problems] == [("blocks", "i")]
    assert one.blocktext == SQUARE


def test_an_empty_if_is_false_with_a_warning_also_when_the_project_is_opened_again():
    stack = [Block("lb_start", "s", inputs={"DO": Input(stack=[Block("controls_if", "i")])})]
    one = document().with_blocks(Workspace([stack]))
    again = document(one.blocktext, workspace=one.workspace)
    for shown in (one, again):
        shown.require_no_errors()
        assert shown.blocktext == "if False:\n    pass\nend\n"
        assert shown.workspace.stacks == [stack]
        assert [(one.severity, one.block) for one in shown.problems] == [("warning", "i")]


def test_an_unknown_name_is_reported_in_both_texts_and_at_its_block():
    one = document("if far > 3:\n    function.turn(90)\nend\n")
    first, second = one.problems
    assert (first.view, first.line, first.column, first.end_column) == ("blocktext", 1, 4, 7)
    assert (second.view, second.line) == ("python", 5)
    assert first.code == second.code == "unknown-name"
    assert first.block == second.block
    assert first.block not in {place.block for place in one.places}


def test_columns_of_hand_written_python_are_in_characters():
    text = document("x = 1\n").python + 'é = "ñ" + far\n'
    one = document().with_text("python", text)
    assert [(problem.line, problem.column) for problem in of_view(one, "python")] == [(6, 11)]


def test_a_message_about_another_line_has_the_line_of_its_own_text():
    one = document("def f():\n    pass\nend\n\ndef f():\n    pass\nend\n")
    assert "1" == of_view(one, "blocktext")[0].message.values["line"]
    assert "6" == of_view(one, "python")[0].message.values["line"]


def test_a_missing_device_of_the_robot_is_reported():
    devices = robots.find("sim-thymio").load().device_names()
    text = "if function.is_any_tag():\n    function.turn(90)\nend\n"
    assert [
        problem.code for problem in document(text).problems if problem.severity == "error"
    ] == []
    one = document(text).with_robot(THYMIO, devices)
    assert {problem.code for problem in one.problems if problem.severity == "error"} == {
        "missing-device"
    }


def test_a_mistake_in_raw_python_is_reported_at_its_line():
    one = document("x = 1\npython:\n    import os\n    x = = 2\nend\n")
    (first,), (second,) = of_view(one, "blocktext"), of_view(one, "python")
    assert one.blocktext.split("\n")[first.line - 1].strip() == "x = = 2"
    assert one.python.split("\n")[second.line - 1].strip() == "x = = 2"


# Raw Python, and the robot.


def test_python_follows_the_chosen_robot():
    one = document().with_robot(THYMIO)
    assert one.python.startswith(f"from {THYMIO} import Robot\n")
    assert shown(one)[0::2] == shown(document())[0::2]


def test_hand_written_python_changes_only_its_robot():
    text = document().python.replace("times += 1", "times+=1")
    one = document().with_text("python", text).with_robot(THYMIO)
    assert one.python == text.replace(EBO, THYMIO)
    assert one.python_by_hand == one.python


def test_python_with_a_mistake_follows_the_robot_too():
    one = document().with_text("python", document().python + "x = (\n").with_robot(THYMIO)
    assert one.python.startswith(f"from {THYMIO} import Robot\n")
    assert one.stale == ("blocks", "blocktext")


def test_choosing_another_robot_does_not_make_python_hand_written():
    text = document().python.replace(EBO, THYMIO)
    assert document().with_text("python", text).python_by_hand is None


def test_hand_written_python_is_generated_again_after_a_change_in_another_view():
    one = document().with_text("python", document().python.replace("times += 1", "times+=1"))
    two = one.with_text("blocktext", SQUARE.replace("90", "45"))
    assert two.python == document(SQUARE.replace("90", "45")).python
    assert two.python_by_hand is None


# Positions.


def test_places_give_the_lines_of_each_statement_in_both_texts():
    one = document("x = 1\nwhile x < 3:\n    x += 1\nend\n")
    places = sorted(
        (place.blocktext, place.blocktext_end, place.python, place.python_end)
        for place in one.places
    )
    assert places == [(1, 1, 5, 5), (2, 4, 6, 7), (3, 3, 7, 7)]


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_places_name_existing_lines_and_each_block_once(path):
    one = document(path.read_text("utf-8"))
    blocktext, python = one.blocktext.count("\n") + 1, one.python.count("\n") + 1
    assert len({place.block for place in one.places}) == len(one.places)
    # In Python, no line says that there is no robot.
    unsaid = {block.id for block in blocks(one.workspace) if block.type == "lb_without_robot"}
    for place in one.places:
        assert 1 <= place.blocktext <= place.blocktext_end <= blocktext
        if place.block in unsaid:
            assert place.python == place.python_end == 0
        else:
            assert 1 <= place.python <= place.python_end <= python


def test_a_line_of_python_belongs_to_its_innermost_block():
    one = document()
    lines = one.python.split("\n")
    for place in one.places:
        assert one.python_line(place.block) == place.python
    turn = lines.index("    robot.turn(90)") + 1
    block = one.block_at(turn)
    assert Place(block, 4, 4, turn, turn) in one.places
    assert one.block_at(1) is None
    assert one.block_at(1000) is None


def test_an_else_belongs_to_its_if():
    one = document("if 1 < 2:\n    x = 1\nelse:\n    x = 2\nend\n")
    lines = one.python.split("\n")
    assert one.block_at(lines.index("else:") + 1) == one.block_at(lines.index("if 1 < 2:") + 1)


def test_places_move_with_the_lines_while_a_text_has_mistakes():
    before = document()
    one = before.with_text("blocktext", "if (\n" + SQUARE)
    moved = {place.block: place.blocktext for place in one.places}
    assert moved == {place.block: place.blocktext + 1 for place in before.places}


# Rename and format.


def test_a_name_is_renamed_in_all_three_views():
    one = document().renamed("variable", "times", "sides")
    assert "times" not in one.blocktext + one.python
    assert [variable.name for variable in one.workspace.variables] == ["sides"]
    assert {place.block for place in one.places} == {place.block for place in document().places}


@pytest.mark.parametrize(("origin", "line"), [("blocktext", "on line 1. "), ("blocks", ". ")])
def test_what_a_connected_robot_lacks_is_said_where_the_author_looks(origin, line):
    one = document("function.set_pen_width(10)\n")
    if origin == "blocks":
        one = one.with_blocks(one.workspace)
    said = str(one.lacking(frozenset({"Base", "Base:ROBOT"})))
    assert said.startswith("The program has an error")
    assert f"{line}This robot has no pen" in said
    assert document().lacking(frozenset({"Base", "Base:ROBOT"})) is None


def test_a_program_with_errors_is_not_renamed():
    with pytest.raises(LearnBlockError) as error:
        document().with_text("blocktext", "if\n").renamed("variable", "times", "sides")
    assert error.value.phrase == Phrase("edit-errors-first", task="rename")


def test_formatting_changes_only_the_block_text():
    ugly = document(SQUARE.replace("    ", " ")).with_text("blocktext", SQUARE.replace("    ", ""))
    one = ugly.formatted()
    assert one.blocktext == SQUARE
    assert (one.python, one.workspace) == (ugly.python, ugly.workspace)


# Saving and opening again.


def reopened(one):
    return Document.from_text(one.blocktext, EBO, builtin(), one.workspace, one.python_by_hand)


def assert_same(one, other):
    assert shown(one) == shown(other)
    assert (one.stale, one.problems, one.places) == (other.stale, other.problems, other.places)


@pytest.mark.parametrize(
    "edit",
    [
        lambda one: one,
        lambda one: one.with_text("blocktext", "x  = 1"),
        lambda one: one.with_text("blocktext", SQUARE + "if\n"),
        lambda one: one.with_text("python", one.python + "y=2\n"),
        lambda one: one.with_text("python", one.python + "y=(\n"),
        lambda one: one.with_text("python", "print(1)\n"),
        lambda one: with_half(one.with_text("python", one.python + "y=2\n")),
        lambda one: one.with_text("python", one.python + "y=2\n").with_text("blocktext", "x  = 1"),
    ],
)
def test_a_document_is_the_same_after_reopening(edit):
    one = edit(document())
    assert_same(one, reopened(one))


def test_python_that_differs_from_the_saved_block_text_is_not_kept():
    one = document(python=document("x = 1\n").python + "# by hand\n")
    assert shown(one) == shown(document())


def test_blocks_nested_too_deeply_are_a_mistake():
    deep = Block("math_number", "n")
    for number in range(240):
        deep = Block("math_single", str(number), fields={"OP": "NEG"}, inputs={"NUM": Input(deep)})
    call = Block("lb_skill_turn", "c", inputs={"angle": Input(deep)})
    workspace = Workspace([[Block("lb_start", "s", inputs={"DO": Input(stack=[call])})]])
    one = document(workspace=workspace)
    assert one.stale == ("blocktext", "python")
    assert [problem.code for problem in one.problems] == ["too-deep"]
    assert one.blocktext == SQUARE


def test_a_file_that_cannot_be_parsed_shows_its_valid_parts_in_the_other_views():
    one = document("x = 1\ny = (\n")
    assert one.stale == ("blocks", "python")
    assert one.python.endswith("\nx = 1\n")


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: f"{path.parent.name}-{path.stem}")
def test_every_program_is_the_same_from_each_of_its_views(path):
    assert_same_from_each_view(document(path.read_text("utf-8")))


@given(st.integers(min_value=0))
@settings(max_examples=100)
def test_random_programs_are_the_same_from_each_of_their_views(seed):
    program = Trees(seed).program()
    # A single block of raw Python is a whole file, which opens as a program without a robot.
    assume([type(item) for item in program.items] != [Raw] or program.main is not None)
    assert_same_from_each_view(document(language.format(program)))


def assert_same_from_each_view(one):
    assert one.stale == ()
    assert shown(one) == shown(one.with_blocks(one.workspace))
    assert shown(one) == shown(one.with_text("python", one.python))
    assert one.python_by_hand is None
    assert_same(one, reopened(one))


@given(st.text(max_size=60), st.sampled_from(["blocktext", "python"]))
@settings(max_examples=100)
def test_any_typed_text_becomes_a_document(text, notation):
    one = document().with_text(notation, text)
    assert getattr(one, notation) == text.removeprefix("\ufeff")
    assert one.first_error or not one.stale
    assert one.places is not None


# Running.


def test_the_same_program_runs_as_on_the_command_line(tmp_path):
    bt, py = tmp_path / "p.bt", tmp_path / "p.py"
    by_hand = document().with_text("python", document().python.replace("times += 1", "times+=1"))
    bt.write_text(SQUARE)
    py.write_text(by_hand.python)
    entry = robots.find("sim-ebo")
    for path, one in ((bt, document()), (py, by_hand)):
        expected = running.program(running.read(path), entry)
        program = one.program("p")
        assert (expected.python, expected.identity) == (program.python, program.identity)


def test_a_run_from_the_page_has_the_trace_of_the_command_line(tmp_path):
    path = tmp_path / "p.bt"
    path.write_text(SQUARE)
    entry = robots.find("sim-ebo")
    hashes = {
        running.ProgramRun(running.Job(program, entry)).run().trace_sha256
        for program in (
            running.program(running.read(path), entry),
            document().program("p"),
            document("x = 1\n").with_blocks(document().workspace).program("p"),
            document("x = 1\n").with_text("python", document().python).program("p"),
        )
    }
    assert len(hashes) == 1


@pytest.mark.parametrize("notation", ["blocktext", "python"])
def test_removing_the_line_without_robot_adds_a_robot(notation):
    plain = document("without robot\n\nfunction.turn(90)  # go\n")
    written = plain.with_text(notation, getattr(plain, notation) + "\n")
    assert {found.message.code for found in written.problems} <= {
        "check-without-robot",
        "python-no-robot",
    }
    ready = written.with_text("blocktext", written.blocktext.removeprefix("without robot\n\n"))
    assert ready.problems == ()
    assert ready.python.endswith("import Robot\n\nrobot = Robot()\n\nrobot.turn(90)  # go\n")
