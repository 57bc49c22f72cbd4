import errno
import json
import os

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.blocks import builtin
from learnblock.blocks.block_sets import BlockNames, BlockSet
from learnblock.errors import (
    LearnBlockError,
    ProgramError,
    ProjectError,
    SettingsError,
    UnknownNameError,
)
from learnblock.language.workspace.blocks import Block, BlockComment, Input, Variable, Workspace
from learnblock.project.document.document import Document
from learnblock.project.files.exchange import export
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.history import PastRun
from learnblock.project.files.project import Project, checked_name
from learnblock.project.files.project_file import LARGEST, decode, encode
from learnblock.running import allow_network, may_use_network
from learnblock.storage import files
from places import ROOT

EXAMPLES = ROOT / "examples"
SQUARE = (EXAMPLES / "square.bt").read_text("utf-8")


@pytest.fixture
def folder(tmp_path):
    return ProjectFolder(tmp_path / "projects")


def file_of(**values):
    return json.dumps({"learnblock": 1, "blocktext": [], **values}).encode()


def refusal(data, name="p"):
    with pytest.raises(ProjectError) as caught:
        decode(data, name)
    (diagnostic,) = caught.value.diagnostics
    return diagnostic


# Files.


def test_a_projects_file_can_be_read_by_a_person():
    project = Project("p", "x = 1\ny = 2\n", robot="sim-thymio", world="line")
    expected = """\
{
  "learnblock": 1,
  "robot": "sim-thymio",
  "world": "line",
  "breakpoints": [],
  "blocktext": [
    "x = 1",
    "y = 2",
    ""
  ]
}
"""
    assert expected == encode(project).decode()


def test_a_byte_order_mark_before_a_project_is_skipped():
    project = Project("mine", "x = 1\n")
    assert decode(b"\xef\xbb\xbf" + encode(project), "mine") == project


def test_a_project_keeps_the_accents_of_a_decomposed_name(tmp_path):
    folder = ProjectFolder(tmp_path)
    assert folder.import_file("cafe\N{COMBINING ACUTE ACCENT}.bt", "x = 1\n").name == "café"


def test_each_stack_of_blocks_has_a_line():
    workspace = Document.from_text(SQUARE, "learnblock.robots.sim_ebo", builtin()).workspace
    lines = encode(Project("p", SQUARE, workspace=workspace)).decode().split("\n")
    assert sum('"lb_main"' in line or '"lb_start"' in line for line in lines) == len(
        workspace.stacks
    )


texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=30)
ids = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=8)
numbers = st.floats(allow_nan=False, allow_infinity=False)
fields = st.dictionaries(texts, texts | st.booleans() | numbers | st.none(), max_size=2)
blocks = st.recursive(
    st.builds(Block, texts, texts, fields=fields, comment=st.builds(BlockComment, texts)),
    lambda inner: st.builds(
        Block,
        texts,
        texts,
        st.none() | numbers,
        inputs=st.dictionaries(
            texts,
            st.builds(Input, st.none() | inner, st.none() | inner, st.lists(inner, max_size=2)),
            max_size=2,
        ),
        data=st.none() | texts,
    ),
    max_leaves=6,
)
workspaces = st.builds(
    Workspace,
    st.lists(st.lists(blocks, max_size=2), max_size=3),
    st.lists(st.builds(Variable, texts, texts), max_size=2),
)
names = st.from_regex(r"[a-z0-9][a-z0-9 _.-]{0,10}[a-z]", fullmatch=True)
mentioned = st.builds(
    BlockNames,
    categories=st.lists(ids, max_size=2).map(tuple),
    blocks=st.lists(ids, max_size=2).map(tuple),
)
block_sets = st.builds(
    BlockSet,
    name=names,
    title=st.dictionaries(st.just("en"), texts),
    show=mentioned,
    hide=mentioned,
)
projects = st.builds(
    Project,
    names,
    texts,
    st.none() | texts,
    st.none() | workspaces,
    names,
    names | st.just(""),
    st.lists(ids, max_size=3).map(tuple),
    names,
    st.lists(block_sets, max_size=2).map(tuple),
)


@given(projects)
def test_any_project_is_read_as_it_was_written(project):
    assert project == decode(encode(project), project.name)


