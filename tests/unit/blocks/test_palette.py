"""The palette: every block that a program can have, in the user's language."""

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest

from learnblock.blocks import builtin
from learnblock.blocks import palette as module
from learnblock.blocks.labels import label
from learnblock.blocks.palette import palette
from learnblock.blocks.schema.configuration import Parameter
from learnblock.blocks.toolbox import SHADOWS, parameter_shadow
from learnblock.blocks.translation import languages, translation
from learnblock.fields import Range
from learnblock.language import Workspace, from_workspace
from learnblock.language.tree.builtins import BUILTINS, TEMPLATES
from learnblock.language.workspace.blocks import Block, Input, Variable
from learnblock.language.workspace.statement_reader import STATEMENTS
from learnblock.language.workspace.types import HATS
from learnblock.language.workspace.value_reader import VALUES

FOLDER = Path(module.__file__).parent / "translations"
every_language = pytest.mark.parametrize("language", ["en", "es"])


def blocks(found):
    return [one for tab in found["toolbox"]["contents"] for one in tab.get("contents", [])]


def named(found, kind):
    return next(one for one in found["definitions"] if one["type"] == kind)


def test_there_is_a_definition_for_each_block_of_ours_and_each_skill():
    defined = [one["type"] for one in palette(builtin(), "en")["definitions"]]
    ours = {kind for kind in {*HATS, *STATEMENTS, *VALUES} if kind.startswith("lb_")}
    skills = {f"lb_skill_{name}" for name in builtin()} - {"lb_skill_elapsedTime"}
    # The page creates the fields of parameters itself.
    fields = {"lb_slider", "lb_angle", "lb_choice", "lb_colour", "lb_tag", "lb_truth"}
    assert (ours - fields) | skills | {"lb_import", "lb_setup", "lb_without_robot"} == set(defined)
    assert len(defined) == len(set(defined))


def test_every_skill_is_in_the_toolbox_once():
    kinds = [one["type"] for one in blocks(palette(builtin(), "en"))]
    for name in builtin().keys() - {"elapsedTime"}:
        assert 1 == kinds.count(f"lb_skill_{name}")


@pytest.mark.parametrize(
    ("skill", "output"),
    [("is_center_ground_line", "Boolean"), ("get_min_distance", None), ("stop_bot", "a statement")],
)
def test_a_question_is_a_boolean_block_and_a_measurement_any_value(skill, output):
    definition = named(palette(builtin(), "en"), f"lb_skill_{skill}")

    assert output == definition.get("output", "a statement")


@every_language
def test_each_placeholder_in_a_message_is_filled(language):
    words = translation(language)
    for one in palette(builtin(), language)["definitions"]:
        reference = re.fullmatch(r"%\{BKY_(\w+)\}", one["message0"])
        message = words[reference[1]] if reference else one["message0"]
        places = re.findall(r"(?<!%)%(\d+)", message)
        asked = [arg for arg in one["args0"] if arg["type"] != "input_dummy"]
        expected = len(one["args0"] if places and len(asked) < len(one["args0"]) else asked)
        assert sorted(map(str, range(1, expected + 1))) == sorted(places)


@every_language
def test_every_word_in_a_definition_exists(language):
    text = json.dumps(palette(builtin(), language))
    assert set(re.findall(r"BKY_(\w+)", text)) <= translation(language).keys()


def test_english_and_spanish_have_the_same_words():
    english, spanish = (json.loads((FOLDER / f"{one}.json").read_bytes()) for one in ("en", "es"))
    assert list(english) == list(spanish)
    for name, text in english.items():
        assert re.findall(r"%\d", text) == re.findall(r"%\d", spanish[name])


def test_an_untranslated_language_falls_back_to_english():
    assert "nl" not in languages()
    assert translation("en") == translation("nl")
    assert translation("es") == translation("es-MX")


def test_skills_are_translated():
    found = named(palette(builtin(), "es"), "lb_skill_move_left")
    assert "ir en curva sin parar a la %3 a %1 mm/s, %2°/s" == found["message0"]
    assert found["tooltip"].startswith("Avanza en curva")


def test_a_label_places_its_parameters_and_others_follow_with_their_names():
    drive = replace(
        builtin()["move_left"],
        languages={"EN": "turn {rotSpeed}°/s {oops} {advSpeed.direction} 5%"},
    )
    found = named(palette({"move_left": drive}, "en"), "lb_skill_move_left")
    assert "turn %3 %2°/s {oops} {advSpeed.direction} 5%% speed %1" == found["message0"]


def test_the_sign_of_a_number_is_a_menu_of_two_words():
    angle, _, direction, *_ = named(palette(builtin(), "es"), "lb_skill_turn")["args0"]
    assert angle["name"] == "angle"
    assert direction == {
        "type": "lb_direction",
        "name": "angle.direction",
        "options": [["derecha", "positive"], ["izquierda", "negative"]],
    }


