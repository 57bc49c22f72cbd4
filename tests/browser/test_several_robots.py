"""Several robots in one project: a tab for each program, one world, one start."""

import re

import pytest
from playwright.sync_api import expect

CALLING = 'main:\n    function.sleep(0.2)\n    function.send("go", 7)\nend\n'
WAITING = """\
main:
    while not function.received("go"):
        function.sleep(0.05)
    end
    print("got", function.message_value("go"))
end
"""
FOREVER = "main:\n    while True:\n        function.sleep(0.1)\n    end\nend\n"


def tab(pupil, name):
    return pupil.page.get_by_role("tab", name=re.compile(rf"^{name}"))


def share(pupil, name, count):
    """Let more robots run the program of a tab."""
    pupil.command("Robot", "Add robots…")
    pupil.dialog().get_by_label("Program").select_option(f"Same program as {name}")
    pupil.dialog().get_by_label("Robots to add").fill(str(count))
    pupil.picture("add-robots")
    pupil.dialog().get_by_role("button", name="Add").click()


def show_robot(pupil, name):
    """Choose the robot whose run is shown, among those that share a program."""
    shown_robot(pupil).click()
    pupil.page.get_by_role("menuitemradio", name=re.compile(f"^{name}")).click()
    expect(shown_robot(pupil)).to_contain_text(name)


def shown_robot(pupil):
    return pupil.page.get_by_title("Robot shown")


def console(pupil):
    return pupil.page.locator(".console-lines")


def test_the_sumo_example_runs_both_robots_in_one_world(own_server, sit_down):
    pupil = sit_down(own_server)
    pupil.open_example("Sumo (2 robots)")
    expect(tab(pupil, "sumo")).to_have_attribute("aria-selected", "true")
    expect(tab(pupil, "bystander")).to_have_attribute("aria-selected", "false")
    pupil.sees("blocktext", "Look for the other robot")
    pupil.picture("opened")
    pupil.page.get_by_role("button", name="Run", exact=True).click()
    expect(tab(pupil, "bystander")).to_have_accessible_name("bystander Running")
    pupil.choose("Speed", "10×")
    end = pupil.page.get_by_role("region", name="sumo wins")
    expect(end.get_by_text("alone in the ring")).to_be_visible(timeout=60_000)
    expect(pupil.page.locator("#world .goals.reached")).to_be_visible()
    pupil.picture("won")
    tab(pupil, "bystander").click()
    pupil.sees("blocktext", "Turn on the spot")
    pupil.picture("bystander")
    pupil.page.get_by_role("tab", name="Result").click()
    expect(pupil.page.locator(".result")).to_contain_text("alone in the ring")
    pupil.picture("result")
    assert pupil.errors == []


