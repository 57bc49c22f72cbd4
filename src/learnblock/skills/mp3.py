"""A music player."""

from typing import TYPE_CHECKING

from learnblock.devices import MP3

if TYPE_CHECKING:
    from learnblock.client import Client


def select_audio(robot: "Client", folder: int, song: int) -> None:
    """Choose the song that the music player plays.

    Args:
        folder: the number of the folder the song is in.
        song: its number in the folder.
    """
    player = robot.device(MP3)
    if player is not None:
        player.select(folder, song)


def send_action(robot: "Client", action: str = "Play") -> None:
    """Press a button of the music player.

    Args:
        action: what to do, such as ``Play`` or ``Pause``.
    """
    player = robot.device(MP3)
    if player is not None:
        player.action(action)


def modify_volume(robot: "Client", volume: int = 5) -> None:
    """Make the music louder or softer.

    Args:
        volume: 0 (silent) to 100.
    """
    player = robot.device(MP3)
    if player is not None:
        player.volume(volume)


def modify_EQ(robot: "Client", EQ: str = "NO") -> None:
    """Change the sound of the music.

    Args:
        EQ: the equalizer's setting, such as ``NO``, ``Pop`` or ``Rock``.
    """
    player = robot.device(MP3)
    if player is not None:
        player.equalizer(EQ)


def modify_loop(robot: "Client", loop: str = "Loop all") -> None:
    """Choose what the music player repeats.

    Args:
        loop: what to repeat, such as ``Loop all``.
    """
    player = robot.device(MP3)
    if player is not None:
        player.loop(loop)
