"""docs/lessons.md says what the code does."""

import re
from types import MappingProxyType

import msgspec
import pytest

from learnblock.lessons import checks
from learnblock.lessons.expert import Experts
from learnblock.lessons.lesson import Lesson, Step
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.reading import read_files
from lesson_files import LESSON, evidence
from places import ROOT

PAGE = (ROOT / "docs" / "lessons.md").read_text("utf-8")
#: Keys that all checks have are told once.
SHARED = {field.name for field in msgspec.structs.fields(checks.AnyCheck)}


def row(struct):
    """The page's line about a kind of check or event."""
    shared = SHARED if issubclass(struct, checks.AnyCheck) else ()
    keys = [key(one) for one in msgspec.structs.fields(struct) if one.name not in shared]
    about = (struct.__doc__ or "").partition("\n\n")[0].strip().replace("``", "`")
    return f"| `{struct.__struct_config__.tag}` | {about} | {', '.join(keys) or '–'} |"


def key(field):
    if field.required or field.default is None:
        return f"`{field.name}`" + (" (optional)" if field.default is None else "")
    default = (
        "" if field.default in ("", ()) else f" = {msgspec.json.encode(field.default).decode()}"
    )
    return f"`{field.name}`{default or ' (optional)'}"


@pytest.mark.parametrize("struct", checks.Check.__args__, ids=lambda one: one.__name__)
def test_every_kind_of_check_is_in_the_table(struct):
    assert row(struct) in PAGE


@pytest.mark.parametrize("struct", checks.Event.__args__, ids=lambda one: one.__name__)
def test_every_event_is_in_the_table(struct):
    assert row(struct) in PAGE


@pytest.mark.parametrize("struct", [Lesson, Step])
def test_every_key_of_a_lesson_is_told(struct):
    for name in struct.__struct_fields__:
        assert f"| `{name}` |" in PAGE


def test_the_example_is_a_lesson():
    blocks = dict(re.findall(r"`([\w./-]+)`:\n\n```\w+\n(.*?)```", PAGE, re.DOTALL))
    opened = read_files("example", {path: text.encode() for path, text in blocks.items()})
    assert opened.teacher is not None
    assert opened.solution(1)


@pytest.mark.parametrize(
    ("east", "reason"), [(1100, None), (1300, "You drove 1300 mm.")], ids=["short", "long"]
)
def test_the_check_in_python_says_its_text(east, reason):
    section = PAGE.partition("### Checks in Python")[2]
    source, texts = re.findall(r"```(?:python|toml)\n(.*?)```", section, re.DOTALL)[:2]
    files = {"checks.py": source.encode(), "checks.en.toml": texts.encode()}
    experts = Experts(OpenLesson("example", LESSON, None, MappingProxyType(files)))
    run = evidence({"t": 0.0, "pose": [0, 0, 0]}, {"t": 1.0, "pose": [east, 0, 0]})
    found = experts(checks.Expert(function="no_detour"), run)
    assert (found.reason and str(found.reason)) == reason
