"""Messages that would keep other pages waiting."""

import base64
import json
import threading

import pytest
from msgspec import inspect

from learnblock.blocks import block_sets
from learnblock.extensions import custom_blocks, libraries
from learnblock.perception import tag_names
from learnblock.project.document.views import LONGEST_TEXT
from learnblock.server.messages import FROM_PAGE
from learnblock.server.pages.page import LARGEST_MESSAGE
from pages import english


@pytest.mark.parametrize("notation", ["blocktext", "python"])
def test_a_program_that_is_too_long_is_refused_in_words(page, notation):
    page.open()
    page.say("EditText", edit=1, notation=notation, text="#" * (LONGEST_TEXT + 1))
    assert "too long: the limit is 250,000 characters" in english(page.hear("Failed")["message"])


@pytest.mark.parametrize("ending", ["bt", "py", "learnblock"])
def test_a_file_with_a_program_that_is_too_long_is_not_imported(page, ending):
    text = "# " + "x" * LONGEST_TEXT
    if ending == "learnblock":
        text = json.dumps({"learnblock": 1, "blocktext": [text]})
    page.say("Import", filename=f"a.{ending}", text=text)
    assert "Split it" in english(page.hear("Failed")["message"])


def test_a_file_of_the_greatest_size_fits_in_a_message():
    fields = [one.type for message in inspect.type_info(FROM_PAGE).types for one in message.fields]
    files = [kind.max_length for kind in fields if isinstance(kind, inspect.BytesType)]
    assert len(files) > 3
    in_base64 = max(files) * 4 // 3
    assert in_base64 < LARGEST_MESSAGE


def test_a_file_with_thousands_of_functions_is_no_custom_block():
    source = "".join(f"def f{n}(robot): pass\n" for n in range(5000))
    (problem,) = custom_blocks.check(source, name="many").problems
    assert "5,000 functions" in str(problem.diagnostic.message)


@pytest.mark.parametrize(
    ("module", "function", "message"),
    [
        (block_sets, "parse", {"kind": "ReadBlockSet", "filename": "a.toml", "text": "show = []"}),
        (block_sets, "write", {"kind": "ExportBlockSet", "set": {"name": "lesson"}}),
        (tag_names, "parse", {"kind": "ReadTags", "filename": "a.toml", "text": "ball = 1"}),
        (
            custom_blocks,
            "check",
            {
                "kind": "CheckCustomBlock",
                "request": 1,
                "name": "a",
                "source": "",
                "configuration": "",
            },
        ),
        (
            libraries,
            "unpack",
            {
                "kind": "ReadLibraries",
                "files": [{"filename": "a.lblib", "content": base64.b64encode(b"a").decode()}],
            },
        ),
    ],
)
def test_what_a_page_sends_is_read_outside_the_event_loop(
    page, monkeypatch, module, function, message
):
    threads = []
    real = getattr(module, function)

    def recorded(*args, **options):
        threads.append(threading.current_thread().name)
        return real(*args, **options)

    monkeypatch.setattr(module, function, recorded)
    page.open()
    page.say(**message)
    page.say("ListProjects")
    page.until("Projects")
    assert threads
    assert "server" not in threads
