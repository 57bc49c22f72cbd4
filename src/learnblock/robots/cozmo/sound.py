"""Cozmo's sounds: tones, notes, effects, the user's files, and speech by espeak-ng."""

import shutil
import subprocess
import wave
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from learnblock.devices.effects import EFFECTS
from learnblock.errors import DeviceValueError, LearnBlockError, nearest
from learnblock.storage.home import home

RATE = 22050
"""Samples per second."""
FRAME_LENGTH = 744
"""Samples in a packet; the robot plays 30 packets per second (pycozmo.audio)."""
LONGEST_TONE = 60.0
"""Seconds."""
FADE = 0.005
"""Seconds in which a tone fades in and out, to avoid a click."""

NOTES: Final = {
    "Do": 261.63, "Re": 293.66, "Mi": 329.63, "Fa": 349.23, "Sol": 392.0, "La": 440.0, "Si": 493.88,
}  # fmt: skip
"""Frequencies in hertz of the octave in the middle of a piano."""
NOTE_LENGTH = 0.5
"""Seconds."""

# u-law with a bias of 132, as in pycozmo.audio.
_BIAS = 132
_LOUDEST = 0x7FFF

Samples = NDArray[np.int16]


def tone(hertz: float, seconds: float) -> Samples:
    """A pure tone at half volume."""
    count = round(RATE * min(max(seconds, 0.0), LONGEST_TONE))
    wave_ = np.sin(2 * np.pi * hertz * np.arange(count) / RATE)
    fading = np.minimum(np.arange(count), np.arange(count)[::-1]) / (FADE * RATE)
    return (0.5 * _LOUDEST * wave_ * np.minimum(fading, 1.0)).astype(np.int16)


def named(name: str) -> Samples:
    """A note, such as ``Do``, an effect, such as ``coin``, or a file in the user's ``sounds``.

    Raises:
        DeviceValueError: there is no such sound, or the file cannot be played.
    """
    if name in NOTES:
        return tone(NOTES[name], NOTE_LENGTH)
    folder = home() / "sounds"
    files = {path.stem: path for path in sorted(folder.glob("*.wav"))}
    if name in files:
        return read(files[name])
    if name in EFFECTS:
        return joined([tone(hertz, milliseconds / 1000) for hertz, milliseconds in EFFECTS[name]])
    suggestion = nearest(name, [*NOTES, *EFFECTS, *files])
    if suggestion is None:
        raise DeviceValueError("cozmo-unknown-sound", name=name, folder=str(folder))
    raise DeviceValueError("cozmo-unknown-sound-like", name=name, suggestion=suggestion)


def read(path: Path) -> Samples:
    """The sound in a WAV file of any rate with 8 or 16 bits per sample.

    Raises:
        DeviceValueError: the file cannot be read.
    """
    try:
        return _wav(path.read_bytes())
    except (OSError, EOFError, ValueError, wave.Error) as error:
        raise DeviceValueError("cozmo-bad-sound", file=str(path)) from error


def speech(text: str, voice: str) -> Samples:
    """Spoken text.

    Args:
        text: the text to say.
        voice: a voice of espeak-ng, such as ``en``.

    Raises:
        LearnBlockError: espeak-ng cannot speak it.
    """
    command = ["espeak-ng", "--stdin", "--stdout", "-v", voice]
    try:
        spoken = subprocess.run(  # noqa: S603 - the text comes by stdin, the voice is an argument
            command, input=text.encode(), capture_output=True, check=True, timeout=10
        )
        return _wav(spoken.stdout)
    except subprocess.CalledProcessError as error:
        reason = error.stderr.decode(errors="replace").strip()
        raise LearnBlockError("cozmo-bad-voice", voice=voice, reason=reason) from error
    except (OSError, EOFError, ValueError, subprocess.TimeoutExpired, wave.Error) as error:
        raise LearnBlockError("cozmo-no-speech", reason=str(error)) from error


def can_speak() -> bool:
    """Whether espeak-ng is installed."""
    return shutil.which("espeak-ng") is not None


def packed(samples: Samples) -> list[bytes]:
    """Samples as the contents of packets; the last one is padded with silence."""
    missing = -len(samples) % FRAME_LENGTH
    coded = _u_law(np.concatenate((samples, np.zeros(missing, np.int16)))).tobytes()
    return [coded[start : start + FRAME_LENGTH] for start in range(0, len(coded), FRAME_LENGTH)]


def joined(parts: Sequence[Samples]) -> Samples:
    """Several sounds in sequence."""
    return np.concatenate([*parts, np.zeros(0, np.int16)])


def _u_law(samples: Samples) -> NDArray[np.uint8]:
    """Samples in the robot's encoding: sign, exponent and four bits, plus one.

    pycozmo's encoder exceeds 255 for the loudest negative samples, and fails.
    """
    loudness = np.minimum(np.abs(samples.astype(np.int32)) + _BIAS, _LOUDEST)
    exponent = np.floor(np.log2(loudness)).astype(np.int32)
    mantissa = (loudness >> (exponent - 4)) & 0x0F
    sign = np.where(samples < 0, 0x80, 0)
    coded: NDArray[np.int32] = (sign | (exponent - 7) << 4 | mantissa) + 1
    return np.minimum(coded, 0xFF).astype(np.uint8)


def _wav(content: bytes) -> Samples:
    with wave.open(BytesIO(content)) as file:
        width, channels, rate = file.getsampwidth(), file.getnchannels(), file.getframerate()
        # espeak-ng writes to a pipe, so the header's length is wrong: read everything.
        raw = file.readframes(min(file.getnframes(), len(content)))
    if width not in {1, 2}:
        raise ValueError(f"{8 * width} bits per sample")
    samples: NDArray[Any] = np.frombuffer(raw, np.uint8 if width == 1 else "<i2")
    if width == 1:
        samples = (samples.astype(np.int32) - 128) << 8
    mono = samples[: len(samples) // channels * channels].reshape(-1, channels).mean(axis=1)
    count = round(len(mono) * RATE / rate)
    if not count:
        raise ValueError("no samples")
    resampled: Samples = np.interp(
        np.arange(count) * rate / RATE, np.arange(len(mono)), mono
    ).astype(np.int16)
    return resampled
