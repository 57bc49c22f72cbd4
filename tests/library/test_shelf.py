"""Installing libraries, and what keeps one from being installed."""

import pytest

from learnblock.errors import LibraryError, UnknownNameError
from learnblock.library import (
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

OTHER = "def step(x):\n    print(x)\nend\n"


def test_what_was_installed_is_there(make, home):
    assert install([make()]) == (make(),)
    assert installed("dance") == make()
    assert versions() == {"dance": "1.0.0"}
    assert sorted(path.name for path in (home / "libraries").iterdir()) == ["dance"]


def test_a_newer_version_takes_the_place_of_an_older(make):
    install([make()])
    install([make(version="1.0.1")])
    assert versions() == {"dance": "1.0.1"}


def test_the_same_once_more_changes_nothing(make):
    install([make()])
    assert install([make()]) == ()


@pytest.mark.parametrize("version", ["1.0.0", "1", "0.9"])
def test_one_that_is_no_newer_is_told_and_replaces_only_when_asked(make, version):
    install([make()])
    other = make(version=version, functions=["step"])
    with pytest.raises(LibraryError, match=r"version 1\.0\.0 .* is installed"):
        install([other])
    assert versions() == {"dance": "1.0.0"}
    install([other], replace=True)
    assert versions() == {"dance": version}


def test_two_libraries_with_one_skill_are_told_with_both_places(make):
    install([make()])
    other = make("songs", text=OTHER, functions=["step"])
    [clash] = clashes([other])
    assert ("step", "songs", "the library dance") == (clash.skill, clash.library, clash.place)
    with pytest.raises(LibraryError, match="--rename step=NEW"):
        install([other])
    install([renamed(other, {"step": "song_step"})])
    assert set(versions()) == {"dance", "songs"}


def test_two_that_come_together_may_clash_too_and_then_none_is_installed(make):
    with pytest.raises(LibraryError, match="the library dance"):
        install([make(), make("songs", text=OTHER, functions=["step"])])
    assert versions() == {}


@pytest.mark.parametrize(
    ("name", "place"),
    [("turn", "LearnBlock's own"), ("stop", "every robot's own"), ("clap", "your own blocks in")],
)
def test_a_library_never_hides_another_skill(make, own, name, place):
    [clash] = clashes([make(text=f"def {name}():\n    pass\nend\n", functions=[name])])
    assert place in clash.place


def test_a_broken_library_is_told_and_its_names_are_free(make, home):
    install([make()])
    (home / "libraries" / "dance" / "functions.bt").write_text("def waltz(:\n")
    [broken] = shelved()
    assert broken.library is None
    assert "functions.bt:1" in broken.problem
    assert install([make(version="1.0.1")])


def test_one_that_was_removed_is_kept_once(make, home):
    install([make()])
    remove("dance")
    install([make()])
    remove("dance")
    assert versions() == {}
    assert (home / "libraries" / ".trash" / "dance" / "functions.bt").is_file()
    with pytest.raises(UnknownNameError, match="there is no library `dance`"):
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
    with pytest.raises(LibraryError, match="LearnBlock downloads nothing"):
        find(address)


@pytest.mark.parametrize("address", ["nothing", "no/thing.lblib", "file:///no/such/thing", ""])
def test_what_is_not_there_is_told(address):
    with pytest.raises(LibraryError, match="there is no library here"):
        find(address)
