"""The skills of each robot as editors and type checkers see them: in the stub file beside this one.

At run time these classes are empty, and `Client` gives a robot its skills.
"""


class EverySkill:
    """Every skill, for hints: a robot of any kind."""


class Coppeliasim:
    """The skills of `coppeliasim`."""


class Cozmo:
    """The skills of `cozmo`."""


class Ebo:
    """The skills of `ebo`."""


class Ev3:
    """The skills of `ev3`."""


class Rcis:
    """The skills of `rcis`."""


class SimCozmo:
    """The skills of `sim-cozmo`."""


class SimEbo:
    """The skills of `sim-ebo`."""


class SimEv3:
    """The skills of `sim-ev3`."""


class SimSpike:
    """The skills of `sim-spike`."""


class SimThymio:
    """The skills of `sim-thymio`."""


class Spike:
    """The skills of `spike`."""


class Thymio:
    """The skills of `thymio`."""
