"""An open project: edited in any view, shared by its pages, and saved within a second."""

import json

import pytest

from learnblock.project.files import folder
from learnblock.server.sessions.periods import Periods
from pages import ON_SAVING, WATCHING, english, serving

PROGRAM = "main:\n    function.move_straight(50)\nend\n"
OTHER = "main:\n    function.move_straight(60)\nend\n"
WRONG = "main:\n    function.move_straight(50\nend\n"


def text_of(file):
    return "\n".join(json.loads(file.read_text("utf-8"))["blocktext"])


def write_outside(file, text, **values):
    """Change the program in a project's file, and other values, as another program would."""
    saved = json.loads(file.read_text("utf-8"))
    changed = {**saved, "blocktext": text.split("\n"), **values}
    file.write_text(json.dumps(changed), "utf-8")


def number(workspace, value):
    """Return the workspace with a different number in its innermost block."""
    text = json.dumps(workspace)
    assert text.count('"NUM": 50') == 1
    return json.loads(text.replace('"NUM": 50', f'"NUM": {value}'))


def test_an_edit_of_block_text_changes_the_other_views_only(page):
    page.open()
    document = page.type(PROGRAM)
    assert "blocktext" not in document
    assert "robot.move_straight(50)" in document["python"]
    assert document["workspace"]["stacks"]


def test_an_edit_of_python_changes_the_other_views_only(page):
    page.open(text=PROGRAM)
    python = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\nrobot.stop_bot()\n"
    document = page.type(python, "python")
    assert "python" not in document
    assert "function.stop_bot()" in document["blocktext"]


def test_an_edit_of_blocks_changes_the_texts_only(page):
    page.open()
    workspace = page.type(PROGRAM)["workspace"]
    page.say("EditBlocks", edit=2, workspace=number(workspace, 70))
    document = page.hear("Document", edit=2)
    assert "workspace" not in document
    assert "function.move_straight(70)" in document["blocktext"]
    assert "robot.move_straight(70)" in document["python"]


def test_a_text_with_an_error_does_not_change_the_other_views(page):
    page.open(text=PROGRAM)
    document = page.type(WRONG)
    assert document["stale"] == ["blocks", "python"]
    assert document["problems"][0]["view"] == "blocktext"
    assert not {"blocktext", "python", "workspace"} & document.keys()


def test_undo_and_redo_reach_every_view(page):
    page.open(text=PROGRAM)
    page.type(OTHER)
    page.say("Undo")
    undone = page.hear("Document", blocktext=PROGRAM)
    assert undone["can_redo"]
    assert "move_straight(50)" in undone["python"]
    page.say("Redo")
    assert page.hear("Document", blocktext=OTHER)["edit"] == 2


def test_every_tab_of_a_project_shows_the_same_program(server, page):
    page.open(text=PROGRAM)
    with server.visit() as other:
        other.say("Open", name="program")
        assert other.hear("Document")["blocktext"] == PROGRAM
        page.type(OTHER)
        document = other.hear("Document")
        assert (document["edit"], document["blocktext"]) == (0, OTHER)
        other.type(PROGRAM)
        assert page.hear("Document", blocktext=PROGRAM)["edit"] == 2


def test_the_robot_that_one_tab_chooses_is_that_of_the_others(server, page):
    page.open(text=PROGRAM)
    with server.visit() as other:
        other.say("Open", name="program")
        other.hear("Scene")
        page.say("ChooseRobot", name="sim-thymio")
        assert other.hear("Scene")["robots"][0][1]["title"] == "Thymio II"
        assert "sim_thymio" in other.hear("Document")["python"]
        assert other.hear("Settings") == {
            "kind": "Settings",
            "robot": "sim-thymio",
            "world": "empty",
        }


def test_the_chosen_world_is_shown(page):
    page.open(text=PROGRAM)
    page.say("ChooseWorld", name="line")
    assert page.hear("Scene")["name"] == "line"
    assert page.hear("Settings")["world"] == "line"


def start_of(scene):
    return scene["world"]["start"][0]


