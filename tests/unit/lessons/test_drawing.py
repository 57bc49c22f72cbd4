"""Programs are drawn as blocks, each with its line."""

from learnblock.lessons.drawing import drawing_of

PROGRAM = """\
# Four sides

main:
    repeat 4:
        function.move_straight(200)

        function.turn(90)
    end
end
"""


def test_each_statement_of_a_drawing_has_its_line():
    drawing = drawing_of(PROGRAM)
    assert sorted(drawing.lines.values()) == [1, 3, 4, 5, 7]


def test_a_program_with_mistakes_is_not_drawn():
    assert drawing_of("main:\n    repeat\n") is None
