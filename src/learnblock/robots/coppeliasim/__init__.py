"""CoppeliaSim, formerly V-REP: drives a robot in a scene over the ZeroMQ remote API.

It needs version 4.6 or later; V-REP 3 had a different remote API. The setting `scene` chooses the
robot: the one of our script, the one of the paper, or any robot by the names of its parts.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, closing
from importlib.resources import files
from typing import Any

from learnblock.client import Rights, skill_sets
from learnblock.devices import Base
from learnblock.errors import MissingPackageError, RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots import settings as user_settings
from learnblock.robots.coppeliasim import named_parts, paper_scene
from learnblock.robots.coppeliasim.named_parts import NamedParts
from learnblock.robots.coppeliasim.paper_scene import PaperScene
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.robots.coppeliasim.scene import RobotScene
from learnblock.robots.coppeliasim.script_scene import ScriptScene
from learnblock.robots.coppeliasim.settings import Settings
from learnblock.robots.coppeliasim.simulation import SceneSimulation
from learnblock.robots.guardian import Guardian
from learnblock.robots.heartbeat import Heartbeat
from learnblock.robots.real import RealRobot
from learnblock.storage.files import save
from learnblock.storage.home import home

__all__ = ["Robot", "Settings"]

_SCENES: Mapping[str, Callable[[Remote, Settings], RobotScene]] = {
    "names": NamedParts,
    "paper": PaperScene,
    "script": ScriptScene,
}


class Robot(RealRobot[Settings], skill_sets.Coppeliasim):
    """A robot in a scene of CoppeliaSim.

    The devices of a scene with our script are known only after connecting.
    """

    settings_type = Settings
    model = "ev3"
    add_on = ("coppeliasim_zmqremoteapi_client",)
    # Its guardian.
    rights = Rights(network=True, programs=True)

    @classmethod
    def device_names(cls) -> frozenset[str] | None:
        """The devices by the saved settings; None for a scene with our script."""
        settings = user_settings.load(cls.name(), Settings)
        if settings.scene == "paper":
            return paper_scene.DEVICES
        return named_parts.devices_of(settings) if settings.scene == "names" else None

    @classmethod
    def abilities(cls) -> frozenset[str] | None:
        """The sides to which it has sensors; None, which is all, for a scene with our script."""
        settings = user_settings.load(cls.name(), Settings)
        if settings.scene == "script":
            return None
        sides = ("front",) if settings.scene == "paper" else named_parts.sides_of(settings)
        return frozenset({"GroundSensors:line", *(f"DistanceSensors:{side}" for side in sides)})

    def connect(self) -> None:
        settings = self.settings
        self._ending = ExitStack()
        remote = Remote(settings.address, settings.port, settings.patience, self.steady_clock)
        self._ending.callback(remote.close)
        remote.open()
        simulation = SceneSimulation(remote, settings.patience, self.steady_clock)
        self._ending.callback(simulation.end)
        simulation.start()
        scene = _SCENES[settings.scene](remote, settings)
        self._guardian = (
            None if scene.has_watchdog else Guardian(type(self), settings, self.steady_clock)
        )
        if self._guardian is not None:
            self._ending.callback(_relieve, self._guardian, remote)
        for device, key in scene.devices():
            if isinstance(device, Base):
                device.functions["move"] = self._move(scene)
            self.add(device, key)

        def beat() -> None:
            simulation.check()
            scene.beat()

        self._heartbeat = Heartbeat(beat, self.steady_clock)
        self._ending.callback(self._heartbeat.stop)

    @classmethod
    def halt(cls, settings: Settings) -> None:
        """Stop the motors of a robot whose program is gone.

        Raises:
            RobotConnectionError: CoppeliaSim cannot be reached.
        """
        with closing(Remote(settings.address, settings.port, settings.patience)) as remote:
            remote.open()
            _SCENES[settings.scene](remote, settings).move(0, 0)

    def disconnect(self) -> None:
        self._ending.close()

    def check_link(self) -> None:
        if self._guardian is not None:
            self._guardian.check()
        self._heartbeat.check()

    def _move(self, scene: RobotScene) -> Callable[[float, float], None]:
        def move(adv: float, rot: float) -> None:
            if self._guardian is not None and (adv or rot):
                self._guardian.check()
            scene.move(adv, rot)

        return move

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        """Try the address in the settings, by default this computer."""
        saved = user_settings.load(cls.name(), Settings)
        try:
            with closing(Remote(saved.address, saved.port, seconds)) as remote:
                remote.open()
        except (MissingPackageError, RobotConnectionError):
            return
        yield {"address": saved.address, "port": saved.port}

    @classmethod
    def set_up(cls, settings: Settings, report: Callable[[Phrase], object]) -> None:  # noqa: ARG003
        """Copy our scene script to the user's folder, and explain how to add it to a scene."""
        path = home() / "coppeliasim" / "scene.lua"
        save(path, files(__package__).joinpath("scene.lua").read_bytes())
        report(Phrase("coppeliasim-setup-done", path=str(path)))


def _relieve(guardian: Guardian, remote: Remote) -> None:
    """Stop the guardian, unless the motors could not be stopped."""
    if remote.is_lost:
        guardian.leave_in_charge()
    else:
        guardian.dismiss()
