"""Every run of the page is kept, and a page can look back at each of them."""

import json
from urllib.parse import quote

import pytest

from learnblock.i18n import Phrase
from learnblock.server.http import runs
from pages import TOKEN, english, serving

pytestmark = [pytest.mark.realtime, pytest.mark.certain, pytest.mark.slow]

DRIVING = """\
main:
    function.move_straight(60)
    function.sleep({seconds})
    function.stop_bot()
end
"""
COOKIE = {"Cookie": f"learnblock_token_page={TOKEN}"}


@pytest.fixture
def ran(page):
    """A page with two runs: of one second and of two."""
    page.open("drive")
    page.say("SetSpeed", factor=None)
    for seconds in (1, 2):
        page.type(DRIVING.format(seconds=seconds))
        page.run()
        page.hear("KeptRuns")
    return page


def kept(page):
    page.say("ListRuns")
    return page.hear("KeptRuns")["runs"]


def show(page, run):
    page.say("OpenRun", run=run)
    shown = page.hear("RunShown")
    page.hear("Scene")
    return shown


def end(page):
    page.say("ReadTimeline")
    return page.hear("Timeline")["end"]


def test_each_run_is_kept_with_its_program_and_result(ran):
    newest, oldest = kept(ran)
    assert (newest["seconds"], oldest["seconds"]) == (2, 1)
    assert newest["program"] == "drive"
    assert newest["ended"] == "finished"
    assert newest["robot"] == "sim-ebo"


def test_a_page_looks_back_at_an_older_run_and_at_the_newest_again(ran):
    _, oldest = kept(ran)
    assert end(ran) == 2
    assert show(ran, oldest["id"])["run"]["id"] == oldest["id"]
    assert end(ran) == 1
    ran.say("CloseRun")
    assert "run" not in ran.hear("RunShown")
    assert end(ran) == 2


def test_the_page_says_whether_the_program_has_changed_since(ran):
    newest, oldest = kept(ran)
    assert "changed" not in show(ran, newest["id"])
    assert show(ran, oldest["id"])["changed"]


def test_lines_of_an_older_program_lead_to_the_blocks_that_are_still_there(ran):
    _, oldest = kept(ran)
    show(ran, oldest["id"])
    ran.say("LookBack", time=0)
    past = ran.hear("Past")
    assert past["line"]["line"] > 0
    assert past["line"].get("block") is None
    ran.say("LookBack", time=1)
    assert ran.hear("Past")["line"]["block"]


def test_a_new_run_is_shown_instead_of_a_kept_one(ran):
    show(ran, kept(ran)[1]["id"])
    ran.say("Run")
    ran.hear("RunShown")
    ran.hear("Ended")
    assert end(ran) == 2


def test_a_run_in_another_world_is_shown_in_its_own(ran):
    ran.say("ChooseWorld", name="line")
    ran.hear("Settings")
    ran.say("OpenRun", run=kept(ran)[0]["id"])
    ran.hear("RunShown")
    assert ran.hear("Scene")["name"] == "empty"
    ran.say("CloseRun")
    assert ran.hear("Scene")["name"] == "line"


def test_a_page_that_comes_later_sees_the_same_run(ran, server):
    show(ran, kept(ran)[1]["id"])
    with server.visit() as other:
        other.say("Open", name="drive")
        assert other.hear("RunShown")["run"]["seconds"] == 1


def test_a_run_is_named_and_deleted_for_all_pages(ran, server):
    newest, oldest = kept(ran)
    with server.visit() as other:
        other.say("Open", name="drive")
        other.hear("Document")
        ran.say("NameRun", run=oldest["id"], name="short")
        assert [one.get("name", "") for one in other.hear("KeptRuns")["runs"]] == ["", "short"]
        ran.hear("KeptRuns")
        other.say("DeleteRun", run=newest["id"])
        assert len(ran.hear("KeptRuns")["runs"]) == 1


def test_a_run_that_is_gone_can_not_be_opened(ran):
    ran.say("OpenRun", run="1700000000000-1")
    assert english(ran.hear("Failed")["message"]) == "This run is not kept any more."


def test_while_a_program_runs_no_other_run_is_opened(ran):
    run = kept(ran)[0]["id"]
    ran.say("Run", paused=True)
    ran.hear("RunState", state="held")
    ran.say("OpenRun", run=run)
    assert "Stop it first" in english(ran.hear("Failed")["message"])


def test_runs_go_with_a_project_that_is_renamed(ran):
    ran.say("RenameProject", name="new name")
    ran.hear("ProjectRenamed")
    assert len(kept(ran)) == 2


