"""Drawn faces, which belong to no person, so that emotions may be recognised in them."""

from learnblock.simulator.faces.expressions import EXPRESSIONS
from learnblock.simulator.faces.people import Person
from learnblock.simulator.faces.portrait import portrait

__all__ = ["EXPRESSIONS", "Person", "portrait"]
