import hashlib
import io

import pytest

from learnblock.runtime.recorder import Recorder
from learnblock.runtime.trace import Trace


@pytest.fixture
def file():
    return io.BytesIO()


@pytest.fixture
def recorder(file):
    return Recorder(Trace(file), lambda: 1.5, lambda: (1.0, 2.0, 3.0))


def test_the_hash_is_that_of_the_file(file, recorder):
    recorder.line(3)
    recorder.printed("hello\n")
    assert recorder.trace.sha256 == hashlib.sha256(file.getvalue()).hexdigest()


def test_a_trace_without_a_file_has_the_same_hash(file, recorder):
    nowhere = Recorder(Trace(), lambda: 1.5, lambda: None)
    for each in (recorder, nowhere):
        each.steps((1, 2, 3))
        each.called("turn", (90,), {})
    assert recorder.trace.sha256 == nowhere.trace.sha256


def test_a_trace_without_a_line_has_no_hash():
    assert Trace().sha256 == ""
