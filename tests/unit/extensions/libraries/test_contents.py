"""The contents of a library, and contents that are refused."""

import pytest

from learnblock.errors import FileError, LibraryError, UnknownNameError
from learnblock.extensions.libraries import from_files, manifest

TOML = b'learnblock = 1\nname = "dance"\nversion = "1.2"\n'
SKILL = b"def waltz(robot):\n    pass\n"


def code_of(files):
    with pytest.raises(FileError) as caught:
        from_files(files, "dance.lblib")
    return caught.value.diagnostics[0].code


def test_a_library_of_functions_has_their_block_text_and_their_python(make):
    assert set(make().files) == {
        "__init__.py", "blocks.json", "functions.bt", "functions.py", "library.toml"
    }  # fmt: skip
    assert make().files["functions.py"].count("(robot") == 3


def test_it_is_unchanged_after_reading_its_files(make, own):
    library = make(own=["clap"])
    files = {name: text.encode() for name, text in library.files.items()}
    assert from_files(files, "dance") == library


def test_the_python_of_functions_is_always_regenerated(make):
    library = make()
    files = {name: text.encode() for name, text in library.files.items()}
    files["functions.py"] = b"import os\nos.abort()\n"
    assert from_files(files, "dance").files == library.files


def test_a_library_can_be_one_file_written_by_hand():
    library = from_files({"library.toml": TOML, "__init__.py": SKILL}, "dance")
    assert list(library.skills) == ["waltz"]
    assert library.files["__init__.py"] == SKILL.decode()


def test_its_code_is_not_run(tmp_path):
    code = SKILL + f"open({str(tmp_path / 'ran')!r}, 'w')\n".encode()
    from_files({"library.toml": TOML, "__init__.py": code}, "dance")
    assert not (tmp_path / "ran").exists()


@pytest.mark.parametrize(
    ("files", "code"),
    [
        ({"__init__.py": SKILL}, "no-manifest"),
        ({"library.toml": TOML, "__init__.py": b"x = 1\n"}, "no-skill"),
        ({"library.toml": TOML, "__init__.py": b"def waltz(name): pass\n"}, "no-skill"),
        ({"library.toml": TOML, "a.py": SKILL, "b.py": SKILL}, "two-skills"),
        ({"library.toml": TOML, "a.py": SKILL, "run.sh": b""}, "unknown-file"),
        ({"library.toml": TOML, "a.py": SKILL, "class.py": b""}, "unknown-file"),
        ({"library.toml": TOML, "a.py": SKILL, "../a.py": b""}, "unknown-file"),
        ({"library.toml": TOML, "a.py": b"def waltz(robot:\n"}, "syntax-error"),
        ({"library.toml": TOML, "a.py": b"\xff"}, "not-utf-8"),
        ({"library.toml": TOML, "a.py": SKILL, "__init__.py": SKILL}, "not-in-library"),
        ({"library.toml": TOML, "a.py": SKILL, "blocks.json": b"{"}, "not-json"),
        ({"library.toml": TOML, "functions.bt": b"def f(): pass end\nf()\n"}, "not-in-library"),
        ({"library.toml": TOML, "functions.bt": b"main: turn(9) end\n"}, "not-in-library"),
        ({"library.toml": TOML, "functions.bt": b"def list(): pass end\n"}, "skill-name"),
        ({"library.toml": TOML, "functions.bt": b"def f(): return g() end\n"}, "unknown-function"),
        ({"library.toml": TOML, "a.py": b"#" * 2_000_000}, "too-large"),
        ({"library.toml": TOML, **{f"a{n}.py": b"" for n in range(100)}}, "too-large"),
    ],
)  # fmt: skip
def test_an_invalid_library_is_refused(files, code):
    assert code_of(files) == code


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ('name = "Dance"', "wrong-value"),
        ('name = "../dance"', "wrong-value"),
        ('name = "class"', "name-taken"),
        ('name = "con"', "name-taken"),
        ('name = "dance"\nauthor = "me"', "unknown-key"),
        ("name = 3", "wrong-type"),
    ],
)
def test_an_invalid_manifest_is_refused_with_its_line(line, code):
    toml = f'learnblock = 1\nversion = "1.2"\n{line}\n'.encode()
    with pytest.raises(LibraryError) as caught:
        from_files({"library.toml": toml, "a.py": SKILL}, "dance")
    [problem] = caught.value.diagnostics
    assert problem.line in (3, 4)


@pytest.mark.parametrize(
    ("older", "newer"), [("1", "1.0.1"), ("1.9", "1.10"), ("1.2.3", "2"), ("0.1", "1")]
)
def test_versions_are_compared_as_numbers(older, newer):
    assert manifest("dance", older).order < manifest("dance", newer).order


def test_a_version_may_be_written_shorter():
    assert manifest("dance", "1.2").order == manifest("dance", "1.2.0").order


@pytest.mark.parametrize("version", ["", "1.", "1.2.3.4", "one", "v1", "1.2-beta", "1\n"])
def test_an_invalid_version_is_refused(version):
    with pytest.raises(LibraryError, match="version"):
        manifest("dance", version)


def test_a_missing_function_or_block_is_named(make, own):
    with pytest.raises(UnknownNameError, match=r"no function 'walz'. Did you mean 'waltz'"):
        make(functions=["walz"])
    with pytest.raises(UnknownNameError, match=r"no custom block 'clapp'. Did you mean 'clap'"):
        make(own=["clapp"])