def test_a_part_in_brackets_is_hidden_while_it_only_says_the_usual():
    found = named(palette(builtin(), "en"), "lb_skill_drive_distance")
    assert found["message0"] == "drive %3 %1 mm %4 %5  at %2 mm/s %6 "
    assert found["args0"][3:] == [
        {
            "type": "lb_more",
            "name": "advSpeed.more",
            "usual": {"advSpeed": 80},
            "end": "advSpeed.after",
        },
        {"type": "input_dummy", "name": "advSpeed.before"},
        {"type": "input_dummy", "name": "advSpeed.after"},
    ]


@pytest.mark.parametrize("words", ["[loud]", "[at {angle}°]", "[at {oops}°]"])
def test_brackets_around_anything_else_are_plain_text(words):
    turn = replace(builtin()["turn"], languages={"EN": f"turn {{angle.direction}} {words}"})
    assert "[" in named(palette({"turn": turn}, "en"), "lb_skill_turn")["message0"]
    assert "[" in label(turn, "en")


def test_each_built_in_label_places_each_parameter_once(subtests):
    for block in builtin().values():
        with subtests.test(block.name):
            for text in block.languages.values():
                places = re.findall(r"\{([\w.]+)\}", text)
                directed = [one.name for one in block.parameters if one.directions]
                names = [one.name for one in block.parameters]
                assert sorted(places) == sorted([*names, *(f"{one}.direction" for one in directed)])


def test_a_percent_sign_in_a_label_is_escaped():
    volume = replace(builtin()["stop_bot"], name="loud", languages={"EN": "100% loud"})
    assert "100%% loud" == named(palette({"loud": volume}, "en"), "lb_skill_loud")["message0"]


def test_a_custom_tab_keeps_its_name():
    waltz = replace(builtin()["stop_bot"], name="waltz", category="Dances")
    tabs = palette({"waltz": waltz}, "es")["toolbox"]["contents"]
    assert ("Dances", "lb_skill_waltz") == (tabs[0]["name"], tabs[0]["contents"][0]["type"])


@pytest.mark.parametrize(
    ("skill", "parameter", "shown"),
    [
        ("move_straight", "advSpeed", {"type": "math_number", "fields": {"NUM": 40}}),
        ("is_tag", "idTag", {"type": "lb_tag", "fields": {"TEXT": "8"}}),
    ],
)
def test_an_input_shows_the_default_of_its_parameter(skill, parameter, shown):
    found = next(
        one for one in blocks(palette(builtin(), "en")) if one["type"] == f"lb_skill_{skill}"
    )
    assert shown == found["inputs"][parameter]["shadow"]


@pytest.mark.parametrize(("language", "text"), [("en", "hello"), ("es", "hola")])
def test_a_new_block_begins_with_a_word_of_the_language(language, text):
    found = {one["type"]: one for one in blocks(palette(builtin(), language))}
    shadows = [found[f"lb_skill_{name}"]["inputs"]["text"] for name in ("say_Text", "show_text")]
    assert [one["shadow"]["fields"] for one in shadows] == [{"TEXT": text}] * 2


def test_every_parameter_but_a_list_has_a_shadow():
    parameters = [one for block in builtin().values() for one in block.parameters]
    lacking = [one.type for one in parameters if parameter_shadow(one) is None]
    assert {"list"} >= set(lacking)
    assert all(SHADOWS.values())


@pytest.mark.parametrize(
    ("parameter", "field", "shadow"),
    [
        (Parameter("x", "float", 5, range=Range(0, 9)), {"min": 0, "max": 9}, ("lb_slider", 5)),
        (
            Parameter("x", "int", range=Range(3, 9, 2)),
            {"min": 3, "max": 9, "step": 2},
            ("lb_slider", 3),
        ),
        (Parameter("x", "angle", range=Range(-9, -1)), {"min": -9, "max": -1}, ("lb_angle", -1)),
        (
            Parameter("x", "choice", choices=("a", "b")),
            {"options": [["a", "a"], ["b", "b"]]},
            ("lb_choice", "a"),
        ),
        (
            Parameter("x", "choice", "b", choices=("a", "b")),
            {"options": [["a", "a"], ["b", "b"]]},
            ("lb_choice", "b"),
        ),
        (
            Parameter(
                "x", "choice", choices=("a", "b"), choice_names={"b": {"ES": "bé", "EN": "bee"}}
            ),
            {"options": [["a", "a"], ["bee", "b"]]},
            ("lb_choice", "a"),
        ),
        (Parameter("x", "colour", "#00ff00"), None, ("lb_colour", "#00ff00")),
        (Parameter("x", "colour"), None, ("lb_colour", "#ff0000")),
        (Parameter("x", "apriltext"), None, ("lb_tag", "")),
        (Parameter("x", "boolean", True), None, ("lb_truth", "TRUE")),
    ],
)
def test_a_parameter_has_the_field_of_its_type(parameter, field, shadow):
    waltz = replace(builtin()["stop_bot"], name="waltz", parameters=(parameter,))
    (place,) = named(palette({"waltz": waltz}, "en"), "lb_skill_waltz")["args0"]
    found = parameter_shadow(parameter)

    assert field == place.get("field")
    assert shadow == (found.type, found.value)


