import pytest

from learnblock.devices import Speaker
from learnblock.testing import FakeRobot


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


@pytest.mark.parametrize(
    ("skill", "arguments", "ability"),
    [
        ("say_Text", ("hi",), "say"),
        ("play_audio", (), "play"),
        ("play_frequency", (440, 100), "tone"),
    ],
)
def test_what_a_speaker_cannot_do_is_reported(skill, arguments, ability):
    noted = []

    class Listener:
        def called(self, skill, args, kwargs):
            pass

        def missing(self, skill, device):
            noted.append((skill, device))

    with FakeRobot(only=[Speaker], observer=Listener()) as robot:
        del robot.device(Speaker).functions[ability]
        getattr(robot, skill)(*arguments)

    assert noted == [(skill, f"Speaker:{ability}")]
