"""Check that a client keeps the rules for every robot.

    >>> from learnblock.devices import Base
    >>> from learnblock.testing import FakeRobot, check_robot
    >>> certificate = check_robot(lambda: FakeRobot(only=[Base]))
    >>> certificate.passed
    True

For your own robot, with a link that can be made to fail between the client and the robot:

    with Relay((address, port)) as relay:
        print(check_robot(lambda: Robot(address="127.0.0.1", port=relay.port), relay=relay))
"""

import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass

from learnblock.testing import device_claims, driving_claims, ending_claims, link_claims
from learnblock.testing.bench import Bench, BrokenClaimError, Make, SkippedClaimError
from learnblock.testing.relay import Relay


class NotConformingError(AssertionError):
    """A client breaks a rule; the certificate in the message shows which one."""


@dataclass(frozen=True, slots=True)
class Finding:
    """The result of checking one claim.

    Args:
        claim: one sentence.
        outcome: ``holds``, ``broken``, ``excused``, or ``skipped`` if the robot lacks the device.
        detail: the measurement, or why the claim is broken, excused or skipped.
    """

    claim: str
    outcome: str
    detail: str = ""


@dataclass(frozen=True, slots=True)
class Certificate:
    """The results of all claims; its text is a table for people."""

    robot: str
    findings: tuple[Finding, ...]

    @property
    def passed(self) -> bool:
        return not any(finding.outcome == "broken" for finding in self.findings)

    def __str__(self) -> str:
        verdict = "conforms" if self.passed else "does not conform"
        lines = [
            f"{finding.outcome:<8} {finding.claim:<58} {finding.detail}"
            for finding in self.findings
        ]
        return "\n".join([f"{self.robot} {verdict}", *(line.rstrip() for line in lines)])


# Why: docs/decisions.md, "Every robot keeps the same promises"
def check_robot(
    make_robot: Make,
    *,
    relay: Relay | None = None,
    excused: Mapping[str, str] | None = None,
    patience: float = 5.0,
    claims: Collection[str] | None = None,
) -> Certificate:
    """Check the claims about a client.

    The robot drives forward for one second at 50 mm/s and turns right by 45 degrees, several times.

    Args:
        make_robot: returns a connected client. It is called many times, and only the check of a
            second client calls it while another client is connected.
        relay: the link between client and robot, to check what happens when it fails; None skips
            these claims.
        excused: claims that may be broken, with the reason.
        patience: the timeout in seconds for connecting, for noticing a lost link, and for stopping.
        claims: the claims to check, such as `LINK_CLAIMS`; all of them by default.

    Raises:
        NotConformingError: a claim is broken.
    """
    bench = Bench(make_robot, relay, patience)
    with bench.robot() as robot:
        name = re.sub(r".*\.(\w+)\.\w+$", r"\1", f"{type(robot).__module__}.{type(robot).__name__}")
    findings = [
        _finding(bench, claim, check, excused or {})
        for claim, check in _CLAIMS.items()
        if claims is None or claim in claims
    ]
    certificate = Certificate(name, tuple(findings))
    if not certificate.passed:
        raise NotConformingError(str(certificate))
    return certificate


def _finding(
    bench: Bench, claim: str, check: Callable[[Bench], str], excused: Mapping[str, str]
) -> Finding:
    if claim in excused:
        return Finding(claim, "excused", excused[claim])
    if claim in LINK_CLAIMS and bench.relay is None:
        # Before a robot is connected in vain.
        return Finding(claim, "skipped", "no relay was given")
    try:
        return Finding(claim, "holds", check(bench))
    except SkippedClaimError as reason:
        return Finding(claim, "skipped", str(reason))
    except BrokenClaimError as problem:
        return Finding(claim, "broken", str(problem))
    except Exception as error:  # noqa: BLE001 - a client may raise any error
        return Finding(claim, "broken", f"{type(error).__name__}: {error}")


_LINK_CLAIMS: Mapping[str, Callable[[Bench], str]] = {
    "a missing robot is reported in time": link_claims.reports_missing_robot,
    "a silent link is reported in time": link_claims.reports_silence,
    "a cut link is reported in time": link_claims.reports_cut,
    "a link that damages data is reported in time": link_claims.reports_garbage,
    "a slow link works, or is reported": link_claims.handles_slowness,
}

_CLAIMS: Mapping[str, Callable[[Bench], str]] = {
    "it connects in time": device_claims.connects,
    "it has the devices it announces": device_claims.has_announced_devices,
    "its devices have words as keys": device_claims.has_words_as_keys,
    "its readings have the form and range of their device": device_claims.has_valid_readings,
    "its accelerometer shows 1 g upwards at rest": device_claims.measures_gravity,
    "its sensors can be read at least 5 times a second": device_claims.reads_often,
    "skills without their device have no effect": device_claims.ignores_missing_devices,
    "positive speed is forward": driving_claims.drives_forward,
    "positive rotation is to the right": driving_claims.turns_right,
    "its gyroscope reads 0 after a reset": driving_claims.resets_gyroscope,
    "its joints move to the commanded angle": driving_claims.moves_joints,
    "values that are not numbers are rejected": driving_claims.rejects_wrong_values,
    "its motors stop however the program ends": ending_claims.stops,
    "it can be stopped twice": ending_claims.stops_twice,
    "it can be connected again": ending_claims.reconnects,
    "a second client at the same time does not hang": ending_claims.answers_second_client,
    **_LINK_CLAIMS,
}

#: The names of all claims, for `excused`.
CLAIMS: Collection[str] = tuple(_CLAIMS)
#: Those about a link that fails, which need a relay.
LINK_CLAIMS: Collection[str] = tuple(_LINK_CLAIMS)
