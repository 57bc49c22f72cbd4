"""What a page to take home contains of a run."""

import pytest

from learnblock import robots, running
from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.project.document.document import Document
from learnblock.running import Job, Options, ProgramRun
from learnblock.runtime.log.keeping import RunLog
from learnblock.server.runs import take_home
from learnblock.server.runs.take_home import Titles, run_content, run_page
from page_files import content_of

DRAWING = """\
main:
    function.pen_down()
    repeat 2:
        function.drive_distance(100)
        print("there")
    end
end
"""


TITLES = Titles("drawing", "sim-ebo", "en")


@pytest.fixture(scope="module")
def ran(tmp_path_factory):
    """The log of a run, and its program."""
    path = tmp_path_factory.mktemp("run") / "drawing.bt"
    path.write_text(DRAWING)
    source = running.read(path)
    robot = robots.find("sim-ebo")
    program = running.program(source, robot)
    log = RunLog(program)
    ProgramRun(Job(program, robot, Options("empty")), log=log).run()
    document = Document.from_text(DRAWING, robot.module, all_configurations())
    return log, document


@pytest.fixture(scope="module")
def content(ran):
    return run_content(*ran, TITLES)


def test_its_moments_go_from_the_start_to_the_end_and_have_the_world(content):
    moments = [moment["past"] for moment in content["moments"]]
    times = [moment.time for moment in moments]
    assert times == sorted(times)
    assert (times[0], times[-1]) == (0.0, content["timeline"].end)
    assert all(moment.telemetry for moment in moments)
    blocks = {place.block for place in content["places"]}
    assert {moment.line.block for moment in moments if moment.line.block} <= blocks


def test_a_drawing_is_kept_once(content):
    drawn = [moment["drawn"] for moment in content["moments"]]
    assert drawn == sorted(drawn)
    assert drawn[-1] == sum(len(part.points) for part in content["drawing"].parts) > 0
    assert all(moment["past"].drawing is None for moment in content["moments"])


def test_every_question_is_answered(content):
    asked = {answer.asked.question for answer in content["answers"]}
    assert {one.question for one in content["questions"].questions} <= asked


def test_the_moments_to_which_answers_lead_are_there(content):
    times = {moment["past"].time for moment in content["moments"]}
    sentences = [one for answer in content["answers"] for one in answer.sentences]
    assert {one.time for one in sentences if one.time is not None} <= times


def test_it_has_fewer_moments_rather_than_more_than_2_mb(ran, content, monkeypatch):
    whole = run_page(*ran, TITLES)
    monkeypatch.setattr(take_home, "LARGEST", len(whole) - 1)
    smaller = run_page(*ran, TITLES)
    assert len(smaller) < len(whole)
    times = [moment["past"]["time"] for moment in content_of(smaller)["moments"]]
    assert len(times) == len(content["moments"]) // 2 + 1
    assert (times[0], times[-1]) == (0.0, content["timeline"].end)


def test_a_run_that_is_too_large_all_the_same_is_refused(ran, monkeypatch):
    monkeypatch.setattr(take_home, "LARGEST", 1_000_000)
    with pytest.raises(LearnBlockError) as refusal:
        run_page(*ran, TITLES)
    assert refusal.value.phrase.code == "take-home-too-large"
