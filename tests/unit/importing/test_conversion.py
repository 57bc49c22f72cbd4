"""Projects of the original LearnBlock become programs with their blocks in place."""

import time

import pytest

from learnblock import language
from learnblock.blocks import builtin
from learnblock.errors import ProjectError
from learnblock.i18n import Phrase
from old_projects import (
    CONTROL,
    FUNCTION,
    LIBRARY,
    SKILL,
    STYLES,
    VARIABLE,
    VERSION_1,
    Old,
    Pickler,
    Thing,
    control,
    define,
    examples,
    forever,
    main,
    project,
    skill,
    when,
    word,
)


def lines(made):
    return made.blocktext.splitlines()


def check(made):
    return language.check(language.parse(made.blocktext), builtin())


@pytest.mark.parametrize("style", STYLES)
def test_a_program_is_the_same_whichever_version_wrote_it(imported, style):
    made = imported(
        project(
            main(
                control("while", [word("not"), skill("is_center_red_line")], skill("turn_right")),
                forever(
                    control("if", [skill("is_center_red_line")], skill("move_straight")),
                    control("elif", [skill("is_left_red_line")], skill("move_left")),
                    control("else", [], skill("stop_bot")),
                    skill("sleep", ("float", "0.5")),
                ),
            ),
            style=style,
        )
    )
    assert lines(made) == [
        "main:",
        "    while not function.is_center_red_line():",
        "        function.turn_right()",
        "    end",
        "    forever:",
        "        if function.is_center_red_line():",
        "            function.move_straight()",
        "        elif function.is_left_red_line():",
        "            function.move_left()",
        "        else:",
        "            function.stop_bot()",
        "        end",
        "        function.sleep(0.5)",
        "    end",
        "end",
    ]
    assert check(made) == []


@pytest.mark.parametrize("data", examples())
def test_a_project_with_everything_checks_clean_and_its_blocks_are_its_program(imported, data):
    made = imported(data)
    assert [one for one in check(made) if one.severity == "error"] == []
    program = language.from_workspace(made.workspace, builtin()).program
    assert program == language.parse(made.blocktext)


def test_functions_events_and_main_stay_where_they_were(imported):
    made = imported(
        project(
            main(Old("dance", FUNCTION), place=(10, -20)),
            define("dance", skill("turn_left"), place=(300.5, 40)),
            when("seen", [skill("is_any_tag")], skill("expressJoy")),
        )
    )
    places = {stack[0].type: (stack[0].x, stack[0].y) for stack in made.workspace.stacks}
    assert places == {
        "lb_main": (10, -20),
        "procedures_defnoreturn": (300.5, 40),
        "lb_when": (0, 0),
    }
    assert "when seen = function.is_any_tag():" in lines(made)


def test_loose_blocks_stay_on_the_canvas_outside_the_program(imported):
    loose = Old("stop_bot", SKILL, place=(5, 6))
    value = Old("is_turning", SKILL, is_value=True, place=(7, 8))
    made = imported(project(main(skill("turn_back")), [loose, skill("look_up")], value))
    stacks = {tuple(block.type for block in stack): stack[0] for stack in made.workspace.stacks}
    first, second = ("lb_skill_stop_bot", "lb_skill_look_up"), ("lb_skill_is_turning",)
    assert (stacks[first].x, stacks[first].y) == (5, 6)
    assert (stacks[second].x, stacks[second].y) == (7, 8)
    assert lines(made) == ["main:", "    function.turn_back()", "end"]


def test_old_and_spanish_names_of_skills_get_their_names_of_today(imported):
    old = ["front_obstacle", "is_there_somebody_happy", "linea_negra_centro"]
    condition = [skill(old[0]), word("or"), skill(old[1]), word("or"), skill(old[2])]
    made = imported(project(main(control("if", condition, skill("desacelerar")))))
    assert lines(made)[1:3] == [
        "    if function.is_front_obstacle() or function.is_any_face_happy()"
        " or function.is_center_black_line():",
        "        function.slow_down()",
    ]
    assert Phrase("import-old-name", name="desacelerar", today="slow_down") in made.report.changed


