"""The examples that come with LearnBlock."""

from pathlib import Path

from learnblock.errors import UnknownNameError


def examples_folder() -> Path:
    """Where the examples are: next to the modules when installed, next to `src` in a checkout."""
    package = Path(__file__).parents[1]
    installed = package / "examples"
    return installed if installed.is_dir() else package.parents[1] / "examples"


def example(name: str) -> Path:
    """Find an example by its file name, with its folder if it is in one: ``several/sumo.bt``.

    Raises:
        UnknownNameError: there is no example with this name.
    """
    folder = examples_folder()
    paths = {path.relative_to(folder).as_posix(): path for path in folder.rglob("*.*")}
    if name in paths:
        return paths[name]
    raise UnknownNameError("example", name, paths)
