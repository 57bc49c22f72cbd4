"""What a robot's driver may do on the computer that runs it."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Rights:
    """What a driver may do, in addition to computing and reading files: by default nothing.

        class Robot(RealRobot[Settings]):
            rights = Rights(network=True, devices=("/dev/ttyACM*",))

    A program can give a driver any value. So the host of a run gives up everything else before it
    creates the robot, as far as the system allows: see `learnblock.runtime.containment.driver`.

    Args:
        network: use sockets of any kind: IP, Bluetooth, local services.
        programs: start other programs, such as espeak-ng or a `guardian`.
        devices: device files to open for writing, as patterns such as ``/dev/ttyUSB*``. Those in
            the user's settings of the robot need not be listed.
        folders: folders in which to change anything.
    """

    network: bool = False
    programs: bool = False
    devices: tuple[str, ...] = ()
    folders: tuple[str, ...] = ()

    def __or__(self, others: "Rights") -> "Rights":
        return Rights(
            self.network or others.network,
            self.programs or others.programs,
            (*self.devices, *others.devices),
            (*self.folders, *others.folders),
        )
