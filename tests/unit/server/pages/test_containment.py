"""Messages between page and server about what programs may do."""

import tomllib

import pytest

from learnblock.i18n import Phrase
from learnblock.runtime.containment.survey import AttemptResult
from pages import english, serving

pytestmark = [pytest.mark.realtime, pytest.mark.certain]

WAITS = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\nrobot.sleep(600)\n"
FREE = AttemptResult(
    Phrase("doctor-network"), False, Phrase("doctor-other-system", system="Darwin")
)


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


def ask(page):
    page.say("ReadNetwork")
    return page.hear("Network")


def allow(page, allowed=True):
    page.say("AllowNetwork", allowed=allowed, key=ask(page)["key"])
    return page.hear("Network")["allowed"]


def refusal(page, **values):
    page.say("AllowNetwork", **{"allowed": True, "key": "", **values})
    return english(page.hear("Failed", refused="AllowNetwork")["message"])


def allowed_programs(own_home):
    file = own_home / "settings.toml"
    written = tomllib.loads(file.read_text("utf-8")) if file.exists() else {}
    return written.get("network", {}).get("allowed", [])


def test_a_page_receives_the_findings_of_doctor(page, monkeypatch):
    monkeypatch.setattr("learnblock.server.sessions.sessions.survey", lambda: (FREE,))
    page.say("ReadContainment")
    assert page.hear("Containment")["findings"] == [
        {
            "name": {"code": "doctor-network", "values": {}},
            "contained": False,
            "reason": {"code": "doctor-other-system", "values": {"system": "Darwin"}},
        }
    ]


def test_the_survey_runs_once_for_all_pages(server, monkeypatch):
    asked = []
    monkeypatch.setattr(
        "learnblock.server.sessions.sessions.survey", lambda: asked.append(1) or (FREE,)
    )
    for _ in range(2):
        with server.visit() as page:
            page.say("ReadContainment")
            page.hear("Containment")
    assert asked == [1]


def test_the_project_is_allowed_and_forbidden_in_the_settings(page, projects, own_home):
    page.open("weather")
    assert not ask(page)["allowed"]
    assert allow(page) is True
    assert allowed_programs(own_home) == [str(projects / "weather.learnblock")]
    assert allow(page, allowed=False) is False
    assert allowed_programs(own_home) == []


def test_a_change_holds_from_the_next_run_on(page):
    text = "from learnblock.robots.sim_ebo import Robot\nimport socket\n\nrobot = Robot()\n"
    page.say("Import", filename="online.py", text=text + "socket.socket().close()\n")
    page.hear("Document")
    assert page.run()["ended"] == "error"
    allow(page)
    assert page.run()["ended"] == "finished"
    allow(page, allowed=False)
    assert page.run()["ended"] == "error"


def test_a_page_that_never_asked_changes_nothing(page, own_home):
    page.open("weather")
    assert "Open the dialog again" in refusal(page)
    assert allowed_programs(own_home) == []


def test_the_key_of_another_page_or_project_changes_nothing(server, page, own_home):
    page.open("weather")
    key = ask(page)["key"]
    with server.visit() as other:
        other.open("games")
        ask(other)
        assert "Open the dialog again" in refusal(other, key=key)
    page.open("chat")
    assert "Open the dialog again" in refusal(page, key=key)
    assert allowed_programs(own_home) == []


@pytest.mark.parametrize(
    "options",
    [
        {"additional_headers": {"X-Forwarded-For": "192.168.1.20"}},
        {"additional_headers": {"Via": "1.1 proxy"}},
    ],
    ids=["forwarded", "via"],
)
def test_a_page_behind_a_proxy_reads_the_setting_and_cannot_change_it(server, options, own_home):
    with server.visit(**options) as page:
        page.open("weather")
        told = ask(page)
        assert "key" not in told
        assert "Only a page on the computer" in english(told["reason"])
        assert "Only a page on the computer" in refusal(page, key="x")
    assert allowed_programs(own_home) == []


