"""Quotes in f-strings that every version of Python takes."""

import json
import subprocess

import pytest

from learnblock.language.python import quotes
from pythons import VERSIONS, interpreter

#: What Python 3.11 takes, and what it does not.
TAKEN = [
    "f\"{ages['Ana']}\"",
    "f'{ages[\"Ana\"]}'",
    'f"""{ages["Ana"]}"""',
    'rf"\\d{x}" "\\n"',
    'f"say \\"{name}\\""',
    "f\"{f'{x}'}\" + \"{y['z']}\"",
    "print(\"a\", 'b')",
]
NOT_TAKEN = [
    'f"{ages["Ana"]}"',
    "f'{ages['Ana']!r:>{wide['x']}}'",
    'f"{f"{x}"}"',
    'f"{f\'{x}"\'}"',
    "f\"{'\\n'.join(lines)}\"",
    'f"""{f"""{x}"""}"""',
]
ASKING = """
import json, sys
print(json.dumps([are_for_every_python(line) for line in json.loads(sys.argv[1])]))
"""


@pytest.mark.parametrize("version", VERSIONS)
def test_each_version_of_python_knows_what_the_oldest_takes(version):
    python = interpreter(version)
    if python is None:
        pytest.skip(f"Python {version} is not on this computer")
    # The oldest does not read the others, so it is never asked about them.
    lines = TAKEN + (NOT_TAKEN if version != VERSIONS[0] else [])
    code = quotes.__loader__.get_source(quotes.__name__) + ASKING
    command = [python, "-W", "ignore", "-c", code, json.dumps(lines)]
    answer = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert json.loads(answer) == [line in TAKEN for line in lines]
