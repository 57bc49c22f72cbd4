"""What the world's picture shows: the robot, its goal, themes and celebrations."""

import json
import re
from typing import get_args

import pytest
from playwright.sync_api import expect

from learnblock.simulator import load_world, world_names
from learnblock.simulator.world_description import Theme

#: Draw now, and say what is drawn: telemetry may move the robot before the next frame.
DRAWN = "() => { const world = learnblock.views.world.value; world.resize(); return world.drawn; }"
#: The middle 80 % of the picture.
INNER = 0.8
DRIVE = "main:\n    function.drive_distance(500)\nend\n"


@pytest.fixture
def pupil(sit_down, server):
    """A pupil whose page says what it draws."""
    return seated(sit_down, server, reduced_motion="reduce")


def seated(sit_down, server, **options):
    pupil = sit_down(server, empty=True, **options)
    page = pupil.page
    page.goto(page.url.replace("/#", "/?test#"))
    # The server accepts another world only once the project is open, which shows its own.
    page.wait_for_function(
        "() => globalThis.learnblock?.views.world.value?.framesDrawn > 0"
        " && learnblock.context.running.scene.value"
    )
    return pupil


def show_world(pupil, name):
    """Choose a world by its file's name, and return what its picture shows first."""
    page = pupil.page
    page.evaluate("name => learnblock.context.connection.send({ kind: 'ChooseWorld', name })", name)
    page.wait_for_function(
        "name => learnblock.context.running.scene.value?.name === name", arg=name
    )
    return page.evaluate(DRAWN)


@pytest.mark.parametrize("robot", ["sim-ebo", "sim-cozmo"])
def test_every_world_starts_with_a_large_robot_and_its_first_goal_in_sight(pupil, robot):
    pupil.page.evaluate(
        "name => learnblock.context.connection.send({ kind: 'ChooseRobot', name })", robot
    )
    small, hidden, unseen = {}, {}, []
    for name in world_names():
        drawn = show_world(pupil, name)
        if drawn["share"] < 0.12:
            small[name] = drawn["share"]
        if not drawn["seen"]:
            unseen.append(name)
        places = [drawn["robot"], *([drawn["goal"]] if drawn["goal"] else [])]
        if any(abs(along) > INNER for place in places for along in place):
            hidden[name] = places
    assert small == {}
    assert hidden == {}
    assert unseen == []


def test_the_robot_stays_in_the_picture_while_it_drives(pupil):
    show_world(pupil, "empty")
    pupil.write("blocktext", "main:\n    function.drive_distance(800)\nend\n")
    expect(pupil.blocks("lb_skill_drive_distance")).to_be_visible()
    pupil.choose("Speed", "20×")
    pupil.press("Run")
    pupil.state("Ended")
    pupil.expect_robot(r"[78]\d\d mm east")
    pupil.page.wait_for_function(
        f"() => ({DRAWN})().robot.every(along => Math.abs(along) < {INNER})"
    )
    pupil.picture("followed")


def test_the_robots_eye_is_another_view(pupil):
    show_world(pupil, "parking")
    world = pupil.page.locator(".world-view")
    world.focus()
    pupil.page.keyboard.press("e")
    pupil.picture("eye")
    goal = pupil.page.evaluate(DRAWN)["goal"]
    assert all(abs(along) < 1 for along in goal)
    pupil.page.keyboard.press("f")
    assert pupil.page.evaluate(DRAWN)["share"] >= 0.12


def test_a_chip_shows_where_its_value_comes_from_and_opens_its_plot(pupil):
    page = pupil.page
    show_world(pupil, "distance")
    marks = f"() => ({DRAWN})().marks"
    page.locator(".world-view").focus()
    page.keyboard.press("l")
    assert not any(page.evaluate(marks).values())

    for chip, mark in {"Front": "beams", "Heading": "bearing"}.items():
        page.get_by_role("button", name=re.compile(f"^{chip}")).hover()
        assert [name for name, shown in page.evaluate(marks).items() if shown] == [mark]
    pupil.picture("heading")

    page.get_by_role("button", name=re.compile("^Heading")).click()
    box = page.get_by_role("checkbox", name="Heading", exact=True)
    expect(box).to_be_checked()
    expect(page.get_by_role("checkbox", name="Distance in front 1")).not_to_be_checked()
    page.mouse.move(0, 0)
    page.locator(".world-view").focus()
    assert not any(page.evaluate(marks).values())