def test_a_run_is_downloaded_and_opened_in_another_project(ran, server):
    newest = kept(ran)[0]["id"]
    file = server.get(f"/projects/drive/runs/{newest}.why", **COOKIE)
    assert file.status == 200
    assert "drive.why" in file.headers["content-disposition"]
    ran.open("elsewhere")
    name = quote("from home.why")
    reply = server.post(f"/projects/elsewhere/runs?filename={name}", file.body, **COOKIE)
    assert reply.status == 200
    [run] = kept(ran)
    assert run["id"] == json.loads(reply.body)["id"]
    assert (run["name"], run["foreign"], run["seconds"]) == ("from home", True, 2)
    assert show(ran, run["id"])["changed"]
    assert end(ran) == 2


@pytest.mark.parametrize("body", [b"", b"PK", b"LearnBlock run log 1\n"])
def test_a_file_that_is_no_log_is_refused(page, server, body):
    page.open("drive")
    reply = server.post("/projects/drive/runs", body, **COOKIE)
    assert reply.status == 400
    assert json.loads(reply.body)["code"] == "log-not-a-log"
    assert kept(page) == []


def test_a_file_that_is_too_large_is_refused_while_it_arrives(page, server, monkeypatch):
    monkeypatch.setattr(runs, "LARGEST", 1000)
    page.open("drive")
    reply = server.post("/projects/drive/runs", b"x" * 5000, **COOKIE)
    assert json.loads(reply.body)["code"] == "log-file-too-large"


@pytest.mark.parametrize("name", ["missing", "..%2Fother", "%00"])
def test_a_file_for_no_project_is_refused(server, name):
    assert server.post(f"/projects/{name}/runs", b"x", **COOKIE).status in (400, 405)


def test_without_the_token_no_run_comes_or_goes(ran, server):
    newest = kept(ran)[0]["id"]
    assert server.get(f"/projects/drive/runs/{newest}.why").status == 403
    assert server.post("/projects/drive/runs", b"x").status == 403


def test_a_server_that_only_reads_shows_runs_and_changes_none(ran, projects):
    newest = kept(ran)[0]["id"]
    with serving(projects, read_only=Phrase("server-reading")) as reading, reading.visit() as page:
        page.say("Open", name="drive")
        page.hear("Document")
        assert show(page, newest)["run"]["seconds"] == 2
        page.say("DeleteRun", run=newest)
        assert page.hear("Failed")["refused"] == "DeleteRun"
        file = reading.get(f"/projects/drive/runs/{newest}.why", **COOKIE).body
        assert reading.post("/projects/drive/runs", file, **COOKIE).status == 400
    assert len(kept(ran)) == 2


def test_two_runs_are_compared_with_their_ways_and_the_edit_between_them(ran):
    newest, oldest = kept(ran)
    ran.say("CompareRuns", first=oldest["id"], second=newest["id"])
    found = ran.hear("RunsCompared")
    assert [english(cause) for cause in found["causes"]] == [
        "Line 7 was edited: robot.sleep(1) became robot.sleep(2)."
    ]
    assert found["together"] == 1
    assert found["first"]["step"]["time"] == 1
    lengths = [found[one]["way"][-1][1] - found[one]["way"][0][1] for one in ("first", "second")]
    assert lengths[1] == pytest.approx(2 * lengths[0], rel=0.1)


def test_a_run_is_the_same_as_itself(ran):
    newest = kept(ran)[0]["id"]
    ran.say("CompareRuns", first=newest, second=newest)
    found = ran.hear("RunsCompared")
    assert (found.get("together"), found.get("causes", [])) == (None, [])


def test_the_calls_of_two_runs_have_one_name_for_the_program(ran):
    newest, oldest = kept(ran)
    ran.say("ReadCallsBeside", first=oldest["id"], second=newest["id"])
    found = ran.hear("CallsBeside")
    names = [[one["name"] for one in found[run]["functions"]] for run in ("first", "second")]
    assert names[0] == names[1]
    assert found["second"]["last"] == 2


def test_each_robot_of_a_team_keeps_its_own_log(page):
    page.open("team")
    page.say("AddTab", robot="sim-ebo")
    page.hear("TabOpened")
    page.hear("Document")
    page.say("SetSpeed", factor=None)
    page.run()
    runs = page.hear("KeptRuns")["runs"]
    assert [run["id"][-2:] for run in runs] == ["-1", "-2"]
    assert len({run["program"] for run in runs}) == 2
    page.say("OpenRun", run=runs[1]["id"])
    assert page.hear("RunShown")["run"]["id"] == runs[1]["id"]
    assert end(page) >= 0