def test_a_second_robot_gets_a_message_and_everything_stays_after_a_reload(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.write("blocktext", CALLING)
    pupil.picture("one-robot")
    pupil.add_robot("Thymio II")
    pupil.write("blocktext", WAITING)
    pupil.page.get_by_role("tab", name="Console").click()
    pupil.page.get_by_role("button", name="Run", exact=True).click()
    expect(console(pupil)).to_contain_text("got 7")
    pupil.picture("console")
    pupil.wait_until_saved()
    pupil.page.reload()
    expect(tab(pupil, "sim-thymio")).to_be_visible()
    pupil.sees("blocktext", 'send("go", 7)')
    tab(pupil, "sim-thymio").click()
    pupil.sees("blocktext", "while not")
    expect(console(pupil)).to_contain_text("got 7")
    assert pupil.errors == []


def test_each_tab_has_its_own_program_robot_and_undo(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.write("blocktext", CALLING)
    pupil.add_robot("Thymio II")
    pupil.write("blocktext", WAITING)
    pupil.sees("python", "sim_thymio", "received")
    tab(pupil, "program").click()
    pupil.sees("python", "send")
    pupil.page.get_by_role("button", name="Undo").click()
    pupil.lacks("blocktext", "function.send")
    tab(pupil, "sim-thymio").click()
    pupil.sees("blocktext", "received")


def test_the_tabs_are_used_with_the_keyboard(own_server, sit_down):
    pupil = sit_down(own_server)
    pupil.open_example("Relay")
    tab(pupil, "relay-first").focus()
    pupil.page.keyboard.press("ArrowRight")
    expect(tab(pupil, "relay-second")).to_have_attribute("aria-selected", "true")
    expect(tab(pupil, "relay-second")).to_be_focused()
    expect(pupil.page.get_by_role("tabpanel", name="relay-second")).to_be_visible()
    pupil.sees("blocktext", "Wait for the baton")


@pytest.mark.certain
def test_a_closed_robot_comes_back_with_its_program(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.add_robot("Thymio II")
    pupil.write("blocktext", WAITING)
    pupil.page.get_by_role("button", name="Close sim-thymio").click()
    expect(tab(pupil, "sim-thymio")).to_have_count(0)
    pupil.expect_note("sim-thymio").get_by_role("button", name="Undo").click()
    pupil.sees("blocktext", "received")
    pupil.page.get_by_role("button", name="Rename sim-thymio").click()
    pupil.answer("keeper")
    expect(tab(pupil, "keeper")).to_be_visible()
    pupil.picture("renamed")
    assert pupil.errors == []


def test_a_program_that_fails_is_marked_and_the_other_goes_on(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.write("blocktext", "main:\n    print(1 / 0)\nend\n")
    pupil.add_robot("Thymio II")
    pupil.write("blocktext", FOREVER)
    pupil.page.get_by_role("button", name="Run", exact=True).click()
    expect(tab(pupil, "program")).to_have_accessible_name("program Failed")
    expect(tab(pupil, "sim-thymio")).to_have_accessible_name("sim-thymio Running")
    pupil.picture("failed")
    pupil.page.get_by_role("button", name="Stop", exact=True).click()
    expect(pupil.page.get_by_role("button", name="Stop", exact=True)).to_be_disabled()


def test_the_swarm_example_is_one_tab_with_ten_robots(own_server, sit_down):
    pupil = sit_down(own_server)
    pupil.open_example("Swarm")
    expect(pupil.page.get_by_role("tablist", name="Robots").get_by_role("tab")).to_have_count(1)
    expect(tab(pupil, "swarm")).to_have_accessible_name("swarm ×10")
    expect(pupil.page.get_by_role("button", name="Close swarm")).to_have_count(0)
    pupil.sees("blocktext", "middle")
    pupil.picture("opened")
    pupil.choose("Speed", "10×")
    pupil.page.get_by_role("button", name="Run", exact=True).click()
    expect(tab(pupil, "swarm")).to_have_accessible_name("swarm ×10 Running")
    expect(pupil.page.locator("#world .goals.reached")).to_be_visible(timeout=60_000)
    pupil.picture("running")
    show_robot(pupil, "swarm-7")
    pupil.picture("another-robot")


def test_more_robots_run_the_same_program_which_is_edited_and_undone_once(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.write("blocktext", CALLING)
    share(pupil, "program", 4)
    expect(tab(pupil, "program")).to_have_accessible_name("program ×5")
    pupil.write("blocktext", 'main:\n    print("here")\nend\n')
    show_robot(pupil, "program-5")
    pupil.sees("blocktext", "here")
    pupil.page.get_by_role("tab", name="Console").click()
    pupil.page.get_by_role("button", name="Run", exact=True).click()
    for number in range(1, 6):
        expect(console(pupil)).to_contain_text(f"program-{number}here")
    pupil.picture("console")
    pupil.page.get_by_role("button", name="Undo").click()
    pupil.sees("blocktext", "send")
    pupil.wait_until_saved()
    pupil.page.reload()
    expect(tab(pupil, "program")).to_have_accessible_name("program ×5")
    pupil.sees("blocktext", "send")


def test_the_page_shows_the_robot_that_stops_at_a_breakpoint_or_asks(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    pupil.write("blocktext", 'main:\n    print("hello", input("Who?"))\nend\n')
    share(pupil, "program", 1)
    pupil.page.get_by_role("button", name="Run", exact=True).click()
    pupil.page.get_by_role("textbox", name="Who?").fill("Ada")
    pupil.page.keyboard.press("Enter")
    expect(shown_robot(pupil)).to_contain_text("program-2")
    pupil.picture("asks")
    pupil.page.get_by_role("textbox", name="Who?").fill("Bob")
    pupil.page.keyboard.press("Enter")
    expect(console(pupil)).to_contain_text("program-1hello Ada")
    expect(console(pupil)).to_contain_text("program-2hello Bob")


def test_the_number_of_robots_of_a_program_is_changed(own_server, sit_down):
    pupil = sit_down(own_server, empty=True)
    share(pupil, "program", 2)
    shown_robot(pupil).click()
    pupil.picture("menu")
    pupil.page.get_by_role("menuitem", name="Number of robots…").click()
    pupil.picture("number")
    pupil.answer("1")
    expect(pupil.page.get_by_role("tablist", name="Robots")).to_have_count(0)
    pupil.sees("blocktext", "pass")


def test_in_spanish_robots_share_a_program(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, language="es")
    pupil.command("Robot", "Añadir robots…")
    pupil.dialog().get_by_label("Programa").select_option(index=1)
    pupil.dialog().get_by_label("Robots que se añaden").fill("2")
    pupil.picture("add-robots")
    pupil.dialog().get_by_role("button", name="Añadir").click()
    expect(pupil.page.get_by_title("Robot que se muestra")).to_be_visible()
    pupil.picture("shared")