def test_a_variant_of_the_world_is_shown_until_another_world_is_chosen(page):
    page.open(text=PROGRAM)
    page.say("ChooseWorld", name="arena")
    drawn = page.hear("Scene")
    page.say("ChooseWorld", name="arena", variant=7)
    varied = page.hear("Scene", variant=7)
    assert start_of(varied) != start_of(drawn)
    page.say("ChooseRobot", name="sim-thymio")
    assert page.hear("Scene", variant=7)["world"] == varied["world"]
    page.say("ChooseWorld", name="arena")
    assert start_of(page.hear("Scene")) == start_of(drawn)


def test_a_world_without_variants_says_so(page):
    page.open(text=PROGRAM)
    page.say("ChooseWorld", name="relay", variant=1)
    assert "variant" in str(page.hear("Failed")["message"])


def test_two_projects_do_not_affect_each_other(server, page):
    page.open("one", PROGRAM)
    with server.visit() as other:
        other.open("two", OTHER)
        page.say("Undo")
        page.hear("Document")
        other.pulse()
        assert other.heard["Document"] == 2


def test_two_pages_that_open_a_project_at_once_share_it(server, page):
    page.open(text=PROGRAM)
    page.say("New", name="elsewhere")
    page.hear("Opened", name="elsewhere")
    with server.visit() as other:
        for each in (page, other):
            each.say("Open", name="program")
        for each in (page, other):
            each.hear("Scene")
        page.type(OTHER)
        assert other.hear("Document")["blocktext"] == OTHER


def test_an_edit_is_on_disk_soon(page, projects):
    page.open(text=PROGRAM)
    assert page.hear("Saved") == {"kind": "Saved", "edit": 1}
    assert (
        "    function.move_straight(50)"
        in json.loads((projects / "program.learnblock").read_text("utf-8"))["blocktext"]
    )


def test_the_last_edit_survives_the_end_of_the_server(projects):
    with serving(projects) as server, server.visit() as page:
        page.open(text=PROGRAM)
        page.type(OTHER)
        page.say("ChooseRobot", name="sim-ev3")
        page.say("ChooseWorld", name="walls")
        page.hear("Settings", world="walls")
        blocks = [page.type(OTHER)["places"][0][0]]
        page.say("SetBreakpoints", blocks=blocks)
        page.hear("Settings")
    with serving(projects) as server, server.visit() as page:
        page.say("Open", name="program")
        opened = page.hear("Opened")
        assert (opened["robot"], opened["world"], opened["breakpoints"]) == (
            "sim-ev3",
            "walls",
            blocks,
        )
        assert page.hear("Document")["blocktext"] == OTHER


def test_a_program_with_an_error_survives_the_end_of_the_server(projects):
    with serving(projects) as server, server.visit() as page:
        page.open(text=PROGRAM)
        page.type(WRONG)
    with serving(projects) as server, server.visit() as page:
        page.say("Open", name="program")
        document = page.hear("Document")
        assert document["blocktext"] == WRONG
        assert "move_straight(50)" in document["python"]


def test_a_read_only_folder_is_reported_and_the_session_continues(page, projects):
    page.open(text=PROGRAM)
    page.hear("Saved")
    for file in projects.rglob("*"):
        file.unlink(missing_ok=True)
    projects.rmdir()
    projects.write_text("a file in its place", "utf-8")
    page.type(OTHER)
    assert "can't be saved" in english(page.hear("Failed")["message"])
    page.say("Run")
    assert "can't be saved" in english(page.hear("Failed")["message"])
    assert page.hear("Ended")["ended"] == "finished"


def test_what_a_full_disk_refused_is_saved_once_there_is_room(projects):
    with serving(projects) as server, server.visit() as page:
        page.open(text=PROGRAM)
        page.hear("Saved")
        away = projects.rename(projects.with_name("away"))
        projects.write_text("a file in its place", "utf-8")
        page.type(OTHER)
        page.hear("Failed")
        projects.unlink()
        away.rename(projects)
    saved = json.loads((projects / "program.learnblock").read_text("utf-8"))
    assert "\n".join(saved["blocktext"]) == OTHER


