"""Checks in a lesson's own Python."""

import sys
from functools import partial
from types import MappingProxyType

import pytest
from msgspec.structs import replace

from learnblock.evidence.evidence import Evidence
from learnblock.i18n import translate
from learnblock.lessons import expert
from learnblock.lessons.checks import Expert
from learnblock.lessons.expert import (
    LIMITS,
    LONGEST,
    Experts,
    NoVerdictError,
    expert_processes,
)
from learnblock.lessons.opened import OpenLesson
from learnblock.running import Report
from learnblock.runtime.activity import Activity
from learnblock.runtime.fork_server import ForkServer
from learnblock.runtime.limits import MEGABYTE, Limits
from lesson_files import LESSON, evidence

contained = pytest.mark.skipif(sys.platform != "linux", reason="only Linux's kernel contains")


#: What checks that take all they can may use here, so that they have it soon.
LITTLE = Limits(memory=256 * MEGABYTE, cpu=1, file_size=MEGABYTE)


#: Says something in place of the answer, wherever that is sent.
SAY = """
import os
def say(data):
    for handle in range(1, 32):
        try:
            os.write(handle, data)
        except OSError:
            pass
"""

#: How a check's process comes to be: forked for those who judge many runs, or started.
WAYS = ("forked", "started")


@pytest.fixture(scope="module")
def judges():
    """Judges a run by the Python of a lesson, in either way."""
    with expert_processes() as processes:
        yield lambda *given, **more: judged(processes, *given, **more)


@pytest.fixture
def judge(judges):
    return partial(judges, "forked")


def judged(
    processes: ForkServer,
    way: str,
    source: str,
    run: Evidence | None = None,
    *,
    limits: Limits = LIMITS,
    longest: float = LONGEST,
    **texts: str,
):
    texts_files = {f"checks.{language}.toml": text.encode() for language, text in texts.items()}
    files = MappingProxyType({"checks.py": source.encode(), **texts_files})
    opened = OpenLesson("it", LESSON, None, files)
    experts = Experts(opened, limits, processes if way == "forked" else None, longest)
    return experts(Expert(function="holds"), run or evidence())


def test_a_check_that_answers_true_is_met(judge):
    assert judge("def holds(run): return True").state == "met"


@pytest.mark.parametrize("answer", ["1", "None", "False", "'yes'", "[True]", "{}", "...", "b''"])
def test_whatever_is_not_true_is_not_met(judge, answer):
    assert judge(f"def holds(run): return {answer}").state == "failed"


def test_a_check_says_why_it_is_not_met_in_each_language(judge):
    found = judge("def holds(run): return {'en': 'Too slow.', 'es': 'Muy lento.'}")
    assert found.reason is not None
    assert [translate(found.reason, one) for one in ("en", "es", "fr")] == [
        "Too slow.",
        "Muy lento.",
        "Too slow.",
    ]


ENGLISH = """[texts]
slow = "It took {seconds:.1f} s to {place}."
park = "the park"
late = "Late."
"""
SPANISH = """[texts]
slow = "Tardó {seconds:.1f} s hasta {place}."
park = "el parque"
"""


@pytest.mark.parametrize(
    ("answer", "english", "spanish"),
    [
        ('"slow", {"seconds": 2.25, "place": 3}', "It took 2.2 s to 3.", "Tardó 2.2 s hasta 3."),
        (
            '"slow", {"seconds": 2, "place": ("park", {})}',
            "It took 2.0 s to the park.",
            "Tardó 2.0 s hasta el parque.",
        ),
        ('"park"', "the park", "el parque"),
        # What a language lacks is said in English.
        ('"late"', "Late.", "Late."),
        ('"Another text."', "Another text.", "Another text."),
        ("{'en': 'Too slow.', 'es': 'Lento.'}", "Too slow.", "Lento."),
    ],
)
def test_a_check_names_a_text_of_the_lesson(judge, answer, english, spanish):
    found = judge(f"def holds(run): return {answer}", en=ENGLISH, es=SPANISH)
    assert found.state == "failed"
    assert found.reason is not None
    words = [translate(found.reason, language) for language in ("en", "es", "fr")]
    assert words == [english, spanish, english]


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ('"fast", {}', "KeyError"),
        ('"slow", {"seconds": 2}', "KeyError"),
        ('"slow", {"seconds": "a", "place": 1}', "ValueError"),
        ('"slow", 3, 4', "ValueError"),
        ('"slow", {"seconds": 2, "place": open("/etc/passwd")}', ""),
    ],
)
def test_a_check_that_gives_a_text_what_it_does_not_take_has_a_mistake(judge, answer, words):
    found = judge(f"def holds(run): return {answer}", en=ENGLISH, es=SPANISH)
    assert found.reason is not None
    assert (found.reason.code, words in str(found.reason)) == ("lesson-expert-error", True)


def test_a_check_without_texts_that_names_one_has_a_mistake(judge):
    assert "checks.en.toml" in str(judge('def holds(run): return "slow", {}').reason)


def test_a_check_knows_each_text_in_every_language(judge):
    source = 'def holds(run): return run.texts["park"] == ["the park", "el parque"]'
    assert judge(source, en=ENGLISH, es=SPANISH).state == "met"


