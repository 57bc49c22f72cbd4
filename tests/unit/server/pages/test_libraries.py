"""Messages between page and server about libraries."""

import base64
import json

import pytest

from learnblock import language
from learnblock.extensions import libraries
from pages import TOKEN, english

PROGRAM = """def waltz(times):
    repeat times:
        step()
    end
end

def step():
    print("step")
end

def late():
    return speed
end

main:
    speed = 1
    waltz(2)
end
"""


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "home").mkdir()
    return tmp_path / "home"


def packed(name="dance", version="1.0.0", text=PROGRAM, functions=("waltz",), **more):
    """Return a library as a page sends it."""
    made = libraries.make(libraries.manifest(name, version), language.parse(text), functions)
    content = base64.b64encode(libraries.pack(made)).decode()
    return {"filename": f"{name}.lblib", "content": content, **more}


def imported(page, *files, **more):
    page.say("ImportLibraries", files=files, **more)
    return [(one["name"], one["version"]) for one in page.hear("Libraries")["libraries"]]


def edited(page, text):
    page.say("EditText", notation="blocktext", text=text, edit=1)
    return page.hear("Document", edit=1)


def test_a_page_receives_the_possible_contents_of_a_library(page, own_home):
    (own_home / "skills").mkdir()
    (own_home / "skills" / "clap.py").write_text("def clap(robot): pass\n")
    page.open()
    edited(page, PROGRAM)
    page.say("ListExportable")
    found = page.hear("Exportable")
    assert found["own"] == [{"name": "clap", "blocks": ["clap"]}]
    waltz, step, late = found["functions"]
    assert waltz == {"name": "waltz", "parameters": ["times"], "takes_along": ["step"]}
    assert step == {"name": "step", "parameters": []}
    assert english(late["problem"]).startswith(
        "Line 12: The functions use 'speed', which line 16 also sets"
    )


def test_a_new_library_can_be_imported_and_used(page):
    page.open()
    edited(page, PROGRAM)
    page.say("MakeLibrary", name="dance", version="1.2", title={"en": "Dances"},
             functions=["waltz"])  # fmt: skip
    made = page.hear("LibraryMade")
    assert made["filename"] == "dance.lblib"
    assert imported(page, made_file(made)) == [("dance", "1.2")]
    edited(page, "main:\n    function.waltz(3)\nend\n")
    page.say("UseLibrary", name="dance")
    document = page.hear("Document")
    assert document["blocktext"].startswith('import "dance"\n\nmain:\n')
    assert document.get("problems", []) == []
    assert page.run()["ended"] == "finished"


def made_file(made):
    return {"filename": made["filename"], "content": made["content"]}


def test_nothing_in_a_file_runs_when_it_is_inspected_or_imported(page, tmp_path):
    toml = 'learnblock = 1\nname = "evil"\nversion = "1"\n'
    code = f"open({str(tmp_path / 'ran')!r}, 'w')\ndef evil(robot): pass\n"
    files = {"library.toml": toml.encode(), "__init__.py": code.encode()}
    content = base64.b64encode(libraries.pack(libraries.from_files(files, "evil"))).decode()
    page.open()
    page.say("ReadLibraries", files=[{"filename": "evil.lblib", "content": content}])
    page.hear("LibrariesRead")
    assert imported(page, {"filename": "evil.lblib", "content": content}) == [("evil", "1")]
    assert not (tmp_path / "ran").exists()


def test_a_clash_is_reported_before_the_import_and_resolved_by_a_new_name(page):
    page.open()
    imported(page, packed())
    other = packed("songs", text="def step():\n    pass\nend\n", functions=["step"])
    page.say("ReadLibraries", files=[other])
    [read] = page.hear("LibrariesRead")["files"]
    assert read["clashes"] == [
        {
            "skill": "step",
            "place": {"code": "library-place-library", "values": {"library": "dance"}},
        }
    ]
    page.say("ReadLibraries", files=[{**other, "renames": {"step": "song_step"}}])
    [read] = page.hear("LibrariesRead")["files"]
    assert "clashes" not in read
    assert read["library"]["skills"] == ["song_step"]
    found = imported(page, {**other, "renames": {"step": "song_step"}})
    assert found == [("dance", "1.0.0"), ("songs", "1.0.0")]


