import json
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock import robots
from learnblock.blocks import builtin
from learnblock.language.blocktext.lexer import KEYWORDS
from learnblock.language.tree.builtins import FUNCTIONS
from learnblock.project.document.document import Document
from learnblock.project.help import services
from learnblock.project.help.services import complete, describe
from learnblock.project.help.words import library_parameters

HELP = Path(services.__file__).parent
EBO = "learnblock.robots.sim_ebo"
PROGRAM = """\
speed = 3
class = 1

def turn_by(angle):
    function.turn(angle)
    for i from 1 to 3:
        speed += i
    end
end

when seen = function.is_any_tag():
    turn_by(90)
    activate go
end

when go:
    x = state_seen and time_go > 3
end
"""


def document(text=PROGRAM):
    equipment = robots.find("sim-thymio").load().known_equipment()
    return Document.from_text(text, EBO, builtin(), equipment=equipment)


@pytest.fixture(scope="module")
def program():
    return document()


def place(text):
    """Return the line and column of the ``|`` in a text, and the text without it."""
    before, _, after = text.partition("|")
    return before.count("\n") + 1, len(before) - before.rfind("\n"), before + after


def typed(line, notation="blocktext"):
    """Return the suggestions at the ``|`` of a line typed below the program, by label."""
    whole = document()
    if notation == "python":
        text = whole.python.replace("\n\n\nrobot.run()", f"\n    {line}\n\n\nrobot.run()")
    else:
        text = PROGRAM + line
    number, column, text = place(text)
    found = complete(whole.with_text(notation, text), notation, number, column)
    return {option.label: option for option in found.options}


def told(one, notation, text, **more):
    """Return the description of the word with the ``|`` in the first line that matches."""
    shown = one.blocktext if notation == "blocktext" else one.python
    line = text.replace("|", "")
    start = shown.index(line)
    at = start + text.index("|")
    column = at - shown.rfind("\n", 0, at)
    return describe(one, notation, shown.count("\n", 0, at) + 1, column, **more)


# Completion.


def test_after_function_the_skills_are_suggested():
    found = typed("function.mo|")
    assert found["move_straight"].detail == "(advSpeed=40)"
    assert found["stop_bot"].insert == "stop_bot()"
    assert {option.sort for option in found.values()} == {"skill"}


def test_after_robot_the_skills_and_its_other_methods_are_suggested():
    found = typed("robot.mo|", "python")
    assert "move_straight" in found
    assert {label for label, option in found.items() if option.sort == "robot"} == {
        "when", "when_start", "run", "elapsedTime", "wait_until"
    }  # fmt: skip


def test_skills_are_explained_in_the_users_language(program):
    found = complete(program, "blocktext", 5, 14, language="es").options
    assert {option.label: option.help for option in found}["stop_bot"] == builtin()[
        "stop_bot"
    ].tooltip["ES"]


def test_an_unknown_language_gets_english_help(program):
    assert complete(program, "blocktext", 5, 14) == complete(
        program, "blocktext", 5, 14, language="xx"
    )


def test_a_line_begins_with_a_statement():
    found = typed("    |")
    assert found["while"].insert == "while ${condition}:\n    ${pass}\nend"
    assert {"speed", "turn_by", "function.stop_bot", "activate seen", "repeat"} <= found.keys()
    assert "def" not in found


def test_a_line_at_the_margin_may_define_something():
    assert {"def", "when", "main", "import"} <= typed("wh|").keys()
    assert {"def", "@robot.when"} <= {
        option.label for option in complete(document(), "python", 4, 1).options
    }


def test_an_expression_offers_values():
    found = typed("x = s|")
    assert {"speed", "state_seen", "time_go", "True", "sqrt", "function.is_any_tag"} <= found.keys()
    assert "while" not in found


@pytest.mark.parametrize("text", ['print(f"at {s|', "x = f'{{ {speed} {s|", 'x = f"{sq|}"'])
def test_a_value_in_a_text_offers_values(text):
    found = typed(text)
    assert {"speed", "sqrt", "function.is_any_tag"} <= found.keys()
    assert "while" not in found


@pytest.mark.parametrize("text", ['print(f"at s|', 'print("{s|', 'x = f"{{s|', 'x = f"{speed} s|'])
def test_the_text_around_values_offers_nothing(text):
    assert typed(text) == {}


def test_waiting_and_repeating_forever_are_suggested():
    found = typed("    |")
    assert found["forever"].insert == "forever:\n    ${pass}\nend"
    assert found["wait until"].insert == "wait until ${condition}"
    assert typed("robot.|", "python")["wait_until"].insert == "wait_until(lambda: ${condition})"


def test_a_function_may_set_a_variable_of_its_own():
    text = "def turn_by(angle):\n    lo|\nend\n"
    number, column, text = place(text)
    found = complete(document("x = 1\n").with_text("blocktext", text), "blocktext", number, column)
    assert "local ${1:name} = ${2:0}" in {option.insert for option in found.options}
    assert "local" not in typed("    |")
    assert "local" not in typed("    |", "python")