@pytest.mark.parametrize(
    ("style", "line"),
    [(VERSION_1, "function.set_move(20, -11.5)"), (STYLES[1], "function.set_move(20, -0.2)")],
)
def test_only_version_1_has_radians(imported, style, line):
    values = ("float", "20"), ("float", "-0.2")
    made = imported(project(main(skill("set_move", *values)), style=style))
    assert lines(made)[1].strip() == line
    assert check(made) == []


def test_a_variable_of_version_1_is_turned_into_degrees_when_the_program_runs(imported):
    assign = Old("r", VARIABLE, [("float", "0.5")])
    move = skill("turn_left", ("float", "r"))
    made = imported(project(main(assign, move), variables=["r"], style=VERSION_1))
    assert lines(made)[1:3] == ["    r = 0.5", "    function.turn_left(r * 180 / pi())"]


@pytest.mark.parametrize(
    ("right", "line"),
    [
        ([word("n")], "print(n)"),
        ([word('"it is"'), word("+"), word("n")], 'print("it is" + n)'),
        ([], "print()"),
    ],
)
def test_print_gets_its_brackets(imported, right, line):
    made = imported(project(main(Old("n", VARIABLE, [("float", "1")]), Old("print", right=right))))
    assert lines(made)[2].strip() == line
    assert made.report.changed == (Phrase("import-print-brackets"),)


@pytest.mark.parametrize(
    ("kind", "text", "argument"),
    [
        ("float", "1,5", "1.5"),
        ("float", "007", "7"),
        ("float", "n", "n"),
        ("string", "3", "3"),
        ("int", "", "1"),
        ("float", "wrong value", "1"),
        ("boolean", "0", "False"),
    ],
)
def test_the_values_of_fields_become_arguments(imported, kind, text, argument):
    made = imported(
        project(
            main(Old("n", VARIABLE, [("float", "2")]), skill("sleep", (kind, text))),
            variables=["n"],
        )
    )
    assert lines(made)[2].strip() == f"function.sleep({argument})"
    assert check(made) == []


@pytest.mark.parametrize(
    ("kind", "text", "argument"),
    [
        ("string", 'say "hi"', "'say \"hi\"'"),
        ("string", '"quoted"', '"quoted"'),
        ("string", "`os`", '"`os`"'),
        ("list", "Do", '"Do"'),
        ("apriltext", "exit", '"exit"'),
    ],
)
def test_texts_of_fields_are_quoted(imported, kind, text, argument):
    made = imported(project(main(skill("say_Text", (kind, text)))))
    assert lines(made)[1].strip() == f"function.say_Text({argument})"


def test_names_that_block_text_does_not_allow_are_changed_everywhere(imported):
    made = imported(
        project(
            main(Old("my lines", FUNCTION), Old("end", VARIABLE, [("float", "1")])),
            define("my lines", Old("1st", VARIABLE, [("string", "a")])),
            variables=["end", "1st"],
            functions=["my lines"],
        )
    )
    assert lines(made) == [
        "def my_lines():", '    _1st = "a"', "end", "",
        "main:", "    my_lines()", "    end_ = 1", "end",
    ]  # fmt: skip
    assert Phrase("import-renamed", name="my lines", new="my_lines") in made.report.changed


def test_what_is_missing_is_listed_by_name_and_leaves_a_program_that_checks_clean(imported):
    made = imported(
        project(
            main(
                control("if", [skill("old_sensor")], skill("older", ("string", "go"))),
                control("while", [], skill("turn", *[("float", one) for one in ("90", "60", "1")])),
                Old("lost", FUNCTION),
                Old("other", LIBRARY),
                Old("activate gone", VARIABLE),
                Old("banana", CONTROL),
            ),
            libraries=["/home/someone/dance"],
        )
    )
    assert made.report.missing == (
        Phrase("import-unknown-skill", skill="old_sensor"),
        Phrase("import-unknown-skill", skill="older"),
        Phrase("import-no-condition", name="while"),
        Phrase("import-argument-dropped", skill="turn", value="1"),
        Phrase("import-unread-line", text="banana"),
        Phrase("import-no-library", name="dance"),
        Phrase("import-no-function", name="lost"),
        Phrase("import-no-function", name="other"),
        Phrase("import-no-event", name="gone"),
    )
    assert '        # function.older("go")' in lines(made)
    assert [one for one in check(made) if one.severity == "error"] == []


