"""What a class of robots announces before one of them is connected."""

from typing import ClassVar

from learnblock import senses
from learnblock.client.rights import Rights
from learnblock.errors import SettingsError
from learnblock.wheels import Drivetrain

#: An ability that only an adult gives to a real camera: the law may forbid it.
_EMOTIONS = frozenset({"Camera:emotions"})


class Announced:
    """The devices of a kind of robot and what its driver may do, for checks before a run."""

    #: Whether the robot gets the camera that the user's settings add to every robot.
    has_extra_camera: ClassVar[bool] = True
    #: Whether its camera sees only drawn and simulated faces.
    sees_drawn_faces: ClassVar[bool] = False
    #: What its driver may do on the computer, in addition to reading files.
    rights: ClassVar[Rights] = Rights()

    @classmethod
    def device_names(cls) -> frozenset[str] | None:
        """Devices that every such robot has (``Type:KEY``); None if unknown before connecting."""
        return None

    @classmethod
    def abilities(cls) -> frozenset[str] | None:
        """What its devices can do that not every robot's can, such as ``Speaker:say``.

        `learnblock.senses.ABILITIES` lists what there is. None means all of it.
        """
        return None

    @classmethod
    def drivetrain(cls) -> Drivetrain | None:
        """What the wheels of every such robot can do; None if unknown before connecting."""
        return None

    @classmethod
    def known_equipment(cls) -> frozenset[str] | None:
        """`known_devices` with their types and abilities, for checks; None if unknown."""
        names = cls.known_devices()
        if names is None:
            return None
        equipment = senses.equipment(names, cls.abilities()) - _EMOTIONS
        return equipment | _EMOTIONS if cls._recognises_emotions(names) else equipment

    @classmethod
    def _recognises_emotions(cls, names: frozenset[str]) -> bool:
        if not any(name.startswith("Camera:") for name in names):
            return False
        # A camera that the user's settings add is a real one.
        is_drawn = cls.sees_drawn_faces and "Camera:ROBOT" in names
        from learnblock.perception.settings import TABLE  # noqa: PLC0415 - rarely used

        try:
            return TABLE.load().permits("emotions", drawn=is_drawn)
        except SettingsError:
            # As in `known_devices`.
            return False

    @classmethod
    def known_devices(cls) -> frozenset[str] | None:
        """`device_names` plus the camera that the user's settings add."""
        names = cls.device_names()
        if names is None or not cls.has_extra_camera:
            return names
        from learnblock.client.extra_camera import extra_devices  # noqa: PLC0415 - rarely used

        try:
            return names | extra_devices(names)
        except SettingsError:
            # The error is raised when the robot is connected.
            return names

    @classmethod
    def known_rights(cls) -> Rights:
        """`rights` plus those that the user's settings add."""
        if not cls.has_extra_camera:
            return cls.rights
        from learnblock.client.extra_camera import extra_rights  # noqa: PLC0415 - rarely used

        try:
            return cls.rights | extra_rights()
        except SettingsError:
            # As in `known_devices`.
            return cls.rights