def test_in_python_a_when_has_its_attributes():
    found = typed("x = s|", "python")
    assert {"seen.active", "go.time", "class_", "speed", "len"} <= found.keys()
    assert not {"state_seen", "class", "sqrt"} & found.keys()
    assert typed("go.|", "python")["activate"].insert == "activate()"


@pytest.mark.parametrize(
    ("notation", "call"), [("blocktext", "function.is_tag(|"), ("python", "robot.is_tag(|")]
)
def test_for_a_tag_argument_the_tag_names_are_suggested(notation, call, tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "tags.toml").write_text('"red \\"door\\"" = 12\n')
    assert typed(call, notation)['"red \\"door\\""'].detail == "12"
    assert '"red \\"door\\""' not in typed(call.replace("is_tag", "turn"), notation)


def test_suggestions_work_with_an_invalid_file_of_tag_names(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "tags.toml").write_text("ball = 1000\n")
    assert "idTag=" in typed("function.is_tag(|")


def test_arguments_of_a_call_are_suggested_until_they_are_given():
    assert "advSpeed=" in typed("function.move_straight(|")
    assert "advSpeed=" not in typed("function.move_straight(advSpeed=3, |")
    assert "adv=" not in typed("function.set_move(3, |")
    assert "rot=" in typed("function.set_move(3, |")
    assert "angle=" in typed("turn_by(|")


def test_local_variables_are_suggested_inside_their_function(program):
    def offered(line):
        return {option.label for option in complete(program, "blocktext", line, 9).options}

    assert {"angle", "i"} <= offered(7)
    assert not {"angle", "i"} & offered(12)


def test_existing_brackets_are_not_inserted_again():
    assert typed("function.tu|(90)")["turn"].insert == "turn"


def test_import_suggests_the_available_libraries():
    waltz = replace(builtin()["turn"], name="waltz", library="dance")
    whole = Document.from_text("import ", EBO, {**builtin(), "waltz": waltz})
    found = complete(whole, "blocktext", 1, 8)
    assert ['"dance"'] == [one.label for one in found.options]


def test_activate_suggests_the_whens():
    assert typed("activate |").keys() == {"seen", "go"}


@pytest.mark.parametrize("line", ["# wh|", 'print("sp|', "print('sp|", "x = `sp|", "def |"])
def test_nothing_is_suggested_in_strings_comments_and_new_names(line):
    assert typed(line) == {}


def test_after_a_string_everything_is_suggested_again():
    assert "speed" in typed('print("a", s|')


def test_completion_works_while_the_text_has_mistakes():
    found = typed("other = 1\nif other\nwhile sp|")
    assert {"speed", "other"} <= found.keys()


def test_a_completion_replaces_the_word_from_its_start(program):
    assert complete(program, "blocktext", 5, 17).from_column == 14


# Descriptions.


def test_help_on_a_skill_has_its_parameters_and_description(program):
    found = told(program, "blocktext", "function.tu|rn(")
    assert found.title == "function.turn(angle, rotSpeed=120)"
    assert found.text == builtin()["turn"].tooltip["EN"]
    assert (found.from_column, found.to_column, found.needs) == (14, 18, ())
    assert told(program, "python", "robot.tu|rn(").title == "robot.turn(angle, rotSpeed=120)"


@pytest.mark.parametrize(
    ("skill", "served"),
    [
        ("is_center_black_line", "On this robot: the sensors under it"),
        ("set_orientation", "On this robot: the wheels"),
        ("is_front_obstacle", "On this robot: the distance sensors at the front"),
    ],
)
def test_help_on_a_skill_says_what_serves_its_sense_on_the_robot(skill, served):
    program = document(f"main:\n    x = function.{skill}()\nend\n")
    assert str(told(program, "blocktext", f"function.|{skill}").serves) == served


@pytest.mark.parametrize("skill", ["move_straight", "is_center_red_line"])
def test_help_names_no_device_without_a_sense_or_without_what_serves_it(skill):
    program = document(f"main:\n    x = function.{skill}()\nend\n")
    assert told(program, "blocktext", f"function.|{skill}").serves is None


def test_a_device_that_the_robot_lacks_is_named(program):
    assert told(program, "blocktext", "is_any|_tag").needs == ("Camera",)


@pytest.mark.parametrize(
    ("notation", "text", "title", "defined"),
    [
        ("blocktext", "speed += |i", "i", (6, 9)),
        ("blocktext", "spe|ed += i", "speed", (1, 1)),
        ("blocktext", "turn(ang|le)", "angle", (4, 13)),
        ("blocktext", "    turn|_by(90)", "turn_by(angle)", (4, 5)),
        ("blocktext", "activate g|o", "when go", (16, 6)),
        ("blocktext", "state_se|en", "state_seen", (11, 6)),
        ("python", "speed += |i", "i", (12, 9)),
        ("python", "turn(ang|le)", "angle", (9, 13)),
        ("python", "    turn|_by(90)", "turn_by(angle)", (9, 5)),
        ("python", "    g|o.activate()", "go", (23, 5)),
        ("python", "cla|ss_ = 1", "class_", (6, 1)),
    ],
)
def test_help_on_a_name_has_the_position_of_its_definition(program, notation, text, title, defined):
    found = told(program, notation, text)
    assert (found.title, (found.line, found.column)) == (title, defined)