def test_messages_are_sent_and_heard_by_todays_skills(imported):
    made = imported(
        project(
            main(
                skill("publish", ("string", "go")),
                control("if", [skill("subscribe", ("string", "stop"))], skill("stop_bot")),
                skill("subscribe", ("string", "go")),
            ),
            when("seen", [skill("subscribe", ("string", "tag"))], skill("turn_right")),
        )
    )
    assert made.report.missing == ()
    text = "\n".join(lines(made))
    assert 'function.send("go")' in text
    assert 'if function.received("stop"):' in text
    assert 'when seen = function.received("tag"):' in text
    assert 'when go = function.received("go"):\n    pass\nend' in text
    heard = Phrase("import-heard", event="go", condition='function.received("go")')
    assert heard in made.report.changed
    assert [one for one in check(made) if one.severity == "error"] == []


def test_a_relative_tilt_of_the_camera_is_carried_over(imported):
    tilt = skill("up_camera", ("float", "5")), skill("down_camera", ("float", "3"))
    made = imported(project(main(*tilt)))
    assert lines(made)[1:3] == ["    function.up_camera(5)", "    function.down_camera(3)"]
    assert made.report.missing == ()


def test_a_variable_without_a_value_becomes_0_and_is_listed(imported):
    made = imported(project(main(Old("n", VARIABLE, [("float", "")])), variables=["n"]))
    assert lines(made)[1].strip() == "n = 0"
    assert made.report.missing == (
        Phrase("import-argument-missing", skill="n", name="n", value="0"),
    )


def test_true_in_small_letters_is_a_constant(imported):
    made = imported(project(main(control("while", [word("true")], skill("stop_bot")))))
    assert lines(made)[1].strip() == "forever:"


def test_an_else_without_an_if_keeps_its_blocks(imported):
    made = imported(project(main(control("else", [], skill("stop_bot")))))
    assert lines(made)[1:3] == ["    if True:", "        function.stop_bot()"]
    assert made.report.missing == (Phrase("import-no-if", name="else"),)


def test_raw_python_does_not_come_from_a_project(imported):
    made = imported(project(main(Old("`__import__('os')`", right=[word("`x`")]))))
    assert "`" not in made.blocktext


def test_a_second_main_becomes_loose_blocks(imported):
    made = imported(project(main(skill("turn_left")), main(skill("turn_back"), place=(9, 99))))
    assert lines(made) == ["main:", "    function.turn_left()", "end"]
    assert [stack[0].type for stack in made.workspace.stacks if stack[0].y == 99] == [
        "lb_skill_turn_back"
    ]


def test_blocks_that_are_nested_too_deeply_are_refused(imported):
    block = skill("turn_back")
    for _ in range(95):
        block = forever(block)
    with pytest.raises(ProjectError) as caught:
        imported(project(main(block)))
    assert caught.value.diagnostics[0].code == "too-deep"


@pytest.mark.parametrize(
    "data",
    [b"N.", b"(t.", b"(NNNNNt.", b"(}]]]It.", b"(}]]](lS'a'\nNat."],
)
def test_a_pickle_of_something_else_is_refused(imported, data):
    with pytest.raises(ProjectError):
        imported(data)


def linked(name, *ends):
    """A block with these ends of connections and blocks there."""
    found = [
        Thing("connection", {"_Connection__type": end, "_Connection__idItem": other})
        for end, other in ends
    ]
    return Thing("block", {"name": name, "type": SKILL, "vars": [], "connections": found})


def test_blocks_in_a_circle_are_left_out_and_listed(imported):
    blocks = {"0": linked("stop_bot", (1, "1")), "1": linked("turn_back", (1, "0"))}
    made = imported(Pickler(VERSION_1).dumps((blocks, [], [], [], [])))
    assert made.blocktext.strip() == ""
    assert made.report.missing == (
        Phrase("import-left-out", name="stop_bot"),
        Phrase("import-left-out", name="turn_back"),
    )


def test_a_row_that_many_lines_share_is_read_once(imported):
    rows = {f"r{n}": linked("is_turning", (3, f"r{n + 1}")) for n in range(500)}
    lines_ = {f"s{n}": linked("stop_bot", (1, f"s{n + 1}"), (3, "r0")) for n in range(500)}
    data = Pickler(VERSION_1).dumps(({**rows, **lines_}, [], [], [], []))
    start = time.process_time()
    imported(data)
    assert time.process_time() - start < 5
