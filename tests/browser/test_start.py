"""The start page: continue, try, choose a robot, find examples and projects."""

import re
import time

import pytest
from playwright.sync_api import expect

import small_lesson
from browser.conftest import ARTEFACTS
from browser.pupil import WORKSPACE, Pupil
from emulated import settle
from learnblock.emulators import emulate
from waiting import wait_for

#: Large parts that the start page does without.
LARGE = re.compile(r"/(blocks|phrases|world|text)-[\w-]+\.js")
COUNT_CLICKS = """() => {
    globalThis.clicks = 0;
    addEventListener("pointerdown", () => { clicks += 1; }, { capture: true });
}"""
#: Loads nothing while idle, so that only what the page itself needs is loaded.
NEVER_IDLE = "globalThis.requestIdleCallback = () => 0;"


@pytest.fixture
def newcomer(own_server, sit_down):
    """A pupil on the start page of a server without projects."""
    return sit_down(own_server, start=True, flat=True)


def section(pupil, name):
    """Return a section of the page."""
    return pupil.page.get_by_role("region", name=name)


def expect_start(pupil):
    """Wait until the start page is shown."""
    expect(section(pupil, "My projects")).to_be_visible()


def show_examples(pupil):
    """Show the cards of the first programs and examples."""
    button = pupil.page.get_by_role("button", name="All examples")
    if button.get_attribute("aria-expanded") == "false":
        button.click()
    return section(pupil, "Examples")


def go_home(pupil):
    """Leave the open project for the start page."""
    pupil.page.get_by_role("banner").get_by_role("button", name="Home").click()
    expect_start(pupil)


def row(pupil, name):
    """Return the button of a project on the start page."""
    return section(pupil, "My projects").get_by_role("button", name=re.compile(f"^{name} "))


def choose(pupil, name, command):
    """Choose a command of the menu of a project on the start page."""
    section(pupil, "My projects").get_by_role("button", name=f"More for {name}").click()
    pupil.page.get_by_role("menuitem", name=command, exact=True).click()


def test_a_newcomer_runs_a_program_with_one_click_and_changes_it_with_the_next(browser, own_server):
    began = time.monotonic()
    pupil = Pupil(browser, own_server, ARTEFACTS, "newcomer", start=True, flat=True)
    pupil.page.evaluate(COUNT_CLICKS)
    steps = []

    def step(what):
        steps.append(f"{time.monotonic() - began:5.1f} s  {what}")

    step("the page can be used")
    pupil.page.get_by_role("button", name="Try it").click()
    pupil.state("Running")
    step("click 1: Try it: the robot drives")
    assert pupil.page.evaluate("clicks") == 1
    # The robot would be back after 15 seconds, in which a busy computer gets no further. The test
    # sets the slider without a click.
    pupil.choose("Speed", "0.1×")
    pupil.page.locator(f"{WORKSPACE} .blocklyText").get_by_text("200", exact=True).click()
    pupil.page.keyboard.press("Control+a")
    pupil.page.keyboard.type("300")
    pupil.page.keyboard.press("Enter")
    pupil.wait_until_saved()
    wait_for(lambda: "300" in _file(own_server, "Drive a square"), "the change in the file")
    assert pupil.page.evaluate("clicks") == 2
    step("click 2: a side is 300 mm long, while the robot still drives")
    pupil.press("Stop")
    pupil.state("Ended")
    pupil.press("Run")
    pupil.state("Running")
    step("clicks 3 and 4: Stop and Run: it drives the longer sides")
    print("", *steps, sep="\n")  # noqa: T201 - the times are what the trial is for
    pupil.context.close()
    assert pupil.errors == []


def test_the_start_page_loads_no_editor_and_no_world(own_server, sit_down):
    pupil = sit_down(own_server, flat=True)
    loaded = []
    pupil.context.add_init_script(NEVER_IDLE)
    pupil.context.on("request", lambda request: loaded.append(request.url))
    pupil.open_start()
    assert loaded
    assert list(filter(LARGE.search, loaded)) == []


def test_the_last_project_is_one_click_away(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, flat=True)
    go_home(pupil)
    expect(pupil.page.get_by_role("heading", level=1)).to_have_text("program")
    pupil.page.get_by_role("button", name="Continue").click()
    pupil.expect_project("program")


