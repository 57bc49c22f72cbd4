"""The first message to a page."""

from importlib.metadata import version

from learnblock.server.catalog.examples import example_choices
from learnblock.server.catalog.robots import robot_choices
from learnblock.server.catalog.worlds import world_choices
from learnblock.server.messages import Welcome


def welcome(folder: str) -> Welcome:
    """Create the first message to a page.

    Args:
        folder: the projects folder.
    """
    return Welcome(
        version=version("learnblock-studio"),
        robots=robot_choices(),
        worlds=world_choices(),
        examples=tuple(example_choices().values()),
        folder=folder,
    )
