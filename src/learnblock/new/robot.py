"""The files of a new robot: its client, its twin, the twin's description, and their test."""

import math
from collections.abc import Iterator, Mapping
from pathlib import Path

from learnblock import running
from learnblock.blocks import builtin
from learnblock.errors import RobotDescriptionError
from learnblock.language import check
from learnblock.new.client import client_source, function_names, literal
from learnblock.new.robot_plan import RobotPlan
from learnblock.new.template import fill
from learnblock.senses import equipment
from learnblock.simulator import RobotDescription, World, load_world
from learnblock.simulator.robot_description import RobotFile
from learnblock.storage import toml_source

#: Examples, each with a suitable world; those that need the most devices come first.
_EXAMPLES = (
    ("labyrinth.bt", "labyrinth"),
    ("avoid.bt", "obstacles"),
    ("wall.bt", "walls"),
    ("line-thymio.bt", "line"),
    ("watch-out.bt", "line"),
    ("tags.bt", "tags"),
    ("line-ebo.bt", "line"),
    ("square.bt", "empty"),
    ("polygons.bt", "empty"),
    ("dance.bt", "empty"),
    ("patrol.bt", "empty"),
)
_EXAMPLES_WITH_ROOM = tuple(example for example in _EXAMPLES if example[1] == "empty")
_EXAMPLES_TRIED = 4
#: The results that `check_robot` accepts for 1 s of 50 mm/s and 45 degrees/s, minus some noise.
_FORWARD = (30.0, 85.0)
_RIGHT = (25.0, 75.0)
_WIDEST = 110.0
"""From the middle of a robot to its farthest corner, mm; a wider one cannot pass the labyrinth."""


def files_at_home(plan: RobotPlan, home: Path) -> dict[Path, str]:
    """The robot's files in the user's folder, where LearnBlock finds them.

    Args:
        plan: the plan, with a checked name.
        home: the folder, `learnblock.storage.home.home`.
    """
    module = _module(plan)
    imports = "import os\n", "from pathlib import Path\n"
    test = _test(plan, imports=imports, home=fill("robot/home.py"))
    return {
        **_modules(plan, home / "robots"),
        home / "tests" / f"test_{module}.py": test,
    }


def files_of_package(plan: RobotPlan, folder: Path) -> dict[Path, str]:
    """The robot's files in a separate package, to be installed with pip.

    Args:
        plan: the plan, with a checked name.
        folder: the folder of the package, which may not exist yet.
    """
    module = _module(plan)
    package = f"learnblock_{module}"
    words = {"title": title_of(plan), "name": plan.name, "module": module, "package": package}
    source = folder / "src" / package
    return {
        folder / "pyproject.toml": fill("robot/pyproject.toml", **words),
        source / "__init__.py": fill("robot/package.py", **words),
        **_modules(plan, source),
        folder / "tests" / f"test_{module}.py": _test(plan),
    }


def title_of(plan: RobotPlan) -> str:
    """The robot's display name."""
    return plan.title or plan.name.replace("-", " ").title()


def _modules(plan: RobotPlan, folder: Path) -> dict[Path, str]:
    module, title = _module(plan), title_of(plan)
    twin = toml_source.write(plan.twin, f"{module}.toml", RobotDescriptionError)
    return {
        folder / f"{module}.py": client_source(plan, title),
        folder / f"sim_{module}.py": fill("robot/twin.py", title=title, module=module),
        folder / f"{module}.toml": fill("robot/twin.toml", title=title, description=twin.strip()),
    }


def _module(plan: RobotPlan) -> str:
    return plan.name.replace("-", "_")


def _test(plan: RobotPlan, *, imports: tuple[str, str] = ("", ""), home: str = "") -> str:
    """The test of client and twin.

    Args:
        plan: the plan of the robot.
        imports: an import of a module and one of a name, both needed by `home`.
        home: lines that set the folder of the robot.
    """
    module, names = imports
    return fill(
        "robot/test.py",
        title=title_of(plan),
        name=plan.name,
        module=module,
        names=names,
        home=home,
        function_names=_rows(literal(name) for name in function_names(plan)),
        examples=_rows(f'("{example}", "{world}")' for example, world in _suitable(plan)),
        excused=_excused(plan),
        wrong_settings=_rows(_wrong_settings(plan), depth=2),
    )


def _rows(rows: Iterator[str], depth: int = 1) -> str:
    return "\n".join(f"{' ' * 4 * depth}{row}," for row in rows)


def _wrong_settings(plan: RobotPlan) -> Iterator[str]:
    if plan.network:
        yield '("address", "")'
        yield '("port", 70000)'
    if plan.serial:
        yield '("serial_port", "")'
        yield '("baud", 0)'
    yield '("wheel_radius", 0)'
    yield '("track", "wide")'
    yield '("full_speed", -1)'


def _suitable(plan: RobotPlan) -> list[tuple[str, str]]:
    """The first examples that such a robot can run."""
    fitting = _EXAMPLES if plan.body.reach <= _WIDEST else _EXAMPLES_WITH_ROOM
    return [example for example in fitting if _can_run(plan, example[0])][:_EXAMPLES_TRIED]


def _can_run(plan: RobotPlan, example: str) -> bool:
    tree = running.read(running.example(example)).tree
    diagnostics = check(tree, builtin(), equipment(plan.devices(), plan.abilities()))
    return not any(diagnostic.severity == "error" for diagnostic in diagnostics)


def _excused(plan: RobotPlan) -> str:
    reasons = [f"    {literal(claim)}: {literal(why)}," for claim, why in unkept(plan).items()]
    return "\n" + "\n".join(reasons) + "\n" if reasons else ""


def unkept(plan: RobotPlan) -> Mapping[str, str]:
    """The claims of `check_robot` that such a robot cannot meet, with the reasons."""
    reasons = {}
    ahead, turned = _driven(plan, 50, 0)[0], _driven(plan, 0, 45)[1]
    if not _FORWARD[0] < ahead < _FORWARD[1]:
        reasons["positive speed is forward"] = (
            f"at 50 mm/s it drives {ahead:.0f} mm in the first second"
        )
    if not _RIGHT[0] < turned < _RIGHT[1]:
        claim = "positive rotation is to the right"
        reasons[claim] = f"at 45 degrees/s it turns {turned:.0f} degrees in the first second"
    if any(not joint.minimum <= 10 <= joint.maximum for joint in plan.joint):
        claim = "its joints move to the commanded angle"
        reasons[claim] = "one of its joints cannot reach 10 degrees"
    if plan.gyroscope and plan.gyroscope.noise > 0.5:
        reasons["its gyroscope reads 0 after a reset"] = "its gyroscope is noisy"
    if plan.accelerometer and plan.accelerometer.noise > 0.3:
        reasons["its accelerometer shows 1 g upwards at rest"] = "its accelerometer is noisy"
    return reasons


def _driven(plan: RobotPlan, adv: float, rot: float) -> tuple[float, float]:
    """The distance and the turn of its twin in the first second, in mm and degrees."""
    world = World(load_world("empty"))
    fields = {field: getattr(plan, field) for field in RobotFile.__struct_fields__}
    body = world.add_robot(RobotDescription(name=plan.name, **fields))
    x, y, heading = body.pose
    body.drive(adv, rot)
    while world.time < 1:
        world.step()
    looks = math.radians(heading)
    ahead = (body.pose[0] - x) * math.cos(looks) - (body.pose[1] - y) * math.sin(looks)
    return ahead, (body.pose[2] - heading + 180) % 360 - 180
