"""Of a zip, whoever made it, only files within the rules are read, by the names its author saw."""

import io
import os
import stat
import struct
import unicodedata
import zipfile

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.errors import ProjectError
from learnblock.i18n import Phrase
from learnblock.storage.archive import DEEPEST, RefusedError, Rules, ZipReader, unzipped, zipped

NAMES = st.text(
    st.characters(codec="utf-8", exclude_characters="\0/\\", exclude_categories=["Cs"]),
    min_size=1,
    max_size=30,
)
RULES = Rules(
    ProjectError,
    entries=20,
    total=2_000_000,
    file=1_500_000,
    damaged=Phrase("library-not-zip"),
    too_many=Phrase("library-too-many-files", most=20),
    too_large=Phrase("library-too-large", limit=2_000_000),
)
PATHS = st.from_regex(r"(?:[a-z]{1,8}/){0,2}[a-z]{1,8}\.[a-z]{1,3}", fullmatch=True)


def made(*entries, method=zipfile.ZIP_DEFLATED):
    """Return a zip of files by name, or by an entry with more details."""
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", method) as archive:
        for name, content in entries:
            archive.writestr(name, content)
    return target.getvalue()


def refused(content, rules=RULES):
    with pytest.raises(ProjectError) as caught:
        unzipped("it.zip", content, rules)
    assert caught.value.filename == "it.zip"
    [diagnostic] = caught.value.diagnostics
    return diagnostic.code, str(diagnostic.message)


# Names.


def names(raw, *, flag):
    """The names that are read from a zip with a name of these bytes."""
    data = made(("x" * len(raw), "")).replace(b"x" * len(raw), raw)
    written = bytearray(data)
    if flag:
        written[7] |= 8
        written[written.index(b"PK\1\2") + 9] |= 8
    return [entry.name for entry in ZipReader(10, 10).entries(io.BytesIO(bytes(written)))]


@given(NAMES.filter(lambda name: "x" not in name and not name.startswith(".")))
def test_a_name_in_utf_8_is_right_with_and_without_the_flag(name):
    expected = [unicodedata.normalize("NFC", name)]
    assert names(name.encode(), flag=True) == names(name.encode(), flag=False) == expected


@pytest.mark.parametrize("name", ["José", "Ü", "plain.bt", "½"])
def test_a_name_of_the_first_pcs_stays(name):
    assert names(name.encode("cp437"), flag=False) == [name]


@pytest.mark.parametrize(
    "name",
    [
        "../up.py", "/root.py", "..\\up.py", "a/../../up.py", "C:\\x.py", "c:x.py",
        "a/" * DEEPEST + "b",
    ],
)  # fmt: skip
def test_a_name_that_leads_out_of_the_folder_or_too_deep_into_it_is_refused(name):
    code, message = refused(made((name, "x")))
    assert (code, name in message) == ("unknown-file", True)


def test_the_folders_of_a_zip_from_windows_are_folders():
    assert unzipped("it.zip", made(("a\\b.py", "x")), RULES) == {"a/b.py": b"x"}


@pytest.mark.parametrize(
    "name", [".hidden", "a/.b", "__MACOSX/a", "a/__pycache__/b.pyc", "Thumbs.db", "a/desktop.ini"]
)
def test_what_file_managers_and_python_add_is_left_out(name):
    assert unzipped("it.zip", made(("a.py", "x"), (name, "x")), RULES) == {"a.py": b"x"}


@pytest.mark.filterwarnings("ignore:Duplicate name")
@pytest.mark.parametrize("other", ["a/b.py", "a\\b.py", "a//b.py", "./a/b.py"])
def test_two_files_with_one_name_are_refused(other):
    assert refused(made(("a/b.py", "1"), (other, "2"))) == (
        "two-files",
        "There are two files named 'a/b.py'.",
    )


# Kinds.


def test_a_link_is_refused():
    entry = zipfile.ZipInfo("link.py")
    entry.create_system = 3
    entry.external_attr = (stat.S_IFLNK | 0o777) << 16
    assert refused(made((entry, "/etc/passwd"))) == (
        "link",
        "'link.py' is a link. Replace it with the file.",
    )


