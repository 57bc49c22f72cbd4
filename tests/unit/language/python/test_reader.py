import ast
import os
import sys
from functools import cache
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gate import examples
from learnblock.errors import ProgramError
from learnblock.language import format as format_program
from learnblock.language import from_python, from_workspace, parse, to_python, to_workspace
from learnblock.language.tree.nodes import Import, Raw
from python_scores import meaning

SKELETON = "from learnblock.robots.ebo import Robot\n\nrobot = Robot()\n\n"


@cache
def library():
    """The files of Python's library."""
    return sorted(Path(os.__file__).parent.rglob("*.py"))


def block_text(python):
    return format_program(from_python(SKELETON + python))


def exact(text):
    """Convert all the way: to a tree, to Block-Text, and back."""
    program = from_python(text)
    return to_python(program, None).text, to_python(parse(format_program(program))).text


def tree_of(python):
    """What the statements of a file mean."""
    return meaning(ast.parse(python.removeprefix("\ufeff")))


@pytest.mark.parametrize(
    ("python", "expected"),
    [
        ("x=1\n", "x = 1\n"),
        ("x = x + 1\n", "x = x + 1\n"),
        ("if x == True: robot.turn( 90 )\n", "if x == True:\n    function.turn(90)\nend\n"),
        ("print('a' 'b')\n", 'print("ab")\n'),
        ("print(f'{x}')\n", 'print(f"{x}")\n'),
        ("print(f'{x:.2f}')\n", "print(`f'{x:.2f}'`)\n"),
        ("print(f'{x!r} {y}')\n", "print(`f'{x!r} {y}'`)\n"),
        ("print(f'{x.y} {x.y()}')\n", "print(`f'{x.y} {x.y()}'`)\n"),
        ("print(f'é {x.y} {2.50}' 'a')\n", 'print(f"é {`x.y`} {2.50}a")\n'),
        ("del d['a']\n", 'pop(d, "a")\n'),
        ("x = {**d}\n", "x = `{**d}`\n"),
        ("x = {'a': 1,}\n", 'x = {"a": 1}\n'),
        ("for x in d.keys(): pass\n", "for x in `d.keys()`:\n    pass\nend\n"),
        ("for k, v in d.items(): pass\n", "for k, v in items(d):\n    pass\nend\n"),
        ("for (i, x) in enumerate(xs): pass\n", "for i, x in enumerate(xs):\n    pass\nend\n"),
        ("for k, v in list(d.items()): pass\n", "for k, v in list(items(d)):\n    pass\nend\n"),
        ("x = list(d.items())\n", "x = items(d)\n"),
        ("for a, b, c in xs: pass\n", "for a, b, c in xs:\n    pass\nend\n"),
        (
            "def items(d):\n    return d\n\n\nfor x in items(d): pass\n",
            "def items(d):\n    return d\nend\n\nfor x in items(d):\n    pass\nend\n",
        ),
        (
            "for a, in xs:\n    pass\n",
            "`for a, in xs`:\n    pass\nend\n",
        ),
        ("x = list(d.keys())\n", "x = keys(d)\n"),
        ("robot.wait_until(lambda: x)\n", "wait until x\n"),
        ("robot.wait_until(lambda y: x)\n", "function.wait_until(`lambda y: x`)\n"),
        ("while 1:\n    pass\n", "while 1:\n    pass\nend\n"),
        ("while True: pass\n", "forever:\n    pass\nend\n"),
        ("for i in range(2, 5): pass\n", "for i from 2 to 4:\n    pass\nend\n"),
        ("for i in range(n): pass\n", "for i from 0 to n - 1:\n    pass\nend\n"),
        ("for x in xs:\n  pass\n", "for x in xs:\n    pass\nend\n"),
        ("x = y if z else 0\n", "x = y if z else 0\n"),
        ("x = y[1:]\n", "x = `y[1:]`\n"),
        ("a = b = 1\n", "`a = b = 1`\n"),
        ("with a as b:\n    pass\n", "`with a as b`:\n    pass\nend\n"),
        ("x = (  # why\n  1)\n", "# why\nx = 1\n"),
        ("if a:\n  b()\n  # c\n# d\n", "if a:\n    b()\n    # c\nend\n# d\n"),
        (
            "import math\nx = math.gcd(4, 6)\n",
            "`import math`\nx = `math.gcd(4, 6)`\n",
        ),
        ("def f(x=1):\n    pass\n", "`def f(x=1)`:\n    pass\nend\n"),
        ("while a:\n    b = {}\n    c, d = 1, 2\n", None),
    ],
)
def test_python_with_an_equivalent_is_converted_and_the_rest_is_raw(python, expected):
    if expected is None:
        expected = "while a:\n    b = {}\n    `c, d = 1, 2`\nend\n"
    assert expected == block_text(python)


