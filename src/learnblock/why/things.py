"""What distance sensors looked at: the things in the sentences of an answer."""

from collections.abc import Callable, Iterator
from dataclasses import replace

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase, Value
from learnblock.why.recorded import Recorded
from learnblock.why.sentences import Explanation, Sentence
from learnblock.why.wording import thing_phrase
from learnblock.why.world_again import WorldAgain

#: Finds the thing that a distance sensor looked at, by its side and the time in s.
Seen = Callable[[str, float], str | None]
#: A placeholder in a sentence for a thing that is not known yet.
_UNKNOWN = "why-thing-at"


def thing_at(side: str, time: float) -> Phrase:
    """What the sensor of a side looked at; `with_things` puts the thing itself in its place."""
    return Phrase(_UNKNOWN, side=side, time=time)


def seen_in(world: WorldAgain) -> Seen:
    """What sensors looked at in a world that is run again."""
    return lambda side, time: world.seek(time).body.looked_at(side)


def seen_in_run(recorded: Recorded) -> Seen | None:
    """What sensors looked at in a run; None if its world cannot be run again."""
    try:
        return seen_in(WorldAgain(recorded))
    except LearnBlockError:
        return None


def with_things(answer: Explanation, identify: Seen | None) -> Explanation:
    """An answer with sentences that name the things that sensors looked at."""
    sights = {
        sight for sentence in (*answer.sentences, *answer.more) for sight in _in(sentence.phrase)
    }
    # In order: a world that runs again reaches a later moment faster than an earlier one.
    in_order = sorted(sights, key=lambda sight: sight[1])
    things = {sight: identify(*sight) if identify else None for sight in in_order}

    def named(sentence: Sentence) -> Sentence:
        phrase = _named(sentence.phrase, things)
        return replace(sentence, phrase=phrase) if isinstance(phrase, Phrase) else sentence

    if not sights:
        return answer
    return Explanation(tuple(map(named, answer.sentences)), tuple(map(named, answer.more)))


def _in(value: Value) -> Iterator[tuple[str, float]]:
    """The places in a sentence where a thing is missing: sides and times."""
    if isinstance(value, tuple):
        for part in value:
            yield from _in(part)
    elif isinstance(value, Phrase):
        side, time = value.values.get("side"), value.values.get("time")
        if value.code == _UNKNOWN and isinstance(side, str) and isinstance(time, float):
            yield side, time
        for inner in value.values.values():
            yield from _in(inner)


def _named(value: Value, things: dict[tuple[str, float], str | None]) -> Value:
    if isinstance(value, tuple):
        parts = (_named(part, things) for part in value)
        return tuple(part for part in parts if isinstance(part, str | Phrase))
    if not isinstance(value, Phrase):
        return value
    if value.code == _UNKNOWN:
        [place] = _in(value)
        thing = things[place]
        return Phrase("why-thing", thing=thing_phrase(thing)) if thing else ""
    return Phrase(value.code, **{name: _named(part, things) for name, part in value.values.items()})
