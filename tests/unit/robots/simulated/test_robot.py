"""The twins: where their world, seed and pace come from, and whether their devices are complete."""

import sys
from importlib.metadata import EntryPoint, EntryPoints
from typing import get_args

import pytest

from learnblock import robots, running
from learnblock.devices import Base, Display, Emotion, Gyroscope, JointMotor, Speaker
from learnblock.errors import DeviceValueError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.robots.sim_cozmo import Robot as Cozmo
from learnblock.robots.sim_ebo import Robot as Ebo
from learnblock.robots.sim_thymio import Robot as Thymio
from learnblock.robots.simulated import Simulation, find_world, pace_factor
from learnblock.runtime.host import Host
from learnblock.runtime.limits import Limits
from learnblock.runtime.program import Program
from learnblock.runtime.recorder import record
from learnblock.runtime.run import Run
from learnblock.runtime.trace import Trace
from learnblock.simulator import World, load_world, textures
from learnblock.simulator.world_description import Theme
from runs import run_file

TWINS = ("sim-ebo", "sim-thymio", "sim-ev3", "sim-cozmo")


@pytest.mark.parametrize("name", TWINS)
def test_a_twin_has_the_devices_in_its_description(name):
    kind = robots.find(name).load()
    with kind(world="empty") as robot:
        devices = {f"{type(device).__name__}:{key}" for key, device in robot.devices()}
    assert kind.device_names() == devices


def test_a_program_drives_and_its_world_advances_while_it_waits():
    with Ebo(world="empty") as robot:
        robot.device(Base).move(100, 0)
        robot.sleep(2)
        x, y, _ = robot.where()
        assert 180 < x < 201
        assert abs(y) < 2
        assert robot.time() == 2


def test_a_gyroscope_turns_with_the_robot_and_can_be_reset():
    with Cozmo(world="empty") as robot:
        robot.device(Base).move(0, 90)
        robot.sleep(1)
        assert 80 < robot.read(Gyroscope, "Z_AXIS") < 91
        robot.device(Gyroscope, "Z_AXIS").reset()
        robot.forget_readings()
        assert abs(robot.read(Gyroscope, "Z_AXIS")) < 1


def test_a_pen_draws_on_the_floor_and_its_stroke_is_in_the_trace(tmp_path):
    source = tmp_path / "line.bt"
    source.write_text(
        "main:\n    function.pen_down()\n    function.drive_distance(100)\n"
        "    function.pen_up()\n    function.sleep(0.1)\nend\n"
    )
    finished = run_file(source, "sim-ev3", world="empty")
    (stroke,) = finished.entries("stroke")
    assert stroke["stroke"][0] == [0, 0]
    assert 95 < stroke["stroke"][-1][0] < 105
    assert (stroke["color"], stroke["width"]) == ([25, 70, 215], 6)


def test_a_text_is_on_the_screen_until_the_next_emotion():
    with Cozmo(world="empty") as robot:
        robot.show_text("hello")
        assert robot.body.text == "hello"
        robot.expressJoy()
        assert robot.body.text == ""


def test_a_text_beside_a_robot_stays_when_its_lamps_show_an_emotion():
    with robots.find("sim-thymio").load()(world="empty") as robot:
        robot.show_text("hello")
        robot.expressJoy()
        assert robot.body.text == "hello"
        robot.clear_screen()
        assert robot.body.text == ""


def test_commands_without_another_effect_are_logged():
    with Cozmo(world="empty") as robot:
        robot.device(Speaker).say("hello")
        robot.device(Display).show_emotion(Emotion.JOY)
        robot.device(JointMotor, "CAMERA").move(20)
        robot.sleep(1)
        assert [entry[1:] for entry in robot.body.log] == [("Speaker", "say", ("hello",))]
        assert robot.body.emotion == "joy"
        assert robot.body.joint("CAMERA") == 20