def test_each_block_of_the_toolbox_is_one_that_a_program_can_have():
    for state in blocks(palette(builtin(), "en")):
        if state["type"] in HATS:
            continue
        problems = from_workspace(alone(state), builtin()).problems
        assert {"missing-value", "missing-condition", "import-name"} >= {
            problem.code for _, problem in problems
        }


def alone(state):
    """Return a workspace with one block of the toolbox, as the page creates it."""
    fields = dict(state.get("fields", {}))
    if state["type"] in {"variables_set", "math_change", "lb_change"} or "VAR" in fields:
        fields["VAR"] = {"id": "x"}
    inputs = {
        name: Input(shadow=Block(**plug["shadow"], id=name))
        for name, plug in state.get("inputs", {}).items()
        if "shadow" in plug
    }
    fields.setdefault("MODULE", "dance")
    if state["type"] in {"lb_change", "lb_change_index"}:
        fields["OP"] = "-="
    if state["type"] == "lb_in":
        fields["OP"] = "in"
    block = Block(state["type"], "b", fields=fields, inputs=inputs)
    block.extraState = state.get("extraState")
    definition = builtin().get(state["type"].removeprefix("lb_skill_"))
    is_value = state["type"] in VALUES if definition is None else definition.returns_value
    if is_value and state["type"] not in {"lists_getIndex"}:
        holder = Block("variables_set", "s", fields={"VAR": {"id": "x"}})
        holder.inputs["VALUE"] = Input(block=block)
        block = holder
    start = Block("lb_start", "start", inputs={"DO": Input(stack=[block])})
    return Workspace([[start]], [Variable("x", "x")])


def test_each_function_of_the_language_has_the_colour_of_a_tab():
    assert {*BUILTINS, *(name for name, _ in TEMPLATES)} == palette(builtin(), "en")["calls"].keys()


@pytest.mark.parametrize(("language", "unit"), [("en", "seconds"), ("es", "segundos")])
def test_a_parameter_names_the_unit_that_follows_it_in_the_sentence(language, unit):
    found = palette(builtin(), language)
    seconds = next(one for one in named(found, "lb_skill_sleep")["args0"] if one.get("label"))
    assert unit == seconds["unit"]
    assert "unit" not in named(found, "lb_skill_say_Text")["args0"][0]


@every_language
def test_each_call_of_python_in_the_palette_is_a_sentence_with_all_its_values(language):
    found = palette(builtin(), language)
    words = translation(language)
    calls = [
        one["extraState"] for one in blocks(found) if one["type"] in ("lb_call", "lb_call_value")
    ]
    assert calls
    for one in calls:
        sentence = words[f"LB_CALL_{one['name'].upper()}_{one['arguments']}"]
        places = [f"%{place + 1}" for place in range(one["arguments"])]
        assert places == re.findall(r"%\d", sentence)


@pytest.mark.parametrize(
    ("kind", "english", "spanish"),
    [
        ("lb_when_is_key_pressed", "when key %1 is pressed", "cuando se pulsa la tecla %1"),
        ("lb_when_is_bumped", "when bumped", "cuando choco"),
        (
            "lb_when_is_front_obstacle",
            "when obstacle nearer than %1 mm",
            "cuando hay un obstáculo a menos de %1 mm",
        ),
        ("lb_when_received", "when I hear %1", "cuando oigo %1"),
        ("lb_when_collected", "when I collect a %1", "cuando recojo %1"),
        ("lb_when_is_time_up", "when time is up", "cuando se acaba el tiempo"),
    ],
)
def test_a_ready_hat_is_a_sentence_with_the_values_of_its_condition(kind, english, spanish):
    for language, sentence in (("en", english), ("es", spanish)):
        found = palette(builtin(), language)
        hat, skill = named(found, kind), named(found, kind.replace("lb_when_", "lb_skill_"))
        assert f"%{{BKY_{kind.upper()}}}" == hat["message0"]
        assert sentence == found["messages"][kind.upper()]
        assert hat["args0"] == skill["args0"]
