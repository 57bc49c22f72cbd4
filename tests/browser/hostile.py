"""Messages that our page never sends to the server."""

import json
import random

from example_messages import examples
from learnblock.server.pages.page import MessageError, decode

#: Every message of a page, with valid values.
MESSAGES = examples()
WRONG = (
    None, True, -1, 10**30, 10**400, 1.5e308, float("inf"), float("nan"), "", "\0", "x" * 2000,
    "../../etc/passwd", [], [[[]]], {}, {"": {}}, ["a", 1, None], {"kind": "Open"}, "🤖", "\ud800",
)  # fmt: skip


def malformed(chance):
    """Return something that is not a message."""
    while True:
        message = chance.choice(WAYS)(chance)
        try:
            decode(message)
        except MessageError:
            return message


def disordered(chance):
    """Return a message sent at the wrong time or about something missing."""
    kind = chance.choice(tuple(MESSAGES))
    values = dict(MESSAGES[kind])
    if values and chance.random() < 0.3:
        values[chance.choice(tuple(values))] = chance.choice(WRONG)
    return json.dumps({"kind": kind, **values})


def _noise(chance):
    return chance.randbytes(chance.randint(0, 200))


def _letters(chance):
    return "".join(chr(chance.randint(0, 0xD7FF)) for _ in range(chance.randint(0, 100)))


def _other_json(chance):
    return json.dumps(chance.choice(WRONG))


def _of_no_kind(chance):
    return json.dumps({"kind": chance.choice(WRONG), "name": chance.choice(WRONG)})


def _with_wrong_values(chance):
    kind = chance.choice(tuple(MESSAGES))
    wrong = {name: chance.choice(WRONG) for name in MESSAGES[kind]}
    return json.dumps({"kind": kind, **MESSAGES[kind], **wrong})


def _with_too_few_values(chance):
    kind = chance.choice(tuple(MESSAGES))
    kept = chance.sample(tuple(MESSAGES[kind]), k=len(MESSAGES[kind]) // 2)
    return json.dumps({"kind": kind, **{name: MESSAGES[kind][name] for name in kept}})


def _cut_off(chance):
    message = json.dumps({"kind": (kind := chance.choice(tuple(MESSAGES))), **MESSAGES[kind]})
    return message[: chance.randrange(len(message))]


def _deep(chance):
    opening, closing = chance.choice((("[", "]"), ('{"a":', "}")))
    depth = chance.choice((10, 1000, 5000))
    inner = opening * depth + "1" + closing * chance.choice((0, depth))
    return chance.choice((inner, f'{{"kind": "SaveWorld", "name": "w", "world": {inner}}}'))


WAYS = (
    _noise,
    _letters,
    _other_json,
    _of_no_kind,
    _with_wrong_values,
    _with_too_few_values,
    _cut_off,
    _deep,
)


def stream(say, count, seed):
    """Return `count` messages made by `say`."""
    chance = random.Random(seed)  # noqa: S311 - repeatable, not secret
    return [say(chance) for _ in range(count)]