@pytest.mark.parametrize(
    ("python", "expected"),
    [
        ("x = x + 1\n", "x = x + 1\n"),
        ("while times<4:\n  times+=1\n", "while times < 4:\n    times += 1\nend\n"),
        ("while x :robot.turn(5)\n", "while x:\n    function.turn(5)\nend\n"),
        ("print('hola')\n", 'print("hola")\n'),
        (
            "if robot.is_tag(1) == True:\n\trobot.stop_bot()\n",
            "if function.is_tag(1) == True:\n    function.stop_bot()\nend\n",
        ),
        ("if (x>2) :\n    print((x))\n", "if x > 2:\n    print(x)\nend\n"),
        ("if not(x == 1): pass\n", "if not x == 1:\n    pass\nend\n"),
        ("x=1; y=2\n", "x = 1\ny = 2\n"),
        ("robot.turn(angle = 90)\n", "function.turn(angle=90)\n"),
        ("for _ in range(0,4): f()\n", "repeat 4:\n    f()\nend\n"),
        ("import random\n\nx = random.randint(1,6)\n", "x = random(1, 6)\n"),
        (
            "def f():\n  robot.turn(90)\ndef g():\n  f()\ng()",
            "def f():\n    function.turn(90)\nend\n\ndef g():\n    f()\nend\n\ng()\n",
        ),
        (
            "def f():\n    a = 1\n    print(a)\n",
            "def f():\n    local a = 1\n    print(a)\nend\n",
        ),
        (
            "def f():\n    global a\n    global b\n    print(a)\n    b = 1\n",
            "def f():\n    print(a)\n    b = 1\nend\n",
        ),
        (
            "if a:\n    b()\nelse:\n    if c:\n        d()\n",
            "if a:\n    b()\nelse:\n    if c:\n        d()\n    end\nend\n",
        ),
    ],
)
def test_the_variants_of_pupils_need_no_raw_python(python, expected):
    text = SKELETON + python
    program = from_python(text)
    assert expected == format_program(program)
    assert text == to_python(program, None).text


@pytest.mark.parametrize(
    "function",
    [
        "def f():\n    x, y = 1, 2\n    x += 1\n",
        "def f():\n    global i\n    for i in xs:\n        pass\n",
    ],
)
def test_a_function_with_variables_that_only_python_has_stays_python(function):
    assert block_text(function).startswith("`def f()`:\n")


@pytest.mark.parametrize(
    "function",
    [
        "def f():\n    x = 1\n\nprint(x)\n",
        "def f():\n    x = 1\n    f()\n    print(x)\n",
        "def f():\n    x = 1\n    return lambda: x\n",
        "def f():\n    x = 1\n\ndef g():\n    x = 2\n",
        "def f():\n    x = 1\n    g()\n    print(x)\n\ndef g():\n    f()\n",
    ],
)
def test_the_variables_of_a_function_stay_its_own(function):
    text = block_text(function)
    assert text.startswith("def f():\n    local x = 1\n")
    assert "global" not in to_python(parse(text)).text


FACTORIAL = SKELETON + (
    "def factorial(n):\n    if n == 0:\n        return 1\n    own = n\n"
    "    rest = factorial(n - 1)\n    return own * rest\n\n\nanswer = factorial(5)\n"
)


def test_a_recursion_keeps_its_helper_variables_in_all_three_notations():
    program = from_python(FACTORIAL)
    text = format_program(program)
    assert "    local own = n\n    local rest = factorial(n - 1)\n" in text
    workspace = to_workspace(program, {}).workspace
    for read in (program, parse(text), from_workspace(workspace, {}).program):
        written = to_python(read, None).text
        namespace = {}
        exec(written.partition("robot = Robot()\n")[2], namespace)  # noqa: S102 - the test's own program
        assert 120 == namespace["answer"]


def test_a_brace_in_a_string_is_not_a_bracket():
    assert 'x = f"{{"\n\n# note\ny = 1\n' == block_text('x = f"{{"\n\n# note\ny = 1\n')


def test_a_file_without_a_robot_is_a_program():
    program = from_python("x = 1\n")
    assert "without robot\n\nx = 1\n" == format_program(program)
    assert "x = 1\n" == to_python(parse(format_program(program))).text


