"""Looking back at a run: its moments, its calls, and why the robot did what it did."""

import re

import pytest
from playwright.sync_api import expect

#: It drives for two seconds, turns round at the wall or not, and counts.
COUNTING = """\
count = 0
main:
    function.expressJoy()
    repeat 3:
        count += 1
        function.move_straight(60)
        function.sleep(1)
    end
    if function.is_front_obstacle(20):
        function.turn(90)
    end
    function.stop_bot()
    print(count)
end
"""


PRINTING = """\
main:
    for turn from 1 to 3:
        print("turn", turn)
        function.move_straight(60)
        function.sleep(1)
    end
end
"""
#: Whether the camera shows a picture.
DRAWN = """() => {
    const canvas = document.querySelector(".camera canvas");
    return canvas?.getContext("2d").getImageData(1, 1, 1, 1).data[3] > 0;
}"""
#: Whether the camera shows another picture than before.
CHANGED = "before => document.querySelector('.camera canvas').toDataURL() !== before"
SAME = "before => document.querySelector('.camera canvas').toDataURL() === before"


@pytest.fixture
def pupil(sit_down, server):
    """A pupil whose program has run."""
    return after_a_run(sit_down(server, empty=True, flat=True))


@pytest.fixture
def onlooker(sit_down, server):
    """The same, with the picture of the world."""
    return after_a_run(sit_down(server, empty=True))


def after_a_run(pupil):
    pupil.write("blocktext", COUNTING)
    pupil.wait_until_saved()
    pupil.run_to_the_end()
    expect(moment(pupil)).to_be_visible()
    return pupil


def moment(pupil):
    return pupil.page.get_by_role("slider", name="Moment of the run")


def look(pupil, seconds):
    """Drag the timeline."""
    moment(pupil).fill(str(seconds))
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile(f"^{seconds:.2f} s"))


def variable(pupil, name):
    pupil.tab("Variables")
    return pupil.page.get_by_role("row", name=re.compile(f"^{name} "))


def test_a_moment_of_the_run_shows_the_world_the_variables_and_the_block(onlooker):
    look(onlooker, 1.5)
    expect(variable(onlooker, "count")).to_contain_text("2")
    expect(onlooker.blocks("lb_skill_sleep")).to_have_class(re.compile("lbRunning"))
    expect(onlooker.page.locator(".status")).to_contain_text("Looking back: 1.5 of 3.0 s")
    expect(onlooker.page.locator(".chips")).to_contain_text("87 mm")
    onlooker.picture("looking-back")
    look(onlooker, 0.5)
    expect(variable(onlooker, "count")).to_contain_text("1")


def test_the_console_shows_what_was_printed_by_then(pupil):
    pupil.write("blocktext", PRINTING)
    pupil.wait_until_saved()
    pupil.run_to_the_end()
    later = pupil.page.locator(".console-lines > .later")
    expect(later).to_have_count(0)
    look(pupil, 1.5)
    expect(later).to_have_text(["turn 3", re.compile("^Finished")])
    pupil.picture("looking-back-console")
    look(pupil, 0.5)
    expect(later).to_have_text(["turn 2", "turn 3", re.compile("^Finished")])
    pupil.press("Back to now")
    expect(later).to_have_count(0)


def test_the_plot_marks_the_moment_and_keeps_its_readings(pupil):
    panel = pupil.tab("Sensors")
    look(pupil, 1.5)
    expect(panel.locator(".plot canvas")).to_be_visible()
    pupil.picture("looking-back-plot")
    readings = panel.get_by_text("Distance in front").first
    expect(readings).to_be_visible()


def test_the_camera_shows_the_picture_of_the_moment(onlooker):
    onlooker.page.get_by_role("button", name="View and robot").click()
    onlooker.page.get_by_role("menuitemcheckbox", name="Robot camera").click()
    picture = onlooker.page.locator(".camera canvas")
    present = pixels(picture)
    look(onlooker, 0.1)
    onlooker.page.wait_for_function(CHANGED, arg=present)
    onlooker.picture("looking-back-camera")
    onlooker.press("Back to now")
    onlooker.page.wait_for_function(SAME, arg=present)


def pixels(canvas):
    """The picture that a canvas shows, once there is one."""
    canvas.page.wait_for_function(DRAWN)
    return canvas.evaluate("canvas => canvas.toDataURL()")


def test_the_present_comes_back(pupil):
    look(pupil, 0.5)
    pupil.press("Back to now")
    expect(variable(pupil, "count")).to_contain_text("3")
    expect(pupil.page.locator(".status")).to_contain_text("Ended · 3.0 s")


