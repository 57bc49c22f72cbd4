"""Several programs on the command line."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from page_files import content_of
from terminals import shown_on_a_terminal

pytestmark = pytest.mark.slow


def call(*arguments):
    """Run a command in this process."""
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


@pytest.fixture
def write(tmp_path):
    """Write a program that drives and prints; return its path."""

    def write(name, *lines):
        path = tmp_path / name
        path.write_text("\n".join(("function.move_straight(50)", *lines)) + "\n")
        return path

    return write


def test_every_line_of_output_has_the_name_of_its_robot(write):
    one, two = write("one.bt", 'print("hello")'), write("two.bt", 'print("hi")')
    result = call("run", f"{one}@sim-ebo", f"{two}@sim-thymio", "--world", "empty")
    assert result.exit_code == 0
    assert result.stdout == "one: hello\ntwo: hi\n"
    for row in ("one\n", "two\n", "trace      "):
        assert row in result.stderr


def test_the_json_report_is_one_object_with_all_robots(write):
    one = write("one.bt", 'print("hello")', "function.sleep(1)")
    result = call("run", f"{one}@sim-ebo:2", one, "--robot", "sim-ev3", "--json")
    report = json.loads(result.stdout)
    assert report.keys() == {"robots", "goals", "trace_sha256"}
    assert ["one-1", "one-2", "one-3"] == [robot["name"] for robot in report["robots"]]
    assert ["sim-ebo", "sim-ebo", "sim-ev3"] == [robot["robot"] for robot in report["robots"]]
    for robot in report["robots"]:
        assert (robot["program"], robot["ended"], robot["output"]) == (
            "one.bt", "finished", "hello\n",
        )  # fmt: skip
        assert robot["distance"] > 40
    assert len(report["trace_sha256"]) == 64


def test_the_page_shows_all_robots_and_the_name_that_is_wished(write, tmp_path):
    one, two, page = write("one.bt", 'print("hello")'), write("two.bt"), tmp_path / "page.html"
    result = call("run", f"{one}@sim-ebo:2", f"{two}@sim-ev3", "--page", page, "--name", " Ada ")
    assert result.exit_code == 0
    content = content_of(page.read_text("utf-8"))
    assert (content["title"], content["pupil"]) == ("one, two", "Ada")
    assert [(robot["name"], robot["robot"], robot["printed"]) for robot in content["robots"]] == [
        ("one-1", "sim-ebo", "hello\n"),
        ("one-2", "sim-ebo", "hello\n"),
        ("two", "sim-ev3", ""),
    ]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--name", "Ada"), "With --name, add --page FILE"),
        (("--page", "page.html", "--variants", "2"), "With --page, leave out --variants."),
    ],
)
def test_a_page_that_cannot_be_is_refused(write, options, message):
    result = call("run", write("one.bt"), *options)
    assert result.exit_code == 2
    assert message in result.stderr


def test_the_exit_code_is_the_worst_of_all(write):
    good, bad = write("good.bt", "function.sleep(2)"), write("bad.bt", "x = 0", "print(1 / x)")
    result = call("run", f"{good}@sim-ebo", f"{bad}@sim-ebo", "--world", "empty")
    assert result.exit_code == 3
    assert "bad.bt:3: " in result.stderr


def test_no_program_starts_if_one_is_refused(write):
    good, bad = write("good.bt", 'print("started")'), write("bad.bt", "function.jump_high()")
    result = call("run", f"{good}@sim-ebo", f"{bad}@sim-ebo", "--json")
    (robot,) = json.loads(result.stdout)["robots"]
    assert (result.exit_code, robot["name"], robot["ended"]) == (1, "bad", "refused")
    assert robot["error"]["line"] == 2


def test_a_program_that_cannot_be_read_is_refused(write):
    result = call("run", f"{write('broken.bt', 'x = (1')}@sim-ebo:2", "--json")
    (robot,) = json.loads(result.stdout)["robots"]
    assert (result.exit_code, robot["ended"], robot["error"]["line"]) == (1, "refused", 2)


def test_one_robot_can_be_named_with_its_program(write):
    result = call("run", f"{write('one.bt')}@sim-ev3", "--json")
    assert json.loads(result.stdout)["ended"] == "finished"


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["one.bt@sim-ebo:31"], "31 robots are too many for one run: at most 30 can take part."),
        (["one.bt@sim-ebo:0"], "does not exist"),
        (["one.bt@sim-ebo", "none.bt@sim-ebo"], "does not exist"),
        (["one.bt@sim-eboo:2"], "Did you mean 'sim-ebo'"),
        (["one.bt@sim-ebo:2", "--picture", "a.gif"], "must be a .png or .svg file."),
    ],
)
def test_an_invalid_choice_is_reported_with_advice(write, monkeypatch, arguments, sentence):
    monkeypatch.chdir(write("one.bt").parent)
    result = call("run", *arguments)
    assert result.exit_code == 2
    assert sentence in " ".join(result.stderr.split())


def test_a_picture_names_every_robot(write, tmp_path):
    one, picture = write("one.bt", "function.sleep(2)"), tmp_path / "all.svg"
    result = call("run", f"{one}@sim-ebo:3", "--world", "empty", "--picture", picture)
    assert result.exit_code == 0
    drawn = picture.read_text()
    for name in ("one-1", "one-2", "one-3"):
        assert f"{name}: finished" in drawn


def test_a_file_whose_name_looks_like_an_assignment_is_that_file(write):
    path = write("one.bt@sim-ebo:2.bt")
    assert json.loads(call("run", path, "--json").stdout)["ended"] == "finished"


def test_each_program_asks_the_person_under_its_name(write):
    one = write("one.bt", 'name = input("name? ")', 'print("hello", name)')
    command = ["run", f"{one}@sim-ebo:2", "--world", "empty"]
    result = CliRunner().invoke(main, command, input="Ana\nBea\n")
    assert result.stdout == "one-1: name? one-1: hello Ana\none-2: name? one-2: hello Bea\n"


DRIVEN = """main:
    while not function.is_key_pressed("q"):
        if function.is_key_pressed("{key}"):
            function.move_straight(60)
        else:
            function.stop_bot()
        end
        function.sleep(0.05)
    end
