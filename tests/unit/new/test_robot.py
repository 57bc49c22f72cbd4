"""The files of a new robot are clean, and their own test passes at once."""

import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from learnblock import language, robots, running
from learnblock.new.files import write_new
from learnblock.new.robot import files_at_home, files_of_package, unkept
from learnblock.new.robot_plan import named, plan_of, read_plan
from learnblock.new.skill import skill_files
from learnblock.server.catalog import welcome
from learnblock.stubs.own import write_stubs
from new_robots import DOCS, EVERYTHING, guide
from places import ROOT
from runs import EXAMPLES, run_example

#: Who writes a robot has none of the plugins that our own tests need.
USUAL = {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}


def plan(folder, text, name):
    (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    return named(read_plan(folder / f"{name}.toml"), name)


def tool(name, *arguments, folder, **environment):
    """Return what a tool of this environment prints about the files in a folder."""
    done = subprocess.run(
        [Path(sys.executable).with_name(name), *arguments],
        cwd=folder,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )
    return done.returncode, done.stdout + done.stderr


@pytest.fixture
def home(own_home, tmp_path):
    """The guide's robot, one with every device, and a skill, in a user's folder."""
    write_new(files_at_home(plan(tmp_path, guide(), "pathfinder"), own_home))
    write_new(files_at_home(plan(tmp_path, EVERYTHING, "whole"), own_home))
    write_new(skill_files("sway", own_home))
    return own_home


@pytest.mark.slow
def test_the_written_files_are_clean(home):
    # The first parameter of every skill, the robot, is not described, as in our own rules.
    rules = ("--config", ROOT / "pyproject.toml", "--extend-per-file-ignores", "skills/*:D417")
    assert tool("ruff", "check", *rules, ".", folder=home)[0] == 0
    assert tool("ruff", "format", "--check", *rules[:2], ".", folder=home)[0] == 0
    files = [str(path) for path in home.glob("*/*.py")]
    # As `learnblock new` does: a type checker knows the new skill from them.
    write_stubs(home)
    status, said = tool("mypy", "--strict", "--no-incremental", *files, folder=home)
    assert (status, said) == (0, "Success: no issues found in 8 source files\n")


@pytest.mark.slow
def test_the_test_of_the_guides_robot_passes_at_once(home, tmp_path):
    command = ("-rs", "-p", "no:cacheprovider", home / "tests" / "test_pathfinder.py")
    # It finds its own folder, whichever folder the environment names.
    status, said = tool("pytest", *command, folder=tmp_path, **USUAL, LEARNBLOCK_HOME="elsewhere")
    assert status == 0, said
    assert "14 passed, 2 skipped" in said
    told = DOCS.read_text("utf-8")
    assert "14 passed, 2 skipped" in told
    unwritten = re.compile(r"pathfinder\.py, line \d+: 'open_link\(\)' still has to be written")
    assert {*unwritten.findall(told)} == {*unwritten.findall(said)}


def test_both_robots_are_in_the_pages_list(home):
    listed = {choice.name: choice for choice in welcome("projects").robots}
    # The page marks the real one; both have the name of the description.
    assert listed["sim-pathfinder"].title == listed["pathfinder"].title == "Pathfinder"
    assert listed["sim-pathfinder"].simulated
    assert not listed["pathfinder"].simulated


def test_the_description_of_a_twin_is_next_to_it(home):
    assert robots.find("sim-whole").load().description().body.radius == 70
    (home / "robots" / "whole.toml").unlink()
    with pytest.raises(LookupError, match="There is no simulated robot 'whole'"):
        robots.find("sim-whole").load().description()


@pytest.mark.slow
def test_a_program_for_the_twin_runs_by_itself_with_the_same_trace(home, tmp_path):
    program, trace = tmp_path / "dance.py", tmp_path / "trace.jsonl"
    tree = running.read(EXAMPLES / "dance.bt").tree
    program.write_text(language.to_python(tree, robots.module_of("sim-pathfinder")).text)
    environment = {**os.environ, "LEARNBLOCK_TRACE": str(trace), "LEARNBLOCK_WORLD": "empty"}
    subprocess.run([sys.executable, program], env=environment, check=True)
    assert trace.read_bytes() == run_example("dance.bt", "sim-pathfinder", world="empty").trace


@pytest.mark.slow
@pytest.mark.exhaustive
def test_a_separate_package_passes_its_test_after_installation(tmp_path):
    package = tmp_path / "package"
    write_new(files_of_package(plan(tmp_path, guide(), "pathfinder"), package))
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", tmp_path / "dist"]
    subprocess.run(build, cwd=package, check=True, capture_output=True)
    installed = tmp_path / "installed"
    with zipfile.ZipFile(next((tmp_path / "dist").glob("*.whl"))) as wheel:
        wheel.extractall(installed)
    status, said = tool(
        "pytest",
        *("-q", "-p", "no:cacheprovider", "tests"),
        folder=package,
        **USUAL,
        PYTHONPATH=str(installed),
    )
    assert status == 0, said
    assert "14 passed, 2 skipped" in said


@pytest.mark.parametrize(
    ("changed", "claim"),
    [
        ({"wheels": {"maximum_speed": 20}}, "positive speed is forward"),
        ({"wheels": {"maximum_speed": 20}}, "positive rotation is to the right"),
        ({"wheels": {"acceleration": 30}}, "positive speed is forward"),
        ({"joint": [{"key": "ARM", "minimum": 20, "maximum": 30}]}, "its joints move to"),
        ({"gyroscope": {"noise": 5}}, "its gyroscope reads 0 after a reset"),
        ({"accelerometer": {"noise": 5}}, "its accelerometer shows 1 g upwards at rest"),
    ],
)
def test_the_test_skips_what_a_robot_cannot_do(changed, claim):
    ordinary = {
        "name": "slow",
        "body": {"shape": "disc", "radius": 50, "height": 50, "mass": 1},
        "wheels": {"radius": 20, "track": 100, "maximum_speed": 200},
    }
    merged = {
        key: {**ordinary.get(key, {}), **value} if isinstance(value, dict) else value
        for key, value in changed.items()
    }
    assert unkept(plan_of(ordinary)) == {}
    assert any(one.startswith(claim) for one in unkept(plan_of({**ordinary, **merged})))
