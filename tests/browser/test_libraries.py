"""Libraries on the page: functions of one pupil used by another with another profile."""

import json
import os
import re
import subprocess
import sys

import pytest
from playwright.sync_api import expect

from browser.conftest import Server
from browser.test_accessibility import THEMES, choose_theme, faults
from old_projects import LIBRARY, Old, main, project

DANCE = """# Dance a waltz.
def waltz(times):
    repeat times:
        sway(15)
    end
end

def sway(angle):
    function.turn(angle)
    function.sleep(0.5)
    function.turn(0 - angle)
end

def late():
    return speed
end

main:
    speed = 1
    waltz(2)
end
"""
#: A library of the second profile, which also has a `waltz`.
OTHER = "def waltz():\n    function.sleep(1)\nend\n"
USE = 'import "dance"\n\nmain:\n    function.{waltz}(2)\nend\n'


@pytest.fixture
def first(sit_down, own_server):
    """A pupil with a program that has functions."""
    pupil = sit_down(own_server, empty=True)
    pupil.show("Blocks", "Block-Text")
    pupil.write("blocktext", DANCE)
    pupil.sees("blocktext", "late")
    return pupil


@pytest.fixture
def second(sit_down, tmp_path):
    """A pupil with another, empty profile."""
    server = Server(tmp_path / "second")
    pupil = sit_down(server, empty=True)
    pupil.server = server
    pupil.show("Blocks", "Block-Text")
    yield pupil
    server.stop()


def test_exported_functions_work_the_same_in_a_profile_with_a_name_clash(first, second, tmp_path):
    install_other(second, tmp_path)
    file = create_library(first, tmp_path, "waltz")
    open_libraries(second)
    choose(second, file)
    expect(second.dialog()).to_contain_text("The name waltz is already used: the library ball.")
    expect(new_name_field(second)).to_have_value("dance_waltz")
    second.picture("clash")
    new_name_field(second).fill("sway")
    expect(import_button(second)).to_be_disabled()
    new_name_field(second).fill("slow_waltz")
    expect(import_button(second)).to_be_enabled()
    import_button(second).click()
    expect(second.dialog()).to_contain_text("Imported: dance.")
    second.picture("installed")
    second.dialog().get_by_role("button", name="Use dance in this program").click()
    second.sees("blocktext", 'import "dance"')
    second.page.keyboard.press("Escape")
    second.write("blocktext", USE.format(waltz="slow_waltz"))
    expect(second.blocks("lb_skill_slow_waltz")).to_be_visible()
    trace = second.trace_of_a_run()
    assert trace == trace_of_the_command_line(second, tmp_path)
    # Both robots drove the same path: the names of the skills do not matter.
    assert seconds(second) == run_and_measure(first)


def test_a_library_block_from_the_palette_adds_its_import(second, tmp_path):
    install_other(second, tmp_path)
    waltz = second.take("My blocks", "lb_skill_waltz")
    second.put_into(waltz, second.blocks("lb_main").get_attribute("data-id"))
    second.sees("blocktext", 'import "ball"', "function.waltz()")
    expect(second.blocks("lb_import")).to_be_visible()
    second.picture("palette")


def test_libraries_can_be_dropped_on_the_page(first, tmp_path):
    file = create_library(first, tmp_path, "waltz")
    first.page.keyboard.press("Escape")
    data = first.page.evaluate_handle(
        """(bytes) => {
            const data = new DataTransfer();
            data.items.add(new File([new Uint8Array(bytes)], "dance.lblib"));
            return data;
        }""",
        list(file.read_bytes()),
    )
    first.page.dispatch_event("body", "drop", {"dataTransfer": data})
    expect(first.dialog()).to_contain_text('import "dance" · 1.0.0 · waltz, sway')


def test_with_the_keyboard_alone(first, tmp_path):
    open_libraries(first)
    keyboard = first.page.keyboard
    press_with_keyboard(first, "Create library…")
    waltz = first.dialog().get_by_role("checkbox", name="waltz(times)")
    expect(waltz).to_be_visible()
    first.page.get_by_role("textbox", name="Name", exact=True).focus()
    keyboard.type("dance")
    for _ in range(3):
        keyboard.press("Tab")
    expect(waltz).to_be_focused()
    keyboard.press("Space")
    with first.page.expect_download() as started:
        press_with_keyboard(first, "Create and download")
    assert started.value.suggested_filename == "dance.lblib"
    expect(first.dialog().get_by_role("status")).to_contain_text("dance.lblib created.")


@pytest.mark.parametrize("theme", THEMES)
def test_the_dialog_has_no_serious_violation(first, tmp_path, theme, axe):
    choose_theme(first, theme)
    file = create_library(first, tmp_path, "waltz")
    choose(first, file)
    import_button(first).click()
    expect(first.dialog()).to_contain_text("Imported: dance.")
    assert faults(first, axe, "dialog") == []
    choose(first, file)
    expect(first.dialog().get_by_role("checkbox", name="Replace dance")).to_be_visible()
    assert faults(first, axe, "dialog") == []
    first.dialog().get_by_role("button", name="Cancel").click()
    first.dialog().get_by_role("button", name="Create library…").click()
    expect(first.dialog().get_by_role("checkbox", name="late()")).to_be_disabled()
    first.picture(f"{theme}-make")
    assert faults(first, axe, "dialog") == []


