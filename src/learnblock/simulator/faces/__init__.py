"""Drawn faces, which belong to no real person, so their emotions may be recognised."""

from learnblock.simulator.faces.expressions import EXPRESSIONS
from learnblock.simulator.faces.people import Person
from learnblock.simulator.faces.portrait import portrait

__all__ = ["EXPRESSIONS", "Person", "portrait"]