@given(st.binary(max_size=300))
@settings(max_examples=300)
def test_any_bytes_are_a_project_or_refused(data):
    assert_read_or_refused(data)


_json = st.recursive(
    st.none() | st.booleans() | st.integers() | numbers | texts,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(texts, inner, max_size=3),
    max_leaves=10,
)
_keys = ("learnblock", "blocktext", "python", "workspace", "robot", "world", "breakpoints")


@given(st.dictionaries(st.sampled_from(_keys) | texts, _json, max_size=6))
@settings(max_examples=500)
def test_any_json_is_a_project_or_refused(values):
    assert_read_or_refused(json.dumps({"learnblock": 1, "blocktext": [], **values}).encode())


@given(st.integers(min_value=0), st.binary(max_size=4))
@settings(max_examples=300)
def test_a_file_with_a_mistake_is_a_project_or_refused(place, put):
    workspace = Document.from_text("x = 1\n", "learnblock.robots.sim_ebo", builtin()).workspace
    data = encode(Project("p", SQUARE, "x=1\n", workspace))
    at = place % len(data)
    assert_read_or_refused(data[:at] + put + data[at + 1 :])


def assert_read_or_refused(data):
    try:
        project = decode(data, "p")
    except ProjectError:
        return
    assert project == decode(encode(project), "p")


@pytest.mark.parametrize(
    ("values", "code", "words"),
    [
        (
            {"learnblock": 5},
            "unknown-version",
            "reads version 4. Open it with a newer",
        ),
        ({"learnblock": None}, "no-project", "not a LearnBlock project"),
        ({"robot": 7}, "wrong-value", "'robot' is 7. It must be the name"),
        ({"breakpoints": ["", "x"]}, "wrong-value", "'breakpoints[0]' is \"\""),
        ({"workspace": {"stacks": [3]}}, "wrong-value", "'workspace.stacks[0]' is 3"),
        ({"wrold": "line"}, "unknown-key", "Did you mean 'world'?"),
        ({"world": "../../etc/passwd"}, "no-name", "can only name a"),
        ({"world": "/etc/passwd"}, "no-name", "can only name a"),
        ({"world": "C:\\worlds\\line"}, "no-name", "can only name a"),
        ({"world": "line.toml/"}, "no-name", "can only name a"),
        ({"robot": "../robot"}, "no-name", "can only name a"),
        (
            {"workspace": {"stacks": [[{"type": "x"}]]}},
            "missing-key",
            "The key 'id' is missing",
        ),
        ({"shown": 3}, "wrong-value", "It must be the name of a block set"),
        ({"block_sets": [{}] * 9}, "wrong-value", "It must be a list of at most 8 block sets"),
        ({"block_sets": [{"shown": {}}]}, "unknown-key", "Did you mean 'show'?"),
        ({"block_sets": [{"show": {"block": []}}]}, "unknown-key", "Did you mean 'blocks'?"),
    ],
)
def test_an_invalid_value_is_refused_with_its_position_and_advice(values, code, words):
    diagnostic = refusal(file_of(**values))
    assert (diagnostic.code, words in str(diagnostic.message)) == (code, True), diagnostic.message


def test_an_invalid_value_is_refused_with_its_line():
    diagnostic = refusal(b'{\n  "learnblock": 1,\n  "blocktext": "x"\n}')
    assert (diagnostic.line, diagnostic.column, diagnostic.end_column) == (3, 3, 14)


def test_broken_json_is_refused_with_its_position():
    diagnostic = refusal(b'{\n  "learnblock": 1,\n  "blocktext": [}')
    assert (diagnostic.code, diagnostic.line, diagnostic.column) == ("not-json", 3, 17)


def test_a_deep_file_is_refused():
    deep = b"[" * 100_000 + b"]" * 100_000
    for key in (
        b'"x":',
        b'"robot":',
        b'"workspace":{"stacks":[[{"type":"a","id":"b","extraState":',
    ):
        closing = b"}]]}" if b"stacks" in key else b""
        data = b'{"learnblock":1,"blocktext":[],' + key + deep + closing + b"}"
        assert refusal(data).code in {"too-deep", "unknown-key", "wrong-value"}


def test_a_huge_file_is_refused():
    assert refusal(b" " * (LARGEST + 1)).code == "too-large"


