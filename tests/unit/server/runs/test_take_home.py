"""What a page to take home contains of a run."""

import pytest

from learnblock import robots, running
from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.project.document.document import Document
from learnblock.running import Job, Options, ProgramRun
from learnblock.running.team import TeamRun
from learnblock.runtime.log.keeping import RunLog
from learnblock.server.runs import take_home
from learnblock.server.runs.take_home import RobotRun, Titles, run_content, run_page
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


HELPER = """\
main:
    function.drive_distance(50)
    print("first there")
end
"""

TITLES = Titles("drawing", "en")


@pytest.fixture(scope="module")
def robot():
    return robots.find("sim-ebo")


@pytest.fixture(scope="module")
def prepared(tmp_path_factory, robot):
    """The program of a text on a robot, and its document."""
    folder = tmp_path_factory.mktemp("run")

    def prepare(text):
        path = folder / "drawing.bt"
        path.write_text(text)
        program = running.program(running.read(path), robot)
        return program, Document.from_text(text, robot.module, all_configurations())

    return prepare


@pytest.fixture(scope="module")
def ran(prepared, robot):
    """A run of a robot that was alone."""
    program, document = prepared(DRAWING)
    log = RunLog(program)
    ProgramRun(Job(program, robot, Options("empty")), log=log).run()
    return [RobotRun(log, document, robot.name)]


@pytest.fixture(scope="module")
def ran_together(prepared, robot):
    """A run of two robots with programs of their own, of which the second ends earlier."""
    texts = {"artist": DRAWING, "helper": HELPER}
    programs = {name: prepared(text) for name, text in texts.items()}
    jobs = {name: Job(program, robot, Options("empty")) for name, (program, _) in programs.items()}
    logs = {name: RunLog(program) for name, (program, _) in programs.items()}
    TeamRun(jobs, logs=logs).run()
    return [RobotRun(logs[name], programs[name][1], robot.name) for name in texts]


@pytest.fixture(scope="module")
def content(ran):
    return run_content(ran, TITLES)


@pytest.fixture(scope="module")
def alone(content):
    """What the page shows of a robot that was alone."""
    return content["robots"][0]


@pytest.fixture(scope="module")
def together(ran_together):
    return run_content(ran_together, TITLES)


def times_of(robot):
    return [moment["past"]["time"] for moment in robot["moments"]]


def test_its_moments_go_from_the_start_to_the_end_and_have_the_world(content, alone):
    times = times_of(alone)
    assert times == sorted(times)
    assert (times[0], times[-1]) == (0.0, alone["timeline"].end)
    assert sorted(set(times)) == [time for time, _ in content["states"]]
    assert content["states"][-1][1][0]["x"] == pytest.approx(200, abs=5)
    blocks = {place.block for place in alone["places"]}
    lines = [moment["past"]["line"] for moment in alone["moments"]]
    assert {line["block"] for line in lines if line.get("block")} <= blocks


def test_a_drawing_is_kept_once(alone):
    drawn = [moment["drawn"] for moment in alone["moments"]]
    assert drawn == sorted(drawn)
    assert drawn[-1] == sum(len(part.points) for part in alone["drawing"].parts) > 0
    assert not any(moment["past"].get("drawing") for moment in alone["moments"])


def test_every_question_is_answered(alone):
    asked = {answer.asked.question for answer in alone["answers"]}
    assert {one.question for one in alone["questions"].questions} <= asked


def test_the_moments_to_which_answers_lead_are_there(alone):
    times = set(times_of(alone))
    sentences = [one for answer in alone["answers"] for one in answer.sentences]
    assert {one.time for one in sentences if one.time is not None} <= times


def test_each_of_several_robots_has_its_own_program_values_and_answers(together):
    artist, helper = together["robots"]
    assert (artist["name"], helper["name"]) == ("artist", "helper")
    assert (artist["blocktext"], helper["blocktext"]) == (DRAWING, HELPER)
    assert (artist["printed"], helper["printed"]) == ("there\nthere\n", "first there\n")
    for robot in (artist, helper):
        asked = {answer.asked.question for answer in robot["answers"]}
        assert {one.question for one in robot["questions"].questions} <= asked


def test_the_states_of_several_robots_are_there_once_at_every_moment(together):
    artist, helper = together["robots"]
    states = dict(together["states"])
    assert set(states) == {*times_of(artist), *times_of(helper)}
    assert all([one["name"] for one in state] == ["artist", "helper"] for state in states.values())
    # Both have the same even times, until the first of them ends.
    assert len(states) < len(set(times_of(artist))) + len(set(times_of(helper))) // 2
    assert [name for name, _ in together["scene"].robots] == ["artist", "helper"]


def test_a_robot_without_a_world_is_left_out(ran, ran_together):
    real = RobotRun(RunLog(ran[0].log.program), ran[0].document, "ebo")
    contents = run_content([real, *ran_together], TITLES)
    assert [robot["name"] for robot in contents["robots"]] == ["artist", "helper"]
    with pytest.raises(LearnBlockError) as refusal:
        run_content([real], TITLES)
    assert refusal.value.phrase.code == "take-home-no-world"


def test_a_page_says_nothing_of_the_pupil_but_the_name_that_is_wished(ran, content):
    assert content["pupil"] == ""
    named = content_of(run_page(ran, Titles("drawing", "en", "Ada")))
    assert named["pupil"] == "Ada"


@pytest.mark.parametrize("which", ["ran", "ran_together"])
def test_it_has_fewer_moments_rather_than_more_than_2_mb(which, request, monkeypatch):
    ran = request.getfixturevalue(which)
    whole = run_page(ran, TITLES)
    monkeypatch.setattr(take_home, "LARGEST", len(whole) - 1)
    smaller = run_page(ran, TITLES)
    assert len(smaller) < len(whole)
    before, after = content_of(whole), content_of(smaller)
    for robot, thinned in zip(before["robots"], after["robots"], strict=True):
        times, fewer = times_of(robot), times_of(thinned)
        assert len(fewer) < 0.6 * len(times)
        assert (fewer[0], fewer[-1]) == (times[0], times[-1])
    shown = {time for robot in after["robots"] for time in times_of(robot)}
    assert shown == {time for time, _ in after["states"]}


def test_a_run_that_is_too_large_all_the_same_is_refused(ran, monkeypatch):
    monkeypatch.setattr(take_home, "LARGEST", 1_000_000)
    with pytest.raises(LearnBlockError) as refusal:
        run_page(ran, TITLES)
    assert refusal.value.phrase.code == "take-home-too-large"