def test_a_server_with_names_for_a_proxy_knows_no_local_page(projects):
    with serving(projects, origins=["school.example"]) as server, server.visit() as page:
        page.open("weather")
        assert "key" not in ask(page)


def test_a_page_of_a_reading_server_cannot_change_it(projects):
    with serving(projects) as server, server.visit() as page:
        page.open("weather")
    with (
        serving(projects, read_only=Phrase("server-reading")) as server,
        server.visit() as page,
    ):
        page.say("Open", name="weather")
        page.hear("Document")
        assert "only reads" in english(ask(page)["reason"])
        assert "only reads" in refusal(page, key="x")


def test_no_page_changes_it_while_a_program_that_uses_the_network_runs(server, page, own_home):
    page.say("Import", filename="online.py", text=WAITS)
    page.hear("Document")
    allow(page)
    with server.visit() as other:
        other.open("weather")
        key = ask(other)["key"]
        page.say("Run")
        page.hear("RunState", state="running")
        assert "Stop it first" in refusal(other, key=key)
        assert "key" not in ask(other)
        page.say("Stop")
        page.hear("RunState", state="ended")
        # A program that has asked while it was running has no key.
        assert "Open the dialog again" in refusal(other, key=key)
        assert allow(other) is True


def test_a_permission_of_a_folder_is_shown_and_cannot_be_changed_here(page, projects, own_home):
    (own_home / "settings.toml").write_text(f"[network]\nallowed = ['{projects}']\n", "utf-8")
    page.open("weather")
    told = ask(page)
    assert (told["allowed"], "key" in told) == (True, False)
    assert str(projects) in english(told["reason"])


def test_a_renamed_project_keeps_its_permission(page, projects, own_home):
    page.open("weather")
    allow(page)
    page.say("RenameProject", name="storms")
    page.hear("ProjectRenamed")
    assert ask(page)["allowed"] is True
    assert allowed_programs(own_home) == [str(projects / "storms.learnblock")]


def test_a_copy_does_not_take_the_permission(page, own_home):
    page.open("weather")
    allow(page)
    page.say("SaveAs", name="copy")
    page.hear("Opened", name="copy")
    assert ask(page)["allowed"] is False


def test_a_new_project_with_the_name_of_a_deleted_one_may_not_use_it(page, own_home):
    page.open("weather")
    allow(page)
    page.open("other")
    page.say("Delete", name="weather")
    page.hear("Projects")
    assert allowed_programs(own_home) == []
    page.open("weather")
    assert ask(page)["allowed"] is False


def test_nor_one_with_the_name_of_a_file_that_was_deleted_by_hand(page, projects, own_home):
    projects.mkdir(exist_ok=True)
    named = [str(projects / "weather.learnblock")]
    (own_home / "settings.toml").write_text(f"[network]\nallowed = {named}\n", "utf-8")
    assert page.open("weather")["name"] == "weather"
    assert ask(page)["allowed"] is False


def test_a_mistake_in_the_settings_is_reported(page, own_home):
    (own_home / "settings.toml").write_text("[network]\nallowed = 3\n")
    page.open("weather")
    page.say("ReadNetwork")
    message = page.hear("Failed", refused="ReadNetwork")["message"]
    assert english(message).startswith("Line 2: 'network.allowed' is 3")


def test_the_first_local_page_of_a_server_for_others_warns(projects):
    with serving(projects, for_others=True) as server:
        with server.visit(additional_headers={"Via": "1.1 proxy"}) as page:
            assert "warns" not in page.hear("Welcome")
        with server.visit() as page:
            assert page.hear("Welcome")["warns"] is True
        with server.visit() as page:
            assert "warns" not in page.hear("Welcome")


def test_a_page_of_a_server_for_this_computer_does_not_warn(page):
    assert "warns" not in page.hear("Welcome")