@pytest.mark.parametrize("periods", [WATCHING])
def test_what_another_program_writes_is_shown(page, projects):
    page.open(text=PROGRAM)
    page.hear("Saved")
    write_outside(projects / "program.learnblock", OTHER, world="line")
    assert page.hear("Settings")["world"] == "line"
    assert page.hear("Document")["blocktext"] == OTHER
    page.hear("TakenIn")
    page.say("Undo")
    assert page.hear("Document", blocktext=PROGRAM)


@pytest.mark.parametrize("periods", [ON_SAVING])
def test_what_another_program_wrote_is_merged_with_an_edit(page, projects):
    page.open(text=PROGRAM)
    page.hear("Saved")
    file = projects / "program.learnblock"
    write_outside(file, OTHER)
    page.type(PROGRAM + "# mine\n")
    assert page.hear("Document", blocktext=OTHER + "# mine\n")
    page.hear("TakenIn")
    page.hear("Saved")
    assert text_of(file) == OTHER + "# mine\n"


@pytest.mark.parametrize("periods", [ON_SAVING])
def test_what_another_program_writes_just_before_a_save_stays(page, projects, monkeypatch):
    page.open(text=PROGRAM)
    page.hear("Saved")
    file = projects / "program.learnblock"
    encode = folder.encode_whole

    def encode_late(project, **options):
        monkeypatch.setattr(folder, "encode_whole", encode)
        write_outside(file, OTHER)
        return encode(project, **options)

    monkeypatch.setattr(folder, "encode_whole", encode_late)
    page.type(PROGRAM + "# mine\n")
    page.hear("TakenIn")
    page.hear("Saved")
    assert text_of(file) == OTHER + "# mine\n"


@pytest.mark.parametrize("periods", [ON_SAVING])
def test_where_another_program_changed_the_same_line_its_version_is_in_the_history(page, projects):
    page.open(text=PROGRAM)
    page.hear("Saved")
    file = projects / "program.learnblock"
    write_outside(file, OTHER)
    mine = PROGRAM.replace("50", "70")
    page.type(mine)
    conflict = page.hear("Conflict")
    assert conflict["by"] == "file"
    page.hear("Saved")
    assert text_of(file) == mine
    page.say("Restore", version=conflict["version"])
    assert page.hear("Document", blocktext=OTHER)


def test_edits_of_two_pages_are_merged(server, page):
    page.open(text=PROGRAM)
    with server.visit() as other:
        other.say("Open", name="program")
        revision = other.hear("Document")["revision"]
        page.type(OTHER, revision=revision)
        merged = other.type(PROGRAM + "# more\n", revision=revision)
        assert merged["blocktext"] == OTHER + "# more\n"
        assert page.hear("Document", blocktext=OTHER + "# more\n")
        # What it types before it shows the merged program is based on its own text.
        further = other.type(PROGRAM + "# more and more\n", revision=revision)
        assert further["blocktext"] == OTHER + "# more and more\n"


def test_of_two_edits_of_one_line_the_first_is_in_the_history(server, page):
    page.open(text=PROGRAM)
    with server.visit() as other:
        other.say("Open", name="program")
        revision = other.hear("Document")["revision"]
        page.type(OTHER, revision=revision)
        mine = PROGRAM.replace("50", "70")
        assert "blocktext" not in other.type(mine, revision=revision)
        conflicts = [one.hear("Conflict") for one in (page, other)]
        assert [one["by"] for one in conflicts] == ["page", "page"]
        page.say("Restore", version=conflicts[0]["version"])
        assert page.hear("Document", blocktext=OTHER)


def test_an_edit_that_was_not_saved_is_repeated_after_a_crash(page):
    page.open(text=PROGRAM)
    line = "# first\n"
    repeated = {"notation": "blocktext", "text": line + PROGRAM, "base": PROGRAM}
    page.say("RecoverText", edit=2, **repeated)
    assert page.hear("Document", edit=2)["origin"] == "blocktext"
    page.say("RecoverText", edit=3, **{**repeated, "text": PROGRAM, "base": line + PROGRAM})
    assert page.hear("Document", edit=3)


