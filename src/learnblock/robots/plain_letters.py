"""Text for screens whose fonts have no accents."""

import unicodedata

_LEFT_OUT = {ord("¡"): "", ord("¿"): ""}


def in_ascii(text: str) -> str:
    """The text without accents; letters without an equivalent in ASCII become question marks.

    >>> in_ascii("¿Dónde estás, 名?")
    'Donde estas, ??'
    """
    parts = unicodedata.normalize("NFKD", text)
    letters = "".join(part for part in parts if not unicodedata.combining(part))
    return letters.translate(_LEFT_OUT).encode("ascii", "replace").decode()