def test_a_file_that_makes_its_robot_in_another_way_is_one_block_of_raw_python():
    text = "from learnblock.robots.ebo import Robot\n\nwith Robot() as robot:\n    robot.turn(90)\n"
    assert (Raw(text),) == from_python(text).items
    assert text == to_python(parse(format_program(from_python(text)))).text


@pytest.mark.parametrize(
    "text",
    [
        "",
        "\n",
        "x = 1",
        "x = 1\n",
        "\n\n\nx = 1\n\n\n",
        "x = 1\r\ny = 2\r\n",
        "x = 1\r\ny = 2\n",
        "x = 1\ry = 2\r",
        "\ufeffx = 1\n",
        "\tx\n".lstrip() + "\x0c\ny\n",
        "if a:\n\tb\n\x0c\n",
        "end\n",
        "  \n   \nx\n\t\n",
        "if 1:\n  end\n  # end\nend # why\n",
        "'''\nend\n   \\\n  '''\n",
        "x = \\\n  1\n",
        "\\\n\nx\n",
        "# `a` ``b`` \\end\n",
        "x = '\u2028\x85\x1c'\n",
        SKELETON + "x=1\n",
        SKELETON.replace("\n", "\r\n") + "x=1\r\n",
        "import os\n" + SKELETON + "x = os.name  # why\n\n\n\n# bye",
        SKELETON + "# main\n# main\nx = 1\n\n# end\n",
        SKELETON + "if a:\n    '''\nb\n'''\nelse:  # c\n    pass\n",
    ],
)
def test_every_file_is_restored_byte_for_byte(text):
    kept, through_block_text = exact(text)
    assert text == kept
    if SKELETON.strip().split("\n", maxsplit=1)[0] not in text:
        assert tree_of(text) == tree_of(through_block_text)