def test_what_others_changed_since_a_crash_wins_over_the_edit_before_it(page):
    page.open(text=OTHER)
    mine = PROGRAM.replace("50", "70")
    page.say("RecoverText", edit=2, notation="blocktext", text=mine, base=PROGRAM)
    assert page.hear("Document", edit=2)["blocktext"] == OTHER
    conflict = page.hear("Conflict")
    assert conflict["by"] == "before"
    page.say("Restore", version=conflict["version"])
    assert page.hear("Document", blocktext=mine)


def test_blocks_that_were_not_saved_are_merged_after_a_crash(page):
    page.open()
    base = page.type(PROGRAM)["workspace"]
    page.type(PROGRAM + "# more\n")
    page.say("RecoverBlocks", edit=3, workspace=number(base, 70), base=base)
    merged = page.hear("Document", edit=3)
    assert merged["blocktext"] == PROGRAM.replace("50", "70") + "\n# more\n"


def test_even_a_damaged_file_of_another_program_is_kept(page, projects, own_home):
    page.open(text=PROGRAM)
    page.hear("Saved")
    (projects / "program.learnblock").write_text("<<<<<<< HEAD", "utf-8")
    page.type(OTHER)
    page.hear("Failed")
    page.hear("Saved")
    kept = list((projects / ".history" / "program").glob("*-outside-0.learnblock"))
    assert [one.read_text("utf-8") for one in kept] == ["<<<<<<< HEAD"]


def test_a_project_with_an_empty_stack_of_blocks_opens_without_it(page, projects):
    page.open(text=PROGRAM)
    page.hear("Saved")
    saved = json.loads((projects / "program.learnblock").read_text("utf-8"))
    saved["workspace"]["stacks"].insert(0, [])
    (projects / "other.learnblock").write_text(json.dumps(saved), "utf-8")
    page.say("Open", name="other")
    workspace = page.hear("Document")["workspace"]
    assert all(workspace["stacks"])
    page.say("EditBlocks", edit=1, workspace={**workspace, "stacks": [[], *workspace["stacks"]]})
    page.hear("Document", edit=1)


def test_a_project_of_a_missing_robot_opens_with_the_default(page, projects):
    page.open(text=PROGRAM)
    page.hear("Saved")
    old = json.loads((projects / "program.learnblock").read_text("utf-8"))
    new = {**old, "robot": "r2d2", "world": "tatooine"}
    (projects / "old.learnblock").write_text(json.dumps(new), "utf-8")
    page.say("Open", name="old")
    opened = page.hear("Opened")
    assert (opened["robot"], opened["world"]) == ("sim-ebo", "empty")
    assert "r2d2" in english(page.hear("Failed")["message"])
    assert "tatooine" in english(page.hear("Failed")["message"])


def test_a_project_whose_world_is_invalid_still_opens(page, projects, own_home):
    page.open(text=PROGRAM)
    page.hear("Saved")
    (own_home / "worlds").mkdir()
    (own_home / "worlds" / "broken.toml").write_text("floor = 3", "utf-8")
    old = json.loads((projects / "program.learnblock").read_text("utf-8"))
    new = {**old, "world": "broken"}
    (projects / "other.learnblock").write_text(json.dumps(new), "utf-8")
    page.say("Open", name="other")
    assert page.hear("Opened")["world"] == "broken"
    assert "floor" in english(page.hear("Failed")["message"])
    page.say("ChooseWorld", name="line")
    assert page.hear("Scene")["name"] == "line"


def test_a_new_project_can_begin_with_an_example(page):
    page.say("New", name="my tags", example="tags")
    opened = page.hear("Opened")
    assert (opened["name"], opened["world"]) == ("my tags", "tags")
    assert "activate maincontrol" in page.hear("Document")["blocktext"]


def test_an_example_speaks_the_language_of_the_page(page):
    page.say("New", name="flor", example="flower", language="es")
    page.hear("Opened")
    assert "def pétalo(tono):" in page.hear("Document")["blocktext"]


def test_a_new_project_can_be_in_any_world(page):
    page.say("New", name="mine", world="square")
    assert page.hear("Opened")["world"] == "square"


def test_a_name_that_is_taken_gets_a_number(page):
    assert page.open("robot")["name"] == "robot"
    assert page.open("robot")["name"] == "robot 2"


