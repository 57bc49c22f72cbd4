import json
import sys
from importlib.metadata import EntryPoint, EntryPoints
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.blocks import builtin
from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter
from learnblock.blocks.schema.loading import load_configurations
from learnblock.blocks.source.derivation import derive, derive_plugin, fitted
from learnblock.blocks.source.signature import signatures
from learnblock.errors import LearnBlockError, ProgramError
from learnblock.fields import Range
from learnblock.storage import skill_files
from phrases import codes

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
    ("hint", "kind", "range_", "choices"),
    [
        ("Annotated[float, Range(0, 100)]", "float", Range(0, 100), ()),
        ("Annotated[int, Range(-10, 10, step=2)]", "int", Range(-10, 10, 2), ()),
        (
            "typing.Annotated[Angle, 'note', fields.Range(most=90, least=-90)]",
            "angle",
            Range(-90, 90),
            (),
        ),
        ("Annotated[float | None, Range(0.5, 1)]", "float", Range(0.5, 1), ()),
        ("'Annotated[int, Range(1, 6)]'", "int", Range(1, 6), ()),
        ("Annotated[str, 'of a song']", "string", None, ()),
        ('Literal["slow", "fast"]', "choice", None, ("slow", "fast")),
        ('Optional[Literal["one"]]', "choice", None, ("one",)),
        ("Colour", "colour", None, ()),
        ("fields.Colour", "colour", None, ()),
        ("Angle", "angle", None, ()),
        ("TagName", "apriltext", None, ()),
        ("list", "list", None, ()),
        ("typing.List[str]", "list", None, ()),
    ],
)
def test_a_hint_names_a_field(hint, kind, range_, choices):
    (parameter,) = derived(f"def f(robot, x: {hint}): ...").parameters

    assert (kind, range_, choices) == (parameter.type, parameter.range, parameter.choices)


@pytest.mark.parametrize(
    ("hint", "reason"),
    [
        ("Decimal", "block-unknown-hint"),
        ("dict[str, int]", "block-unknown-hint"),
        ("int | float | str", "block-unknown-hint"),
        ("None", "block-unknown-hint"),
        ("'('", "block-unknown-hint"),
        ("Annotated[str, Range(0, 1)]", "block-hint-range-not-number"),
        ("Annotated[int, Range(9, 1)]", "block-range-order"),
        ("Annotated[int, Range(0, 1, 5)]", "block-range-step"),
        ("Annotated[int, Range(0, 1e999)]", "block-range-ends"),
        ("Annotated[int, Range(LEAST, 9)]", "block-hint-range-number"),
        ("Annotated[int, Range(True, 9)]", "block-hint-range-number"),
        ("Annotated[int, Range(1)]", "block-hint-range-form"),
        ("Annotated[int, Range(0, 1, 2, 3)]", "block-hint-range-form"),
        ("Annotated[int, Range(0, most=1, size=2)]", "block-hint-range-form"),
        ("Literal[1, 2]", "block-hint-choices"),
        ('Literal["a", "a"]', "block-hint-choices"),
        ('Literal[""]', "block-hint-choices"),
    ],
)
def test_an_invalid_hint_is_reported_and_the_default_is_used(hint, reason):
    (argument,) = signatures(f"def f(robot, x: {hint} = 'Up'): ...", "a.py")[0].arguments

    assert reason in codes(argument.wrong)
    assert "string" == argument.field.type


words = st.sampled_from(["a", "b2", "x_y", "größe"])
numbers = st.integers(-1000, 1000)
plain = st.sampled_from(
    [("float", "float"), ("int", "int"), ("str", "string"), ("bool", "boolean"), ("list", "list"),
     ("Colour", "colour"), ("Angle", "angle"), ("TagName", "apriltext"), ('Literal["a"]', "choice")]
)  # fmt: skip


@given(
    st.dictionaries(words, plain),
    st.booleans(),
    st.lists(numbers, min_size=2, max_size=2, unique=True),
)
def test_any_signature_can_be_read(parameters, answers, ends):
    ends.sort()
    heads = [f"{name}: {hint}" for name, (hint, _) in parameters.items()]
    heads.append(f"last: Annotated[int, Range({ends[0]}, {ends[1]})]")
    block = derived(f"def f(robot, {', '.join(heads)}) -> {'int' if answers else 'None'}: ...")

    assert [*parameters.items(), ("last", (None, "int"))] == [
        (one.name, (parameters.get(one.name, (None,))[0], one.type)) for one in block.parameters
    ]
    assert Range(*ends) == block.parameters[-1].range
    assert answers is block.returns_value


# Chosen fields.


def fit(source: str, **chosen) -> BlockConfiguration:
    """Return the block of `source` with the `chosen` fields of parameters that fit."""
    (signature,) = signatures(source, "a.py")
    configuration = {"type": "motor", "category": "Dance", "name": "f", "shape": ["blockVertical"]}
    (written,) = load_configurations(json.dumps({**configuration, **chosen}))
    return fitted(written, signature, derived(source))


