"""Every message of a page is executed or refused with a sentence, and the session continues."""

import json
from contextlib import suppress

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from example_messages import examples
from learnblock.server import messages
from learnblock.server.pages.lobby import HANDLERS
from learnblock.server.pages.page import LARGEST_MESSAGE, MessageError, decode
from pages import english

pytestmark = pytest.mark.realtime

PROGRAM = "main:\n    function.move_straight(50)\nend\n"

EXAMPLES = examples()
#: What no page of ours sends.
BROKEN = (
    "",
    "hello",
    "{",
    "[]",
    "null",
    "{}",
    '{"kind": 3}',
    '{"kind": "Launch"}',
    '{"kind": "Open"}',
    '{"kind": "Open", "name": ""}',
    '{"kind": "Open", "name": ["a"]}',
    '{"kind": "EditText", "edit": "1", "notation": "blocktext", "text": ""}',
    '{"kind": "EditText", "edit": 1, "notation": "latin", "text": ""}',
    '{"kind": "EditBlocks", "edit": 1, "workspace": {"stacks": [[{}]]}}',
    '{"kind": "Drive", "advance": 2, "rotation": 0}',
    '{"kind": "SetSpeed", "factor": 0}',
    '{"kind": "SetSpeed", "factor": NaN}',
    '{"kind": "PlaceRobot", "x": 1e9, "y": 0, "heading": 0}',
    b"\xff\xfe",
    "text of another kind".encode("utf-16"),
    "[" * 100_000,
    '{"kind": "SaveWorld", "name": "w", "world": ' + '{"a":' * 50_000 + "1" + "}" * 50_001,
    json.dumps({"kind": "Answer", "text": "x" * 20_000}),
    json.dumps({"kind": "Answer", "text": "x" * (LARGEST_MESSAGE + 1)}),
)

json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=12,
)
kinds = st.sampled_from([kind.__name__ for kind in HANDLERS])
fields = st.sampled_from(
    sorted({name for kind in HANDLERS for name in kind.__struct_fields__} | {"kind", "x"})
)


def test_every_message_of_a_page_has_a_handler():
    assert set(messages.FROM_PAGE.__args__) == set(HANDLERS)


@pytest.mark.parametrize("kind", EXAMPLES)
def test_the_example_of_every_message_is_one(kind):
    assert type(decode(json.dumps({"kind": kind, **EXAMPLES[kind]}))).__name__ == kind


def test_a_message_of_which_nobody_said_who_may_send_it_is_no_message():
    with pytest.raises(TypeError, match="Undecided needs a base that says who may send it"):
        type(messages.FromPage)("Undecided", (messages.FromPage,), {"__module__": __name__})


def test_what_answers_a_request_repeats_its_number():
    answers = {kind.answer for kind in HANDLERS if kind.answer}
    assert answers == {
        "ClassOpened",
        "Completions",
        "CustomBlockChecked",
        "Description",
        "ShareLink",
        "WorldChecked",
        "WorldToEdit",
    }
    for answer in answers:
        assert "request" in getattr(messages, answer).__struct_fields__


def test_the_server_sends_the_first_message(page):
    welcome = page.next()
    assert welcome["kind"] == "Welcome"
    assert "sim-ebo" in [robot["name"] for robot in welcome["robots"]]
    assert {"name", "title", "own", "group"} <= welcome["worlds"][0].keys()
    assert "square" in [example["name"] for example in welcome["examples"]]


@pytest.mark.parametrize("said", BROKEN, ids=lambda said: str(said[:40]))
def test_broken_messages_are_refused(page, said):
    page.say_raw(said)
    assert english(page.hear("Failed")["message"])


def test_a_program_runs_after_every_broken_message(page):
    page.open(text=PROGRAM)
    for said in BROKEN:
        page.say_raw(said)
        page.hear("Failed")
    assert page.run()["ended"] == "finished"


@pytest.mark.parametrize(
    ("kind", "values"),
    [
        ("Run", {}),
        ("Stop", {}),
        ("Step", {}),
        ("Undo", {}),
        ("EditText", {"edit": 1, "notation": "python", "text": ""}),
        ("Complete", {"request": 1, "notation": "python", "line": 1, "column": 1}),
        ("Answer", {"text": "hello"}),
        ("ListHistory", {}),
        ("WatchCamera", {"on": True}),
    ],
)
def test_messages_about_a_project_are_refused_before_one_is_open(page, kind, values):
    page.say(kind, **values)
    failed = page.hear("Failed")
    assert failed["refused"] == kind
    assert "Open a project first" in english(failed["message"])


@pytest.mark.parametrize(
    ("kind", "values", "reason"),
    [
        ("Answer", {"text": "hello"}, "not waiting for an answer"),
        ("ChooseRobot", {"name": "sim-ebbo"}, "Did you mean 'sim-ebo'"),
        ("ChooseWorld", {"name": "../../etc/passwd"}, "no world"),
        ("ChooseWorld", {"name": "/etc/passwd.toml"}, "no world"),
        ("ReadWorld", {"name": "../robots/ebo.toml"}, "no world"),
        ("Open", {"name": "../other"}, "can't be called"),
        ("Open", {"name": "nothing"}, "no project"),
        ("SaveAs", {"name": "a\0b"}, ""),
        ("New", {"name": "x", "example": "../README"}, "no example"),
        ("Import", {"filename": "a.exe", "text": ""}, "this type of file"),
        ("ImportOriginal", {"filename": "a.exe", "content": ""}, "this type of file"),
        ("ImportOriginal", {"filename": "a.blockProject", "content": "Y29z"}, "damaged"),
        ("Import", {"filename": "a.learnblock", "text": "{}"}, "not a LearnBlock project"),
        ("Restore", {"version": "../../x"}, "no version"),
        ("Delete", {"name": "program"}, "is open"),
        ("Rename", {"sort": "variable", "name": "nothing", "new": "x"}, ""),
    ],
)
def test_an_impossible_request_is_refused_with_a_reason(page, kind, values, reason):
    page.open(text=PROGRAM)
    page.say(kind, **values)
    if kind == "SaveAs":
        assert page.hear("Opened")["name"] == "a b"
        return
    failed = page.hear("Failed")
    assert (failed["refused"], reason in english(failed["message"])) == (kind, True), failed
    page.pulse()


def test_a_request_is_answered_with_its_number_also_if_it_is_wrong_in_itself(page):
    page.open(text=PROGRAM)
    page.say("ListBlockSets", request=7)
    assert page.hear("Done")["request"] == 7
    page.say("Answer", request=8, text="hello")
    failed = page.hear("Failed")
    assert (failed["refused"], failed["request"]) == ("Answer", 8)
    page.say("SetSpeed", request=9, factor=0)
    failed = page.hear("Failed")
    assert (failed["refused"], failed["request"]) == ("SetSpeed", 9)


def test_a_request_that_a_newer_one_replaces_is_answered_too(page):
    page.open(text=PROGRAM)
    for request in range(1, 40):
        page.say("CheckWorld", request=request, world={})
    assert sorted(page.hear("Done")["request"] for _ in range(1, 40)) == [*range(1, 40)]


@given(st.text() | st.binary() | json_values.map(json.dumps))
def test_anything_is_a_message_or_refused(said):
    refused_or(said)


@given(kinds, st.dictionaries(fields, json_values, max_size=5))
def test_anything_with_the_kind_of_a_message_is_one_or_refused(kind, values):
    refused_or(json.dumps({**values, "kind": kind}))


def refused_or(said):
    with suppress(MessageError):
        message = decode(said)
        assert decode(msgspec.json.encode(message)) == message
