"""The programs that may use the network, as the user's settings say."""

from collections.abc import Callable
from pathlib import Path

from learnblock.storage.settings import Settings, SettingsSection


class NetworkSettings(Settings, frozen=True):
    """The table ``[network]``.

    Args:
        allowed: programs, and folders with all their programs.
    """

    allowed: tuple[str, ...] = ()


TABLE = SettingsSection(("network",), "the network", NetworkSettings)


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
    _replace(lambda allowed: (*_without(program, allowed), str(program.resolve())))


def forbid_network(program: Path) -> None:
    """Take a program's own permission away; one of its folder stays.

    Raises:
        SettingsError: the user's file has a mistake.
        OSError: it can't be written.
    """
    _replace(lambda allowed: _without(program, allowed))


def move_network(program: Path, target: Path) -> None:
    """Give a program's own permission, or the lack of one, to the file that it becomes.

    Raises:
        SettingsError: the user's file has a mistake.
        OSError: it can't be written.
    """

    def moved(allowed: tuple[str, ...]) -> tuple[str, ...]:
        others = _without(program, allowed)
        name = () if others == allowed else (str(target.resolve()),)
        return (*_without(target, others), *name)

    _replace(moved)


def _replace(change: Callable[[tuple[str, ...]], tuple[str, ...]]) -> None:
    TABLE.update(lambda settings: {"allowed": change(settings.allowed)})


def _without(program: Path, allowed: tuple[str, ...]) -> tuple[str, ...]:
    """All that is allowed but the program itself, however it is written."""
    return tuple(place for place in allowed if _path(place) != program.resolve())


def _path(place: str) -> Path:
    return Path(place).expanduser().resolve()
