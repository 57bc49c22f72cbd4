"""Which languages are translated."""

from learnblock.i18n import languages
from places import ROOT

FOLDER = ROOT / "src" / "learnblock" / "i18n"
#: Begins a file that `scripts/translations --add` has copied, until it is translated.
COPIED = "# Not translated yet."


def complete_languages() -> set[str]:
    """The languages without a file that was only copied."""
    return {language for language in languages() if not _was_begun(language)}


def _was_begun(language: str) -> bool:
    files = (FOLDER / language).rglob("*.ftl")
    return any(file.read_text("utf-8").startswith(COPIED) for file in files)
