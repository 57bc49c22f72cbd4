"""`learnblock stubs`, and the commands that renew what it writes."""

from click.testing import CliRunner

from learnblock.cli import main


def run(*words: str) -> str:
    result = CliRunner().invoke(main, words)
    assert result.exit_code == 0, result.output
    return result.output


def own_skills(folder) -> str:
    return (folder / "learnblock_home" / "own_skills.pyi").read_text("utf-8")


def test_it_writes_the_skills_and_robots_of_ones_own(own_home, tmp_path):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "rover.py").write_text(
        "from learnblock.client import Client\nclass Robot(Client):\n    '''A rover.'''\n"
    )
    (own_home / "skills").mkdir()
    (own_home / "skills" / "dance.py").write_text("def waltz(robot, times=3): pass\n")
    assert f"Wrote {tmp_path / 'learnblock_home'}\n" == run("stubs", str(tmp_path))
    assert "def waltz(self, times=3) -> None:" in own_skills(tmp_path)
    assert "A rover." in (tmp_path / "learnblock_home/robots/rover.pyi").read_text("utf-8")


def test_a_file_with_mistakes_is_left_out(own_home, tmp_path):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "broken.py").write_text("1 / 0\n")
    (own_home / "skills").mkdir()
    (own_home / "skills" / "broken.py").write_text("def waltz(robot:\n")
    run("stubs", str(tmp_path))
    assert "class OwnSkills:\n    ...\n" in own_skills(tmp_path)
    assert ["__init__.pyi"] == [path.name for path in tmp_path.rglob("robots/*")]


def test_a_webcam_of_the_settings_gives_every_robot_the_skills_of_a_camera(own_home, tmp_path):
    (own_home / "settings.toml").write_text("[perception]\nwebcam = 0\n")
    run("stubs", str(tmp_path))
    assert "skill_sets._NeedsCamera" in own_skills(tmp_path)


def test_a_new_skill_is_written_at_home_and_where_stubs_are_already(
    own_home, tmp_path, monkeypatch
):
    (tmp_path / "with").mkdir()
    (tmp_path / "without").mkdir()
    run("stubs", str(tmp_path / "with"))
    for folder in ("with", "without"):
        monkeypatch.chdir(tmp_path / folder)
        run("new", "skill", f"sway_{folder}")
    assert "def sway_without(" in own_skills(own_home)
    assert "def sway_with(" in own_skills(tmp_path / "with")
    assert [] == list((tmp_path / "without").iterdir())
