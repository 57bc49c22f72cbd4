"""HTML from values that may be hostile: everything is text unless it was made here."""

import html
import re

#: Control characters, and those that change the direction of the text after them.
_HIDDEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069\ud800-\udfff]"
)


def escaped(text: object) -> str:
    """A text for HTML, between tags or in an attribute in double quotes."""
    return html.escape(_HIDDEN.sub("\ufffd", str(text)))


def tag(name: str, *inner: str, **attributes: object) -> str:
    """An element.

    Args:
        name: its tag.
        inner: HTML inside it.
        attributes: values of its attributes, any text; `class_` is its class.
    """
    values = "".join(
        f' {key.rstrip("_").replace("_", "-")}="{escaped(value)}"'
        for key, value in attributes.items()
        if value is not None
    )
    return f"<{name}{values}>{''.join(inner)}</{name}>"
