"""The files of a new skill."""

from pathlib import Path

from learnblock.new.names import check_skill_name
from learnblock.new.template import fill


def skill_files(name: str, folder: Path) -> dict[Path, str]:
    """A skill of that name in a file of its own, and its test.

    Args:
        name: of the function; so are the files called.
        folder: a user's own, `learnblock.home.home`, or another of that kind.

    Raises:
        NewNameError: there can be no skill of that name.
    """
    file = folder / "skills" / f"{name}.py"
    check_skill_name(name, file)
    return {
        file: fill("skill.py", name=name),
        folder / "tests" / f"test_{name}.py": fill("skill_test.py", name=name),
    }
