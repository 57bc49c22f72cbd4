"""New names for skills in functions, Python and configurations."""

import pytest

from learnblock.blocks import load_configurations
from learnblock.errors import FileError, LibraryError, UnknownNameError
from learnblock.extensions.libraries import renamed
from learnblock.extensions.libraries.renaming import renamed_module
from learnblock.i18n import Phrase


def test_a_function_is_renamed_wherever_it_is_called(make):
    library = renamed(make(), {"step": "small_step"})
    assert "def small_step():" in library.functions
    assert "        small_step()\n" in library.functions
    assert "small_step(robot)" in library.files["functions.py"]


def test_its_configuration_follows_and_so_does_its_label(make):
    library = renamed(make(), {"waltz": "ball_waltz"})
    blocks = {one.name: one for one in load_configurations(library.configurations)}
    assert {"EN": "ball waltz"} == blocks["ball_waltz"].languages
    assert "Dance a waltz." == library.skills["ball_waltz"].tooltip["EN"]


def test_a_skill_in_python_is_renamed_where_it_is_defined_and_called(make, own):
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
        ({"clap": "applause"}, "library-skill-exists"),
        ({"clap": "a b"}, "library-bad-skill-name"),
        ({"clap": "print"}, "library-python-name"),
        ({"clap": "class"}, "library-python-name"),
        ({"clap": "_clap"}, "library-python-name"),
        ({"clap": "times"}, "library-name-used"),
    ],
)
def test_an_invalid_name_is_refused(make, own, names, reason):
    with pytest.raises(FileError) as error:
        renamed(make(own=["clap"]), names)
    assert [reason] == [one.message.code for one in error.value.diagnostics]


def test_an_unknown_skill_is_named(make):
    with pytest.raises(UnknownNameError, match="There is no skill 'walz'"):
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
def test_a_name_with_two_meanings_is_refused(code):
    with pytest.raises(LibraryError) as error:
        renamed_module(code, "clap", "applaud", "clap.py")
    (problem,) = error.value.diagnostics
    assert problem.message == Phrase("library-two-meanings", name="clap")


def test_multibyte_letters_are_counted_correctly():
    code = 'def clap(robot): pass\nx = "ñandú", clap, "ñ"; robot = 1; robot.clap()\n'
    expected = 'def applaud(robot): pass\nx = "ñandú", applaud, "ñ"; robot = 1; robot.applaud()\n'
    assert renamed_module(code, "clap", "applaud", "clap.py") == expected
