import pytest

from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter
from learnblock.errors import Diagnostic
from learnblock.language import check, recover
from learnblock.senses import equipment
from places import TESTS


@pytest.fixture
def cases():
    return TESTS / "cases"


def skill(name, *parameters, type="motor", answers=False, needs=("Base",)):  # noqa: A002
    return BlockConfiguration(
        type=type,
        category=type,
        name=name,
        parameters=parameters,
        shapes=("blockLeft",) if answers else ("blockVertical",),
        needs=needs,
    )


@pytest.fixture
def skills():
    """Some of the robot's skills, as configurations."""
    speed = Parameter("advSpeed", "float", default=40.0)
    angle = Parameter("angle", "float", required=True)
    adv, rot = Parameter("adv", "float", required=True), Parameter("rot", "float", required=True)
    camera = {"type": "perceptual", "answers": True, "needs": ("Camera",)}
    ground = {"type": "perceptual", "answers": True, "needs": ("GroundSensors",)}
    sides = ("is_center", "is_left", "is_right")
    found = [
        skill("move_straight", speed),
        skill("turn", angle),
        skill("set_move", adv, rot),
        skill("stop_bot"),
        *(skill(name) for name in ("move_left", "move_right", "turn_left", "turn_right")),
        skill("slow_down", Parameter("decAdv", "float", 5.0), Parameter("decRot", "float", 5.0)),
        skill("reset_orientation", Parameter("keygyro", "string", "Z_AXIS"), needs=("Gyroscope",)),
        skill("set_orientation", angle, needs=("Base", "Gyroscope")),
        skill("look_floor", needs=("JointMotor:CAMERA",)),
        skill("look_front", needs=("JointMotor:CAMERA",)),
        *(
            skill(f"express{emotion}", type="express", needs=("Display",))
            for emotion in ("Joy", "Sadness", "Surprise", "Fear", "Neutral")
        ),
        *(skill(f"{side}_black_line", **camera) for side in sides),
        *(skill(f"{side}_ground_line", **ground) for side in sides),
        *(skill(name, **camera) for name in ("is_any_tag", "tag_on_the_left", "tag_on_the_right")),
        skill("is_tag", Parameter("idTag", "apriltext", 8), **camera),
        skill("sleep", Parameter("seconds", "float", required=True), type="others", needs=()),
    ]
    return {one.name: one for one in found}


@pytest.fixture
def thymio():
    devices = ("Base:ROBOT", "GroundSensors:ROBOT", "DistanceSensors:ROBOT", "Display:ROBOT")
    return equipment(devices, None)


@pytest.fixture
def diagnose(skills, thymio):
    """The diagnostics of `learnblock check` for a robot like Thymio."""

    def diagnosed(text) -> list[Diagnostic]:
        program, diagnostics = recover(text)
        return list(diagnostics) or check(program, skills, thymio)

    return diagnosed


@pytest.fixture
def report(diagnose):
    """The output of `learnblock check` for a program and a robot like Thymio."""

    def printed(text, filename):
        parts = []
        for diagnostic in diagnose(text):
            parts.append(diagnostic.located(filename))
            pointed = diagnostic.pointed(text)
            if pointed:
                parts.append(pointed)
        return "\n".join([*parts, ""])

    return printed
