"""The call graph of a run: what called what, how often and for how long."""

import json
import re

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.runtime.log.events import Op
from learnblock.why.calls import Callee, Layer, calls
from learnblock.why.graph_picture import COLOURS, colour, picture
from logged_runs import logged_example, logged_file, logged_text

PROGRAM = """\
def side(mm):
    function.drive_distance(mm)
    function.turn(90)
end
main:
    repeat 4:
        side(100)
    end
    function.sleep(1)
end
"""


@pytest.fixture(scope="module")
def square(tmp_path_factory):
    return calls(logged_text(tmp_path_factory.mktemp("square"), PROGRAM).history)


def node(graph, name):
    [found] = [one for one in graph.nodes if one.called.name == name]
    return found


def test_each_layer_calls_the_one_below(square):
    assert [*dict.fromkeys(one.called.layer for one in square.nodes)] == [*Layer]
    for edge in square.edges:
        assert edge.caller.layer <= edge.callee.layer


def test_calls_are_counted_through_a_function(square):
    program, side = square.program, Callee(Layer.FUNCTIONS, "side")
    counts = {(edge.caller, edge.callee.name): edge.count for edge in square.edges}
    assert counts[program, "side"] == 4
    assert counts[side, "drive_distance"] == 4
    assert counts[side, "turn"] == 4
    assert counts[program, "sleep"] == 1


def test_the_time_of_a_function_is_that_of_what_it_calls(square):
    whole = square.nodes[0]
    assert whole.seconds == pytest.approx(node(square, "side").seconds + 1, abs=0.05)
    parts = node(square, "drive_distance").seconds + node(square, "turn").seconds
    assert node(square, "side").seconds == pytest.approx(parts, abs=0.05)
    assert node(square, "sleep").share == pytest.approx(1 / whole.seconds, abs=0.001)


def test_a_device_is_reached_through_the_generic_client(square):
    ways = {(edge.caller.name, edge.callee.name) for edge in square.edges}
    assert ways >= {
        ("drive_distance", "device(Base)"),
        ("device(Base)", "Base.move"),
        ("Base.move", "sim-ebo.drive"),
    }


def test_a_sensor_is_read_by_the_generic_client_and_changed_through_its_device(tmp_path):
    text = "main:\n    function.reset_orientation()\n    function.get_heading()\nend\n"
    graph = calls(logged_text(tmp_path, text, "sim-ev3").history)
    ways = {edge.callee.name: edge.caller.name for edge in graph.edges}
    assert ways["Gyroscope.read"] == "read(Gyroscope)"
    assert ways["Gyroscope.reset"] == "device(Gyroscope)"


def test_an_edge_has_its_share_of_the_time(square):
    for edge in square.edges:
        assert edge.share == pytest.approx(edge.seconds / square.last, abs=0.001)


def test_an_edge_begins_with_its_first_event(tmp_path):
    history = logged_text(tmp_path, PROGRAM).history
    firsts = {edge.callee.name: history.events[edge.event] for edge in calls(history).edges}
    assert firsts["turn"][:2] == (Op.SKILL, "turn")
    assert firsts["Base.move"][:3] == (Op.COMMAND, "Base:ROBOT", "move")


def test_a_span_counts_what_happens_in_it(tmp_path):
    history = logged_text(tmp_path, PROGRAM).history
    last = calls(history, history.end - 0.5)
    assert [edge.callee.name for edge in last.edges] == ["sleep"]
    assert last.nodes[-1].seconds == pytest.approx(0.5)


@pytest.mark.parametrize("span", [(3, 2), (1000, None)])
def test_nothing_is_called_in_a_span_without_time(tmp_path, span):
    assert calls(logged_text(tmp_path, PROGRAM).history, *span).edges == ()


def test_turns_that_were_only_counted_are_calls_as_well(tmp_path):
    text = "main:\n    while not elapsedTime(5):\n        function.sleep(0.1)\n    end\nend\n"
    graph = calls(logged_text(tmp_path, text).history)
    assert node(graph, "sleep").count == 51
    assert node(graph, "sleep").seconds == pytest.approx(5.1)


def test_program_and_skills_are_the_same_on_a_robot_without_a_gyroscope():
    graphs = [calls(logged_example("square.bt", robot).history) for robot in ("sim-ebo", "sim-ev3")]
    names = [
        {one.called.name for one in graph.nodes if one.called.layer <= Layer.SKILLS}
        for graph in graphs
    ]
    assert names[0] == names[1]


def test_the_picture_has_a_box_for_each_function_and_a_line_for_each_edge(square):
    svg = picture(square, {layer: layer.name for layer in Layer})
    assert svg.count("<rect") == 1 + len(square.nodes)
    assert svg.count("<path") == len(square.edges)
    assert len(re.findall("[0-9]×, [0-9]+%<", svg)) == len(square.edges)
    assert "<title>side: 4×" in svg


def test_colours_go_from_little_to_much_time():
    assert colour(0) == COLOURS[0]
    assert colour(1) == COLOURS[-1]
    assert [colour(share / 100) for share in range(0, 60, 13)] == [*COLOURS]


@pytest.fixture
def log(tmp_path):
    program, log = tmp_path / "p.bt", tmp_path / "p.why"
    program.write_text(PROGRAM)
    done = CliRunner().invoke(main, ["run", str(program), "--why", str(log)])
    assert done.exit_code == 0, done.output
    return log


def test_the_command_prints_the_calls_as_a_tree(log):
    lines = CliRunner().invoke(main, ["calls", str(log)]).output.splitlines()
    assert lines[0].startswith("p.bt ")
    drives = [line.split()[:2] for line in lines if line.startswith("    drive_distance")]
    assert drives == [["drive_distance", "4x"]]


def test_the_command_writes_json_and_a_picture(log, tmp_path):
    svg = tmp_path / "p.svg"
    done = CliRunner().invoke(main, ["calls", str(log), "--json", "--svg", str(svg)])
    assert svg.read_text(encoding="utf-8").startswith("<svg")
    edges = json.loads(done.output)["edges"]
    assert {"drive_distance", "turn"} <= {edge["callee"]["name"] for edge in edges}


def test_a_span_that_ends_before_it_begins_is_refused(log):
    done = CliRunner().invoke(main, ["calls", str(log), "--from", "5", "--to", "2"])
    assert done.exit_code == 2
    assert "--to 2 is before --from 5." in done.output


def test_another_file_is_refused(tmp_path):
    other = tmp_path / "other.why"
    other.write_text("hello")
    done = CliRunner().invoke(main, ["calls", str(other)])
    assert done.exit_code == 2
    assert "other.why is not the log of a run" in done.output


METHODS = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()


class Driver:
    def __init__(self, mm):
        self.mm = mm

    def __repr__(self):
        return "driver"

    def side(self):
        robot.drive_distance(self.mm)
        robot.turn(90)


driver = Driver(100)
for _ in range(2):
    driver.side()
"""


def test_a_method_is_between_the_program_and_its_skills(tmp_path):
    path = tmp_path / "methods.py"
    path.write_text(METHODS, encoding="utf-8")
    graph = calls(logged_file(path, "sim-ebo").history)
    edges = {(edge.caller.name, edge.callee.name): edge.count for edge in graph.edges}
    assert edges[graph.program.name, "Driver.__init__"] == 1
    assert edges[graph.program.name, "Driver.side"] == 2
    assert edges["Driver.side", "drive_distance"] == 2
    assert (graph.program.name, "drive_distance") not in edges
