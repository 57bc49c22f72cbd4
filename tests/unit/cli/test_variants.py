"""One program in many variants of a world on the command line."""

import json

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.cli.console import ExitCode

pytestmark = pytest.mark.slow


def call(*arguments):
    """Run a command in this process."""
    return CliRunner().invoke(main, ["run", *map(str, arguments)])


@pytest.fixture
def straight(tmp_path):
    """Write a program that drives 500 mm straight on; return its path."""
    path = tmp_path / "straight.bt"
    path.write_text(
        "main:\n    function.move_straight(100)\n    function.sleep(5)\n"
        "    function.stop_bot()\nend\n"
    )
    return path


def test_a_table_says_for_each_variant_how_many_goals_were_reached(straight):
    result = call(straight, "--world", "distance", "--variants", 2)
    assert result.exit_code == 0
    *rows, total = result.stderr.splitlines()
    assert rows == ["variant 1: 1 of 1 goals, 5.0 s", "variant 2: 1 of 1 goals, 5.0 s"]
    assert total == "2 of 2 variants: every goal reached."


def test_the_report_as_json_has_each_variants_own_report(straight):
    result = call(straight, "--world", "edge", "--variants", 2, "--json")
    shown = json.loads(result.stdout)
    assert shown["reached"] == 0
    assert [one["variant"] for one in shown["variants"]] == [1, 2]
    poses = [one["report"]["pose"] for one in shown["variants"]]
    assert poses[0] != poses[1]


def test_a_variant_leaves_the_same_trace_each_time_and_another_one_than_the_drawn_world(straight):
    def trace(*arguments):
        report = call(straight, "--world", "edge", *arguments, "--json").stdout
        return json.loads(report)["trace_sha256"]

    drawn, first = trace(), trace("--variant", 1)
    assert first == trace("--variant", 1)
    assert trace("--variant", 0) == drawn
    assert len({drawn, first, trace("--variant", 2), trace("--variant", 1, "--seed", 5)}) == 4


def test_the_environment_chooses_a_variant(straight, monkeypatch):
    chosen = call(straight, "--world", "edge", "--variant", 3, "--json").stdout
    monkeypatch.setenv("LEARNBLOCK_VARIANT", "3")
    assert call(straight, "--world", "edge", "--json").stdout == chosen


def test_a_variant_in_the_environment_has_to_be_a_number(straight, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_VARIANT", "first")
    result = call(straight, "--world", "edge")
    assert "The variant has to be a whole number from 0, not 'first'." in result.stderr


@pytest.mark.parametrize(
    "others", [["--variant", 1], ["--picture", "a.png"], ["--trace", "a.jsonl"]]
)
def test_many_variants_have_neither_one_picture_nor_one_trace(straight, others):
    result = call(straight, "--world", "edge", "--variants", 2, *others)
    assert result.exit_code == ExitCode.USAGE
    assert "leave out --variant, --trace and --picture" in result.stderr


def test_a_team_runs_in_one_world_at_a_time(straight):
    result = call(f"{straight}@sim-ebo:2", "--world", "edge", "--variants", 2)
    assert result.exit_code == ExitCode.USAGE


def test_a_team_may_run_in_a_variant(straight):
    def trace(*arguments):
        report = call(f"{straight}@sim-ebo:2", "--world", "stage", *arguments, "--json").stdout
        return json.loads(report)["trace_sha256"]

    assert trace("--variant", 1) != trace()


def test_a_world_without_variants_says_so(straight, tmp_path):
    (tmp_path / "plain.toml").write_text("")
    result = call(straight, "--world", tmp_path / "plain.toml", "--variants", 2)
    assert "The world 'plain' has no variants. Add [vary] to its file" in result.stderr