def test_a_copy_continues_under_its_own_name(page):
    page.open(text=PROGRAM)
    page.say("SaveAs", name="copy")
    assert page.hear("Opened")["name"] == "copy"
    assert page.hear("Document")["blocktext"] == PROGRAM
    assert {"copy", "program"} == {project["name"] for project in page.pulse()["projects"]}


def test_a_renamed_project_is_the_same_for_every_page(server, page, projects):
    page.open(text=PROGRAM)
    with server.visit() as other:
        other.say("Open", name="program")
        other.hear("Document")
        other.type(OTHER)
        page.say("RenameProject", name="patrol")
        assert other.hear("ProjectRenamed")["name"] == "patrol"
        page.hear("ProjectRenamed")
        other.type(PROGRAM)
        page.hear("Document", blocktext=PROGRAM)
        assert [one["name"] for one in page.pulse()["projects"]] == ["patrol"]
        with server.visit() as third:
            third.say("Open", name="patrol")
            assert third.hear("Document")["blocktext"] == PROGRAM
    page.hear("Saved")
    assert [file.name for file in projects.glob("*.learnblock")] == ["patrol.learnblock"]


def test_a_project_is_not_renamed_to_a_name_that_is_taken(page):
    page.open("one")
    page.open("two")
    page.say("RenameProject", name="One")
    refused = page.hear("Failed")
    assert refused["refused"] == "RenameProject"
    assert english(refused["message"]).startswith("There is already a project named 'One'.")
    assert {one["name"] for one in page.pulse()["projects"]} == {"one", "two"}


def test_a_file_becomes_a_project_and_a_project_a_file(page):
    page.say("Import", filename="square.py", text="print('hi')\n")
    assert page.hear("Opened")["name"] == "square"
    assert page.hear("Document")["python"] == "print('hi')\n"
    page.say("Export", format="py")
    assert page.hear("File") == {"kind": "File", "filename": "square.py", "text": "print('hi')\n"}


def test_a_deleted_project_is_no_longer_listed_and_is_kept_in_the_trash(page, projects):
    page.open("one")
    page.open("two")
    assert {project["name"] for project in page.pulse()["projects"]} == {"one", "two"}
    page.say("Delete", name="one")
    assert [project["name"] for project in page.hear("Projects")["projects"]] == ["two"]
    assert len([*projects.glob(".trash/*/one.learnblock")]) == 1


def test_a_version_can_be_restored_and_that_can_be_undone(page):
    page.open(text=PROGRAM)
    page.run()
    page.type(OTHER)
    page.say("ListHistory")
    [version] = page.hear("History")["versions"]
    page.say("Restore", version=version["id"])
    assert page.hear("Document")["blocktext"] == PROGRAM
    page.say("ListHistory")
    assert [one["reason"] for one in page.hear("History")["versions"]] == ["restored", "run"]
    page.say("Undo")
    assert page.hear("Document")["blocktext"] == OTHER


def test_a_name_is_completed_and_described_in_the_pages_language(page):
    page.open(text="main:\n    function.move_str\nend\n")
    place = {"notation": "blocktext", "line": 2, "language": "es"}
    page.say("Complete", request=7, column=22, **place)
    completions = page.hear("Completions")
    assert completions["request"] == 7
    assert completions["options"][0]["label"] == "move_straight"
    page.type(PROGRAM)
    page.say("Describe", request=8, column=18, **place)
    assert "move_straight" in page.hear("Description")["title"]


def test_a_function_is_renamed_everywhere(page):
    page.open(text="def spin():\n    pass\nend\n\nmain:\n    spin()\nend\n")
    page.say("Rename", sort="function", name="spin", new="turn")
    document = page.hear("Document")
    assert "spin" not in document["blocktext"] + document["python"]


def test_a_project_without_pages_is_closed_after_a_while(projects):
    with serving(projects, periods=Periods(grace=0)) as server:
        with server.visit() as page:
            page.open(text=PROGRAM)
            page.say("Run")
            page.hear("RunState", state="running")
        with server.visit() as page:
            page.say("Open", name="program")
            assert page.hear("RunState")["state"] == "idle"
