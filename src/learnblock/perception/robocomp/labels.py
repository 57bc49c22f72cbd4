"""The names of emotions in EmotionRecognition."""

from collections.abc import Mapping

#: The five labels and our names for them.
EMOTIONS: Mapping[str, str] = {
    "Happy": "joy",
    "Sad": "sadness",
    "Neutral": "neutral",
    "Angry": "anger",
    "Surprised": "surprise",
}
_LABELS = {emotion: label for label, emotion in EMOTIONS.items()}
_FOLDED = {label.casefold(): emotion for label, emotion in EMOTIONS.items()}


def label_of(emotion: str) -> str | None:
    """The label for one of our emotions; fear and disgust have none."""
    return _LABELS.get(emotion)


def emotion_of(label: str) -> str | None:
    """Our emotion for a label in any case; None for any other word."""
    return _FOLDED.get(label.strip().casefold())
