import pytest


@pytest.mark.parametrize(
    ("skill", "args", "command"),
    [
        ("matrix_number", (7,), ("Matrix.number", 7, 4)),
        ("matrix_text", ("Hola Mundo",), ("Matrix.text", "Hola Mundo", 4, 0)),
        ("matrix_text", ("Hi", 9, 99), ("Matrix.text", "Hi", 7, 15)),
        ("matrix_icon", ("heart", 2), ("Matrix.icon", "heart", 2)),
    ],
)
def test_the_matrix_shows_numbers_texts_and_icons(robot, skill, args, command):
    getattr(robot, skill)(*args)

    assert [command] == robot.commands
