"""The choices of a page: robots, worlds, examples, settings and tag names."""

from learnblock.server.catalog.examples import example, example_choices
from learnblock.server.catalog.greeting import welcome
from learnblock.server.catalog.robots import robot_choices
from learnblock.server.catalog.tags import tag_dictionary
from learnblock.server.catalog.worlds import check_world_name, usual_world, world_choices

__all__ = [
    "check_world_name",
    "example",
    "example_choices",
    "robot_choices",
    "tag_dictionary",
    "usual_world",
    "welcome",
    "world_choices",
]