end
"""


@pytest.fixture
def driven(tmp_path, monkeypatch):
    """Run two players' programs with keys; return the report, and the keys in its trace."""
    monkeypatch.chdir(tmp_path)
    for name, key in (("left", "up"), ("right", "w")):
        Path(f"{name}.bt").write_text(DRIVEN.format(key=key))

    def driven(keys):
        Path("keys.jsonl").write_text(keys)
        programs = ["left.bt@sim-ebo", "right.bt@sim-thymio"]
        result = call("run", *programs, "--json", "--keys", "keys.jsonl", "--trace", "trace.jsonl")
        trace = Path("trace.jsonl").read_text()
        pressed = [one for one in map(json.loads, trace.splitlines()) if "keys" in one]
        return json.loads(result.stdout), pressed, trace

    return driven


def test_keys_in_a_file_reach_the_programs_of_all_robots(driven):
    lines = [
        '{"t": 0.5, "keys": ["up"]}',
        '{"t": 1.5, "keys": ["up", "w"]}',
        '{"t": 2.5, "keys": ["q"]}',
    ]
    report, pressed, _ = driven("\n".join(lines))
    left, right = (robot["distance"] for robot in report["robots"])
    assert left == pytest.approx(2 * right, rel=0.1)
    assert {"left", "right"} == {one["robot"] for one in pressed}


def test_the_trace_of_several_robots_repeats_their_keys_with_the_same_hash(driven):
    lines = [
        '{"t": 0.5, "keys": ["up"], "robot": "left"}',
        '{"t": 1, "keys": ["w"], "robot": "right"}',
        '{"t": 2, "keys": ["q"]}',
    ]
    report, pressed, trace = driven("\n".join(lines))
    assert [(one["robot"], one["keys"]) for one in pressed] == [
        ("left", ["up"]), ("right", ["w"]), ("left", ["q"]), ("right", ["q"]),
    ]  # fmt: skip
    assert all(robot["distance"] > 40 for robot in report["robots"])
    again, _, repeated = driven(trace)
    assert again["trace_sha256"] == report["trace_sha256"]
    assert repeated == trace
    without, _, _ = driven('{"t": 2, "keys": ["q"]}')
    assert without["trace_sha256"] != report["trace_sha256"]


def test_keys_of_a_robot_that_does_not_take_part_are_refused(tmp_path, write):
    keys = tmp_path / "keys.jsonl"
    keys.write_text('{"t": 1, "keys": ["up"], "robot": "on"}\n')
    one, two = write("one.bt"), write("two.bt")
    result = call("run", f"{one}@sim-ebo", f"{two}@sim-ebo", "--keys", keys)
    assert result.exit_code == 1
    assert "keys.jsonl:1:" in result.stderr
    assert "There is no robot 'on'. Did you mean 'one'?" in result.stderr


@pytest.mark.skipif(os.name == "nt", reason="Windows has no pseudo-terminals")
def test_a_terminal_shows_how_many_programs_run(write):
    one, two = write("one.bt", "function.sleep(2)"), write("two.bt", "function.sleep(6)")
    arguments = [f"{one}@sim-ebo", f"{two}@sim-ebo", "--world", "empty", "--pace", "5"]
    command = [sys.executable, "-m", "learnblock", "run", *arguments]
    states = shown_on_a_terminal(command).split("\r\x1b[K")
    assert any("2 of 2 running" in state and "x real time" in state for state in states)
    assert any("1 of 2 running" in state for state in states)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGINT for one process")
def test_ctrl_c_ends_all_programs_with_a_report(write):
    one = write("one.bt", 'print("started")', "function.sleep(1000)")
    command = [sys.executable, "-m", "learnblock", "run", f"{one}@sim-ebo:2", "--pace", "real"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        for _ in range(2):
            assert b"started" in process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, report = process.communicate(timeout=60)
    assert process.returncode == 130
    assert report.count(b"ended      stopped") == 2
