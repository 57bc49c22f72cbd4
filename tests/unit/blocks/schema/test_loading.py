import json
import re
from importlib.metadata import EntryPoint, EntryPoints
from pathlib import Path
from typing import get_args

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.blocks import builtin, load_configurations
from learnblock.blocks.known import all_configurations
from learnblock.blocks.labels import label
from learnblock.blocks.schema.configuration import (
    SIGNS,
    BlockConfiguration,
    Parameter,
    ParameterType,
)
from learnblock.blocks.schema.loading import tabs
from learnblock.blocks.schema.writing import written
from learnblock.devices import DEVICE_TYPES
from learnblock.errors import BlockConfigurationError
from learnblock.fields import Range
from learnblock.senses import SENSES
from places import TESTS

HERE = Path(__file__).parent
CONFIGURATIONS = Path(builtin.__wrapped__.__code__.co_filename).parents[1] / "configurations"
WALTZ = """{
  "type": "motor", "category": "Dance", "name": "waltz", "shape": ["blockVertical"],
  "variables": [{"type": "int", "name": "times", "default": 3}]
}"""


def spoken(block: BlockConfiguration) -> list[tuple[str, dict[str, str]]]:
    """Yield every set of translations of a block."""
    labels = [(f"{block.name}.{one.name}", one.translations) for one in block.parameters]
    return [(block.name, block.languages), (f"{block.name} tooltip", block.tooltip), *labels]


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    for folder in ("skills", "blocks"):
        (tmp_path / folder).mkdir()
    return tmp_path


def test_the_paper_s_listing_1_loads_as_printed():
    angle = Parameter("angle", "float", default=0, translations={"ES": "angulo", "EN": "angle"})

    assert (
        BlockConfiguration(
            type="motor",
            category="Base",
            name="turn",
            parameters=(angle,),
            shapes=("blockVertical",),
            languages={"ES": "girar", "EN": "turn"},
            tooltip={
                "ES": "Gira la base del robot un angulo determinado",
                "EN": "Make the robot base turn a certain angle",
            },
        ),
    ) == load_configurations(TESTS / "cases" / "listing1.json")


def test_a_string_loads_like_a_file(tmp_path):
    (tmp_path / "waltz.json").write_text(WALTZ)

    assert load_configurations(tmp_path / "waltz.json") == load_configurations(WALTZ)


def test_a_byte_order_mark_is_ignored(tmp_path):
    (tmp_path / "waltz.json").write_text(WALTZ, "utf-8-sig")

    assert load_configurations(WALTZ) == load_configurations(tmp_path / "waltz.json")


def test_a_list_contains_several_blocks():
    blocks = load_configurations(f"[{WALTZ}, {WALTZ.replace('waltz', 'tango')}]")

    assert ["waltz", "tango"] == [block.name for block in blocks]


def test_an_empty_list_contains_no_blocks():
    assert () == load_configurations("[]")


def test_any_language_may_be_in_upper_or_lower_case():
    (block,) = load_configurations(WALTZ[:-1] + ', "languages": {"en": "waltz", "pt-br": "valsa"}}')

    assert {"EN": "waltz", "PT-BR": "valsa"} == block.languages


@pytest.mark.parametrize(
    ("kind", "written", "default"),
    [
        ("float", "40", 40),
        ("float", '"0"', 0),
        ("float", '"0.5"', 0.5),
        ("float", "null", None),
        ("float", '"None"', None),
        ("int", '"0.0"', 0),
        ("int", "12345678901234567890", 12345678901234567890),
        ("boolean", "0", False),
        ("boolean", '"True"', True),
        ("boolean", "false", False),
        ("string", '"Hola  Mundo"', "Hola  Mundo"),
        ("string", '""', ""),
        ("list", "[1, [2]]", [1, [2]]),
        ("list", '"[]"', []),
        ("apriltext", '"8"', 8),
        ("apriltext", '"ball"', "ball"),
    ],
)
def test_a_default_may_be_written_as_a_string(kind, written, default):
    (block,) = load_configurations(
        WALTZ.replace('"int"', f'"{kind}"').replace('"default": 3', f'"default": {written}')
    )
    (parameter,) = block.parameters

    assert (default, type(default)) == (parameter.default, type(parameter.default))
    assert not parameter.required


