"""The skills of each robot as editors and type checkers see them: in the stub file beside this one.

At run time these classes are empty, and `Client` gives a robot its skills.
"""


class EverySkill:
    """Every skill, for hints: a robot of any kind."""


class Coppeliasim:
    """The skills of `coppeliasim`."""


class Cozmo:
    """The skills of `cozmo`."""


class Create3:
    """The skills of `create3`."""


class Ebo:
    """The skills of `ebo`."""


class Ev3:
    """The skills of `ev3`."""


class Legoed:
    """The skills of `legoed`."""


class Rcis:
    """The skills of `rcis`."""


class Root:
    """The skills of `root`."""


class SimCozmo:
    """The skills of `sim-cozmo`."""


class SimCreate3:
    """The skills of `sim-create3`."""


class SimEbo:
    """The skills of `sim-ebo`."""


class SimEv3:
    """The skills of `sim-ev3`."""


class SimLegoed:
    """The skills of `sim-legoed`."""


class SimRoot:
    """The skills of `sim-root`."""


class SimSpike:
    """The skills of `sim-spike`."""


class SimThymio:
    """The skills of `sim-thymio`."""


class Spike:
    """The skills of `spike`."""


class Thymio:
    """The skills of `thymio`."""
