"""Other names for skills, in functions, Python and configurations alike."""

import pytest

from learnblock.blocks import load_configurations
from learnblock.errors import LearnBlockError, LibraryError, UnknownNameError
from learnblock.library import renamed
from learnblock.library.python_names import renamed as renamed_in_python


def test_a_function_has_another_name_wherever_it_is_called(make):
    library = renamed(make(), {"step": "small_step"})
    assert "def small_step():" in library.functions
    assert "        small_step()\n" in library.functions
    assert "small_step(robot)" in library.files["functions.py"]


def test_its_configuration_follows_and_so_does_its_label(make):
    library = renamed(make(), {"waltz": "ball_waltz"})
    blocks = {one.name: one for one in load_configurations(library.configurations)}
    assert {"EN": "ball waltz"} == blocks["ball_waltz"].languages
    assert "Dance a waltz." == library.skills["ball_waltz"].tooltip["EN"]


def test_python_has_another_name_where_it_is_defined_and_called(make, own):
    library = renamed(make(own=["clap"]), {"clap": "clap_hands"})
    code = library.modules["clap.py"]
    assert "def clap_hands(robot, times: int = 2)" in code
    assert "    clap_hands(robot, 1)\n    robot.clap_hands(times=1)\n" in code
    assert '        print("clap")\n' in code


def test_functions_that_call_a_skill_of_the_library_follow(make, own):
    text = "def f():\n    function.clap(1)\nend\n"
    library = renamed(make(text=text, functions=["f"], own=["clap"]), {"clap": "clap_hands"})
    assert "function.clap_hands(1)" in library.functions


@pytest.mark.parametrize(
    ("names", "reason"),
    [
        ({"clap": "applause"}, "has a skill `applause` already"),
        ({"clap": "a b"}, "is no name"),
        ({"clap": "print"}, "cannot be the name of a skill"),
        ({"clap": "class"}, "cannot be the name of a skill"),
        ({"clap": "_clap"}, "cannot be the name of a skill"),
        ({"clap": "times"}, "`times` stands there already"),
    ],
)
def test_a_name_that_will_not_do_is_refused(make, own, names, reason):
    with pytest.raises(LearnBlockError, match=reason):
        renamed(make(own=["clap"]), names)


def test_a_skill_that_is_not_there_is_named(make):
    with pytest.raises(UnknownNameError, match="no skill in the library dance `walz`"):
        renamed(make(), {"walz": "polka"})


@pytest.mark.parametrize(
    "code",
    [
        "def clap(robot): pass\ndef f(robot, clap): return clap\n",
        "def clap(robot): pass\ndef f(robot):\n    clap = 1\n",
        "def clap(robot):\n    global clap\n",
        "from hands import clap as g\ndef f(robot):\n    import clap\n",
    ],
)
def test_a_name_with_two_meanings_is_left_to_its_author(code):
    with pytest.raises(LibraryError, match="means something else there as well"):
        renamed_in_python(code, "clap", "applaud", "clap.py")


def test_letters_of_many_bytes_are_counted_right():
    code = 'def clap(robot): pass\nx = "ñandú", clap, "ñ"; robot = 1; robot.clap()\n'
    expected = 'def applaud(robot): pass\nx = "ñandú", applaud, "ñ"; robot = 1; robot.applaud()\n'
    assert renamed_in_python(code, "clap", "applaud", "clap.py") == expected