def test_a_parameter_without_a_default_must_be_given():
    (block,) = load_configurations(WALTZ.replace(', "default": 3', ""))

    assert block.parameters[0].required


@pytest.mark.parametrize("path", sorted((HERE / "malformed").glob("*.json")), ids=lambda p: p.stem)
def test_a_malformed_configuration_is_refused_with_position_and_advice(path):
    with pytest.raises(BlockConfigurationError) as caught:
        load_configurations(path)

    messages = [
        text
        for one in caught.value.diagnostics
        for text in (one.located(path.name), one.pointed(caught.value.source))
        if text
    ]
    assert path.with_suffix(".txt").read_text("utf-8") == "\n".join(messages) + "\n"


def test_a_file_larger_than_any_configuration_is_refused():
    with pytest.raises(BlockConfigurationError, match="too-large The file has 250,001 characters"):
        load_configurations(" " * 250_001)


@pytest.mark.parametrize("text", ["[" * 200_000, '{"a":' * 50_000, '"\\"' * 80_000])
def test_extreme_nesting_is_refused(text):
    with pytest.raises(BlockConfigurationError):
        load_configurations(text)


def test_at_most_a_hundred_problems_are_reported():
    with pytest.raises(BlockConfigurationError) as caught:
        load_configurations(f"[{'1, ' * 1000}1]")

    assert 100 == len(caught.value.diagnostics)


def test_thousands_of_digits_are_refused():
    with pytest.raises(BlockConfigurationError, match="more digits than a block"):
        load_configurations(WALTZ.replace("3", "3" * 5000))


def test_a_default_that_is_a_deeply_nested_string_is_refused():
    nested = '"' + "[" * 100_000 + '"'
    with pytest.raises(BlockConfigurationError, match="does not fit the type list"):
        load_configurations(WALTZ.replace("3", nested).replace('"int"', '"list"'))


def test_a_missing_file_raises_an_os_error(tmp_path):
    with pytest.raises(FileNotFoundError):
        load_configurations(tmp_path / "no.json")


anything = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=3), inner),
    max_leaves=4,
)
parameters = st.fixed_dictionaries(
    {},
    optional={
        "type": st.sampled_from([*get_args(ParameterType)]) | anything,
        "name": st.sampled_from(["a", "b"]) | anything,
        "range": st.lists(st.integers() | st.floats(), max_size=3) | anything,
        "choices": st.lists(st.text(max_size=3) | anything, max_size=3) | anything,
        "choiceNames": st.dictionaries(st.text(max_size=3), anything) | anything,
        "directions": st.fixed_dictionaries(dict.fromkeys(SIGNS, anything)) | anything,
        "default": anything,
        "translate": st.dictionaries(st.sampled_from(["EN", "en", "??"]), anything) | anything,
    },
)
blocks = st.fixed_dictionaries(
    {},
    optional={
        "type": st.just("motor") | anything,
        "category": st.just("Base") | anything,
        "name": st.sampled_from(["turn", "spin"]) | anything,
        "variables": st.lists(parameters, max_size=3) | anything,
        "shape": st.just(["blockLeft"]) | anything,
        "languages": anything,
        "tooltip": anything,
        "needs": anything,
        "more": anything,
    },
)


@given(blocks | st.lists(blocks, max_size=3) | anything)
def test_any_configuration_is_a_block_or_raises_our_own_error(value):
    blocks, diagnostics = outcome(json.dumps(value))

    assert bool(diagnostics) is (blocks is None)
    assert blocks is None or len(blocks) == (len(value) if isinstance(value, list) else 1)


def outcome(text: str):
    try:
        return load_configurations(text), ()
    except BlockConfigurationError as error:
        return None, error.diagnostics


# Built-in configurations.


def test_every_built_in_file_is_a_tab():
    assert sorted(tabs()) == sorted(path.stem for path in CONFIGURATIONS.glob("*.json"))


@pytest.mark.parametrize("tab", [*tabs()])
def test_the_built_in_configurations_pass_every_check(tab):
    blocks = load_configurations(CONFIGURATIONS / f"{tab}.json")
    complete = tuple(builtin()[block.name] for block in blocks)

    assert complete == load_configurations(written(complete))


