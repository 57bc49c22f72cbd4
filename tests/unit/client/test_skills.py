"""Claims about every skill, by its block configuration."""

import inspect
import subprocess
import sys
from contextlib import suppress
from itertools import product

import pytest

from learnblock.blocks import builtin
from learnblock.blocks.schema.configuration import BlockConfiguration
from learnblock.client import skills
from learnblock.devices import DEVICE_TYPES
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.senses import ABILITIES, SENSES
from learnblock.testing import FakeRobot

BLOCKS = list(builtin().values())
SAMPLES = {
    "angle": 1.0,
    "float": 1.0,
    "int": 1,
    "string": "CAMERA",
    "boolean": True,
    "list": [],
    "apriltext": 1,
}


class Listener:
    def __init__(self) -> None:
        self.lacking: list[str] = []

    def called(self, skill, args, kwargs) -> None:
        pass

    def missing(self, skill, device) -> None:
        self.lacking.append(device)


def with_key(need: str) -> str:
    """A sense, or a device with its key; an ability of a device is not looked for at run time."""
    kind, _, key = need.partition(":")
    known = need in SENSES or (key and "{" not in key and key not in ABILITIES.get(kind, ()))
    return need if known else kind + ":*"


def call(robot: FakeRobot, block: BlockConfiguration):
    required = [SAMPLES[one.type] for one in block.parameters if one.required]
    # The end of a game ends the program.
    with suppress(SystemExit):
        return getattr(robot, block.name)(*required)
    return None


def test_every_skill_of_ours_is_a_block_and_every_block_a_skill(monkeypatch, tmp_path):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))

    assert sorted(skills.find()) == sorted(builtin())


def test_a_skill_without_its_device_has_no_effect_and_reports_it(subtests):
    for block in BLOCKS:
        with subtests.test(block.name):
            listener = Listener()
            with FakeRobot(only=[], skills=[block.name], observer=listener) as robot:
                answer = call(robot, block)

                assert not block.needs or answer is None or answer is False
                assert answer is None or block.returns_value
                # Any device of that type satisfies a need without a key of its own.
                assert sorted(map(with_key, block.needed())) == sorted(
                    with_key(one if one in block.needed() else one.partition(":")[0])
                    for one in listener.lacking
                )
                assert [] == robot.commands


def test_a_skill_that_returns_a_boolean_is_a_question(subtests):
    for block in BLOCKS:
        with subtests.test(block.name):
            hint = skills.find([block.name])[block.name].__annotations__["return"]
            is_question = hint in (bool, "bool")

            assert is_question is (block.returns == "boolean")


def test_with_every_device_no_skill_reports_a_missing_one(subtests):
    for block in BLOCKS:
        with subtests.test(block.name):
            listener = Listener()
            with FakeRobot(skills=[block.name], observer=listener) as robot:
                # RGBled and led ask for the lamp with the key "Up", which this robot has.
                answer = call(robot, block)

                assert [] == listener.lacking
                assert block.returns_value or answer is None


def test_the_declared_devices_are_enough_for_a_skill(subtests):
    for block in BLOCKS:
        with subtests.test(block.name):
            ways = [SENSES.get(need, (need,)) for need in block.needs]
            for serving in product(*ways):
                needed = [DEVICE_TYPES[way.partition(":")[0]] for way in serving]
                listener = Listener()
                with FakeRobot(only=needed, skills=[block.name], observer=listener) as robot:
                    call(robot, block)

                    assert [] == listener.lacking


def test_a_block_has_its_function_s_parameters_and_defaults(subtests):
    for block in BLOCKS:
        with subtests.test(block.name):
            function = skills.find([block.name])[block.name]
            robot, *parameters = inspect.signature(function).parameters.values()

            assert "robot" == robot.name
            assert [
                (one.name, None if one.required else one.default, one.required)
                for one in block.parameters
            ] == [
                (
                    one.name,
                    None if one.default is one.empty else one.default,
                    one.default is one.empty,
                )
                for one in parameters
            ]


def test_a_skill_starts_its_documentation_with_a_sentence(subtests):
    for block in BLOCKS:
        with subtests.test(block.name):
            function = skills.find([block.name])[block.name]
            first = (inspect.getdoc(function) or "").splitlines()[0]

            assert first[:1].isupper()


def test_a_skill_of_a_plugin_or_of_the_user_never_hides_one_of_ours(monkeypatch, tmp_path):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "skills").mkdir()
    (tmp_path / "skills" / "mine.py").write_text(
        "def turn(robot): ...\n\n\ndef waltz(robot): return 3\n"
    )
    found = skills.find()

    assert "learnblock.skills.base" == found["turn"].__module__
    assert 3 == found["waltz"](None)


def test_a_file_runs_when_one_of_its_skills_is_called(own_home):
    (own_home / "skills").mkdir()
    (own_home / "skills" / "mine.py").write_text(
        "def waltz(robot): return 3\n\n\nraise SystemExit\n"
    )
    waltz = skills.find(["waltz"])["waltz"]

    with pytest.raises(LearnBlockError) as caught:
        waltz(None)
    assert caught.value.phrase == Phrase(
        "skill-file-broken", file="skills/mine.py", reason="SystemExit"
    )


def test_a_name_without_a_skill_is_left_out():
    assert {"turn"} == set(skills.find(["turn", "fly"]))
    assert {} == skills.find([])


@pytest.mark.parametrize(
    ("source", "phrase"),
    [
        (
            "import no_such_module\ndef waltz(robot): ...\n",
            Phrase(
                "skill-file-broken",
                file="skills/mine.py",
                reason="ModuleNotFoundError: No module named 'no_such_module'",
            ),
        ),
        (
            "x = 1\ndef waltz(robot):\n    return (\n",
            Phrase(
                "skill-file-syntax",
                file="skills/mine.py",
                line=3,
                reason="'(' was never closed",
            ),
        ),
        (
            "def waltz(robot): ...\nwaltz = 3\n",
            Phrase("skill-not-function", file="skills/mine.py", name="waltz"),
        ),
    ],
)
def test_a_broken_file_of_skills_is_reported_with_the_reason(own_home, source, phrase):
    (own_home / "skills").mkdir()
    (own_home / "skills" / "mine.py").write_text(source)
    (own_home / "skills" / "other.py").write_text("def rumba(robot): return 4\n")
    with FakeRobot() as robot:
        assert 4 == robot.rumba()
        with pytest.raises(LearnBlockError) as caught:
            robot.waltz()
    assert caught.value.phrase == phrase


class Importing(str):
    """The name of a module; whoever looks at it finds that another one has just been imported."""

    __slots__ = ()

    def startswith(self, *args):
        sys.modules["learnblock_imported_meanwhile"] = sys
        return super().startswith(*args)


def test_skills_are_found_while_another_thread_imports(monkeypatch):
    monkeypatch.setitem(sys.modules, Importing("learnblock_being_looked_at"), sys)
    monkeypatch.delitem(sys.modules, "learnblock_imported_meanwhile", raising=False)
    try:
        assert "move_straight" in skills.find()
    finally:
        sys.modules.pop("learnblock_imported_meanwhile", None)


def test_after_preparing_most_programs_load_no_skills():
    program = (
        "import sys\n"
        "from learnblock.client import skills\n"
        "skills.prepare()\n"
        "before = set(sys.modules)\n"
        "skills.find({'move_straight', 'drive_distance', 'turn'})\n"
        "print(sorted(set(sys.modules) - before))\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout == "[]\n"