def test_one_steps_from_line_to_line_by_keyboard(pupil):
    look(pupil, 1.5)
    back = pupil.page.get_by_role("button", name="Back one line")
    back.focus()
    pupil.page.keyboard.press("Enter")
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile("^1.00 s"))
    pupil.page.get_by_role("button", name="Forward one line").press("Enter")
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile("^2.00 s"))
    moment(pupil).press("ArrowLeft")
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile("^1.99 s"))


def test_marks_say_what_happened(pupil):
    look(pupil, 2)
    pupil.press("Forward to the next mark")
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile("prints 3"))
    pupil.press("Back to the mark before")
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile("shows joy"))


def test_a_new_run_leaves_the_past(pupil):
    look(pupil, 0.5)
    pupil.run_to_the_end()
    expect(pupil.page.locator(".status")).to_contain_text("Ended")


def test_the_calls_of_the_run_are_walked_through_by_keyboard(pupil):
    pupil.tab("Calls")
    drive = pupil.page.get_by_role("button", name=re.compile("^move_straight, Skills"))
    expect(drive).to_have_attribute("aria-label", re.compile("called 3 times"))
    pupil.picture("calls")
    program = pupil.page.locator(".call").first
    program.focus()
    pupil.page.keyboard.press("ArrowRight")
    expect(pupil.page.locator(".call:focus")).to_have_attribute("aria-label", re.compile("Skills"))
    drive.press("Enter")
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile("^0.00 s"))
    # Its own line, not the wait that began at the same moment.
    expect(pupil.blocks("lb_skill_move_straight")).to_have_class(re.compile("lbRunning"))
    # Up to this moment it has been called once.
    expect(drive).to_have_attribute("aria-label", re.compile("called once"))


def test_a_span_of_time_is_chosen_in_the_calls(pupil):
    pupil.tab("Calls")
    drive = pupil.page.get_by_role("button", name=re.compile("^move_straight, Skills"))
    expect(drive).to_have_attribute("aria-label", re.compile("called 3 times"))
    pupil.page.get_by_label("From (s)").fill("0.5")
    expect(drive).to_have_attribute("aria-label", re.compile("called 2 times"))
    pupil.page.get_by_label("To (s)").fill("1.5")
    expect(drive).to_have_attribute("aria-label", re.compile("called once"))
    sleep = pupil.page.get_by_role("button", name=re.compile("^sleep, Skills"))
    expect(sleep).to_have_attribute("aria-label", re.compile("1 s$"))
    pupil.picture("calls-span")
    pupil.page.get_by_label("To (s)").fill("0.1")
    expect(pupil.page.get_by_text("Nothing was called in this time.")).to_be_visible()
    pupil.press("Whole run")
    expect(drive).to_have_attribute("aria-label", re.compile("called 3 times"))
    look(pupil, 1.5)
    pupil.press("From this moment")
    pupil.press("Back to now")
    expect(drive).to_have_attribute("aria-label", re.compile("called once"))
    pupil.run_to_the_end()
    expect(drive).to_have_attribute("aria-label", re.compile("called 3 times"))


def test_the_calls_are_counted_while_the_program_runs(pupil):
    pupil.write("blocktext", "main:\n    forever:\n        function.sleep(0.2)\n    end\nend\n")
    pupil.wait_until_saved()
    pupil.tab("Calls")
    pupil.press("Run")
    sleep = pupil.page.get_by_role("button", name=re.compile("^sleep, Skills"))
    expect(sleep).to_have_attribute("aria-label", re.compile("called [2-9]"))
    pupil.page.get_by_label("From (s)").fill("1000")
    expect(pupil.page.get_by_text("Nothing was called in this time.")).to_be_visible()
    pupil.press("Stop")


def test_why_is_answered_in_sentences_that_lead_to_their_moment(pupil):
    pupil.tab("Why?")
    pupil.page.get_by_role("searchbox", name="Search the questions").fill("stand still")
    pupil.page.get_by_role("button", name=re.compile("Why did the robot stand still")).click()
    answer = pupil.page.locator(".why-answer")
    expect(answer).to_contain_text("stop_bot()")
    pupil.picture("why")
    answer.get_by_role("button", name=re.compile("^See")).first.click()
    expect(pupil.page.locator(".status")).to_contain_text("Looking back: 3.0")
    pupil.press("All questions")
    expect(pupil.page.get_by_role("heading", name="What did not happen")).to_be_visible()


def test_a_block_is_asked_why_it_did_not_run(pupil):
    pupil.open_menu(pupil.blocks("lb_skill_turn"))
    pupil.page.get_by_role("menuitem", name="Why did it run, or not?").click()
    expect(pupil.page.locator(".why-answer")).to_contain_text("20 mm")