@pytest.mark.parametrize(
    ("notation", "text", "sort", "name"),
    [
        ("blocktext", "spe|ed += i", "variable", "speed"),
        ("blocktext", "turn(ang|le)", "variable", "angle"),
        ("blocktext", "state_se|en", "when", "seen"),
        ("blocktext", "    turn|_by(90)", "function", "turn_by"),
        ("blocktext", "function.tu|rn(", "", ""),
        ("python", "cla|ss_ = 1", "variable", "class"),
        ("python", "    g|o.activate()", "when", "go"),
    ],
)
def test_help_names_what_can_be_renamed(program, notation, text, sort, name):
    found = told(program, notation, text)
    assert (found.sort, found.name) == (sort, name)
    if sort:
        assert "other" in program.renamed(sort, name, "other").blocktext


def test_a_parameter_with_the_name_of_a_variable_is_renamed_alone():
    one = document("x = 1\n\ndef f(x):\n    print(x)\nend\n")
    assert told(one, "blocktext", "print(|x)").name == "f.x"
    assert told(one, "blocktext", "|x = 1").name == "x"
    expected = "x = 1\n\ndef f(y):\n    print(y)\nend\n"
    assert one.renamed("variable", "f.x", "y").blocktext == expected


def test_a_word_of_the_language_has_help(program):
    assert told(program, "blocktext", "wh|en go").title == "when"
    assert told(program, "blocktext", "acti|vate go").text == "Starts a `when`."
    found = told(program, "blocktext", "acti|vate go", language="es")
    assert found.text == "Activa un `when`."


def test_a_function_of_the_language_has_help_on_each_form():
    found = told(document("x = p|op([1])\n".replace("|", "")), "blocktext", "p|op")
    assert found.title == "pop(values), pop(values, index)"


def test_help_on_an_argument_has_its_default():
    one = document("function.move_straight(advSpeed=3)\n")
    found = told(one, "blocktext", "adv|Speed=")
    assert found.title == "advSpeed"
    assert "Default: 40." in found.text


def test_inside_the_brackets_of_a_call_the_help_is_about_the_call():
    one = document("function.set_move(3, 4)\n")
    assert told(one, "blocktext", "set_move(3,| 4").title.startswith("function.set_move(")


@pytest.mark.parametrize("text", ["speed |= 3", "class = |1"])
def test_other_words_have_no_help(program, text):
    assert told(program, "blocktext", text).title == ""


def test_a_description_works_while_the_text_has_mistakes():
    one = document().with_text("blocktext", "if (\n" + PROGRAM)
    found = told(one, "blocktext", "turn|_by(90)")
    assert (found.title, found.line) == ("turn_by(angle)", 5)


# Everything.


@given(
    st.text(
        st.sampled_from("abx_.,:=()[]\"'`# \n\té1function.robot.turn(whenstate_go"), max_size=60
    ),
    st.sampled_from(["blocktext", "python"]),
    st.integers(-2, 9),
    st.integers(-2, 60),
)
@settings(max_examples=150)
def test_any_position_in_any_text_has_an_answer(text, notation, line, column):
    one = document("x = 1\n").with_text(notation, text)
    found = complete(one, notation, line, column)
    assert found.from_column >= 1
    assert describe(one, notation, line, column).line >= 0


def test_every_word_and_function_is_explained_in_every_language():
    english = json.loads((HELP / "en.json").read_text("utf-8"))
    assert english["functions"].keys() == FUNCTIONS
    soft = {"python", "repeat", "forever", "wait", "until", "local"}
    assert english["keywords"].keys() == KEYWORDS | soft
    assert all(library_parameters(name) for name in FUNCTIONS)
    for path in HELP.glob("*.json"):
        other = json.loads(path.read_text("utf-8"))
        assert english.keys() == other.keys()
        for key, words in english.items():
            if isinstance(words, dict):
                assert words.keys() == other[key].keys()


PASTED = """\
import math as m


class Dog:
    def bark(self, times=2):
        return times


try:
    first, second = 1, 2
except ValueError as error:
    print(error)
with open("x") as file:
    pass
"""


@pytest.mark.parametrize("notation", ["blocktext", "python"])
def test_names_that_lines_of_python_set_are_suggested(notation):
    whole = Document.from_text("", EBO, builtin()).with_text("python", PASTED)
    text = whole.blocktext if notation == "blocktext" else whole.python
    found = complete(whole, notation, len(text.split("\n")), 1).options
    labels = [option.label for option in found if option.sort == "variable"]
    expected = {"m", "Dog", "bark", "times", "first", "second", "error", "file"}
    assert expected <= set(labels)
    assert len(labels) == len(set(labels))