def test_a_check_sees_what_happened(judge):
    run = evidence(
        {"t": 0.0, "pose": [0, 0, 0]},
        {"t": 1.0, "pose": [300, 400, 90]},
        {"t": 1.5, "print": "hello"},
        {"t": 2.0, "goal": "there", "state": "reached"},
        report=Report(ended="finished", time=2.0),
    )
    source = """
def holds(run):
    seen = [run.distance, run.ended, run.time, run.prints, run.goals, run.path[1]]
    return seen == [500, "finished", 2, [[1.5, "hello"]], {"there": 2}, [1, 300, 400, 90]]
"""
    assert judge(source, run).reason is None


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ("def holds(run): return 1 / 0", "ZeroDivisionError"),
        ("def other(run): return True", "KeyError"),
        ("def holds(: pass", "SyntaxError"),
        ("raise SystemExit(0)", "SystemExit"),
        ("def holds(run): raise KeyboardInterrupt", "KeyboardInterrupt"),
        ("def holds(): return True", "TypeError"),
    ],
)
def test_a_check_with_a_mistake_is_not_met(judge, source, words):
    found = judge(source)
    assert (found.state, words in str(found.reason)) == ("failed", True)


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(
    "source",
    [
        pytest.param("import os\nos._exit(0)", id="ends"),
        pytest.param(f"{SAY}say(b'{{}}' * 1000)\nos._exit(0)", id="nonsense"),
        pytest.param(f"{SAY}say(b'[' * 60000)\nos._exit(0)", id="deep"),
        pytest.param(f"{SAY}while True: say(bytes(10 ** 6))", id="floods"),
        pytest.param(f"{SAY}say(b'{{\"met\": true}}')\nwhile True: pass", id="says and stays"),
        pytest.param("import os\nos.closerange(0, 32)\ndef holds(run): return True", id="closes"),
        pytest.param("list(range(10 ** 9))", id="memory"),
        pytest.param("import sys\nsys.setrecursionlimit(10 ** 9)\ndef f(): f()\nf()", id="stack"),
    ],
)
def test_a_hostile_check_is_not_met(judges, way, source):
    assert judges(way, source, limits=LITTLE).state == "failed"


@pytest.mark.parametrize("source", ["while True: pass", "import time\ntime.sleep(1000)"])
def test_a_check_without_an_end_is_ended(judge, source):
    assert judge(source, limits=replace(LITTLE, blocked=0.5)).state == "failed"


#: It sleeps for longer than a check may be blocked below.
SLOW = "import time\ndef holds(run):\n    time.sleep(0.4)\n    return True"


@pytest.fixture
def busy(monkeypatch):
    """A machine on which a check waits for a processor and for nothing else."""
    monkeypatch.setattr(expert, "of_process", lambda _: Activity(0.0, waits=False))


def test_a_check_that_waits_for_too_long_is_not_met(judge):
    assert judge(SLOW, limits=replace(LIMITS, blocked=0.1)).state == "failed"


@pytest.mark.usefixtures("busy")
def test_a_busy_machine_does_not_change_what_a_check_says(judge):
    assert judge(SLOW, limits=replace(LIMITS, blocked=0.1)).state == "met"


@pytest.mark.usefixtures("busy")
def test_a_machine_that_is_too_busy_for_a_check_gives_no_verdict(judge):
    with pytest.raises(NoVerdictError, match="too busy"):
        judge(SLOW, longest=0.2)


@contained
@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(
    "source",
    [
        pytest.param("import os\nos.fork()", id="fork"),
        pytest.param("import subprocess\nsubprocess.run(['true'])", id="process"),
        pytest.param("import socket\nsocket.create_connection(('127.0.0.1', 9))", id="network"),
        pytest.param("open('/etc/passwd').read()", id="reads"),
        pytest.param("import os\nos.listdir(os.path.expanduser('~root'))", id="lists"),
        pytest.param("import os\nos.kill(os.getppid(), 9)", id="kills"),
        pytest.param("open('/tmp/learnblock-expert-was-here', 'w')", id="writes"),
    ],
)
def test_a_check_can_do_nothing_but_compute(judges, way, source):
    found = judges(way, f"{source}\ndef holds(run): return True")
    assert found.state == "failed"


def test_a_check_gets_none_of_the_users_variables(judge, monkeypatch):
    monkeypatch.setenv("SECRET_TOKEN", "abc")
    source = "import os\ndef holds(run): return 'SECRET_TOKEN' not in os.environ"
    assert judge(source).state == "met"


def test_a_check_leaves_nothing_to_the_next_one(judge):
    judge("import builtins, os\nopen('left', 'w').close()\nbuiltins.left = os.environ['LEFT'] = ''")
    source = """
import builtins, os
def holds(run):
    return not (os.listdir() or hasattr(builtins, "left") or "LEFT" in os.environ)
"""
    assert judge(source).reason is None


def test_a_check_is_judged_although_what_forks_its_process_has_been_killed():
    class Killed(ForkServer):
        def standby(self):
            raise ConnectionResetError

    files = MappingProxyType({"checks.py": b"def holds(run): return True"})
    with Killed() as processes:
        experts = Experts(OpenLesson("it", LESSON, None, files), processes=processes)
        assert experts(Expert(function="holds"), evidence()).state == "met"