#: A function with a variable of its own, and a condition.
DECIDING = """\
limit = 300
count = 0

def look(far):
    near = far / 2
    count += 1
    function.sleep(1)
end

main:
    repeat 3:
        look(limit)
        if count > 2:
            function.expressJoy()
        end
    end
    function.sleep(1)
end
"""


def test_values_are_beside_the_lines_and_the_blocks(pupil):
    pupil.write("blocktext", DECIDING)
    pupil.wait_until_saved()
    pupil.run_to_the_end()
    shown = pupil.editor("blocktext").locator(".cm-values")
    expect(shown).to_have_count(0)
    look(pupil, 1.5)
    expect(shown).to_have_text(["far = 300", "near = 150.0", "count = 2"])
    labels = pupil.page.locator(".lbValues text")
    expect(labels.filter(has_text="count = 2")).to_be_visible()
    pupil.picture("looking-back-values")
    pupil.press("Back to now")
    expect(shown).to_have_count(0)
    expect(labels).to_have_count(0)


def at(pupil, seconds):
    """Wait until this moment is shown."""
    expect(moment(pupil)).to_have_attribute("aria-valuetext", re.compile(f"^{seconds:.2f} s"))


def test_a_condition_shows_its_outcome_when_one_steps_to_it(pupil):
    pupil.write("blocktext", DECIDING)
    pupil.wait_until_saved()
    pupil.run_to_the_end()
    look(pupil, 3)
    for _ in range(2):
        pupil.press("Back one line")
    shown = pupil.editor("blocktext").locator(".cm-values")
    expect(shown.filter(has_text="count = 3 → true")).to_be_visible()
    pupil.picture("looking-back-condition")


def test_one_goes_to_the_changes_of_a_variable(pupil):
    pupil.tab("Variables")
    look(pupil, 1.5)
    pupil.press("Go to the previous change of count")
    at(pupil, 1)
    expect(variable(pupil, "count")).to_contain_text("2")
    pupil.press("Go to the next change of count")
    at(pupil, 2)
    pupil.picture("looking-back-changes")
    pupil.press("Go to the next change of count")
    expect(pupil.page.locator(".timeline-none")).to_have_text("None further")


def test_one_goes_to_the_runs_of_a_block(pupil):
    look(pupil, 1.5)
    for name, seconds in (("previous", 1), ("previous", 0), ("next", 1)):
        pupil.open_menu(pupil.blocks("lb_skill_move_straight"))
        pupil.page.get_by_role("menuitem", name=f"Go to its {name} run").click()
        at(pupil, seconds)


def test_one_steps_by_turns_of_a_loop_and_to_marks_of_one_kind(pupil):
    look(pupil, 1.5)
    choose(pupil, "Turns of the loop")
    pupil.press("Back one turn of the loop")
    at(pupil, 1)
    choose(pupil, "Emotions")
    pupil.press("Forward to the next mark")
    expect(pupil.page.locator(".timeline-none")).to_have_text("None further")
    pupil.press("Back to the mark before")
    at(pupil, 0)


def choose(pupil, name):
    """Choose in the menu of the timeline."""
    pupil.page.get_by_role("button", name="Steps and marks").press("Enter")
    pupil.page.get_by_role("menuitemradio", name=name).press("Enter")


def test_the_keys_of_the_timeline_step_jump_and_leave(pupil):
    look(pupil, 1.5)
    moment(pupil).press("Shift+ArrowLeft")
    at(pupil, 1)
    moment(pupil).press("Control+ArrowRight")
    at(pupil, 3)
    moment(pupil).press("Escape")
    expect(pupil.page.locator(".status")).to_contain_text("Ended")


#: Whether the timeline is longer than some seconds.
LASTS = "seconds => Number(document.querySelector('.timeline input')?.max) > seconds"
#: It counts for ever.
ENDLESS = """\
count = 0
main:
    forever:
        count += 1
        function.move_straight(20)
        function.sleep(0.5)
    end
end
"""


def test_one_looks_back_while_the_program_goes_on(pupil):
    pupil.write("blocktext", ENDLESS)
    pupil.wait_until_saved()
    pupil.press("Run")
    pupil.state("Running")
    pupil.page.wait_for_function(LASTS, arg=2)
    look(pupil, 0.7)
    expect(variable(pupil, "count")).to_contain_text("2")
    expect(pupil.page.locator(".status")).to_contain_text("Looking back: 0.7 of")
    end = float(moment(pupil).get_attribute("max"))
    pupil.page.wait_for_function(LASTS, arg=end + 1)
    at(pupil, 0.7)
    pupil.picture("looking-back-live")
    pupil.press("Back to now")
    expect(pupil.page.locator(".status")).to_contain_text("Running")
    pupil.press("Stop")
    expect(pupil.page.locator(".status")).to_contain_text("Ended")
