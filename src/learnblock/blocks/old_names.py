"""The names that skills had in the original LearnBlock, and in Spanish, with today's names.

Its third version put ``is_`` in front of questions; programs of the first two have the old names.
Spanish names are those of its Spanish blocks, which pupils type from memory.
"""

from collections.abc import Container, Mapping
from types import MappingProxyType

_LINES = tuple(
    f"{place}_{colour}_line"
    for place in ("center", "left", "right")
    for colour in ("black", "blue", "red")
)
_QUESTIONS = (
    *_LINES,
    *(f"{place}_face" for place in ("center", "down", "left", "right", "up")),
    *(f"{place}_obstacle" for place in ("back", "front", "left", "right")),
    *(f"there_{colour}_line" for colour in ("black", "blue", "red")),
    "there_face",
    "line_crossing",
    "obstacle_free",
)
_FEELINGS = ("angry", "disgusted", "happy", "neutral", "sad", "scared", "surprised")
_SPANISH = {
    "desacelerar": "slow_down",
    "estoy_girando": "is_turning",
    "girar": "turn",
    "girar_derecha": "turn_right",
    "girar_izquierda": "turn_left",
    "mas_despacio": "slow_down",
    "mirar_frente": "look_front",
    "mirar_suelo": "look_floor",
    "mover_derecha": "move_right",
    "mover_izquierda": "move_left",
    "mover_recto": "move_straight",
    "no_hay_obstaculo": "is_obstacle_free",
    "no_hay_obstaculos": "is_obstacle_free",
    "obstaculo_frontal": "is_front_obstacle",
    "obstaculo_izquierda": "is_left_obstacle",
    "obstaculo_derecha": "is_right_obstacle",
    "obstaculo_detras": "is_back_obstacle",
    "hay_obstaculo_delante": "is_front_obstacle",
    "hay_obstaculo_izquierda": "is_left_obstacle",
    "hay_obstaculo_derecha": "is_right_obstacle",
    "hay_obstaculo_detras": "is_back_obstacle",
    "parar": "stop_bot",
    "expresar_alegria": "expressJoy",
    "expresar_asco": "expressDisgust",
    "expresar_enfado": "expressAnger",
    "expresar_miedo": "expressFear",
    "expresar_neutral": "expressNeutral",
    "expresar_sorpresa": "expressSurprise",
    "expresar_tristeza": "expressSadness",
}
_MESSAGES = {
    "publish": "send",
    "send_message": "send",
    "subscribe": "received",
    "receive_message": "received",
}
_COLOURS = {"azul": "blue", "negra": "black", "roja": "red"}
_PLACES = {"centro": "center", "derecha": "right", "izquierda": "left"}

#: Today's name of a skill, by its old or Spanish name.
OLD_NAMES: Mapping[str, str] = MappingProxyType(
    {
        **{name: f"is_{name}" for name in _QUESTIONS},
        **{f"is_there_somebody_{feeling}": f"is_any_face_{feeling}" for feeling in _FEELINGS},
        **{
            f"linea_{colour}_{place}": f"is_{today}_{shade}_line"
            for colour, shade in _COLOURS.items()
            for place, today in _PLACES.items()
        },
        **_SPANISH,
        **_MESSAGES,
    }
)


def todays_name(name: str, skills: Container[str]) -> str | None:
    """Today's name of a skill with an old or Spanish name; None if `skills` lacks it."""
    name_today = OLD_NAMES.get(name) or OLD_NAMES.get(name.casefold())
    return name_today if name_today is not None and name_today in skills else None