def test_built_in_names_are_all_different():
    count = sum(len(load_configurations(path)) for path in CONFIGURATIONS.glob("*.json"))

    assert count == len(builtin())


def test_every_built_in_text_is_english_and_spanish(subtests):
    for block in builtin().values():
        with subtests.test(block.name):
            for _what, translations in spoken(block):
                assert {"EN", "ES"} == set(translations)
            assert all(text.endswith((".", "?")) for text in block.tooltip.values())
            # A Spanish question begins with its own question mark.
            for text in (block.languages["ES"], block.tooltip["ES"]):
                assert text.count("¿") == text.count("?")


def test_no_two_built_in_blocks_have_the_same_label():
    for language in ("EN", "ES"):
        labels = [label(block, language) for block in builtin().values()]
        assert len(labels) == len(set(labels))


def test_built_in_blocks_need_senses_and_devices_that_exist(subtests):
    for block in builtin().values():
        with subtests.test(block.name):
            for need in block.needs:
                assert need in SENSES or need.partition(":")[0] in DEVICE_TYPES


# The user's configurations.


def test_without_a_user_folder_there_are_only_built_in_blocks(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "nowhere"))

    assert builtin() == all_configurations()


def test_a_custom_skill_is_a_block_without_being_run(home):
    (home / "skills" / "ball_room.py").write_text(
        'def waltz(robot, times: int = 3) -> None:\n    "Dance."\n\n\nraise SystemExit\n'
    )
    block = all_configurations()["waltz"]

    assert ("Ball room", "waltz", {"EN": "Dance."}) == (block.category, block.name, block.tooltip)


def test_a_custom_skill_does_not_hide_a_built_in_one(home):
    (home / "skills" / "mine.py").write_text("def turn(robot): ...\n")

    assert builtin()["turn"] == all_configurations()["turn"]


def test_a_configuration_completes_the_block_of_a_skill(home):
    (home / "skills" / "mine.py").write_text("def waltz(robot, times: int = 3): 'Dance.'\n")
    (home / "blocks" / "waltz.json").write_text(
        WALTZ[:-1] + ', "languages": {"FR": "valse"}}', "utf-8"
    )
    block = all_configurations()["waltz"]

    assert {"EN": "waltz", "FR": "valse"} == block.languages
    assert {"EN": "Dance."} == block.tooltip
    assert {"EN": "times"} == block.parameters[0].translations
    assert ("motor", "Dance") == (block.type, block.category)


def test_a_configuration_adds_a_translation_to_a_built_in_block(home):
    (home / "blocks" / "fr.json").write_text(
        '{"type": "motor", "category": "Base", "name": "turn", "shape": ["blockVertical"],'
        ' "languages": {"FR": "tourner"}}',
        "utf-8",
    )
    ours, block = builtin()["turn"], all_configurations()["turn"]

    assert "tourner" == block.languages["FR"]
    assert ours.languages["ES"] == block.languages["ES"]
    assert (ours.parameters, ours.needs, ours.tooltip) == (
        block.parameters,
        block.needs,
        block.tooltip,
    )


def test_a_broken_file_is_reported_and_the_others_are_loaded(home):
    (home / "blocks" / "bad.json").write_text("{")
    (home / "skills" / "bad.py").write_text("x = 1\ndef rumba(robot, (:\n")
    (home / "skills" / "good.py").write_text("def waltz(robot): ...\n")
    found = all_configurations()

    assert "waltz" in found
    assert "rumba" not in found
    assert str(found.broken["rumba"]).startswith("bad.py, line 2: ")
    assert ["bad.py:2", "bad.json:1"] == [
        re.search(r"bad\.\w+:\d", str(problem))[0] for problem in found.problems
    ]


def test_a_skill_named_like_a_robot_attribute_is_not_a_block(home):
    (home / "skills" / "mine.py").write_text("def stop(robot): ...\n")

    assert builtin() == all_configurations()


