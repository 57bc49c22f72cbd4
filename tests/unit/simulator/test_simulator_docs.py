import re
from pathlib import Path

import pytest

from learnblock.simulator import load_robot, load_world, robot_names, world_names
from learnblock.simulator.reference import reference, tables
from learnblock.simulator.robot_description import RobotFile
from learnblock.simulator.world_description import WorldFile
from places import ROOT

PAGE = ROOT / "docs" / "simulator.md"


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)


def test_the_tables_of_the_page_are_up_to_date() -> None:
    # `scripts/docs` writes them.
    page = PAGE.read_text(encoding="utf-8")
    assert reference(page) == page


def test_every_table_of_a_file_has_its_heading() -> None:
    page = PAGE.read_text(encoding="utf-8")
    assert [heading for heading in tables() if f"\n### `{heading}`\n" not in page] == []


def test_a_table_lists_each_key_with_its_bounds_and_default() -> None:
    assert reference("### `[bumper]`\n") == (
        "### `[bumper]`\n\nA bar across the front that detects touches.\n\n"
        "| key | value | default |\n|---|---|---|\n"
        "| `x` | a number from -1000 to 1000 (of the bar, forward of the wheels, mm) | required |\n"
        "| `width` | a number from 1 to 1000 (of the bar, mm) | required |\n"
        "| `travel` | a number from 0.5 to 50 (distance at which it is pressed, mm) | `3` |\n"
    )


def test_text_below_a_table_stays() -> None:
    written = reference("### `[bumper]`\n")
    page = f"# Robots\n\n{written}\nIt clicks.\n\n### Pen\n\n| a |\n"
    assert reference(page.replace("| `3` |", "| `2` |")) == page


def test_a_heading_that_no_file_has_is_an_error() -> None:
    with pytest.raises(KeyError, match="bumpers"):
        reference("### `[bumpers]`\n")


def test_the_page_describes_every_other_key_of_a_file() -> None:
    page = PAGE.read_text(encoding="utf-8")
    headings = {re.split(r"[\[\].]+", heading)[1] for heading in tables()}
    keys = {key for file in (WorldFile, RobotFile) for key in file.__struct_fields__} - headings
    assert "ambient_light" in keys
    assert [key for key in sorted(keys) if f"`{key}`" not in page] == []


def test_the_page_names_every_shipped_world_and_robot() -> None:
    page = PAGE.read_text(encoding="utf-8")

    assert all(f"`{name}`" in page for name in (*world_names(), *robot_names()))


def test_the_examples_of_files_load(tmp_path: Path) -> None:
    world, task, game, teams, robot = blocks("toml")
    (tmp_path / "garden.toml").write_text(world)
    (tmp_path / "task.toml").write_text(task)
    (tmp_path / "game.toml").write_text(game)
    (tmp_path / "teams.toml").write_text(teams)
    (tmp_path / "beetle.toml").write_text(robot)

    assert load_world("garden", [tmp_path]).title == "A garden"
    assert len(list(load_world("task", [tmp_path]).goal.all())) == 3
    assert load_world("game", [tmp_path]).game
    assert len(load_world("teams", [tmp_path]).team) == 2
    assert load_robot("beetle", [tmp_path]).title == "Beetle"


def test_the_example_in_python_runs(capsys: pytest.CaptureFixture[str]) -> None:
    (program,) = blocks("python")
    exec(compile(program, str(PAGE), "exec"), {})  # noqa: S102 - it is our own page

    assert capsys.readouterr().out.startswith("0.76 s: robot bumped into border\n")
