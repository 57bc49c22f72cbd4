import pytest

from learnblock.devices import Speaker


@pytest.mark.parametrize(
    ("skill", "args", "command"),
    [
        ("say_Text", ("hello",), ("Speaker.say", "hello")),
        ("say_Text", (42,), ("Speaker.say", "42")),
        ("play_audio", (), ("Speaker.play", "Do")),
        ("play_frequency", (440, 500), ("Speaker.tone", 440, 500)),
    ],
)
def test_a_sound_is_made(robot, skill, args, command):
    getattr(robot, skill)(*args)

    assert [command] == robot.commands


def test_a_speaker_that_cannot_speak_stays_silent(robot):
    del robot.device(Speaker).functions["say"]
    robot.say_Text("hello")

    assert [] == robot.commands
