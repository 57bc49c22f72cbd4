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
    places = (Path(place).expanduser().resolve() for place in TABLE.load().allowed)
    return any(program.resolve().is_relative_to(place) for place in places)
