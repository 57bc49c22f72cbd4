import sys
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest

from learnblock.blocks import builtin
from learnblock.blocks.configuration import Parameter
from learnblock.blocks.derivation import derive, derive_plugins
from learnblock.errors import LearnBlockError, ProgramError

SKILLS = Path(sys.modules[derive.__module__].__file__).parents[1] / "skills"


def derived(source: str):
    (block,) = derive(source, "ball_room.py")
    return block


def test_a_function_that_takes_the_robot_first_is_a_block():
    block = derived('def follow_the_light(robot): """Go where it is bright."""')

    assert ("others", "Ball room", "follow_the_light") == (block.type, block.category, block.name)
    assert {"EN": "follow the light"} == block.languages
    assert {"EN": "Go where it is bright."} == block.tooltip
    assert not block.returns_value


def test_the_tooltip_is_the_first_paragraph():
    block = derived('def f(robot):\n    """Go\n    on.\n\n    And on.\n    """')

    assert {"EN": "Go on."} == block.tooltip


def test_without_a_docstring_the_name_is_the_tooltip():
    assert {"EN": "say HELLO world"} == derived("def say_HELLO_World(robot): ...").tooltip


@pytest.mark.parametrize(
    ("written", "kind", "default", "required"),
    [
        ("x: float", "float", None, True),
        ("x: int = 3", "int", 3, False),
        ("x: str = 'Up'", "string", "Up", False),
        ("x: bool = False", "boolean", False, False),
        ("x: list[int] = []", "list", [], False),
        ("x: 'float' = 1", "float", 1, False),
        ("x: int | None = None", "int", None, False),
        ("x: int | str = 8", "apriltext", 8, False),
        ("x: int | str | None = None", "apriltext", None, False),
        ("x=2", "int", 2, False),
        ("x='a'", "string", "a", False),
        ("x=-2.5", "float", -2.5, False),
        ("x=True", "boolean", True, False),
        ("x", "float", None, True),
        ("x: Decimal = compute()", "float", None, False),
        ("x=b'raw'", "float", None, False),
    ],
)
def test_a_parameter_s_type_comes_from_its_hint_or_else_its_default(
    written, kind, default, required
):
    (parameter,) = derived(f"def f(robot, {written}): ...").parameters

    assert parameter == Parameter("x", kind, default, required, {"EN": "x"})


@pytest.mark.parametrize(
    ("source", "is_value"),
    [
        ("def f(robot) -> bool: ...", True),
        ("def f(robot) -> None: return print()", False),
        ("def f(robot): return 3", True),
        ("def f(robot): return", False),
        ("def f(robot):\n    def inner(): return 3\n    inner()", False),
        ("def f(robot):\n    if robot:\n        return 3", True),
    ],
)
def test_a_function_that_returns_something_is_a_value(source, is_value):
    assert is_value is derived(source).returns_value


def test_private_functions_classes_and_functions_without_a_robot_are_no_blocks():
    source = "def _help(robot): ...\nclass A:\n    def f(self): ...\ndef g(): ...\nx = 1\n"

    assert () == derive(source, "a.py")


def test_of_two_functions_of_one_name_the_later_counts():
    assert "Two." == derived("def f(robot): 'One.'\ndef f(robot): 'Two.'").tooltip["EN"]


def test_a_file_that_is_no_python_is_refused_with_its_place():
    with pytest.raises(ProgramError, match=r"dance\.py:2:\d+: syntax-error"):
        derive("x = 1\ndef f(robot:\n", "dance.py")


@pytest.mark.parametrize("source", ["x = '\0'", "-" * 200_000 + "1"])
def test_a_file_that_python_cannot_even_parse_is_refused(source):
    with pytest.raises(ProgramError, match="syntax-error"):
        derive(source, "dance.py")


def test_what_our_own_skills_would_be_without_configurations_agrees_with_them():
    for path in SKILLS.glob("*.py"):
        for block in derive(path.read_text("utf-8"), str(path)):
            ours = builtin().get(block.name)
            if ours is None:
                continue
            assert ours.shapes == block.shapes
            assert [(one.name, one.type, one.default, one.required) for one in ours.parameters] == [
                (one.name, one.type, one.default, one.required) for one in block.parameters
            ]


def plugin(monkeypatch, module: str) -> None:
    point = EntryPoint("dances", module, "learnblock.skills")
    monkeypatch.setattr("importlib.metadata.entry_points", lambda group: [point])


@pytest.mark.parametrize("module", ["lb_dances", "lb_dances.latin.slow"])
def test_a_plugin_s_skills_are_read_without_importing_it(tmp_path, monkeypatch, module):
    package = tmp_path / "lb_dances"
    (package / "latin").mkdir(parents=True)
    for path in (package / "__init__.py", package / "latin" / "slow.py"):
        path.write_text("def rumba(robot): 'Dance.'\nraise SystemExit\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    plugin(monkeypatch, module)

    assert ["rumba"] == [block.name for block in derive_plugins()]
    assert "lb_dances" not in sys.modules


@pytest.mark.parametrize("module", ["lb_no_such_package", "learnblock.no_such_module", "sys"])
def test_a_plugin_whose_module_is_missing_is_named(monkeypatch, module):
    plugin(monkeypatch, module)

    with pytest.raises(LearnBlockError, match=f"the plugin `dances` names the module {module}"):
        list(derive_plugins())
