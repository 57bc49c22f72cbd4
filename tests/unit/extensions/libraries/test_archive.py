"""A library in one file, and files that are refused."""

import io
import zipfile

import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from gate import examples
from learnblock import language
from learnblock.errors import LibraryError, ProgramError
from learnblock.extensions.libraries import make, manifest, pack, read, unpack, write
from learnblock.language.tree.nodes import Activate, Deactivate, Def, Program, Raw, RawExpression
from trees import Trees

TOML = 'learnblock = 1\nname = "dance"\nversion = "1.2"\n'
SKILL = "def waltz(robot):\n    pass\n"


def zipped(*entries):
    """Return a zip of files by name, or by an entry with more details."""
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in (("library.toml", TOML), ("dance.py", SKILL), *entries):
            archive.writestr(name, text)
    return target.getvalue()


def code_of(content):
    with pytest.raises(LibraryError) as caught:
        unpack(content, "dance.lblib")
    return caught.value.diagnostics[0].code


def test_a_library_is_restored_from_its_file(make, own):
    library = make(own=["clap"])
    assert unpack(pack(library), "dance.lblib") == library


def test_the_same_library_always_has_the_same_bytes(make):
    assert pack(make()) == pack(make())


def test_a_library_is_restored_from_its_folder(make, tmp_path):
    write(make(), tmp_path / "dance")
    (tmp_path / "dance" / "__pycache__").mkdir()
    assert read(tmp_path / "dance") == make()


def test_all_files_may_be_in_one_folder():
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w") as archive:
        archive.writestr("dance/", "")
        archive.writestr("dance/library.toml", TOML)
        archive.writestr("dance/__init__.py", SKILL)
    assert list(unpack(target.getvalue(), "dance.lblib").skills) == ["waltz"]


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"", "no-zip"),
        (zipped(("a/b/evil.py", "")), "unknown-file"),
        (zipped(("evil.so", "")), "unknown-file"),
        (zipped(("a/more.py", ""), ("b/more.py", "")), "two-files"),
        (zipped(*((f"a{n}.py", "") for n in range(100))), "too-many-files"),
        (zipped(("bomb.py", b"#" * 50_000_000)), "too-large"),
        (b"\0" * 5_000_000, "too-large"),
    ],
)
def test_an_invalid_library_file_is_refused(content, code):
    assert code_of(content) == code


def test_a_link_in_a_folder_is_refused(make, tmp_path):
    write(make(), tmp_path / "dance")
    (tmp_path / "dance" / "more.py").symlink_to("/etc/passwd")
    with pytest.raises(LibraryError, match=r"more\.py is not a plain file"):
        read(tmp_path / "dance")


class Functions(Trees):
    """Generates random functions, most of which can be in a library."""

    def call(self, depth=2):
        return self.library_call(depth)

    def raw(self, _):
        return RawExpression(self.choice(("{1: 2}", "lambda: 0", "b'`'")))

    def statement(self, depth):
        while isinstance(found := super().statement(depth), Activate | Deactivate | Raw):
            pass
        return found

    def functions(self):
        names = self.random.sample(("waltz", "polka", "turn_around"), 2)
        items = tuple(
            Def(name, tuple(self.random.sample(("x", "y"), self.random.randrange(3))), self.body(2))
            for name in names
        )
        return language.parse(language.format(Program(items)))


@settings(max_examples=examples(100, gate=30))
@given(st.integers(0, 2**32))
def test_functions_are_the_same_after_export_and_import(seed):
    trees = Functions(seed)
    trees.skills = ("turn", "is_any_tag")
    program = trees.functions()
    try:
        library = make(manifest("dance", "1.0"), program, program.functions)
    except ProgramError:
        # A `break` outside of any loop, for example.
        reject()
    again = unpack(pack(library), "dance.lblib")
    assert language.parse(again.functions).functions == program.functions
    assert again.files == library.files
