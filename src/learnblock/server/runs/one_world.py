"""What a page shows of several robots in one world, written once for all of them."""

from collections.abc import Mapping, Sequence
from typing import Any

from msgspec import to_builtins

from learnblock.i18n import with_languages
from learnblock.server import messages

#: Decimals of mm, degrees and readings: more can't be seen, and hardly be compressed.
DECIMALS = 3


def plain(past: messages.Past) -> dict[str, Any]:
    """A moment as plain data, with the world as exactly as it can be seen."""
    data: dict[str, Any] = to_builtins(past, enc_hook=with_languages)
    if telemetry := data.get("telemetry"):
        data["telemetry"] = _rounded(telemetry)
    return data


def shared_states(robots: Sequence[Mapping[str, Any]]) -> list[tuple[float, Any]]:
    """Take the states of all robots out of the moments of each; return them by time in s.

    At a time, each robot has the same state in the moments of all.
    """
    states: dict[float, Any] = {}
    for robot in robots:
        for moment in robot["moments"]:
            past = moment["past"]
            of_all = past["telemetry"].pop("robots")
            states.setdefault(past["time"], sorted(of_all, key=lambda state: state["name"]))
    return sorted(states.items())


def thinned(content: Mapping[str, Any]) -> dict[str, Any]:
    """The content of a page with every other moment, the same ones of all robots."""
    times = [time for time, _ in content["states"]]
    ends = {moments[index]["past"]["time"] for moments in _moments(content) for index in (0, -1)}
    kept = {*times[::2], *ends}
    robots = [
        {**robot, "moments": [moment for moment in moments if moment["past"]["time"] in kept]}
        for robot, moments in zip(content["robots"], _moments(content), strict=True)
    ]
    states = [(time, state) for time, state in content["states"] if time in kept]
    return {**content, "robots": robots, "states": states}


def _moments(content: Mapping[str, Any]) -> list[list[dict[str, Any]]]:
    return [robot["moments"] for robot in content["robots"]]


def _rounded(data: Any) -> Any:
    if isinstance(data, float):
        return round(data, DECIMALS)
    if isinstance(data, dict):
        return {key: _rounded(value) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [_rounded(value) for value in data]
    return data
