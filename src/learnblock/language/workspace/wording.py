"""Messages about a program in the words of blocks: they advise a block, not a line to write."""

from collections.abc import Mapping
from types import MappingProxyType

from learnblock.i18n import Phrase, Value

#: The messages about blocks, by those about text whose advice is a line or a spelling.
_IN_BLOCKS: Mapping[str, str] = MappingProxyType(
    {
        "check-unknown-name": "workspace-unknown-name",
        "check-unknown-name-near": "workspace-unknown-name-near",
        "check-read-before-set": "workspace-read-before-set",
        "check-defined-below": "workspace-defined-below",
        **dict.fromkeys(
            (
                "check-unknown-function",
                "check-unknown-function-near",
                "check-unknown-function-meant",
            ),
            "workspace-unknown-function",
        ),
        **dict.fromkeys(
            (
                "check-unknown-skill",
                "check-unknown-skill-near",
                "check-unknown-skill-meant",
            ),
            "workspace-no-such-skill",
        ),
        "check-unknown-when": "workspace-unknown-when",
        "check-unknown-when-near": "workspace-unknown-when-near",
        "check-never-started": "workspace-never-started",
        "check-events-never-run": "workspace-events-never-run",
        "check-events-held-up": "workspace-events-held-up",
        **dict.fromkeys(
            ("check-events-held-up-by-event", "check-events-held-up-by-event-python"),
            "workspace-events-held-up-by-event",
        ),
        "check-defined-twice": "workspace-defined-twice",
        **dict.fromkeys(
            ("check-value-of-event", "check-value-of-event-python"), "workspace-value-of-event"
        ),
        **dict.fromkeys(
            ("check-follows-condition", "check-follows-condition-python"),
            "workspace-follows-condition",
        ),
        "check-without-robot": "workspace-without-robot",
        "check-decimals": "workspace-decimals",
        "check-not-imported": "workspace-not-imported",
        "check-missing-argument": "workspace-missing-argument",
        "check-too-many-arguments": "workspace-too-many-arguments",
        "check-number-expected": "workspace-text-for-number",
        "check-text-for-number": "workspace-text-for-number",
        "check-number-in-quotes": "workspace-number-as-text",
        "check-number-without-quotes": "workspace-number-as-text",
        "check-outside-range": "workspace-outside-range",
        "check-negative-wait": "workspace-negative-wait",
        "check-unknown-choice": "workspace-no-such-choice",
        "check-not-a-colour": "workspace-not-a-colour",
        "check-whole-number": "workspace-whole-number",
        "check-step-zero": "workspace-step-zero",
        "check-counts-up": "workspace-counts-up",
        "check-never-repeats": "workspace-never-repeats",
        "check-idle-loop": "workspace-idle-loop",
        **dict.fromkeys(
            ("check-growing-list", "check-growing-list-python"), "workspace-growing-list"
        ),
        "check-idle-wait": "workspace-idle-wait",
        "check-unchanged-in-wait": "workspace-unchanged-in-wait",
        "check-unchanged-in-loop": "workspace-unchanged-in-loop",
        "check-told-stays": "workspace-told-stays",
        **dict.fromkeys(
            ("check-state-in-wait", "check-state-in-wait-python"), "workspace-state-in-wait"
        ),
        **dict.fromkeys(
            ("check-state-in-loop", "check-state-in-loop-python"), "workspace-state-in-loop"
        ),
        **dict.fromkeys(("check-time-stays", "check-time-stays-python"), "workspace-time-stays"),
        "check-speed-as-angle": "workspace-speed-as-angle",
        "check-convert-to-number": "workspace-convert-to-number",
        "check-answer-for-number": "workspace-answer-for-number",
        "check-answer-changed": "workspace-answer-changed",
        "check-list-for-number": "workspace-list-for-number",
        "check-dictionary-for-number": "workspace-dictionary-for-number",
        "check-join-text": "workspace-join-text",
        "check-append": "workspace-append",
        "check-never-equal": "workspace-never-equal",
        **dict.fromkeys(("check-rounded", "check-rounded-sum"), "workspace-rounded"),
        "check-repeat-whole-number": "workspace-repeat-whole-number",
        "check-for-number": "workspace-for-number",
        "check-for-dictionary": "workspace-for-dictionary",
        "check-text-as-condition": "workspace-text-as-condition",
        "check-number-as-condition": "workspace-number-as-condition",
        "check-action-as-condition": "workspace-action-as-condition",
        "check-no-result": "workspace-no-result",
        "check-unused-answer": "workspace-unused-answer",
        "check-bare-value": "workspace-bare-value",
        "check-divide-by-zero": "workspace-divide-by-zero",
        "check-length-of-number": "workspace-length-of-number",
        "check-numbers-of-list": "workspace-numbers-of-list",
        "check-past-end": "workspace-past-end",
        "check-loop-past-end": "workspace-loop-past-end",
        **dict.fromkeys(
            ("check-empty-list-item", "check-empty-list-item-python"), "workspace-empty-list-item"
        ),
        **dict.fromkeys(
            ("check-calls-itself", "check-calls-itself-python"), "workspace-calls-itself"
        ),
        **dict.fromkeys(
            ("check-shared-in-recursion", "check-shared-in-recursion-python"),
            "workspace-shared-in-recursion",
        ),
        **dict.fromkeys(
            ("check-shared-counter", "check-shared-counter-python"), "workspace-shared-counter"
        ),
        **dict.fromkeys(
            ("check-shared-by-events", "check-shared-by-events-python"),
            "workspace-shared-by-events",
        ),
        "check-skill-without-answer": "workspace-skill-without-answer",
        "check-skill-impossible": "workspace-skill-impossible",
        "check-skill-without-effect": "workspace-skill-without-effect",
        "check-no-device-of-name": "workspace-no-device-of-name",
        "check-outside-loop": "workspace-outside-loop",
        "check-outside-function": "workspace-outside-function",
        "check-unreachable-after-jump": "workspace-unreachable-after-jump",
        "check-unreachable-after-loop": "workspace-unreachable-after-loop",
        "check-unreachable-after-call": "workspace-unreachable-after-call",
        "check-unreachable-after-branches": "workspace-unreachable-after-branches",
        **dict.fromkeys(
            ("check-sensor-outside-loop", "check-sensor-outside-loop-python"),
            "workspace-sensor-outside-loop",
        ),
    }
)


#: The signs of comparisons on blocks.
_SIGNS: Mapping[str, str] = MappingProxyType({"==": "=", "!=": "≠", "<=": "≤", ">=": "≥"})


def in_blocks(message: Phrase) -> Phrase | None:
    """The words for a block; None if those for the text suit it."""
    code = _IN_BLOCKS.get(message.code)
    if code is None:
        return None
    return Phrase(code, **{name: _value(value) for name, value in message.values.items()})


def _value(value: Value) -> Value:
    if isinstance(value, Phrase):
        return in_blocks(value) or value
    return _SIGNS.get(value, value) if isinstance(value, str) else value
