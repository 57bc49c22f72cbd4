"""Figure 8 of the paper: of one program on several robots, only the lowest row of calls differs."""

import pytest

from emulated import settle
from learnblock.emulators import emulate
from learnblock.why.calls import Layer, calls
from logged_runs import logged_text
from twins_time import follow

#: The paper's square, with shorter sides.
SQUARE = """\
times = None
angle = None

main:
    times = 0
    angle = 90
    function.reset_orientation()
    while times < 2:
        function.move_straight()
        function.sleep(0.5)
        function.stop_bot()
        function.set_orientation(angle)
        times += 1
        angle += 90
    end
end
"""


@pytest.fixture
def graph(tmp_path, monkeypatch):
    """Run a program on a twin, or through a real driver and its wire; return its calls."""

    def graph(robot, text=SQUARE):
        if robot.startswith("sim-"):
            return calls(logged_text(tmp_path, text, robot, world="empty").history)
        with emulate(robot, "empty") as emulation:
            follow(emulation.twin, monkeypatch)
            settle(robot, emulation.settings)
            logged = logged_text(tmp_path, text, robot, seconds=60)
        assert logged.report.error is None
        return calls(logged.history)

    return graph


def upper(graph):
    """Return what called what above the drivers."""
    return {(edge.caller, edge.callee) for edge in graph.edges if edge.callee.layer < Layer.DRIVER}


def lowest(graph):
    return {node.called.name for node in graph.nodes if node.called.layer == Layer.DRIVER}


def test_only_the_lowest_row_differs_between_ev3_and_cozmo_and_their_twins(graph):
    graphs = {robot: graph(robot) for robot in ("sim-ev3", "sim-cozmo", "ev3", "cozmo")}
    first = upper(graphs["sim-ev3"])
    assert {callee.name for _, callee in first} >= {
        "set_orientation",
        "device(Base)",
        "read(Gyroscope)",
        "Base.move",
        "Gyroscope.read",
    }
    assert [upper(each) == first for each in graphs.values()] == [True] * 4
    assert lowest(graphs["ev3"]) == {"ev3._drive", "ev3._reading"}
    assert lowest(graphs["cozmo"]) == {"cozmo.move", "CozmoOdometry.turned", "CozmoOdometry.reset"}
    for twin in ("sim-ev3", "sim-cozmo"):
        functions = ("drive", "gyroscope", "reset_gyroscope")
        assert lowest(graphs[twin]) == {f"{twin}.{name}" for name in functions}


def test_the_lowest_row_of_a_robot_of_robocomp_has_the_operations_of_its_components(graph):
    program = "main:\n    function.move_straight(30)\n    function.is_front_obstacle(100)\nend\n"
    assert {"differentialrobot.setSpeedBase", "laser.getLaserData"} <= lowest(
        graph("rcis", program)
    )