def test_the_function_overrides_an_outdated_configuration(home):
    (home / "skills" / "mine.py").write_text("def waltz(robot, speed: float): 'Dance.'\n")
    (home / "blocks" / "waltz.json").write_text(WALTZ)

    assert ["speed"] == [one.name for one in all_configurations()["waltz"].parameters]


@pytest.mark.parametrize(
    ("variable", "range_", "choices"),
    [
        ('{"type": "float", "name": "x", "range": [0, 2.5]}', Range(0, 2.5), ()),
        ('{"type": "angle", "name": "x", "range": [-90, 90, 15]}', Range(-90, 90, 15), ()),
        ('{"type": "choice", "name": "x", "choices": ["a", "b"]}', None, ("a", "b")),
    ],
)
def test_a_parameter_may_have_a_range_or_choices(variable, range_, choices):
    (block,) = load_configurations(
        WALTZ.replace('{"type": "int", "name": "times", "default": 3}', variable)
    )

    assert (range_, choices) == (block.parameters[0].range, block.parameters[0].choices)


some_words = st.text(st.characters(categories=["L", "N"]), min_size=1, max_size=8)
texts = st.dictionaries(st.sampled_from(["EN", "ES", "PT-BR"]), some_words)
finite = st.integers(-1000, 1000) | st.floats(-1000, 1000).filter(lambda x: not x.is_integer())
ranges = st.tuples(finite, finite).filter(lambda ends: ends[0] < ends[1])
#: The parameter types, each with its other keys.
fields = st.one_of(
    st.tuples(st.sampled_from(["float", "angle"]), finite, st.none(), st.just(())),
    st.tuples(
        st.just("int"), st.integers(-99, 99), ranges.map(lambda ends: Range(*ends)), st.just(())
    ),
    st.tuples(
        st.just("string"), some_words.filter(lambda text: text != "None"), st.none(), st.just(())
    ),
    st.tuples(st.just("boolean"), st.booleans(), st.none(), st.just(())),
    st.tuples(st.just("list"), st.lists(finite), st.none(), st.just(())),
    st.tuples(st.just("colour"), st.just("#ff8800"), st.none(), st.just(())),
    st.tuples(st.just("choice"), st.just("a"), st.none(), st.just(("a", "b c"))),
)
choice_names = st.dictionaries(st.sampled_from(["a", "b c"]), texts)
signs = st.fixed_dictionaries(dict.fromkeys(SIGNS, texts))


@st.composite
def configurations(draw) -> BlockConfiguration:
    required = draw(st.integers(0, 2))
    parameters = []
    for i, (kind, default, range_, choices) in enumerate(draw(st.lists(fields, max_size=4))):
        given_default = None if i < required else draw(st.sampled_from([default, None]))
        names = draw(choice_names) if choices else {}
        is_number = kind in ("float", "int", "angle")
        directions = draw(st.just({}) | signs) if is_number else {}
        parameters.append(
            Parameter(
                f"p{i}",
                kind,
                given_default,
                i < required,
                draw(texts),
                range_,
                choices,
                names,
                directions,
            )
        )
    return BlockConfiguration(
        draw(st.sampled_from(["motor", "others"])), draw(some_words), "waltz", tuple(parameters),
        draw(st.sampled_from([("blockVertical",), ("blockLeft", "blockBoth")])),
        draw(texts), draw(texts), draw(st.sampled_from([(), ("Base", "JointMotor:CAMERA")])),
        draw(st.sampled_from(["any", "boolean"])),
    )  # fmt: skip


@given(configurations())
def test_a_written_configuration_is_read_unchanged(block):
    assert (block,) == load_configurations(written([block]))


def test_a_broken_plugin_does_not_affect_others(home, monkeypatch):
    (home / "lb_good.py").write_text("def rumba(robot): ...\n")
    (home / "lb_bad.py").write_text("def tango(robot:\n")
    monkeypatch.syspath_prepend(str(home))
    points = [
        EntryPoint(name, name, "learnblock.skills") for name in ("lb_gone", "lb_bad", "lb_good")
    ]
    monkeypatch.setattr("importlib.metadata.entry_points", lambda: EntryPoints(points))
    found = all_configurations()

    assert "rumba" in found
    assert 2 == len(found.problems)