def test_the_last_lesson_is_named_with_its_step_and_stars(own_server, sit_down):
    small_lesson.put_in(own_server.home)
    pupil = sit_down(own_server, start=True, flat=True)
    lesson = pupil.page.locator(".lesson-card", has_text="My lesson")
    lesson.get_by_role("button", name="First drive").first.click()
    pupil.expect_project("First drive")
    go_home(pupil)
    hero = section(pupil, "First drive")
    expect(hero).to_contain_text("Level 1")
    expect(hero).to_contain_text("Step 1 of")
    expect(hero.locator(".start-stars")).to_contain_text("0 of")
    pupil.picture("lesson")
    hero.get_by_role("button", name="Continue").click()
    pupil.expect_project("First drive")


def test_the_back_button_goes_between_the_start_page_and_a_project(newcomer):
    show_examples(newcomer).get_by_role("button", name=re.compile("^Half a metre")).click()
    newcomer.expect_project("Half a metre")
    newcomer.page.go_back()
    expect_start(newcomer)
    expect(newcomer.page).to_have_title("LearnBlock")
    newcomer.page.go_forward()
    newcomer.expect_project("Half a metre")
    newcomer.page.reload()
    newcomer.expect_project("Half a metre")


def test_an_example_opened_twice_is_one_project_until_it_is_changed(newcomer, own_server):
    for _ in range(2):
        show_examples(newcomer).get_by_role("button", name=re.compile("^Half a metre")).click()
        newcomer.expect_project("Half a metre")
        go_home(newcomer)
    assert _projects(own_server) == ["Half a metre"]
    row(newcomer, "Half a metre").click()
    newcomer.expect_project("Half a metre")
    newcomer.show("Block-Text")
    newcomer.write("blocktext", "main:\n    function.drive_distance(100)\nend\n")
    newcomer.wait_until_saved()
    go_home(newcomer)
    show_examples(newcomer).get_by_role("button", name=re.compile("^Half a metre")).click()
    newcomer.expect_project("Half a metre 2")
    assert _projects(own_server) == ["Half a metre", "Half a metre 2"]


def test_new_programs_and_examples_use_the_chosen_robot_where_it_can_run_them(newcomer, own_server):
    section(newcomer, "Which robot do you have?").get_by_text("Thymio II").click()
    newcomer.page.reload()
    expect(newcomer.page.get_by_role("radio", name="Thymio II")).to_be_checked()
    section(newcomer, "My projects").get_by_role("button", name="New").click()
    newcomer.answer("mine")
    newcomer.expect_project("mine")
    assert '"sim-thymio"' in _file(own_server, "mine")
    go_home(newcomer)
    show_examples(newcomer).get_by_role("button", name=re.compile("^Drive a square")).click()
    newcomer.expect_project("Drive a square")
    assert '"sim-thymio"' in _file(own_server, "Drive a square")
    go_home(newcomer)
    show_examples(newcomer).get_by_role("button", name=re.compile("^Find the tag")).click()
    newcomer.expect_project("Find the tag")
    assert '"sim-ebo"' in _file(own_server, "Find the tag")


def test_a_project_that_is_not_open_is_renamed_copied_exported_and_deleted(own_server, sit_down):
    pupil = sit_down(own_server, empty=True, flat=True)
    go_home(pupil)
    choose(pupil, "program", "Rename…")
    pupil.answer("dance")
    expect(row(pupil, "dance")).to_be_visible()
    choose(pupil, "dance", "Copy…")
    expect(pupil.dialog().get_by_role("textbox")).to_have_value("dance copy")
    pupil.answer("waltz")
    expect(row(pupil, "waltz")).to_be_visible()
    pupil.picture("projects")
    with pupil.page.expect_download() as download:
        choose(pupil, "waltz", "Download project (.learnblock)")
    assert download.value.suggested_filename == "waltz.learnblock"
    choose(pupil, "dance", "Delete…")
    pupil.dialog().get_by_role("button", name="Delete", exact=True).click()
    expect(row(pupil, "dance")).to_have_count(0)
    assert _projects(own_server) == ["waltz"]


