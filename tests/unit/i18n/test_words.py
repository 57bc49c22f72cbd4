"""Plain words are read without Fluent, and mean the same."""

import re
import subprocess
import sys

import pytest
from fluent.runtime import FluentBundle, FluentResource
from fluent.syntax.ast import Message

from learnblock.i18n import languages
from learnblock.i18n.words import words
from places import ROOT

WORDS = ROOT / "src" / "learnblock" / "i18n"
_VALUE = re.compile(r"\$(\w+)")


@pytest.mark.parametrize("language", languages())
def test_every_message_with_texts_as_values_is_as_fluent_has_it(language):
    different = []
    for file in sorted((WORDS / language).rglob("*.ftl")):
        source = file.read_text("utf-8")
        # A value with backslashes and braces shows whether a value is read as words.
        values = {name: f"\\1 {{ ${name} }}" for name in _VALUE.findall(source)}
        bundle = FluentBundle([language], use_isolating=False)
        resource = FluentResource(source)
        bundle.add_resource(resource)
        for message in resource.body:
            if not isinstance(message, Message):
                continue
            pattern = bundle.get_message(message.id.name).value
            text, errors = bundle.format_pattern(pattern, values)
            if not errors and words(message.id.name, values, language) != text:
                different.append(message.id.name)
    assert different == []


def test_a_number_is_written_as_the_language_writes_it():
    code, values = "report-ended-time-limit", {"seconds": 1234.5}
    assert "1,234.5" in words(code, values, "en")
    assert "1.234,5" in words(code, values, "es")


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("number", [0, 7, 60.0, 999, 1000, 1000.0, 0.5, -3, 999.5, True])
def test_a_number_is_written_as_fluent_writes_it(language, number):
    code, values = "report-ended-time-limit", {"seconds": number}
    bundle = FluentBundle([language], use_isolating=False)
    bundle.add_resource(FluentResource((WORDS / language / "report.ftl").read_text("utf-8")))
    expected, _ = bundle.format_pattern(bundle.get_message(code).value, values)
    assert words(code, values, language) == expected


#: Runs whose reports have different rows.
RUNS = """
import sys
from contextlib import suppress
from learnblock.cli import main

for options in ([], ["--for", "2"], ["--world", "square"]):
    with suppress(SystemExit):
        main(["run", "examples/square.bt", *options])
print("fluent.runtime" in sys.modules)
"""


def test_a_run_does_not_load_fluent():
    command = [sys.executable, "-c", RUNS]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert "ended      finished" in done.stderr
    assert "ended      at the time limit of 2 s" in done.stderr
    assert "goal       four corners: reached at " in done.stderr
    assert done.stdout == "False\n"
