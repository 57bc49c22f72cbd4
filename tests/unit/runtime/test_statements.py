import contextlib
import json
import os
import subprocess
import sys

import pytest

from learnblock.runtime.statements import Statements, has_statements
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


@pytest.mark.parametrize("name", STREAMS)
def test_following_a_frame_reports_what_asking_at_each_line_reports(name):
    source, expected = STREAMS[name]
    statements, asked, followed = Statements(source), [], []

    def enter(frame, _event, _argument):
        if frame.f_code.co_filename != "program.py" or not has_statements(frame.f_code):
            return None
        statements.enter(frame)
        follow = statements.follow(frame, followed.append)

        def local(frame, event, argument):
            if event == "line" and (begun := statements.begun(frame, frame.f_lineno)):
                asked.append(begun)
            follow(frame, event, argument)
            return local

        return local

    code = compile(source, "program.py", "exec")
    before = sys.gettrace()
    sys.settrace(enter)
    try:
        exec(code, {"__name__": "program", "c": contextlib.nullcontext})  # noqa: S102 - our own
    finally:
        sys.settrace(before)

    assert asked == followed
    assert asked == expected or sys.version_info >= (3, 12)