def test_an_encrypted_file_is_refused():
    data = bytearray(made(("a.py", "x")))
    data[data.index(b"PK\1\2") + 8] |= 1
    assert refused(bytes(data))[0] == "encrypted"


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_a_file_that_is_packed_in_another_way_is_refused(method):
    assert refused(made(("a.py", "x" * 1000), method=method))[0] == "encrypted"


# Limits.


def test_too_many_files_and_folders_are_refused_in_the_words_of_the_caller():
    many = ((f"{number}/", "") for number in range(21))
    assert refused(made(*many)) == ("too-many-files", "A library can have at most 20 files.")


def test_what_is_ignored_does_not_count():
    many = ((f"__MACOSX/{number}", "") for number in range(50))
    assert list(unzipped("it.zip", made(*many, ("a.py", "x")), RULES)) == ["a.py"]


def test_files_that_are_too_large_together_are_refused_in_the_words_of_the_caller():
    content = os.urandom(1_200_000)
    assert refused(made(("a", content), ("b", content))) == (
        "too-large",
        "The library is too large: the limit is 2,000,000 bytes.",
    )


def test_a_file_that_is_too_large_is_named():
    assert refused(made(("a", os.urandom(1_600_000)))) == (
        "too-large",
        "a is too large: the limit is 1 MB.",
    )


def test_a_bomb_is_refused_before_it_is_unpacked_whole():
    assert refused(made(("a", bytes(1_000_000))))[0] == "bomb"
    assert refused(made(("a", bytes(50_000_000))))[0] == "too-large"


def test_a_zip_that_lies_about_sizes_is_refused():
    data = bytearray(made(("a", os.urandom(100_000))))
    at = data.rindex(b"PK\1\2")
    data[at + 24 : at + 28] = struct.pack("<I", 10)
    assert refused(bytes(data))[0] == "no-zip"


@pytest.mark.parametrize(
    ("entries", "total", "rule"), [(5, 9, "too-many-files"), (6, 3, "too-large")]
)
def test_the_zips_in_a_zip_count_together(entries, total, rule):
    inner = made(("a", "x"), ("b", "x"))
    reader = ZipReader(entries, total)

    def read_all():
        for entry in reader.entries(io.BytesIO(made(("1.zip", inner), ("2.zip", inner)))):
            for part in reader.inner(entry, 1000):
                reader.read(part, 10)

    with pytest.raises(RefusedError) as caught:
        read_all()
    assert caught.value.rule == rule


def test_of_a_file_no_more_is_read_than_is_asked_for():
    reader = ZipReader(1, 100)
    [content] = (reader.read(one, 3) for one in reader.entries(io.BytesIO(made(("a", "xxxx")))))
    assert content == b"xxx"


# Damage.


@pytest.mark.parametrize(
    "content",
    [b"", b"PK", b"no zip", bytes(1000), zipped({"a": b"x"})[:-30]],
    ids=["empty", "start", "text", "zeros", "cut off"],
)
def test_what_is_no_zip_is_refused_in_the_words_of_the_caller(content):
    assert refused(content) == ("no-zip", "This file is damaged or not a library.")


@settings(max_examples=300)
@given(st.data())
def test_a_damaged_zip_gives_an_error_of_ours_or_files_within_the_rules(data):
    whole = bytearray(made(("a/b.py", "x" * 5000), ("c.png", bytes(range(256))), ("d/", "")))
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(whole) - 1))
        whole[at : at + data.draw(st.integers(0, 3))] = data.draw(st.binary(max_size=40))
    try:
        found = unzipped("it.zip", bytes(whole), RULES)
    except ProjectError as error:
        assert str(error)  # noqa: PT017 - it can be told
    else:
        assert sum(map(len, found.values())) <= RULES.total
        assert not any(path.startswith("/") or ".." in path.split("/") for path in found)


@given(st.dictionaries(PATHS, st.binary(max_size=200), max_size=15))
def test_files_come_back_from_their_zip_and_always_give_the_same_bytes(files):
    files = {path: content for path, content in files.items() if "desktop.ini" not in path}
    assert unzipped("it.zip", zipped(files), RULES) == files
    assert zipped(dict(reversed(files.items()))) == zipped(files)