def test_a_version_that_is_not_newer_is_replaced_only_on_request(page):
    page.open()
    imported(page, packed(version="1.1"))
    older = packed(functions=["step"])
    page.say("ReadLibraries", files=[older])
    [read] = page.hear("LibrariesRead")["files"]
    assert (read["installed"], read["is_newer"]) == ("1.1", False)
    page.say("ImportLibraries", files=[older])
    assert "1.0.0 is not newer" in english(page.hear("Failed")["message"])
    assert imported(page, older, replace=True) == [("dance", "1.0.0")]


def test_a_broken_file_is_reported_and_the_others_are_read(page):
    page.open()
    files = [{"filename": "a.lblib", "content": "bm8gemlw"}, packed()]
    page.say("ReadLibraries", files=files)
    broken, whole = page.hear("LibrariesRead")["files"]
    assert english(broken["problem"]).startswith("This file is damaged or not a library")
    assert whole["library"]["skills"] == ["waltz", "step"]


def test_every_page_is_notified_of_a_library_and_knows_its_skills(server, page):
    page.open()
    with server.visit() as other:
        other.open("other")
        edited(other, 'import "dance"\nfunction.waltz(1)\n')
        imported(page, packed())
        other.hear("PaletteChanged")
        assert [one["name"] for one in other.hear("Libraries")["libraries"]] == ["dance"]
        edited(other, 'import "dance"\nfunction.waltz(2)\n')
        assert other.run()["ended"] == "finished"


def test_the_palette_has_a_tab_for_an_installed_library(server, page):
    page.open()
    assert tab_of_waltz(server) is None
    imported(page, packed())
    assert tab_of_waltz(server) == "Dance"
    page.say("RemoveLibrary", name="dance")
    page.hear("Libraries", libraries=[])
    assert tab_of_waltz(server) is None


def tab_of_waltz(server):
    """Return the name of the tab that contains the block."""
    response = server.get("/palette/en.json", Cookie=f"learnblock_token={TOKEN}")
    tabs = json.loads(response.body)["toolbox"]["contents"]
    found = (tab["name"] for tab in tabs for block in tab.get("contents", ())
             if block["type"] == "lb_skill_waltz")  # fmt: skip
    return next(found, None)


def test_a_block_of_a_library_brings_its_import(page):
    page.open()
    imported(page, packed())
    document = edited(page, 'import "dance"\n\nmain:\n    function.waltz(3)\nend\n')
    [_, main] = document["workspace"]["stacks"]
    edited(page, "main:\n    pass\nend\n")
    page.say("EditBlocks", edit=2, workspace={"stacks": [main], "variables": []})
    document = page.hear("Document", edit=2)
    assert document["blocktext"].startswith('import "dance"\n\nmain:\n')
    assert len(document["workspace"]["stacks"]) == 2
    # An import that the user removed is reported, and not added again.
    page.say("EditBlocks", edit=3, workspace={"stacks": [main], "variables": []})
    document = page.hear("Document", edit=3)
    assert [one["code"] for one in document["problems"] if one["view"] == "blocktext"] == [
        "not-imported"
    ]


def test_an_installed_library_is_exported_as_it_was_imported(page):
    page.open()
    file = packed()
    imported(page, file)
    page.say("DownloadLibrary", name="dance")
    assert page.hear("LibraryMade")["content"] == file["content"]


def test_a_project_remembers_the_version_it_was_made_with(server, page, projects):
    page.open("ball")
    imported(page, packed(version="1.2"))
    edited(page, 'import "dance"\n\nmain:\n    function.waltz(1)\nend\n')
    page.hear("Saved", edit=1)
    saved = json.loads((projects / "ball.learnblock").read_text("utf-8"))
    assert saved["libraries"] == {"dance": "1.2"}
    imported(page, packed(), replace=True)
    saved["libraries"] = {"dance": "1.10", "songs": "2"}
    (projects / "copy.learnblock").write_text(json.dumps(saved), "utf-8")
    page.say("Open", name="copy")
    remarks = [english(page.hear("Failed")["message"]) for _ in range(2)]
    assert remarks == [
        "This program was made with version 1.10 of the library 'dance', but version 1.0.0 is"
        " installed. Import the newer version.",
        "This program was made with version 2 of the library 'songs', which is not installed."
        " Import the library.",
    ]


@pytest.mark.parametrize("libraries", [{"../dance": "1"}, {"dance": "one"}, ["dance"]])
def test_a_project_names_libraries_and_no_paths(page, projects, libraries):
    page.open("ball")
    project = {"learnblock": 1, "blocktext": [], "libraries": libraries}
    (projects / "wrong.learnblock").write_text(json.dumps(project), "utf-8")
    page.say("Open", name="wrong")
    assert "It must give the version of each" in english(page.hear("Failed")["message"])
