"""The files that a program may read and write."""

import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from learnblock.runtime.containment import landlock
from learnblock.runtime.containment.beside import files_beside
from learnblock.storage.home import home

#: Programs' libraries and data, which every user of the computer can read.
_SYSTEM = ("/usr", "/lib", "/lib32", "/lib64", "/nix/store", "/gnu/store")
#: Library settings; nothing about users and their passwords.
_SETTINGS = (
    "/etc/ld.so.cache", "/etc/localtime", "/etc/mime.types", "/etc/os-release", "/etc/fonts",
    "/etc/ssl/openssl.cnf", "/etc/pki/tls/openssl.cnf", "/sys/devices/system/cpu",
    "/dev/null", "/dev/zero", "/dev/random", "/dev/urandom",
)  # fmt: skip
#: Where names and certificates on the network are looked up.
_NETWORK = (
    "/etc/resolv.conf", "/run/systemd/resolve", "/etc/hosts", "/etc/host.conf", "/etc/gai.conf",
    "/etc/nsswitch.conf", "/etc/services", "/etc/ssl/certs", "/etc/pki", "/etc/ca-certificates",
)  # fmt: skip
#: What a host knows of its programs, and of the user that they belong to.
_PROCESSES = ("/proc", "/etc/passwd", "/etc/group")


def allowed(project: str, *, network: bool) -> Iterator[tuple[str, int]]:
    """Files and folders that a program may use, each with its rights.

    Args:
        project: the folder of the program; "" for none.
        network: whether it may use the network.
    """
    # TMPDIR is the temporary folder that the host has created for the program: see `environment`.
    for path in (os.environ["TMPDIR"], os.devnull):
        yield path, landlock.WRITE
    for path in (*_SYSTEM, *_SETTINGS, *_installation(project), *_user_code(), *_NETWORK * network):
        yield path, landlock.READ
    if project:
        yield from _own_files(Path(project).resolve())


def allowed_to_host(world: str | None) -> Iterator[tuple[str, int]]:
    """Files and folders that the host of a simulated robot reads, each with its rights.

    Args:
        world: the name or the path of its world.
    """
    names = ("skills", "libraries", "robots", "worlds", "settings.toml", "tags.toml")
    own = (str(home() / name) for name in names)
    for path in (*_SYSTEM, *_SETTINGS, *_installation(""), *own):
        yield path, landlock.READ
    if world and Path(world).is_file():
        # A world may have a picture in its folder.
        yield from _own_files(Path(world).resolve().parent)


def allowed_to_server(folder: Path) -> Iterator[tuple[str, int]]:
    """Files and folders that a pupil's server and all that it starts may use, with their rights.

    Args:
        folder: the pupil's folder.
    """
    yield str(folder), landlock.FOLDER
    yield os.devnull, landlock.WRITE
    for path in (*_SYSTEM, *_installation("")):
        yield path, landlock.RUN
    for path in (*_SETTINGS, *_NETWORK, *_PROCESSES):
        yield path, landlock.READ


def _installation(project: str) -> Iterator[str]:
    """Python, its libraries and LearnBlock."""
    yield from {sys.prefix, sys.exec_prefix, sys.base_prefix, sys.base_exec_prefix}
    yield from (entry for entry in sys.path if entry and entry != project)


def _user_code() -> Iterator[str]:
    """What programs import from the user's folder, but not its settings, which hold passwords."""
    return (str(home() / name) for name in ("skills", "libraries"))


def _own_files(project: Path) -> Iterator[tuple[str, int]]:
    """A project's folder, or only the files directly in it if it also contains other things."""
    if not is_shared(project):
        yield str(project), landlock.READ
        return
    for path in files_beside(project):
        yield str(path), landlock.READ


def is_shared(folder: Path) -> bool:
    """Whether this folder also contains things that do not belong to the program.

    Args:
        folder: the folder, without links in its path.
    """
    others = (Path(_users_home()), home(), Path(tempfile.gettempdir()))
    return any(other.resolve().is_relative_to(folder) for other in others)


def _users_home() -> str:
    import pwd  # noqa: PLC0415 - POSIX only

    # Not $HOME, which the host has set to the temporary folder.
    return pwd.getpwuid(os.getuid()).pw_dir