def test_the_chips_are_the_values_that_the_program_asks_for_and_point_at_their_sensors(pupil):
    page = pupil.page
    robot = "name => learnblock.context.connection.send({ kind: 'ChooseRobot', name })"
    page.evaluate(robot, "sim-ev3")
    show_world(pupil, "empty")
    chips = page.locator(".chips button")
    expect(chips).to_have_text([re.compile(one) for one in ("^Front", "^Heading", "^Driven")])

    pupil.write("blocktext", "main:\n    x = function.is_left_ground_line()\nend\n")
    expect(chips).to_have_text([re.compile(one) for one in ("^Floor .* %$", "^Heading", "^Driven")])
    chips.first.hover()
    assert page.evaluate(DRAWN)["marks"]["origin"]
    pupil.picture("floor-sensors")
    chips.first.click()
    expect(page.get_by_role("checkbox", name=re.compile("^Ground"))).to_be_checked()


def celebrates(pupil):
    """Run a program that reaches a goal, and return whether the world has begun an effect."""
    show_world(pupil, "distance")
    pupil.write("blocktext", DRIVE)
    expect(pupil.blocks("lb_skill_drive_distance")).to_be_visible()
    pupil.choose("Speed", "10×")
    pupil.press("Run")
    pupil.state("Ended")
    # The world and this chip show the same message.
    expect(pupil.page.locator(".chip.goals.reached")).to_be_visible()
    return pupil.page.evaluate(DRAWN)["effects"] > 0


def test_a_reached_goal_is_celebrated(sit_down, server):
    pupil = seated(sit_down, server, reduced_motion="no-preference")

    assert celebrates(pupil)
    pupil.picture("celebrated")


def test_nothing_is_celebrated_with_reduced_motion_or_if_the_user_does_not_want_it(
    pupil, sit_down, server
):
    assert not celebrates(pupil)
    other = seated(sit_down, server, reduced_motion="no-preference")
    other.command("Settings and help", "Settings")
    other.dialog().get_by_label("Celebrate reached goals").uncheck()
    other.page.keyboard.press("Escape")
    assert not celebrates(other)


@pytest.mark.parametrize("theme", get_args(Theme))
def test_every_theme_is_drawn(own_server, sit_down, theme):
    worlds = own_server.home / "worlds"
    worlds.mkdir(parents=True, exist_ok=True)
    (worlds / "own.toml").write_text(f"title = {json.dumps(theme)}\ntheme = {json.dumps(theme)}\n")
    pupil = seated(sit_down, own_server, reduced_motion="reduce")
    assert load_world("own", [worlds]).theme == theme
    assert show_world(pupil, "own")["share"] >= 0.12
    pupil.picture(theme)


#: The shares of both halves of the picture that are drawn, and how much of them differs.
DIFFERENT = """() => {
    const world = document.querySelector("#world .world-view canvas");
    learnblock.views.world.value.drawBest();
    const [wide, high] = [world.width / 2, world.height];
    const [left, right] = [0, wide].map((from) => {
        const part = Object.assign(document.createElement("canvas"), { width: 40, height: 40 });
        const pen = part.getContext("2d");
        pen.drawImage(world, from, 0, wide, high, 0, 0, 40, 40);
        return pen.getImageData(0, 0, 40, 40).data;
    });
    const isDrawn = (data) => data.filter((value, i) => i % 4 === 3 && value > 0).length / 1600;
    const differs = left.filter((value, i) => Math.abs(value - right[i]) > 24);
    return [isDrawn(left), isDrawn(right), differs.length / left.length];
}"""


def test_two_players_are_seen_side_by_side_and_named(pupil):
    pupil.open_example("Race for two")
    halves = pupil.page.locator(".world-halves")
    expect(halves).to_be_hidden()
    pupil.choose("View and robot", "Side by side: arrows and wasd")
    expect(halves.locator("b")).to_have_text(["arrows", "wasd"])
    left, right, different = pupil.page.evaluate(DIFFERENT)
    assert min(left, right) > 0.5
    assert 0 < different < 0.5
    pupil.picture("side-by-side")
    pupil.page.get_by_role("tab", name="wasd").click()
    expect(halves.locator("b")).to_have_text(["arrows", "wasd"])
    pupil.choose("View and robot", "Follow wasd")
    expect(halves).to_be_hidden()
    pupil.picture("one")
    assert pupil.errors == []