def test_colour_tab_and_words_are_chosen():
    block = fit("def f(robot): 'Go.'", languages={"ES": "ir"}, tooltip={"EN": "Run."})

    assert ("motor", "Dance") == (block.type, block.category)
    assert {"EN": "f", "ES": "ir"} == block.languages
    assert {"EN": "Run."} == block.tooltip


def test_names_order_and_defaults_of_parameters_are_the_function_s():
    variables = [
        {"type": "int", "name": "gone", "default": 3},
        {"type": "int", "name": "b", "default": 3, "translate": {"ES": "be"}},
    ]
    block = fit("def f(robot, a, b=4): ...", variables=variables)

    assert [("a", None, True), ("b", 4, False)] == [
        (one.name, one.default, one.required) for one in block.parameters
    ]
    assert {"EN": "b", "ES": "be"} == block.parameters[1].translations


@pytest.mark.parametrize(
    ("head", "chosen", "kind"),
    [
        ("x", "string", "string"),
        ("x=3", "string", "int"),
        ("x=3", "angle", "angle"),
        ("x: float", "angle", "angle"),
        ("x: str", "colour", "colour"),
        ("x: str", "float", "string"),
        ("x: bool", "int", "boolean"),
        ("x: Colour", "string", "colour"),
        ("x: Annotated[float, Range(0, 9)]", "float", "float"),
    ],
)
def test_a_field_can_be_chosen_if_the_function_does_not_determine_it(head, chosen, kind):
    block = fit(
        f"def f(robot, {head}): ...", variables=[{"type": chosen, "name": "x", "default": None}]
    )

    assert kind == block.parameters[0].type


def test_a_range_of_the_function_is_kept():
    head = "x: Annotated[float, Range(0, 9)]"
    variables = [{"type": "float", "name": "x", "default": None, "range": [0, 99]}]

    assert Range(0, 9) == fit(f"def f(robot, {head}): ...", variables=variables).parameters[0].range


@pytest.mark.parametrize(
    ("source", "shape", "is_value"),
    [
        ("def f(robot) -> bool: ...", "blockVertical", True),
        ("def f(robot): return 3", "blockVertical", False),
        ("def f(robot) -> bool: ...", "blockLeft", True),
        ("def f(robot) -> None: ...", "blockLeft", False),
    ],
)
def test_a_hint_determines_whether_a_function_returns_a_value(source, shape, is_value):
    assert is_value is fit(source, shape=[shape]).returns_value


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


@pytest.mark.parametrize(
    ("hint", "returns"),
    [("-> bool", "boolean"), ('-> "bool"', "boolean"), ("-> int", "any"), ("", "any")],
)
def test_a_hint_determines_whether_a_value_is_a_question(hint, returns):
    source = f"def f(robot) {hint}: return 3"

    assert returns == derived(source).returns
    assert returns == fit(source, shape=["blockLeft"]).returns


def test_a_configuration_makes_a_question_of_a_function_without_a_hint():
    block = fit("def f(robot): return 3", shape=["blockLeft"], returns="boolean")

    assert "boolean" == block.returns


def test_only_public_functions_with_a_robot_are_blocks():
    source = "def _help(robot): ...\nclass A:\n    def f(self): ...\ndef g(): ...\nx = 1\n"

    assert () == derive(source, "a.py")


def test_if_two_functions_have_the_same_name_the_later_is_used():
    assert "Two." == derived("def f(robot): 'One.'\ndef f(robot): 'Two.'").tooltip["EN"]


def test_a_file_of_invalid_python_is_refused_with_its_position():
    with pytest.raises(ProgramError, match=r"dance\.py:2:\d+: syntax-error"):
        derive("x = 1\ndef f(robot:\n", "dance.py")


@pytest.mark.parametrize("source", ["x = '\0'", "-" * 200_000 + "1"])
def test_a_file_that_python_cannot_even_parse_is_refused(source):
    with pytest.raises(ProgramError, match="syntax-error"):
        derive(source, "dance.py")


def test_blocks_derived_from_our_skills_match_their_configurations():
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
    monkeypatch.setattr("importlib.metadata.entry_points", lambda: EntryPoints([point]))


@pytest.mark.parametrize("module", ["lb_dances", "lb_dances.latin.slow"])
def test_a_plugin_s_skills_are_read_without_importing_it(tmp_path, monkeypatch, module):
    package = tmp_path / "lb_dances"
    (package / "latin").mkdir(parents=True)
    for path in (package / "__init__.py", package / "latin" / "slow.py"):
        path.write_text("def rumba(robot): 'Dance.'\nraise SystemExit\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    plugin(monkeypatch, module)

    assert ["rumba"] == [
        block.name for point in skill_files.plugins() for _, block in derive_plugin(point)
    ]
    assert "lb_dances" not in sys.modules


@pytest.mark.parametrize("module", ["lb_no_such_package", "learnblock.no_such_module", "sys"])
def test_a_plugin_whose_module_is_missing_is_named(monkeypatch, module):
    plugin(monkeypatch, module)

    with pytest.raises(LearnBlockError, match=f"The module {module} of the plugin 'dances'"):
        [*derive_plugin(*skill_files.plugins())]
