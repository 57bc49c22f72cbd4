import json
import os
import subprocess

import pytest

from places import ROOT
from pythons import VERSIONS, interpreter
from statement_streams import STREAMS, stream


@pytest.mark.parametrize("name", STREAMS)
def test_a_statement_is_reported_once_each_time_it_begins(name):
    source, expected = STREAMS[name]
    assert stream(source) == expected


@pytest.mark.slow
@pytest.mark.parametrize("version", VERSIONS)
def test_every_version_of_python_reports_the_same_statements(version):
    python = interpreter(version)
    if python is None:
        pytest.skip(f"Python {version} is not on this computer")
    helper = ROOT / "tests" / "helpers" / "statement_streams.py"
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "src")}
    done = subprocess.run([python, helper], env=environment, capture_output=True, check=True)
    assert json.loads(done.stdout) == {name: lines for name, (_, lines) in STREAMS.items()}
