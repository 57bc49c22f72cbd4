from statistics import fmean, stdev

import pytest

from learnblock.simulator.noise import Noise


def test_the_same_measurement_has_the_same_noise() -> None:
    assert Noise(3, "ebo").normal("gyroscope", 7) == Noise(3, "ebo").normal("gyroscope", 7)


@pytest.mark.parametrize(
    ("noise", "sensor", "step"),
    [
        (Noise(4, "ebo"), "gyroscope", 7),
        (Noise(3, "cozmo"), "gyroscope", 7),
        (Noise(3, "ebo"), "light", 7),
        (Noise(3, "ebo"), "gyroscope", 8),
    ],
)
def test_another_measurement_has_other_noise(noise: Noise, sensor: str, step: int) -> None:
    assert noise.normal(sensor, step) != Noise(3, "ebo").normal("gyroscope", 7)


def test_noise_is_pinned_to_these_values_on_every_machine() -> None:
    drawn = [round(Noise(0, "robot").normal("light", step), 9) for step in range(3)]

    assert drawn == [-0.125307642, 0.483229036, 0.593953624]


def test_noise_has_mean_0_and_standard_deviation_1() -> None:
    drawn = [Noise(0, "robot").normal("light", step) for step in range(4000)]

    assert fmean(drawn) == pytest.approx(0, abs=0.05)
    assert stdev(drawn) == pytest.approx(1, abs=0.05)