def test_a_huge_project_is_not_written(folder):
    folder.write(Project("p", "x = 1\n"))
    with pytest.raises(ProjectError, match="at most 4,194,304"):
        folder.write(Project("p", "é" * LARGEST))
    assert folder.read("p").blocktext == "x = 1\n"


def test_half_a_character_is_not_written():
    with pytest.raises(ProjectError, match=r"U\+D800 can't be saved"):
        encode(Project("p", "x = '\ud800'"))


# Names.


@pytest.mark.parametrize(
    "name", ["square", "Square 2", "línea-1", "a_b.c", "名前", "2", "x" * 100, "console"]
)
def test_a_valid_name_is_accepted(name):
    assert checked_name(name) == name


@pytest.mark.parametrize(
    "name",
    [
        "", " ", ".", "..", "../x", "a/b", "a\\b", "/etc/passwd", ".hidden", "-x", " x", "x ", "x.",
        "con", "NUL", "com1", "Lpt9.txt", "a:b", "a\0b", "a\nb", "x" * 101, "é" * 60, "a*",
        "\ud800",
    ],
)  # fmt: skip
def test_a_name_that_could_leave_the_folder_or_not_be_a_file_is_refused(folder, name):
    for use in (folder.read, folder.delete, folder.versions, folder.runs, checked_name):
        with pytest.raises(ProjectError):
            use(name)
    with pytest.raises(ProjectError):
        folder.write(Project(name))
    assert not folder.path.exists()


def test_a_name_is_the_same_in_each_unicode_form(folder):
    folder.write(Project("línea", "x = 1\n"))
    assert folder.read("li\u0301nea").name == "línea"


@given(st.text(max_size=120))
def test_any_wish_leads_to_a_valid_name(tmp_path_factory, wish):
    folder = ProjectFolder(tmp_path_factory.mktemp("projects"))
    first = folder.free_name(wish)
    folder.write(Project(first))
    second = folder.free_name(wish)
    folder.write(Project(second))
    assert {entry.name for entry in folder.entries()} == {first, second}


def test_a_free_name_keeps_the_wish_and_adds_a_number(folder):
    for expected in ("square", "square 2", "square 3"):
        assert folder.free_name("square") == expected
        folder.write(Project(expected))
    assert folder.free_name("SQUARE") == "SQUARE 4"


# The folder.


def test_a_project_is_read_as_it_was_saved(folder):
    project = Project("p", SQUARE, breakpoints=("a",))
    folder.write(project)
    assert folder.read("p") == project


def test_projects_are_listed_last_changed_first(folder):
    for number, name in enumerate(("b", "a", "c")):
        folder.write(Project(name))
        os.utime(folder.path / f"{name}.learnblock", (number, number))
    assert [entry.name for entry in folder.entries()] == ["c", "a", "b"]


def test_a_missing_folder_has_no_projects(folder):
    assert folder.entries() == ()
    with pytest.raises(UnknownNameError, match="There is no project 'p'"):
        folder.read("p")


def test_other_files_are_not_projects(folder):
    folder.write(Project("p"))
    for name in (".p.learnblock.new", "-x.learnblock", "notes.txt", ".hidden.learnblock"):
        (folder.path / name).write_text("")
    assert [entry.name for entry in folder.entries()] == ["p"]


def test_a_crash_while_saving_does_not_change_the_project(folder, monkeypatch):
    folder.write(Project("p", "x = 1\n"))

    def crash(_):
        raise KeyboardInterrupt

    monkeypatch.setattr(files.os, "fsync", crash)
    with pytest.raises(KeyboardInterrupt):
        folder.write(Project("p", "x = 2\n"))
    assert folder.read("p").blocktext == "x = 1\n"
    assert [entry.name for entry in folder.entries()] == ["p"]


def test_a_removed_folder_is_created_again(folder):
    folder.write(Project("p"))
    (folder.path / "p.learnblock").unlink()
    folder.path.rmdir()
    folder.write(Project("p", "x = 1\n"))
    assert folder.read("p").blocktext == "x = 1\n"


