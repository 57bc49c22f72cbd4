"""Faces that are drawn: nobody's, so that feelings may be read in them."""

from learnblock.simulator.faces.expressions import EXPRESSIONS
from learnblock.simulator.faces.people import Person
from learnblock.simulator.faces.portrait import portrait

__all__ = ["EXPRESSIONS", "Person", "portrait"]
