"""Installing libraries, and the reasons why one cannot be installed."""

import pytest

from learnblock.errors import LibraryError, UnknownNameError
from learnblock.extensions.libraries import (
    clashes,
    find,
    install,
    installed,
    pack,
    remove,
    renamed,
    shelved,
    versions,
    write,
)
from learnblock.i18n import Phrase

OTHER = "def step(x):\n    print(x)\nend\n"


def test_an_installed_library_is_found(make, home):
    assert install([make()]) == (make(),)
    assert installed("dance") == make()
    assert versions() == {"dance": "1.0.0"}
    assert sorted(path.name for path in (home / "libraries").iterdir()) == ["dance"]


def test_a_newer_version_replaces_an_older_one(make):
    install([make()])
    install([make(version="1.0.1")])
    assert versions() == {"dance": "1.0.1"}


def test_installing_the_same_again_changes_nothing(make):
    install([make()])
    assert install([make()]) == ()


@pytest.mark.parametrize("version", ["1.0.0", "1", "0.9"])
def test_a_version_that_is_not_newer_replaces_only_on_request(make, version):
    install([make()])
    other = make(version=version, functions=["step"])
    with pytest.raises(LibraryError, match=r"installed, and .* is not newer"):
        install([other])
    assert versions() == {"dance": "1.0.0"}
    install([other], replace=True)
    assert versions() == {"dance": version}


def test_two_libraries_with_the_same_skill_clash(make):
    install([make()])
    other = make("songs", text=OTHER, functions=["step"])
    [clash] = clashes([other])
    assert ("step", "songs") == (clash.skill, clash.library)
    assert clash.place == Phrase("library-place-library", library="dance")
    with pytest.raises(LibraryError, match="--rename step=NEW"):
        install([other])
    install([renamed(other, {"step": "song_step"})])
    assert set(versions()) == {"dance", "songs"}


def test_if_two_new_libraries_clash_none_is_installed(make):
    with pytest.raises(LibraryError, match="the library dance"):
        install([make(), make("songs", text=OTHER, functions=["step"])])
    assert versions() == {}


@pytest.mark.parametrize(
    ("name", "place"),
    [
        ("turn", "library-place-learnblock"),
        ("stop", "library-place-robot"),
        ("clap", "library-place-block"),
    ],
)
def test_a_library_never_hides_another_skill(make, own, name, place):
    [clash] = clashes([make(text=f"def {name}():\n    pass\nend\n", functions=[name])])
    assert place == clash.place.code


def test_a_broken_library_is_reported_and_its_names_are_free(make, home):
    install([make()])
    (home / "libraries" / "dance" / "functions.bt").write_text("def waltz(:\n")
    [broken] = shelved()
    assert broken.library is None
    assert str(broken.problem).startswith("functions.bt: Line 1: ")
    assert install([make(version="1.0.1")])


def test_the_last_removed_version_is_kept(make, home):
    install([make()])
    remove("dance")
    install([make()])
    remove("dance")
    assert versions() == {}
    assert (home / "libraries" / ".trash" / "dance" / "functions.bt").is_file()
    with pytest.raises(UnknownNameError, match="There is no library 'dance'"):
        remove("dance")


# Addresses.


def test_a_library_is_found_by_path_by_address_and_by_name(make, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(make(), tmp_path / "dance")
    (tmp_path / "songs.lblib").write_bytes(pack(make("songs")))
    (tmp_path / "libraries").mkdir()
    (tmp_path / "libraries" / "moves.lblib").write_bytes(pack(make("moves")))
    named = {
        "dance": "dance",
        "songs": "songs",
        "moves": "moves",
        str(tmp_path / "dance"): "dance",
        (tmp_path / "songs.lblib").as_uri(): "songs",
        (tmp_path / "dance").as_uri(): "dance",
    }
    assert {address: find(address).name for address in named} == named


@pytest.mark.parametrize("address", ["http://a.org/x.lblib", "https://a.org/x", "ftp://a/x.lblib"])
def test_nothing_is_downloaded(address):
    with pytest.raises(LibraryError, match="LearnBlock does not download libraries"):
        find(address)


@pytest.mark.parametrize("address", ["nothing", "no/thing.lblib", "file:///no/such/thing", ""])
def test_a_missing_library_is_reported(address):
    with pytest.raises(LibraryError, match="There is no library here"):
        find(address)
