"""Plain words are read without Fluent, and mean the same."""

import re
import subprocess
import sys

import pytest
from fluent.runtime import FluentBundle, FluentResource
from fluent.syntax import FluentParser
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
        bundle.add_resource(FluentResource(source))
        for message in FluentParser().parse(source).body:
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


@pytest.mark.parametrize(
    ("arguments", "row"),
    [
        (["examples/square.bt"], "ended      finished"),
        (["examples/square.bt", "--for", "2"], "ended      at the time limit of 2 s"),
        (["examples/square.bt", "--world", "square"], "goal       four corners: reached at "),
    ],
)
def test_a_run_does_not_load_fluent(arguments, row):
    program = (
        "import sys; from learnblock.cli import main\n"
        "try: main(['run', *sys.argv[1:]])\n"
        "except SystemExit: pass\n"
        "print('fluent.runtime' in sys.modules)"
    )
    command = [sys.executable, "-c", program, *arguments]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert row in done.stderr
    assert done.stdout == "False\n"
