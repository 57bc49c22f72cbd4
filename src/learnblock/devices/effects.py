"""Sound effects for games: each is a few tones, one after the other."""

import json
from collections.abc import Mapping
from importlib.resources import files
from types import MappingProxyType

#: The tones of each effect by its name, as (hertz, milliseconds); the page plays the same.
EFFECTS: Mapping[str, tuple[tuple[float, float], ...]] = MappingProxyType(
    {
        name: tuple((hertz, milliseconds) for hertz, milliseconds in tones)
        for name, tones in json.loads(
            (files(__package__) / "effects.json").read_text("utf-8")
        ).items()
    }
)
