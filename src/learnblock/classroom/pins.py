"""Four pictures as a PIN, which young children remember more easily than digits."""

import hashlib
import hmac
import secrets
from collections.abc import Sequence
from typing import Annotated, Literal, Self, get_args

import msgspec

Picture = Literal[
    "apple", "boat", "car", "cloud", "fish", "flower", "heart", "house", "key", "moon", "star",
    "sun", "tree", "umbrella", "ball", "bell",
]  # fmt: skip
PICTURES: tuple[Picture, ...] = get_args(Picture)
#: The pictures of a PIN.
LENGTH = 4
Pictures = Annotated[tuple[Picture, ...], msgspec.Meta(min_length=LENGTH, max_length=LENGTH)]

#: RFC 7914's parameters for interactive logins: 16 MB and some hundredths of a second for a try.
COST = {"n": 2**14, "r": 8, "p": 1}


# Why: docs/decisions.md, "Pictures instead of passwords"
class Pin(msgspec.Struct, frozen=True):
    """A PIN that can be checked, but not read.

    Args:
        salt: a random word in hexadecimal.
        hashed: scrypt's hash of the pictures with it, in hexadecimal.
    """

    salt: str
    hashed: str

    @classmethod
    def of(cls, pictures: Sequence[Picture]) -> Self:
        """Hash the pictures with a new salt."""
        salt = secrets.token_hex(16)
        return cls(salt, _hashed(salt, pictures))

    def fits(self, pictures: Sequence[Picture]) -> bool:
        """Whether these are the pictures; it always takes the same time."""
        return hmac.compare_digest(self.hashed, _hashed(self.salt, pictures))


def new_pictures() -> tuple[Picture, ...]:
    """Four random pictures, all different."""
    return tuple(secrets.SystemRandom().sample(PICTURES, LENGTH))


def _hashed(salt: str, pictures: Sequence[Picture]) -> str:
    return hashlib.scrypt(" ".join(pictures).encode(), salt=salt.encode(), **COST).hex()
