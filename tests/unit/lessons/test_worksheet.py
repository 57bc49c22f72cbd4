"""A worksheet has the blocks of each solution to cut out, and says what the lesson says."""

import base64

import pytest

from learnblock.blocks.known import all_configurations
from learnblock.language import parse, to_workspace
from learnblock.lessons.reading import find_lesson, unpack
from learnblock.lessons.worksheet import pieces_of, worksheet
from page_files import content_of
from small_lesson import PICTURE, packed

SQUARE = "1-03-square"


@pytest.fixture(scope="module")
def sheet():
    return content_of(worksheet(find_lesson(SQUARE), "es"))


def types(pieces):
    return sorted(stack[0]["type"] for piece in pieces for stack in piece["stacks"])


def test_it_is_in_the_language_that_was_asked_for(sheet):
    assert sheet["title"] == "Un cuadrado con un bucle"
    assert sheet["palette"]["messages"]["LB_MAIN"] == "al pulsar Ejecutar"


def test_the_blocks_to_cut_out_are_those_of_the_solution(sheet):
    assert types(sheet["steps"][3]["pieces"]) == [
        "controls_repeat_ext",
        "lb_main",
        "lb_skill_drive_distance",
        "lb_skill_turn",
    ]


def test_a_puzzle_has_its_distractors_too(sheet):
    turns = [kind for kind in types(sheet["steps"][2]["pieces"]) if kind == "lb_skill_turn"]
    assert len(turns) == 3


def test_a_step_that_is_done_with_its_own_program_has_nothing_to_cut_out(sheet):
    assert sheet["steps"][1]["pieces"] == []
    assert sheet["steps"][1]["solution"] is None


def test_the_order_is_the_same_each_time_and_not_that_of_the_program(sheet):
    again = content_of(worksheet(find_lesson(SQUARE), "es"))
    step = sheet["steps"][4]
    order = [piece["stacks"][0][0]["id"] for piece in step["pieces"]]
    assert order == [piece["stacks"][0][0]["id"] for piece in again["steps"][4]["pieces"]]
    solution = to_workspace(parse(step["solution"]["text"]), all_configurations()).workspace
    assert order != [block.id for block in pieces_of(solution)]


def test_a_piece_has_its_values_but_nothing_inside():
    program = to_workspace(
        parse("main:\n    repeat 3:\n        print(1)\n    end\nend\n"), all_configurations()
    )
    loop = [*pieces_of(program.workspace)][1]
    assert loop.type == "controls_repeat_ext"
    assert [*loop.inputs] == ["TIMES"]


def test_drawn_programs_are_apart_from_the_text_around_them(sheet):
    kinds = [part["workspace"] is not None for part in sheet["steps"][0]["text"]]
    assert kinds == [False, True]


def test_the_pictures_in_its_texts_are_inside():
    sheet = content_of(worksheet(unpack("small.lesson", packed()), "en"))
    [(name, address)] = sheet["pictures"].items()
    assert name == "start.svg"
    kind, _, data = address.partition(";base64,")
    assert (kind, base64.b64decode(data).decode()) == ("data:image/svg+xml", PICTURE)
    assert any("](start.svg)" in part["text"] for part in sheet["steps"][0]["text"])
