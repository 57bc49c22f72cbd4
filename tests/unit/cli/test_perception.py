"""Perception on the command line: its settings, and components."""

import json
import re
import signal
import subprocess
import sys

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.cli.console import ExitCode
from learnblock.ice import Proxy
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.ice.robocomp.recognition import Picture
from learnblock.perception.sources import TABLE
from shown_pictures import TAG_AT, a_tag


def call(*arguments, **options):
    return CliRunner().invoke(main, ["perception", *arguments], **options)


def test_the_settings_are_listed_with_their_allowed_values():
    listed = call().output
    assert "emotions_on_cameras  False" in listed
    assert "HOST:PORT of a component" in listed
    assert "5(1)(f) of the AI Act" in listed
    names = [one["name"] for one in json.loads(call("--json").output)]
    assert names[:2] == ["emotions_on_cameras", "apriltag"]


def test_a_setting_is_changed_and_restored():
    changed = call("set", "webcam", "0").output
    assert "[default: none]" in changed
    assert "AI Act" not in changed
    assert TABLE.load().webcam == 0
    assert call("set", "webcam", "--default").exit_code == 0
    assert TABLE.load().webcam == "none"


def test_the_path_of_a_video_is_made_absolute(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "lesson.mp4").write_bytes(b"")
    assert call("set", "video", "lesson.mp4").exit_code == 0
    assert TABLE.load().video == str(tmp_path / "lesson.mp4")
    assert "There is no file" in call("set", "video", "other.mp4").stderr
    assert call("set", "video", "").exit_code == 0
    assert TABLE.load().video == ""


@pytest.mark.parametrize("answer", ["n\n", "\n", ""])
def test_emotions_stay_off_until_the_warning_is_confirmed(answer):
    result = call("set", "emotions_on_cameras", "true", input=answer)
    assert "5(1)(f) of the AI Act" in result.output
    assert result.exit_code == 1
    assert not TABLE.load().emotions_on_cameras


def test_confirming_the_warning_switches_emotions_on():
    assert call("set", "emotions_on_cameras", "true", input="y\n").exit_code == 0
    assert TABLE.load().emotions_on_cameras


def test_a_script_confirms_with_an_option_and_still_prints_the_warning():
    result = call("set", "emotions_on_cameras", "true", "--yes")
    assert "5(1)(f) of the AI Act" in result.stderr
    assert TABLE.load().emotions_on_cameras


def test_switching_emotions_off_asks_no_questions():
    TABLE.change("emotions_on_cameras", "true")
    assert "AI Act" not in call().output
    assert "AI Act" not in call("set", "emotions_on_cameras", "false").stderr
    assert not TABLE.load().emotions_on_cameras


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (
            ("set", "webcam", "front"),
            "'webcam' is \"front\", but must be a whole number from 0 to 63",
        ),
        (("set", "apriltag", "here"), "'apriltag' is \"here\", but must be text"),
        (("set", "webcm", "0"), "Did you mean 'webcam'?"),
        (("set", "webcam"), "Give either a value or --default."),
        (("set", "webcam", "0", "--default"), "Give either a value or --default."),
    ],
)
def test_an_invalid_value_is_refused_with_a_message(arguments, sentence):
    result = call(*arguments)
    assert result.exit_code != 0
    assert sentence in result.output
    assert "Traceback" not in result.output


def begun(*arguments):
    """Start a component's process, and return its first line."""
    command = [sys.executable, "-m", "learnblock", "component", *arguments]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    return process, process.stdout.readline()


def test_a_component_is_served_until_ctrl_c():
    process, line = begun("apriltag", "--port", "0")
    assert re.fullmatch(r"apriltag:tcp -h 127\.0\.0\.1 -p \d+\n", line)
    with Proxy.parse(line.strip(), interfaces(Layout.TOOL)["apriltag"]) as proxy:
        frame = a_tag(8)
        found = proxy.call("processimage", Picture(*frame.shape, frame.tobytes()))
    assert [(tag.id, tag.cx, tag.cy) for tag in found] == [(8, *TAG_AT)]
    process.send_signal(signal.SIGINT)
    _, complaints = process.communicate(timeout=10)
    assert (process.returncode, complaints) == (ExitCode.INTERRUPTED, "")


def test_a_component_for_emotions_does_not_start_for_real_faces():
    process, line = begun("emotionrecognition", "--port", "0")
    _, complaint = process.communicate(timeout=10)
    assert (process.returncode, line) == (ExitCode.USAGE, "")
    assert "5(1)(f) of the AI Act" in complaint
    assert "--only-drawn-faces" in complaint


def test_a_component_for_emotions_starts_for_drawn_faces():
    process, line = begun("emotionrecognition", "--port", "0", "--only-drawn-faces")
    process.terminate()
    process.communicate(timeout=10)
    assert line.startswith("emotionrecognition:tcp ")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("apriltags",), "Did you mean 'apriltag'?"),
        (("apriltag", "--port", "70000"), "70000 is not in the range"),
        (("apriltag", "--layout", "row"), "'row' is not one of"),
        (("apriltag", "--port", "0", "--host", "nowhere.invalid"), "cannot listen at nowhere"),
        (("apriltag", "--port", "0", "--host", "a" * 70), "cannot listen at aaa"),
    ],
)
def test_an_invalid_component_is_reported_in_a_sentence(arguments, sentence):
    result = CliRunner().invoke(main, ["component", *arguments])
    assert result.exit_code != 0
    assert sentence in result.output
    assert "Traceback" not in result.output
