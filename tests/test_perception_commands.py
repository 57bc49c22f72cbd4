"""Perception on the command line: its settings, and components."""

import json

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.vision import TABLE


def call(*arguments, **options):
    return CliRunner().invoke(main, ["perception", *arguments], **options)


def test_the_settings_are_listed_with_what_they_may_be():
    listed = call().output
    assert "emotions_on_cameras  False" in listed
    assert "HOST:PORT of a component" in listed
    names = [one["name"] for one in json.loads(call("--json").output)]
    assert names[:2] == ["emotions_on_cameras", "apriltag"]


def test_a_setting_is_changed_and_put_back():
    assert "[default: none]" in call("set", "webcam", "0").output
    assert TABLE.load().webcam == 0
    assert call("set", "webcam", "--default").exit_code == 0
    assert TABLE.load().webcam == "none"


@pytest.mark.parametrize("answer", ["n\n", "\n", ""])
def test_emotions_stay_off_until_somebody_has_read_why_and_says_yes(answer):
    result = call("set", "emotions_on_cameras", "true", input=answer)
    assert "5(1)(f) of the AI Act" in result.output
    assert result.exit_code == 1
    assert not TABLE.load().emotions_on_cameras


def test_who_says_yes_switches_emotions_on():
    assert call("set", "emotions_on_cameras", "true", input="y\n").exit_code == 0
    assert TABLE.load().emotions_on_cameras


def test_a_script_says_yes_beforehand_and_is_told_why_all_the_same():
    result = call("set", "emotions_on_cameras", "true", "--yes")
    assert "5(1)(f) of the AI Act" in result.stderr
    assert TABLE.load().emotions_on_cameras


def test_nobody_is_asked_who_switches_emotions_off():
    TABLE.change("emotions_on_cameras", "true")
    assert "AI Act" not in call("set", "emotions_on_cameras", "false").stderr
    assert not TABLE.load().emotions_on_cameras


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("set", "webcam", "front"), '`webcam` is "front": expected a whole number from 0 to 63'),
        (("set", "apriltag", "here"), '`apriltag` is "here": expected a text'),
        (("set", "webcm", "0"), "did you mean `webcam`?"),
        (("set", "webcam"), "give either a VALUE or --default"),
        (("set", "webcam", "0", "--default"), "give either a VALUE or --default"),
    ],
)
def test_what_cannot_be_is_told_in_a_sentence(arguments, sentence):
    result = call(*arguments)
    assert result.exit_code != 0
    assert sentence in result.output
    assert "Traceback" not in result.output
