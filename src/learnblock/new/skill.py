"""The files of a new skill."""

from pathlib import Path

from learnblock.new.names import check_skill_name
from learnblock.new.template import fill


def skill_files(name: str, folder: Path) -> dict[Path, str]:
    """A new skill and its test.

    Args:
        name: the name of the function and its files.
        folder: `learnblock.storage.home.home`, or another folder with the same structure.

    Raises:
        NewNameError: the name is not allowed, or is taken.
    """
    file = folder / "skills" / f"{name}.py"
    check_skill_name(name, file)
    return {
        file: fill("skill.py", name=name),
        folder / "tests" / f"test_{name}.py": fill("skill_test.py", name=name),
    }
