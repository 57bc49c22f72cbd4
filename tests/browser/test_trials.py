"""What newcomers try first; each trial prints its steps and seconds."""

import time

import pytest
from playwright.sync_api import expect

#: Counts what a hand does: presses of the mouse and of keys.
COUNT_STEPS = """() => {
    globalThis.steps = { mouse: 0, keys: 0 };
    addEventListener("pointerdown", () => { steps.mouse += 1; }, { capture: true });
    addEventListener("keydown", () => { steps.keys += 1; }, { capture: true });
}"""


#: The names of what can be used, besides the palette and the program, and the values in the world,
#: which the 15 controls of the design's picture leave out too.
CONTROLS = """() => [...document.querySelectorAll("button, select, input, a[href], [role=tab]")]
    .filter((one) => one.checkVisibility({ visibilityProperty: true }))
    .filter((one) => !one.closest(".blocks, .zoom-buttons, .cm-editor, .skip-links, .chips"))
    .map((one) => one.ariaLabel || one.title || one.textContent)"""


@pytest.fixture
def pupil(sit_down, server):
    return sit_down(server, stage="starter", empty=True)


@pytest.fixture
def trial(pupil, request):
    """Count the steps and seconds of a trial, and print them; a function that returns both."""
    pupil.page.evaluate(COUNT_STEPS)
    began = time.monotonic()

    def so_far():
        return pupil.page.evaluate("steps"), time.monotonic() - began

    yield so_far
    steps, seconds = so_far()
    name = request.node.name.removeprefix("test_")
    print(f"{name}: {steps['mouse']} by mouse, {steps['keys']} keys, {seconds:.1f} s")  # noqa: T201 - what the trial measured


def main_of(pupil):
    return pupil.blocks("lb_main").get_attribute("data-id")


# The picture has 15; the button that shares came with links.
@pytest.mark.parametrize("stage", ["Starter", "Explorer"])
def test_at_first_sight_there_are_at_most_16_controls_besides_palette_and_program(pupil, stage):
    pupil.command("Settings and help", stage)
    expect(pupil.menu("View and robot")).to_be_visible()
    expect(pupil.page.locator(".blocklyToolbox")).to_be_visible()
    controls = pupil.page.evaluate(CONTROLS)
    print(len(controls), "controls:", ", ".join(controls))  # noqa: T201 - what the trial counts
    assert 10 < len(controls) <= 16


@pytest.mark.usefixtures("trial")
def test_a_triangle_is_built_by_dragging_and_driven(pupil):
    loop = pupil.take("Control", "controls_repeat_ext")
    pupil.put_into(loop, main_of(pupil))
    drive = pupil.take("Move", "lb_skill_drive_distance")
    pupil.put_into_loop(drive, loop)
    turn = pupil.take("Move", "lb_skill_turn")
    pupil.put_below(turn, drive)
    times = pupil.block(loop).locator(".blocklyNumberField").first
    pupil.fill(times, "3")
    pupil.fill(pupil.block(drive).locator(".blocklyNumberField").first, "200")
    pupil.fill(pupil.block(turn).get_by_text("90", exact=True), "120")
    pupil.picture("triangle")
    pupil.choose("Speed", "20×")
    pupil.press("Run")
    pupil.state("Ended")
    x, y = pupil.place_of_robot()
    assert abs(x) < 30
    assert abs(y) < 30


def test_a_when_is_dragged_to_the_program_and_runs(pupil, trial):
    when = pupil.take("Events", "lb_when_is_front_obstacle")
    say = pupil.take("Control", "lb_skill_sleep")
    pupil.put_into(say, when)
    pupil.press("Run")
    pupil.state("Running|Ended")
    pupil.picture("when")
    steps, _ = trial()
    assert steps["keys"] == 0


@pytest.mark.usefixtures("trial")
def test_an_if_with_a_question_and_an_else_is_built_by_dragging(pupil):
    choice = pupil.take("Control", "controls_if", "else")
    pupil.put_into(choice, main_of(pupil))
    question = pupil.take("Sense", "lb_skill_is_front_obstacle")
    pupil.put_on(question, pupil.hole(choice))
    stop = pupil.take("Move", "lb_skill_stop_bot")
    pupil.put_into_loop(stop, choice)
    pupil.picture("if-else")
    pupil.sees("blocktext", "if function.is_front_obstacle(200):", "stop_bot", "else")


@pytest.mark.usefixtures("trial")
def test_the_colour_of_a_lamp_is_chosen_with_the_mouse(pupil):
    lamp = pupil.take("Show", "lb_skill_RGBled")
    pupil.put_into(lamp, main_of(pupil))
    pupil.click_on(pupil.block(lamp).locator("> .blocklyImageField").last)
    pupil.page.get_by_role("button", name="green").click()
    pupil.picture("lamp")
    pupil.sees("blocktext", "RGBled(0, 255, 0")


@pytest.mark.usefixtures("trial")
def test_a_breakpoint_is_set_with_one_click_on_a_line_number(pupil):
    pupil.press("Block-Text")
    pupil.write("blocktext", "main:\n    function.sleep(1)\n    function.sleep(2)\nend\n")
    pupil.sees("blocktext", "sleep(2)")
    pupil.click_line_number("blocktext", 3)
    pupil.press("Run")
    pupil.state("Paused at breakpoint")
    pupil.picture("breakpoint")
    pupil.press("Stop")
    pupil.state("Ended")


def test_a_world_with_a_wall_a_line_and_a_tag_is_made_in_eleven_steps(
    sit_down, own_server, request
):
    pupil = sit_down(own_server, stage="starter", empty=True)
    began = time.monotonic()
    pupil.press("Edit world")
    editor = pupil.dialog()
    pupil.put_in_world("Line", up=-60)
    pupil.put_in_world("Tag", right=120, up=60)
    pupil.put_in_world("Wall", up=20)
    drag_corner(pupil, editor.locator(".knob.corner").last)
    editor.get_by_label("Save as").fill("My first world")
    editor.get_by_role("button", name="Save and use").click()
    pupil.expect_chosen("World", "My first world")
    seconds = time.monotonic() - began
    pupil.picture("own world")
    print(f"{request.node.name.removeprefix('test_')}: 11 steps, {seconds:.1f} s")  # noqa: T201 - what the trial measured


def test_a_maze_to_drive_in_is_made_in_six_steps(sit_down, own_server, request):
    pupil = sit_down(own_server, stage="starter", empty=True)
    began = time.monotonic()
    pupil.press("Edit world")
    editor = pupil.dialog()
    editor.get_by_role("button", name="New world", exact=True).click()
    editor.get_by_role("button", name="Maze", exact=True).click()
    expect(editor.locator("[data-thing^=wall]").first).to_be_attached()
    editor.get_by_role("button", name="Done", exact=True).click()
    editor.get_by_role("button", name="Save and use").click()
    pupil.expect_chosen("World", r"Maze \d+")
    pupil.picture("own maze")
    seconds = time.monotonic() - began
    print(f"{request.node.name.removeprefix('test_')}: 6 steps, {seconds:.1f} s")  # noqa: T201 - what the trial measured


def drag_corner(pupil, knob):
    box = knob.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    pupil.page.mouse.move(x, y)
    pupil.page.mouse.down()
    pupil.page.mouse.move(x + 20, y - 60, steps=4)
    pupil.page.mouse.up()