def test_a_read_only_folder_is_reported(tmp_path):
    (tmp_path / "projects").write_text("a file")
    folder = ProjectFolder(tmp_path / "projects")
    with pytest.raises(ProjectError, match="The project can't be saved in"):
        folder.write(Project("p"))
    with pytest.raises(ProjectError, match="The version can't be saved in"):
        folder.keep_version(Project("p"), "run")


def test_a_full_disk_is_reported_as_such(folder, monkeypatch):
    def fill(_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(files.os, "fsync", fill)
    with pytest.raises(ProjectError, match=r"The version can't be saved .* The disk is full"):
        folder.keep_version(Project("p"), "run")


def test_a_deleted_project_goes_to_the_trash_with_its_history(folder):
    for text in ("x = 1\n", "x = 2\n"):
        folder.write(Project("p", text))
        folder.keep_version(Project("p", text), "run")
        folder.delete("p")
        assert (folder.entries(), folder.versions("p")) == ((), ())
    kept = sorted(path.read_text() for path in folder.path.glob(".trash/*/p.learnblock"))
    assert ["x = 1" in kept[0], "x = 2" in kept[1]] == [True, True]
    assert len([*folder.path.glob(".trash/*/history/*.learnblock")]) == 2


def test_a_renamed_project_keeps_its_history(folder):
    version = folder.keep_version(Project("p", "x = 1\n"), "run")
    folder.write(Project("p", "x = 2\n"))
    folder.rename("p", "q")
    assert [one.name for one in folder.entries()] == ["q"]
    assert folder.read("q") == Project("q", "x = 2\n")
    assert folder.read_version("q", version) == Project("q", "x = 1\n")
    assert folder.versions("p") == ()


@pytest.mark.parametrize("taken", ["other", "OTHER"])
def test_a_project_cannot_have_the_name_of_another(folder, taken):
    for name in ("p", "other"):
        folder.write(Project(name, f"x = '{name}'\n"))
    with pytest.raises(ProjectError, match="There is already a project named"):
        folder.rename("p", taken)
    assert {one.name for one in folder.entries()} == {"p", "other"}
    assert folder.read("other").blocktext == "x = 'other'\n"


def test_a_project_can_change_the_case_of_its_name(folder):
    folder.write(Project("square", "x = 1\n"))
    folder.rename("square", "Square")
    assert [one.name for one in folder.entries()] == ["Square"]


def test_a_rename_that_fails_halfway_changes_nothing(folder, monkeypatch):
    folder.keep_version(Project("p", "x = 1\n"), "run")
    folder.write(Project("p", "x = 1\n"))

    def refuse(*_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(ProjectFolder, "_move_history", refuse)
    with pytest.raises(ProjectError, match="Can't rename the project"):
        folder.rename("p", "q")
    assert [one.name for one in folder.entries()] == ["p"]
    assert len(folder.versions("p")) == 1


def test_the_history_that_a_lost_project_has_left_goes_to_the_trash(folder):
    folder.keep_version(Project("q", "x = 0\n"), "run")
    folder.write(Project("p", "x = 1\n"))
    folder.rename("p", "q")
    assert folder.versions("q") == ()
    assert len([*folder.path.glob(".trash/*/history/*.learnblock")]) == 1


def test_a_missing_project_cannot_be_deleted(folder):
    with pytest.raises(UnknownNameError, match="There is no project 'p'"):
        folder.delete("p")


def test_a_project_has_versions_and_runs(folder):
    version = folder.keep_version(Project("p", "x = 1\n"), "run")
    run = PastRun(1.0, "sim-ebo", "", "finished", 1.0, (), "ab", version)
    folder.add_run("p", run)
    assert folder.runs("p") == (run,)
    assert [one.id for one in folder.versions("p")] == [version]
    assert folder.read_version("p", version) == Project("p", "x = 1\n")


# Import and export.


def test_block_text_becomes_a_project(folder):
    assert folder.import_file("C:\\my\\square.bt", "x = 1\r\n") == Project("square", "x = 1\n")


def test_python_becomes_a_project_for_its_robot(folder):
    text = "from learnblock.robots.sim_thymio import Robot\n\nrobot = Robot()\n\nx=1\n"
    expected = Project("p", "x = 1\n", text, robot="sim-thymio")
    assert folder.import_file("p.py", text) == expected


@pytest.mark.parametrize("text", ["x = (", "from nowhere import Robot\n\nrobot = Robot()\n"])
def test_python_that_cannot_be_parsed_or_run_here_still_becomes_a_project(folder, text):
    project = folder.import_file("p.py", text)
    assert (project.python, project.robot) == (text, "sim-ebo")


def test_a_project_is_imported_under_a_free_name(folder):
    folder.write(Project("p"))
    text = encode(Project("other", SQUARE, world="line")).decode()
    assert folder.import_file("p.learnblock", text) == Project("p 2", SQUARE, world="line")


def test_another_file_is_refused(folder):
    with pytest.raises(ProjectError, match=r"Choose a \.bt, \.py, \.learnblock or"):
        folder.import_file("p.txt", "x = 1\n")


def test_a_project_is_exported_in_each_notation(folder):
    project = Project("p", "x = 1\n", robot="sim-thymio")
    assert export(project, "bt") == ("p.bt", "x = 1\n")
    filename, python = export(project, "py")
    assert filename == "p.py"
    assert python.startswith("from learnblock.robots.sim_thymio import Robot\n")
    filename, text = export(project, "learnblock")
    assert folder.import_file(filename, text) == project


def test_hand_written_python_is_exported_unchanged():
    assert export(Project("p", "x = 1\n", "x=1"), "py") == ("p.py", "x=1")


def test_a_program_with_mistakes_has_no_python():
    with pytest.raises(ProgramError):
        export(Project("p", "x = (\n"), "py")


@given(st.text(max_size=40), st.sampled_from(["a.bt", "a.py", "a.learnblock", "a", ""]))
def test_any_text_is_imported_or_refused(tmp_path_factory, text, filename):
    folder = ProjectFolder(tmp_path_factory.mktemp("projects"))
    try:
        project = folder.import_file(filename, text)
    except LearnBlockError:
        return
    folder.write(project)
    assert folder.read(project.name) == project


# The permission to use the network.


@pytest.fixture
def online(folder, tmp_path, monkeypatch):
    """A project that may use the network."""
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    folder.write(Project("online", "x = 1\n"))
    allow_network(folder.file("online"))
    return folder


def test_it_follows_a_renamed_project(online):
    online.rename("online", "weather")
    assert may_use_network(online.file("weather"))
    online.write(Project("online", ""))
    assert not may_use_network(online.file("online"))


def test_a_project_does_not_take_it_over_with_the_name(online):
    online.file("online").unlink()
    online.write(Project("other", ""))
    online.rename("other", "online")
    assert not may_use_network(online.file("online"))


@pytest.mark.parametrize("by_hand", [True, False])
def test_a_new_project_does_not_inherit_it(online, by_hand):
    online.file("online").unlink() if by_hand else online.delete("online")
    assert online.add(Project("online", "")).name == "online"
    assert not may_use_network(online.file("online"))


def test_a_new_project_beside_it_gets_another_name_and_no_permission(online):
    assert online.add(Project("online", "")).name == "online 2"
    assert not may_use_network(online.file("online 2"))
    assert may_use_network(online.file("online"))


@pytest.mark.parametrize(
    "change", [lambda it: it.delete("online"), lambda it: it.rename("online", "b")]
)
def test_with_a_mistake_in_the_settings_the_project_stays(online, tmp_path, change):
    (tmp_path / "home" / "settings.toml").write_text("[network]\nallowed = 3\n")
    with pytest.raises(SettingsError):
        change(online)
    assert [one.name for one in online.entries()] == ["online"]


def test_with_a_mistake_in_the_settings_projects_can_still_be_created(online, tmp_path):
    (tmp_path / "home" / "settings.toml").write_text("[network]\nallowed = 3\n")
    assert online.add(Project("new", "")).name == "new"


@pytest.mark.parametrize("name", ["PROG.BT", "TEST.PY"])
def test_the_ending_of_an_opened_file_may_be_in_capitals(name, tmp_path):
    project = ProjectFolder(tmp_path).import_file(name, "print(1)\n")
    assert name.partition(".")[0] == project.name
    assert "print(1)\n" in (project.python or project.blocktext)


@pytest.mark.parametrize("wish", ["con", "AUX", "nul", "com1"])
def test_a_name_that_windows_reserves_stays_readable(folder, wish):
    assert folder.free_name(wish) == f"program {wish}"