def test_world_seed_and_pace_come_from_the_environment_unless_the_program_sets_them(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_WORLD", "tags")
    monkeypatch.setenv("LEARNBLOCK_SEED", "7")
    monkeypatch.setenv("LEARNBLOCK_PACE", "50")
    with Ebo() as robot:
        assert robot.conditions() == {"robot": "sim-ebo", "world": "tags", "seed": 7}
        assert robot.simulation.pacing.factor == 50
    with Ebo(world="line", seed=1, pace="free") as robot:
        assert robot.conditions() == {"robot": "sim-ebo", "world": "line", "seed": 1}
        assert robot.simulation.pacing.factor is None


@pytest.mark.parametrize(("pace", "factor"), [("free", None), ("real", 1), ("2.5", 2.5), (3, 3)])
def test_a_pace_is_a_word_or_a_factor(pace, factor):
    assert pace_factor(pace) == factor


@pytest.mark.parametrize("pace", ["fast", "0", "-1", "nan", "inf", ""])
def test_another_pace_is_refused_by_name(pace):
    with pytest.raises(DeviceValueError) as refused:
        pace_factor(pace)
    assert refused.value.phrase == Phrase("world-bad-pace", pace=pace)


def test_a_seed_that_is_not_a_whole_number_is_refused(monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_SEED", "lucky")
    with pytest.raises(DeviceValueError) as refused:
        Ebo(world="empty")
    assert refused.value.phrase == Phrase("world-bad-seed", seed="lucky")


def test_a_world_is_found_in_the_users_folder_or_in_a_plugin(own_home, tmp_path, monkeypatch):
    (own_home / "worlds").mkdir()
    (own_home / "worlds" / "room.toml").write_text('title = "My room"')
    package = tmp_path / "school_worlds"
    package.mkdir()
    (package / "__init__.py").touch()
    (package / "gym.toml").write_text('title = "The gym"')
    monkeypatch.syspath_prepend(tmp_path)
    point = EntryPoint("school", "school_worlds", "learnblock.worlds")
    monkeypatch.setattr("importlib.metadata.entry_points", lambda: EntryPoints([point]))
    assert find_world("room").title == "My room"
    assert find_world("gym").title == "The gym"
    assert "school_worlds" not in sys.modules
    with pytest.raises(UnknownNameError, match="Did you mean 'gym'"):
        find_world("gyn")


ENDLESS = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()
robot.move_straight(100)
robot.sleep(1)
"""


@pytest.mark.parametrize(
    ("ending", "how"),
    [
        ("while True: pass", "no call"),
        ("1 / 0", "error"),
        ("import os; os._exit(1)", "killed"),
        ("while True: robot.sleep(1)", "time limit"),
    ],
)
def test_every_program_ends_with_its_robot_at_rest(ending, how):
    source = ENDLESS + ending
    entry = robots.find("sim-ebo")
    session = running.ProgramRun(
        running.Job(
            Program("endless.py", source, source),
            entry,
            running.Options(world="empty", seconds=3),
            limits=Limits(silence=0.3),
        )
    )
    assert session.run().ended == how
    simulation = session.client.simulation
    simulation.advance(simulation.steps + 100)
    at_rest = session.client.where()
    simulation.advance(simulation.steps + 100)
    assert session.client.where() == at_rest


@pytest.mark.parametrize("theme", get_args(Theme))
def test_a_theme_and_decoration_do_not_change_a_trace(tmp_path, theme):
    program, world = tmp_path / "drive.bt", tmp_path / "w.toml"
    program.write_text(
        "main:\n    function.drive_distance(150)\n    x = function.get_min_distance()\nend\n"
    )
    box = "[[box]]\nx = 200\ny = 0\nmass = 0.2\n"
    tree = '[[prop]]\nkind = "tree"\nx = 150\ny = 0\n'

    def traced(text):
        world.write_text(text)
        finished = run_file(program, "sim-ebo", world=str(world), seed=3)
        assert finished.report.error is None
        return finished.trace

    assert traced(f'theme = "{theme}"\n{box}{tree}') == traced(box)


def test_programs_of_one_world_leave_the_same_trace_every_time():
    source = (
        ENDLESS.replace("100", "60") + "while True:\n    robot.turn_right()\n    robot.sleep(0.1)"
    )

    def run_three():
        trace = Trace()
        simulation = Simulation(World(load_world("obstacles"), seed=4))

        def one(index):
            program = Program("three.py", source, source)
            return Run(
                program,
                lambda *_: Ebo(simulation=simulation, name=f"robot {index}"),
                lambda client: record(client, program.identity, trace, {"robot": client.name}),
            )

        Host(*map(one, range(3)), seconds=4).run()
        return trace.sha256, [body.pose for body in simulation.world.robots.values()]

    assert run_three() == run_three()


def test_a_twin_in_the_world_of_its_host_attaches_a_skill_when_it_is_called():
    with Ebo(simulation=Simulation(World(load_world("empty")))) as robot:
        assert "move_straight" not in vars(robot)
        robot.move_straight()
        assert robot.device(Base).speed == (40.0, 0.0)


@pytest.mark.parametrize(("kind", "is_drawn"), [(Ebo, True), (Thymio, False)])
def test_the_floor_is_drawn_for_the_runs_of_robots_with_a_camera(kind, is_drawn, monkeypatch):
    kept = kind.prepared({"world": "line"})
    assert kept.description.name == "line"
    assert ("mips" in vars(kept.floor)) == is_drawn
    if is_drawn:
        monkeypatch.setattr(textures, "floor", None)
        assert World(load_world("line")).floor.image is kept.floor.image


def test_a_picture_of_the_users_is_not_unpacked_for_other_processes(tmp_path):
    header = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes([0, 0, 0, 9, 0, 0, 0, 9])
    (tmp_path / "damaged.png").write_bytes(header)
    (tmp_path / "pictured.toml").write_text('[floor]\npicture = "damaged.png"')

    assert Ebo.prepared({"world": str(tmp_path / "pictured.toml")}).floor.reaches(0, 0)
