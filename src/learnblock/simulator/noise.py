"""Noise that depends only on the measurement and its time.

Each value is a hash of robot, sensor and step. Reading a sensor twice in a step thus gives the same
value, and neither other robots or sensors nor the order of reading change it. No library's random
generator is used, because their streams differ between versions.
"""

from dataclasses import dataclass
from functools import lru_cache
from hashlib import blake2b
from statistics import NormalDist

_inverse = NormalDist().inv_cdf


@dataclass(frozen=True, slots=True)
class Noise:
    """The noise of one robot in one world.

    Args:
        seed: the world's seed.
        robot: the robot's name.
        factor: by which all its sensors' noise is multiplied.
    """

    seed: int
    robot: str
    factor: float = 1.0

    def bits(self, sensor: str, step: int) -> int:
        """64 random bits for this sensor at this step."""
        value = _begun(self.seed, self.robot, sensor).copy()
        value.update(b"%d" % step)
        return int.from_bytes(value.digest(), "big")

    def normal(self, sensor: str, step: int = 0) -> float:
        """A normally distributed number with mean 0 and the factor as standard deviation."""
        # 52 bits leave room for adding one half, which keeps the value between 0 and 1 exclusively.
        share = ((self.bits(sensor, step) >> 12) + 0.5) / 2**52
        return self.factor * _inverse(share)


@lru_cache(maxsize=1024)
def _begun(seed: int, robot: str, sensor: str) -> blake2b:
    """The hash of what all values of a sensor begin with."""
    return blake2b(f"{seed}\0{robot}\0{sensor}\0".encode(), digest_size=8)
