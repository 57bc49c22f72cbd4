"""The world in which the wall shows pupils who have not opened theirs."""

import asyncio

import pytest

from learnblock.classroom.lesson_worlds import LessonWorlds


def read(lesson, step=1):
    worlds = LessonWorlds()
    asyncio.run(worlds.read(lesson, step))
    return worlds.of(lesson, step)


def test_the_world_of_a_step_has_the_usual_robot_of_the_lesson_at_its_start():
    scene = read("1-03-square", 4)
    assert (scene.name, scene.robots[0][0], scene.start) == ("big-square", "thymio", (-150, 150, 0))


@pytest.mark.parametrize("lesson", ["", "no-such-lesson"])
def test_without_a_lesson_that_can_be_read_there_is_no_world(lesson):
    assert read(lesson) is None
