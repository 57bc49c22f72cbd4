import re
from pathlib import Path

import msgspec
import pytest
from msgspec import Struct, inspect

from learnblock.simulator import goal_description as goals
from learnblock.simulator import load_robot, load_world, robot_names, world_names
from learnblock.simulator import robot_description as robots
from learnblock.simulator import world_description as worlds
from learnblock.storage.toml_source import describe
from places import ROOT

PAGE = ROOT / "docs" / "simulator.md"
TABLES: dict[str, type[Struct]] = {
    "[floor]": worlds.Floor,
    "[[line]]": worlds.Line,
    "path": worlds.Part,
    "[[wall]]": worlds.Wall,
    "[[box]]": worlds.Box,
    "[[cylinder]]": worlds.Cylinder,
    "[[tag]]": worlds.Tag,
    "[[face]]": worlds.Face,
    "[[light]]": worlds.Lamp,
    "[[prop]]": worlds.Prop,
    "[[start]]": worlds.Start,
    "[[goal.reach]]": goals.Reach,
    "[[goal.follow]]": goals.Follow,
    "[[goal.visit]]": goals.Visit,
    "[[goal.tour]]": goals.Tour,
    "[[goal.stop]]": goals.Stop,
    "[[goal.show]]": goals.Show,
    "[[goal.avoid]]": goals.Avoid,
    "[vary]": worlds.Vary,
    "[[vary.thing]]": worlds.Moved,
    "[body]": robots.Body,
    "[wheels]": robots.Wheels,
    "[[distance]]": robots.DistanceSensor,
    "[[ground]]": robots.GroundSensor,
    "[gyroscope]": robots.Gyroscope,
    "[accelerometer]": robots.Accelerometer,
    "[bumper]": robots.Bumper,
    "[light]": robots.LightSensor,
    "[[camera]]": robots.Camera,
    "[[joint]]": robots.Joint,
    "[display]": robots.Display,
    "[[led]]": robots.Led,
}


def section(heading: str, struct: type[Struct]) -> str:
    """Return the page's text about one table of a file."""
    fields = inspect.type_info(struct).fields  # type: ignore[attr-defined]
    rows = [f"| `{f.name}` | {describe(f.type)} | {default(f)} |" for f in fields]
    table = "\n".join(["| key | value | default |", "|---|---|---|", *rows])
    return f"### `{heading}`\n\n{(struct.__doc__ or '').strip()}\n\n{table}\n"


def default(field: inspect.Field) -> str:
    if field.required:
        return "required"
    if field.default is None:
        return "none"
    value = field.default_factory() if field.default is msgspec.NODEFAULT else field.default
    return f"`{toml(value)}`"


def toml(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, tuple):
        return "[" + ", ".join(map(toml, value)) + "]"
    return f"{value:g}"


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("heading", sorted(TABLES))
def test_the_page_lists_each_key_with_its_bounds_and_default(heading: str) -> None:
    assert section(heading, TABLES[heading]) in PAGE.read_text(encoding="utf-8")


def test_every_table_of_a_file_has_its_section() -> None:
    told = PAGE.read_text(encoding="utf-8")
    simple = {"title", "theme", "ambient_light", "sensor_noise", "world", "outputs"}
    files = (worlds.WorldFile, robots.RobotFile)
    keys = {key for file in files for key in file.__struct_fields__} - simple - {"goal"}

    assert all(f"### `[{key}]`" in told or f"### `[[{key}]]`" in told for key in keys)
    assert all(f"`{key}`" in told for key in simple)


def test_the_page_names_every_shipped_world_and_robot() -> None:
    told = PAGE.read_text(encoding="utf-8")

    assert all(f"`{name}`" in told for name in (*world_names(), *robot_names()))


def test_the_examples_of_files_load(tmp_path: Path) -> None:
    world, task, robot = blocks("toml")
    (tmp_path / "garden.toml").write_text(world)
    (tmp_path / "task.toml").write_text(task)
    (tmp_path / "beetle.toml").write_text(robot)

    assert load_world("garden", [tmp_path]).title == "A garden"
    assert len(list(load_world("task", [tmp_path]).goal.all())) == 3
    assert load_robot("beetle", [tmp_path]).title == "Beetle"


def test_the_example_in_python_runs(capsys: pytest.CaptureFixture[str]) -> None:
    (program,) = blocks("python")
    exec(compile(program, str(PAGE), "exec"), {})  # noqa: S102 - it is our own page

    assert capsys.readouterr().out.startswith("0.76 s: robot bumped into border\n")
