"""What Root's colour strip sees before anything under it has changed.

Root names the colours of its strip only when one changes, and no message asks for them. It is asked
instead how much light reaches each sensor, with and without the light of the strip itself.
"""

from statistics import median

from learnblock.robots.irobot import messages
from learnblock.robots.irobot.link import PacketLink

#: What reflects less than this share of the brightest part of the floor is dark.
SHARE = 0.5


def first_look(link: PacketLink) -> list[int]:
    """What each of the 32 sensors sees: black or white; on a floor of one brightness, white.

    Raises:
        RobotConnectionError: the robot is gone.
    """
    # The robot's body keeps all other light away from the strip.
    unlit = link.probe(messages.strip_levels(0, messages.UNLIT))
    lit = [
        link.probe(messages.strip_levels(bank, messages.ALL_LIT)) for bank in range(messages.BANKS)
    ]
    if unlit is None or None in lit:
        # Firmware that does not answer.
        return [messages.WHITE] * messages.COLOURS
    darkness = median(messages.levels(unlit))
    # Whether a level rises or falls with light is not documented.
    reflected = [abs(level - darkness) for bank in lit if bank for level in messages.levels(bank)]
    limit = SHARE * max(reflected)
    return [messages.BLACK if level < limit else messages.WHITE for level in reflected]
