"""Block sets on the command line."""

from click.testing import CliRunner

from learnblock.cli import main


def test_block_sets_are_listed_and_invalid_files_reported(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "sets").mkdir()
    (tmp_path / "sets" / "ours.toml").write_text('[title]\nen = "Our lesson"\n')
    (tmp_path / "sets" / "wrong.toml").write_text("show = 3\n")
    result = CliRunner().invoke(main, ["sets"])
    assert result.exit_code == 0
    listed = result.stdout.splitlines()
    assert [line.split()[0] for line in listed] == [
        "first-steps", "loops-and-functions", "senses", "events", "everything", "ours",
    ]  # fmt: skip
    assert listed[-1].endswith("Our lesson")
    assert "wrong.toml:1" in result.stderr
