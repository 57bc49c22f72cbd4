"""The choices of a page: robots, worlds, examples, settings and tag names."""

from learnblock.server.catalog.examples import example, example_choices, example_programs, suits
from learnblock.server.catalog.greeting import tag_dictionary, welcome
from learnblock.server.catalog.lessons import (
    add_lesson,
    copy_lesson,
    delete_lesson,
    find_lesson,
    find_own,
    free_lesson_name,
    lesson_choices,
    star_names,
    take_lesson,
)
from learnblock.server.catalog.robots import robot_choices, runs_on
from learnblock.server.catalog.worlds import check_world_name, usual_world, world_choices

__all__ = [
    "add_lesson",
    "check_world_name",
    "copy_lesson",
    "delete_lesson",
    "example",
    "example_choices",
    "example_programs",
    "find_lesson",
    "find_own",
    "free_lesson_name",
    "lesson_choices",
    "robot_choices",
    "runs_on",
    "star_names",
    "suits",
    "tag_dictionary",
    "take_lesson",
    "usual_world",
    "welcome",
    "world_choices",
]
