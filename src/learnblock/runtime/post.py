"""The messages between the robots of one run, on the host's side."""

import threading
from collections import deque
from dataclasses import dataclass
from typing import Any, NamedTuple

from learnblock.client.mailbox import MOST_WAITING


class Letter(NamedTuple):
    """A message on its way; `step` is that of the sender's world, or None for a real robot."""

    name: str
    value: Any
    step: int | None

    def has_arrived(self, step: int | None) -> bool:
        """Whether a robot can read it at this step of its world.

        In one world a message takes a step: programs that continue at the same step do so one
        after the other, and must all find the same.
        """
        return step is None or self.step is None or self.step < step


class Post:
    """Delivers messages between robots; real ones may use it from several threads.

    Args:
        robots: how many there are.
    """

    def __init__(self, robots: int) -> None:
        self._waiting = [deque[Letter](maxlen=MOST_WAITING) for _ in range(robots)]
        self._lock = threading.Lock()

    def box(self, robot: int) -> "PostBox":
        """The box of a robot, by its number from 0."""
        return PostBox(self, robot)

    def send(self, sender: int, letter: Letter) -> None:
        """Deliver a message to all other robots."""
        with self._lock:
            for robot, waiting in enumerate(self._waiting):
                if robot != sender:
                    waiting.append(letter)

    def collect(self, robot: int, step: int | None) -> list[tuple[str, Any]]:
        """Hand over what has arrived for a robot, in the order in which it was sent."""
        with self._lock:
            waiting = self._waiting[robot]
            arrived = [letter for letter in waiting if letter.has_arrived(step)]
            later = [letter for letter in waiting if not letter.has_arrived(step)]
            waiting.clear()
            waiting.extend(later)
        return [(letter.name, letter.value) for letter in arrived]


@dataclass(frozen=True, slots=True)
class PostBox:
    """The messages from and to one robot.

    Args:
        post: delivers them.
        robot: its number, from 0.
    """

    post: Post
    robot: int

    def send(self, name: str, value: Any, step: int | None) -> None:
        """Send a message to all other robots, at a step of the sender's world."""
        self.post.send(self.robot, Letter(name, value, step))

    def collect(self, step: int | None) -> list[tuple[str, Any]]:
        """Take the messages that have arrived at a step of the robot's world."""
        return self.post.collect(self.robot, step)
