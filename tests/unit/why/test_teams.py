"""Each robot of several has a log, which shows the world of all of them exactly as it was."""

from unittest.mock import patch

import pytest
from click.testing import CliRunner

from learnblock import robots, running
from learnblock.cli import main
from learnblock.cli.console import ExitCode
from learnblock.monitor.world_monitor import WorldMonitor
from learnblock.running import Job, Options
from learnblock.running.team import TeamRun
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.log.noting import TICK
from learnblock.simulator import World
from learnblock.why import EventHistory, Recorded, read
from learnblock.why.calls import calls
from learnblock.why.moments import Moments
from learnblock.why.world_again import WorldAgain
from runs import EXAMPLES

SECONDS = 8
STEPS = (0, 1, 77, 250, 333, 500, 799)
TEAMS = {
    "football": (("striker.bt", "sim-ebo"), ("keeper.bt", "sim-thymio")),
    "relay": (("relay-first.bt", "sim-ebo"), ("relay-second.bt", "sim-ebo")),
    "sumo": (("sumo.bt", "sim-ebo"), ("sumo.bt", "sim-cozmo")),
}


def team(world, *, logged=True):
    """A run that is about to start, and the logs of its robots by name."""
    jobs, options = {}, Options(world=world, seconds=SECONDS, seed=2)
    for number, (file, robot) in enumerate(TEAMS[world]):
        source, entry = running.read(EXAMPLES / "several" / file), robots.find(robot)
        jobs[f"r{number}"] = Job(running.program(source, entry), entry, options)
    logs = {name: RunLog(job.program) for name, job in jobs.items()} if logged else None
    return TeamRun(jobs, worker=InlineWorker, logs=logs), logs or {}


def shown(client):
    """What the page shows of a robot's world."""
    robot = WorldMonitor.of(client)
    camera = client.body.description.camera
    picture = client.body.view(camera[0].key).picture().tobytes() if camera else b""
    return robot.state(), [(one.colour, one.points) for one in robot.strokes()], picture


def run_and_look(run):
    """Run to the end; return what the page showed of each robot before some steps."""
    seen, step = {}, World.step

    def looked_at(world):
        # A hand disturbs one of them.
        if world.steps == 120:
            run.simulation.place("r1", 100.12345, -50.5, 33.3333)
        if world.steps in STEPS:
            for name in run.jobs:
                if run.client(name):
                    seen[name, world.steps] = shown(run.client(name))
        step(world)

    with patch.object(World, "step", looked_at):
        return run.run(), seen


@pytest.mark.parametrize("world", TEAMS)
def test_any_of_the_logs_shows_the_world_of_all_robots_as_it_was(world):
    run, logs = team(world)
    _, seen = run_and_look(run)
    assert len(seen) > len(STEPS)
    again = {name: WorldAgain(Recorded.of(log.blocks)) for name, log in logs.items()}
    for world_again in again.values():
        while world_again.prepare():
            pass
    for (name, step), was in seen.items():
        assert shown(again[name].seek(step * TICK)) == was, (name, step)


def test_logs_leave_the_trace_of_a_run_as_it_was():
    without, with_logs = team("football", logged=False)[0].run(), team("football")[0].run()
    assert with_logs.trace_sha256 == without.trace_sha256


def test_each_log_is_of_its_own_program():
    run, logs = team("football")
    report = run.run()
    striker, keeper = (EventHistory(Recorded.of(log.blocks)) for log in logs.values())
    assert striker.recorded.name == "r0"
    assert striker.recorded.conditions["robot"] == "sim-ebo"
    assert keeper.recorded.conditions["robot"] == "sim-thymio"
    assert {node.called.name for node in calls(striker).nodes} != {
        node.called.name for node in calls(keeper).nodes
    }
    lines = {line["robot"] for line in striker.recorded.lines if "line" in line}
    assert lines == {"r0"}
    assert Moments(keeper).at(4).line > 0
    assert striker.recorded.ending["trace_sha256"] == report.trace_sha256


def test_the_command_writes_a_log_for_each_robot(tmp_path):
    swarm = EXAMPLES / "several" / "swarm.bt"
    command = ["run", f"{swarm}@sim-ebo:2", "--world", "empty", "--for", "2"]
    done = CliRunner().invoke(main, [*command, "--why", str(tmp_path / "logs")])
    assert done.exit_code == ExitCode.WELL, done.output
    files = sorted((tmp_path / "logs").iterdir())
    assert [file.name for file in files] == ["swarm-1.why", "swarm-2.why"]
    world = WorldAgain(read(files[1]))
    assert {*world.seek(1).simulation.world.robots} == {"swarm-1", "swarm-2"}
    asked = CliRunner().invoke(main, ["why", str(files[0])])
    assert asked.exit_code == ExitCode.WELL
    (tmp_path / "file").write_text("")
    refused = CliRunner().invoke(main, [*command, "--why", str(tmp_path / "file")])
    assert refused.exit_code == ExitCode.USAGE