def open_libraries(pupil):
    pupil.project("Libraries…")
    expect(pupil.dialog().get_by_role("heading", name="Libraries")).to_be_visible()


def create_library(pupil, folder, function):
    """Create the library `dance` in the dialog; return its file."""
    open_libraries(pupil)
    dialog = pupil.dialog()
    dialog.get_by_role("button", name="Create library…").click()
    dialog.get_by_role("textbox", name="Name", exact=True).fill("dance")
    dialog.get_by_role("textbox", name="Tab name").fill("Ball room")
    dialog.get_by_role("checkbox", name=f"{function}(").check()
    with pupil.page.expect_download() as started:
        dialog.get_by_role("button", name="Create and download").click()
    file = folder / started.value.suggested_filename
    started.value.save_as(file)
    dialog.get_by_role("button", name="Cancel").click()
    return file


def choose(pupil, *files):
    with pupil.page.expect_file_chooser() as chooser:
        pupil.dialog().get_by_role("button", name="Import files…").click()
    chooser.value.set_files(files)
    expect(import_button(pupil)).to_be_visible()


def import_button(pupil):
    return pupil.dialog().get_by_role("button", name="Import", exact=True)


def new_name_field(pupil):
    return pupil.dialog().get_by_role("textbox", name="New name for waltz")


def press_with_keyboard(pupil, button):
    """Press a button with the keyboard."""
    pupil.dialog().get_by_role("button", name=button).focus()
    pupil.page.keyboard.press("Enter")


def install_other(pupil, folder):
    """Install a library `ball` with the command line."""
    (folder / "other.bt").write_text(OTHER)
    learnblock(pupil, "library", "export", "other.bt", "--functions", "waltz", "--name", "ball")
    learnblock(pupil, "library", "import", "ball.lblib")
    pupil.page.reload()
    # A block that is dropped before the program comes is replaced by it.
    expect(pupil.blocks("lb_main")).to_be_visible()
    pupil.show("Blocks", "Block-Text")


def learnblock(pupil, *args):
    """Run the command line with a pupil's profile, in its parent folder."""
    home = pupil.server.home
    done = subprocess.run(
        [sys.executable, "-m", "learnblock", *args],
        cwd=home.parent, env={**os.environ, "LEARNBLOCK_HOME": str(home)},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return done.stdout


def trace_of_the_command_line(pupil, folder):
    (folder / "use.bt").write_text(pupil.text("blocktext"))
    return json.loads(learnblock(pupil, "run", "use.bt", "--json", "--world", "empty"))[
        "trace_sha256"
    ]


def run_and_measure(pupil):
    pupil.page.keyboard.press("Escape")
    pupil.trace_of_a_run()
    return seconds(pupil)


def seconds(pupil):
    """Return the time and the distance shown in the result."""
    found = re.findall(r"[\d.,]+ (?:s|mm|m)\b", pupil.tab("Result").inner_text())
    assert len(found) > 1
    return found


# Libraries of the original LearnBlock.


@pytest.fixture
def original(tmp_path):
    """A folder with a project of the original LearnBlock and its library."""
    folder = tmp_path / "old"
    (folder / "step").mkdir(parents=True)
    (folder / "step" / "step.lb").write_text('def step():\n\tprint "stepped"\nend\n')
    (folder / "step" / "step.py").write_text("def other(lbot):\n\tpass\n")
    words = [{"name": "step", "type": "library", "languages": {"EN": "take a step"}}]
    (folder / "step" / "step.conf").write_text(json.dumps(words))
    (folder / "walk.blockProject").write_bytes(
        project(main(Old("step", LIBRARY)), libraries=["/home/ana/step"])
    )
    return folder


def choose_folder(pupil, folder):
    with pupil.page.expect_file_chooser() as chooser:
        pupil.project("Upload a folder of the original LearnBlock…")
    chooser.value.set_files(folder)


def test_a_folder_of_the_original_learnblock_opens_its_project_with_the_library(second, original):
    choose_folder(second, original)
    second.expect_project("walk")
    expect(second.dialog()).to_contain_text("The project used the library 'step'")
    second.page.keyboard.press("Escape")
    assert 'print("stepped")' in second.text("blocktext")


def test_a_library_of_the_original_learnblock_is_imported_with_its_words(second, original):
    choose_folder(second, original / "step")
    dialog = second.dialog()
    expect(dialog.get_by_role("listitem").first).to_contain_text('import "step"')
    expect(dialog).to_contain_text("'step.py' has functions in Python")
    second.picture("original-library")
    dialog.get_by_role("button", name="Import", exact=True).click()
    expect(dialog.get_by_role("status")).to_have_text("Imported: step.")
    dialog.get_by_role("button", name="Use step in this program").click()
    second.page.keyboard.press("Escape")
    second.sees("blocktext", 'import "step"')


def test_a_part_of_an_original_library_alone_is_refused_with_what_to_choose(second, original):
    second.upload(original / "step" / "step.conf")
    expect(second.dialog().get_by_role("alert")).to_contain_text("Choose step.lb too")
