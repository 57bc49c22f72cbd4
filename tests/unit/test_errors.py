import pickle

import msgspec
import pytest

from learnblock import errors
from learnblock.errors import Diagnostic, FileError, ProgramError, UnknownNameError, nearest
from learnblock.i18n import Phrase

FAMILY = [
    value
    for value in vars(errors).values()
    if isinstance(value, type) and issubclass(value, errors.LearnBlockError)
]


@pytest.mark.parametrize("kind", FAMILY[1:])
def test_every_error_is_also_the_builtin_it_is(kind):
    builtins = [base for base in kind.__mro__ if base.__module__ == "builtins"]
    assert builtins[0] not in {Exception, BaseException, object}


def test_a_stop_cannot_be_swallowed_by_except_exception():
    assert not issubclass(errors.ProgramStopped, Exception)


def test_a_file_error_has_file_line_column_code_and_message():
    error = ProgramError("square.bt", [Diagnostic("missing-colon", "a `:` is missing", 3, 7)])
    assert str(error) == "square.bt:3:7: missing-colon a `:` is missing"


def test_a_file_error_reports_every_mistake():
    first, second = Diagnostic("one", "first", 1), Diagnostic("two", "second", 2)
    assert str(FileError("x", [first, second])) == "x:1:0: one first\nx:2:0: two second"


def test_a_file_with_many_mistakes_has_a_phrase_that_can_be_sent():
    wrong = [Diagnostic("wrong", Phrase("It is wrong."), line) for line in range(1, 40_001)]
    error = FileError("x", wrong)
    assert msgspec.json.encode(error.phrase)
    assert str(error.phrase).endswith("Line 20: It is wrong. There are 39,980 more mistakes.")
    assert len(error.diagnostics) == 40_000


@pytest.mark.parametrize(
    "error",
    [
        ProgramError("square.bt", [Diagnostic("a", "b", 1, 2, 3, "warning")], "text"),
        UnknownNameError("robot", "sim-ebbo", ["sim-ebo"]),
    ],
)
def test_errors_cross_process_boundaries_unchanged(error):
    copy = pickle.loads(pickle.dumps(error))  # noqa: S301 - our own bytes
    assert vars(error) == vars(copy)
    assert str(error) == str(copy)


def test_a_caret_is_below_the_mistake():
    diagnostic = Diagnostic("a", "b", line=2, column=3, end_column=5)
    assert diagnostic.pointed("first\nx == y\n") == "x == y\n  ^^"


def test_a_tab_stays_a_tab_above_the_caret():
    assert Diagnostic("a", "b", 1, 2, 3).pointed("\tx") == "\tx\n\t^"


def test_a_column_after_the_line_points_to_its_end():
    assert Diagnostic("a", "b", 1, 99).pointed("ab") == "ab\n  ^"


@pytest.mark.parametrize("line", [-1, 0, 3])
def test_nothing_is_shown_for_a_missing_line(line):
    assert Diagnostic("a", "b", line).pointed("one\ntwo") == ""


def test_nearest_finds_a_misspelt_name():
    assert nearest("folow", ["turn", "follow"]) == "follow"


def test_nearest_ignores_case():
    assert nearest("EXPRESSJOY", ["expressJoy"]) == "expressJoy"


def test_nearest_finds_nothing_if_nothing_is_similar():
    assert nearest("xyz", ["follow"]) is None


@pytest.mark.parametrize(
    ("known", "message"),
    [
        (["line", "walls"], "There is no world 'moon'. Known names: line, walls."),
        (["mooon"], "There is no world 'moon'. Did you mean 'mooon'?"),
        ([], "There is no world 'moon'."),
    ],
)
def test_an_unknown_name_comes_with_advice(known, message):
    assert str(UnknownNameError("world", "moon", known)) == message
