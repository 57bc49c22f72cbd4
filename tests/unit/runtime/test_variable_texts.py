"""A program's own variables as text."""

import math
from pathlib import Path

from learnblock.runtime.variable_texts import described_variables


class Wheel:
    def __init__(self, turns):
        self.turns = turns


class Driver:
    def __init__(self):
        self.speed = 40
        self.wheel = Wheel(3)
        self.me = self


class Point:
    __slots__ = ("x", "y")

    def __init__(self):
        self.x = 1


class Sly:
    @property
    def __dict__(self):
        raise RuntimeError


for own in (Wheel, Driver, Point, Sly):
    # As in a program.
    own.__module__ = "__main__"


def test_an_object_of_the_program_is_followed_by_its_parts():
    assert described_variables({"driver": Driver(), "n": 1}) == {
        "driver": "Driver",
        "driver.speed": "40",
        "driver.wheel": "Wheel",
        "driver.wheel.turns": "3",
        "driver.me": "Driver",
        "n": "1",
    }


def test_an_object_with_slots_shows_those_that_have_a_value():
    assert described_variables({"point": Point()}) == {"point": "Point", "point.x": "1"}


def test_what_is_imported_and_what_can_be_called_is_no_variable():
    assert described_variables({"math": math, "sqrt": math.sqrt, "Driver": Driver}) == {}


def test_no_path_of_the_computer_is_shown():
    with Path(__file__).open(encoding="utf-8") as file:
        assert described_variables({"file": file}) == {"file": "TextIOWrapper"}


def test_objects_in_a_list_are_named_by_their_class():
    assert described_variables({"all": [Wheel(1), 2]}) == {"all": "[Wheel, 2]"}


def test_no_code_of_a_class_runs_to_open_its_objects():
    assert described_variables({"sly": Sly()}) == {"sly": "Sly"}


def test_variables_that_do_not_fit_into_a_message_are_left_out():
    many = {f"v{index}": "x" * 150 for index in range(1000)}
    assert 0 < len(described_variables(many)) < 200
