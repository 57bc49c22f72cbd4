"""Notes and beats, with the tones that a speaker is told to play."""

import pytest

from learnblock.devices import Speaker
from learnblock.devices.notes import NOTES
from learnblock.errors import UnknownNameError
from learnblock.testing import FakeRobot


def frequency(note):
    """Return the frequency of the tone that a note makes."""
    with FakeRobot() as robot:
        robot.play_note(note)
        [(_, hertz, _)] = robot.commands
    return hertz


def test_a_note_sounds_for_its_beats_less_a_gap_and_the_program_waits_for_them(robot):
    robot.play_note("A4", 2)
    assert robot.commands == [("Speaker.tone", 440.0, 900.0)]
    assert robot.clock.time() == pytest.approx(1)


def test_the_tempo_decides_how_long_a_beat_is(robot):
    robot.set_tempo(60)
    robot.play_note("C4")
    robot.rest(0.5)
    assert robot.clock.time() == pytest.approx(1.5)


@pytest.mark.parametrize(("bpm", "seconds"), [(1, 3), (100_000, 0.12)])
def test_the_tempo_stays_within_its_limits(robot, bpm, seconds):
    robot.set_tempo(bpm)
    robot.rest()
    assert robot.clock.time() == pytest.approx(seconds)


@pytest.mark.parametrize(
    ("note", "hertz"),
    [
        ("C4", 261.63),
        ("A3", 220),
        ("A#4", 466.16),
        ("Bb4", 466.16),
        ("Cb4", 246.94),
        ("B8", 7902.13),
    ],
)
def test_a_note_has_the_frequency_of_equal_temperament(note, hertz):
    assert frequency(note) == hertz


def test_an_octave_doubles_the_frequency_and_the_notes_of_the_menu_ascend():
    pairs = zip(NOTES[:17], NOTES[17:34], strict=True)
    for low, high in pairs:
        assert frequency(high) == pytest.approx(2 * frequency(low), rel=1e-4)
    heard = [frequency(note) for note in NOTES]
    assert heard == sorted(heard)


@pytest.mark.parametrize("note", ["H4", "C", "C9", "do", 4, "C##4"])
def test_an_unknown_note_is_refused(robot, note):
    with pytest.raises(UnknownNameError, match="There is no note"):
        robot.play_note(note)


def test_a_robot_without_a_speaker_keeps_the_time_of_the_melody():
    with FakeRobot(only=[]) as robot:
        robot.play_note("C4", 4)
        assert robot.clock.time() == pytest.approx(2)


def test_a_speaker_without_tones_is_reported():
    noted = []

    class Listener:
        def called(self, skill, args, kwargs):
            pass

        def missing(self, skill, device):
            noted.append((skill, device))

    with FakeRobot(only=[Speaker], observer=Listener()) as robot:
        del robot.device(Speaker).functions["tone"]
        robot.play_note()
    assert noted == [("play_note", "Speaker:tone")]


def test_the_block_offers_the_notes_in_the_order_of_the_scale():
    from learnblock.blocks import builtin

    [note, _] = builtin()["play_note"].parameters
    assert note.choices == NOTES
