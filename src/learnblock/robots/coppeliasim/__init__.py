"""CoppeliaSim, which was V-REP: a robot in one of its scenes, by its ZeroMQ remote API.

Version 4.6 or later is needed; the remote API of V-REP 3 was another one. The setting `scene` says
which robot is driven: that of our own script, the paper's, or any one by the names of its parts.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, closing
from importlib.resources import files
from typing import Any

from learnblock.errors import MissingPackageError, RobotConnectionError
from learnblock.files import save
from learnblock.home import home
from learnblock.robots import settings as user_settings
from learnblock.robots.coppeliasim import named_parts, paper_scene
from learnblock.robots.coppeliasim.heartbeat import Heartbeat
from learnblock.robots.coppeliasim.named_parts import NamedParts
from learnblock.robots.coppeliasim.paper_scene import PaperScene
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.robots.coppeliasim.scene import Scene
from learnblock.robots.coppeliasim.script_scene import ScriptScene
from learnblock.robots.coppeliasim.settings import Settings
from learnblock.robots.coppeliasim.simulation import Simulation
from learnblock.robots.guardian import Guardian
from learnblock.robots.real import RealRobot

__all__ = ["Robot", "Settings"]

_SCENES: Mapping[str, Callable[[Remote, Settings], Scene]] = {
    "names": NamedParts,
    "paper": PaperScene,
    "script": ScriptScene,
}

_HOW_TO_LOAD = """\
The script lies in {path}
In CoppeliaSim, with a scene that has a floor:
  1. Add > Dummy, and rename it to LearnBlock.
  2. Select it, then Add > Script > Simulation script > Non threaded > Lua
     (before version 4.7: Add > Associated child script > Non threaded > Lua).
  3. Double-click the script's icon, replace all of its text by that of the file, and close it.
  4. Press play: a robot appears where the dummy is. Save the scene.
Then: learnblock robots test coppeliasim"""


class Robot(RealRobot[Settings]):
    """A robot in a scene of CoppeliaSim.

    What is not in `device_names` its scene tells once it is connected.
    """

    settings_type = Settings

    @classmethod
    def device_names(cls) -> frozenset[str] | None:
        """Known beforehand for the scenes whose script does not tell, as the settings are saved."""
        settings = user_settings.load(cls.name(), Settings)
        if settings.scene == "paper":
            return paper_scene.DEVICES
        return named_parts.devices_of(settings) if settings.scene == "names" else None

    def connect(self) -> None:
        settings = self.settings
        self._ending = ExitStack()
        remote = Remote(settings.address, settings.port, settings.patience)
        self._ending.callback(remote.close)
        remote.open()
        simulation = Simulation(remote, settings.patience)
        self._ending.callback(simulation.end)
        simulation.start()
        scene = _SCENES[settings.scene](remote, settings)
        if not scene.has_watchdog:
            self._ending.callback(_relieve, Guardian(type(self), settings), remote)
        for device, key in scene.devices():
            self.add(device, key)

        def beat() -> None:
            simulation.check()
            scene.beat()

        self._heartbeat = Heartbeat(beat)
        self._ending.callback(self._heartbeat.stop)

    @classmethod
    def halt(cls, settings: Settings) -> None:
        """Stop the motors of a robot whose program is gone.

        Raises:
            RobotConnectionError: it cannot be reached.
        """
        with closing(Remote(settings.address, settings.port, settings.patience)) as remote:
            remote.open()
            _SCENES[settings.scene](remote, settings).move(0, 0)

    def disconnect(self) -> None:
        self._ending.close()

    def check_link(self) -> None:
        self._heartbeat.check()

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:
        """Ask where the settings say that it runs, by default on this machine."""
        saved = user_settings.load(cls.name(), Settings)
        try:
            with closing(Remote(saved.address, saved.port, seconds)) as remote:
                remote.open()
        except (MissingPackageError, RobotConnectionError):
            return
        yield {"address": saved.address, "port": saved.port}

    @classmethod
    def set_up(cls, settings: Settings, tell: Callable[[str], object]) -> None:  # noqa: ARG003
        """Copy our scene script to where the user finds it, and say how it gets into a scene."""
        path = home() / "coppeliasim" / "scene.lua"
        save(path, files(__package__).joinpath("scene.lua").read_bytes())
        tell(_HOW_TO_LOAD.format(path=path))


def _relieve(guardian: Guardian, remote: Remote) -> None:
    """At the end its motors stand, unless it could not be told."""
    if remote.is_lost:
        guardian.leave_in_charge()
    else:
        guardian.dismiss()