def test_a_project_has_a_picture_of_its_last_run(sit_down, own_server):
    newcomer = sit_down(own_server, start=True)
    show_examples(newcomer).get_by_role("button", name=re.compile("^Turn right")).click()
    newcomer.expect_project("Turn right")
    expect(newcomer.page.locator("[data-region=world] canvas")).to_be_visible()
    newcomer.press("Run")
    newcomer.state("Ended")
    kept = own_server.home / "projects" / ".history" / "Turn right" / "picture.jpg"
    wait_for(kept.is_file, "the picture of the run")
    go_home(newcomer)
    picture = row(newcomer, "Turn right").get_by_role("presentation")
    expect(picture).to_have_js_property("naturalWidth", 960)
    assert 5_000 < kept.stat().st_size <= 60_000


def test_four_examples_are_shown_and_all_of_a_stage_on_request(newcomer):
    examples = section(newcomer, "Examples")
    expect(examples.get_by_role("listitem")).to_have_count(4)
    expect(examples.get_by_role("button", name="Coder")).to_have_count(0)
    show_examples(newcomer)
    expect(examples.get_by_role("listitem").nth(4)).to_be_visible()
    expect(examples.get_by_role("button", name="Half a metre")).to_be_visible()
    examples.get_by_role("button", name="Coder").click()
    expect(examples.get_by_role("button", name="Steer smoothly")).to_be_visible()
    expect(examples.get_by_role("button", name="Half a metre")).to_have_count(0)


def test_a_dropped_file_opens_as_a_project(newcomer):
    newcomer.page.evaluate(
        """() => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File(["main:\\n    pass\\nend\\n"], "dropped.bt"));
            const options = { dataTransfer, bubbles: true, cancelable: true };
            document.querySelector("main").dispatchEvent(new DragEvent("drop", options));
        }"""
    )
    newcomer.expect_project("dropped")


def test_an_address_of_no_project_leads_to_the_start_page(own_server, sit_down):
    pupil = sit_down(own_server, start=True, flat=True)
    pupil.page.goto(own_server.address_of("nowhere"))
    expect_start(pupil)
    pupil.expect_note("no project")
    expect(pupil.page).not_to_have_url(re.compile("nowhere"))


def test_the_keyboard_alone_chooses_a_robot_and_opens_an_example(newcomer):
    keyboard = newcomer.page.keyboard
    robots = section(newcomer, "Which robot do you have?").get_by_role("radio")
    robots.first.focus()
    keyboard.press("ArrowRight")
    expect(robots.nth(1)).to_be_checked()
    tab_to(newcomer, newcomer.page.get_by_role("button", name="All examples"))
    keyboard.press("Enter")
    tab_to(newcomer, section(newcomer, "Examples").get_by_role("button", name="Turn right"))
    keyboard.press("Enter")
    newcomer.expect_project("Turn right")


def tab_to(pupil, button):
    """Press Tab until a button has the focus."""
    for _ in range(80):
        if button.evaluate("one => one === document.activeElement"):
            return
        pupil.page.keyboard.press("Tab")
    raise AssertionError("Tab does not lead there")


def _projects(server):
    return sorted(path.stem for path in (server.home / "projects").glob("*.learnblock"))


def _file(server, name):
    return (server.home / "projects" / f"{name}.learnblock").read_text("utf-8")


def test_undo_has_no_effect_on_the_start_page(sit_down, server):
    pupil = sit_down(server, empty=True, flat=True)
    name = pupil.name_of_project()
    go_home(pupil)
    pupil.page.keyboard.press("Control+z")
    # The server answers in order: had it refused something, the page would tell so by now.
    row(pupil, re.escape(name)).click()
    pupil.expect_project(name)
    expect(pupil.page.locator(".toast")).to_have_count(0)


def test_a_robot_that_was_tried_is_named_with_its_charge(newcomer, own_server, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(own_server.home))
    with emulate("spike", "empty") as emulation:
        settle("spike", {**emulation.settings, "patience": 15.0})
        robots = section(newcomer, "Which robot do you have?")
        robots.get_by_role("button", name="Connect", exact=True).click()
        dialog = newcomer.dialog()
        dialog.get_by_role("button", name="Connect LEGO SPIKE Prime").click()
        expect(dialog.get_by_label("Live values")).to_contain_text("Distance in front")
        dialog.get_by_role("button", name="Use this robot").click()
        expect(robots).to_contain_text("LEGO SPIKE Prime is ready · 87%")
        newcomer.picture("robot-ready")
