"""The programs that may use the network, as the user's settings say."""

from pathlib import Path

from learnblock.storage.settings import Settings, Table


class NetworkSettings(Settings, frozen=True):
    """The table ``[network]``.

    Args:
        allowed: programs, and folders with all their programs.
    """

    allowed: tuple[str, ...] = ()


TABLE = Table(("network",), "the network", NetworkSettings)


def may_use_network(program: Path) -> bool:
    """Whether the user's settings allow a program the network.

    Raises:
        SettingsError: the user's file has a mistake.
    """
    return any(program.resolve().is_relative_to(_path(place)) for place in TABLE.load().allowed)


def folder_on_network(program: Path) -> str | None:
    """The folder in the user's settings that allows a program the network, if there is one.

    Raises:
        SettingsError: the user's file has a mistake.
    """
    above = program.resolve().parents
    return next((place for place in TABLE.load().allowed if _path(place) in above), None)


def allow_network(program: Path) -> None:
    """Allow a program the network, in the user's settings.

    Raises:
        SettingsError: the user's file has a mistake.
        OSError: it can't be written.
    """
    _replace(program, str(program.resolve()))


def forbid_network(program: Path) -> None:
    """Take a program's own permission away; one of its folder stays.

    Raises:
        SettingsError: the user's file has a mistake.
        OSError: it can't be written.
    """
    _replace(program)


def move_network(program: Path, target: Path) -> None:
    """Give a program's own permission, or the lack of one, to the file that it becomes.

    Raises:
        SettingsError: the user's file has a mistake.
        OSError: it can't be written.
    """
    allowed = program.resolve() in map(_path, TABLE.load().allowed)
    forbid_network(program)
    (allow_network if allowed else forbid_network)(target)


def _replace(program: Path, *names: str) -> None:
    """Write these names instead of all that mean a program."""
    before = TABLE.load().allowed
    others = (place for place in before if _path(place) != program.resolve())
    after = (*others, *names)
    if after != before:
        TABLE.change_all({"allowed": after})


def _path(place: str) -> Path:
    return Path(place).expanduser().resolve()