def test_files_of_the_standard_library_are_restored_byte_for_byte():
    """Read some of the files, with and without our skeleton."""
    files = library()[:: len(library()) // examples(200, gate=20)]
    for path in files:
        try:
            text = path.read_bytes().decode()
            program = from_python(text)
        except (UnicodeDecodeError, ProgramError):
            continue  # Invalid files in the test data of Python's own tests.
        assert text == to_python(program).text
        assert tree_of(text) == tree_of(to_python(parse(format_program(program))).text)
        ours = SKELETON + text
        assert ours == to_python(from_python(ours), None).text


def test_a_file_with_our_skeleton_is_read_again_from_its_block_text():
    for path in library()[5:300:30]:
        program = from_python(SKELETON + path.read_text("utf-8"))
        again = parse(format_program(program))
        assert program == again
        assert again == from_python(to_python(again).text)


@settings(max_examples=300, database=None)
@given(st.text(st.sampled_from("ax=1 \t\n\r\f#'\"\\()`:end\x0b\u2028")))
def test_any_text_is_restored_or_is_not_valid_python(text):
    try:
        kept, through_block_text = exact(text)
    except ProgramError:
        return
    assert text == kept
    assert tree_of(text) == tree_of(through_block_text)


def test_the_rest_of_a_program_does_not_use_a_raw_when():
    odd = "@robot.when(lambda: robot.is_any_tag())\ndef seen(): x, y = 1, 2; z: int = seen.time\n"
    raw = "@robot.when\ndef odd(x=1):\n    pass\n"
    text = SKELETON + odd + raw + "\nprint(seen.active, odd.active)\n\nrobot.run()\n"
    program = from_python(text)
    assert ["seen"] == list(program.whens)
    assert "print(state_seen, `odd.active`)" in format_program(program)
    again = parse(format_program(program))
    assert again == from_python(to_python(again).text)


@pytest.mark.parametrize(
    "text",
    [
        "# python\nif a:\n# end\n    b()\n",
        "if a:\n    b()\n    # python\n# end\n",
        "# python\nwith a:\n    # end\n    b()\n# end\nc()\n",
        "x = 1\n# end\n# bye\n",
        "# main\nx = 1\n\n\ndef f():\n    pass\n\n\n# main\ny = 1\n",
        "# python\nimport math\n# end\nx = 1\n",
        "# about\nimport math\n@robot.when\ndef f():\n    pass\n",
    ],
)
def test_markers_moved_by_hand_result_in_a_stable_tree(text):
    program = from_python(SKELETON + text)
    again = parse(format_program(program))
    assert program == again
    assert again == from_python(to_python(again).text)


def test_only_the_robots_import_is_replaced():
    text = SKELETON + "x=1  # kept\n"
    expected = text.replace("learnblock.robots.ebo", "learnblock.robots.cozmo")
    assert expected == to_python(from_python(text), "learnblock.robots.cozmo").text


def test_lines_of_an_unchanged_file_map_to_themselves():
    text = SKELETON + "x=1\nif x:\n    y=2\n"
    source_map = to_python(from_python(text)).source_map
    assert [5, 6, 7] == [source_map.source_line(line) for line in (5, 6, 7)]


@pytest.mark.parametrize(
    "text",
    [
        "x = (\n",
        "x = = 1\n",
        "\0",
        "x = '\ud800'",
        "(" * 1000,
        "-" * 100_000 + "1",
        "1+" * 100_000 + "1",
        "if a:\n" * 200,
        "x = 1\n" * 500_000,
        "x" * 3_000_000,
    ],
    ids=range(10),
)
def test_invalid_python_is_a_program_error(text):
    with pytest.raises(ProgramError) as caught:
        from_python(text, "mine.py")
    assert "mine.py" == caught.value.filename
    assert caught.value.diagnostics


def test_a_syntax_error_has_its_position():
    with pytest.raises(ProgramError) as caught:
        from_python("x = 1\ny = % 2\n")
    (diagnostic,) = caught.value.diagnostics
    assert (2, 5) == (diagnostic.line, diagnostic.column)


def test_long_sums_are_kept_in_a_form_that_can_be_read_again():
    text = SKELETON + "x = " + "1 + " * 600 + "1\n"
    program = from_python(text)
    assert program == parse(format_program(program))


def test_an_import_is_read_in_its_old_spelling_and_written_in_ours():
    program = from_python("from dance import *\n" + SKELETON)
    ours = "from learnblock.libraries.dance import *\n" + SKELETON.rstrip("\n") + "\n"
    assert format_program(program) == 'import "dance"\n'
    assert to_python(parse(format_program(program)), "learnblock.robots.ebo").text == ours


#: Since 3.14 Python itself looks for the features that are imported.
FUTURE = pytest.mark.skipif(sys.version_info >= (3, 14), reason="Python 3.14 refuses this import")


@pytest.mark.parametrize(
    "module", ["math", "os.path", "learnblock.client", pytest.param("__future__", marks=FUTURE)]
)
def test_a_module_that_only_python_can_import_stays_python(module):
    text = f"from {module} import *\n" + SKELETON
    assert not any(isinstance(item, Import) for item in from_python(text).items)
    assert to_python(from_python(text), None).text == text


@pytest.mark.parametrize("module", ["dance", "songs.slow", "math", "learnblock.client"])
def test_any_import_is_restored_from_python(module):
    program = parse(f'import "{module}"\n')
    assert program == from_python(to_python(program).text)


def test_a_call_of_a_function_that_stays_python_is_not_that_of_a_library():
    join = "def join(first, *rest):\n    return first\n\n\nx = join('a', 'b')\n"
    assert "x = join('a', 'b')\n" in exact(SKELETON + join)[1]


@pytest.mark.parametrize("text", ["without robot\n", "without robot\n\n# Nothing yet.\n"])
def test_a_program_without_a_robot_needs_no_statement(text):
    assert text == format_program(from_python(to_python(parse(text)).text))


IF_MAIN = 'def main():\n    print(1)\n\n\nif __name__ == "__main__":\n'


@pytest.mark.parametrize(
    "text",
    [
        IF_MAIN + "    main()\n",
        IF_MAIN + "    # It begins here.\n    main()\n    print(2)\n",
        IF_MAIN.replace('"', "'") + "    main()\n\n\n",
        IF_MAIN + "    # python\n    x = 1; y = 2\n    # end\n",
        'if __name__ == "__main__": pass',
    ],
)
def test_the_last_if_main_of_plain_python_is_the_main_program(text):
    program = from_python(text)
    assert program.main is not None
    assert text == to_python(program).text
    blocks = from_workspace(to_workspace(program, {}).workspace, {}).program
    for again in (parse(format_program(program)), blocks):
        assert program.main == again.main
        assert meaning(ast.parse(text)) == meaning(ast.parse(to_python(again).text))


@pytest.mark.parametrize(
    "text",
    [
        IF_MAIN + "    main()\nprint(2)\n",
        IF_MAIN + "    main()\n# The end.\n",
        IF_MAIN + "    main()\nelse:\n    print(2)\n",
        IF_MAIN.replace(":\n", ":  # Run it.\n") + "    main()\n",
        IF_MAIN.replace("==", "!=") + "    main()\n",
        SKELETON + IF_MAIN + "    main()\n",
    ],
)
def test_another_if_main_is_an_if(text):
    program = from_python(text)
    assert program.main is None
    assert text == to_python(program, None).text
