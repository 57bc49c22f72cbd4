"""iRobot's education robots, Root and Create 3, by Bluetooth.

Both understand the same packets (`packets`, `messages`). `PacketLink` sends and hears them, and
`IRobot` is what their drivers share.
"""

from learnblock.robots.irobot.robot import IRobot, IRobotSettings

__all__ = ["IRobot", "IRobotSettings"]
