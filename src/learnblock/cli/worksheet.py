"""`learnblock lesson worksheet`: a lesson on paper."""

from pathlib import Path

import click

from learnblock.cli.console import say, usage_error
from learnblock.cli.language import language
from learnblock.i18n import languages


@click.command("worksheet")
@click.argument("lesson", metavar="LESSON")
@click.option(
    "--to",
    "target",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="The sheet, as .html or .pdf  [default: the lesson's name with .html]",
)
@click.option(
    "--language",
    "words",
    type=click.Choice(languages()),
    help="Language of the sheet  [default: the language of the output]",
)
def worksheet_command(lesson: str, target: Path | None, words: str | None) -> None:
    """Put a lesson on paper.

    The sheet has the tasks, the blocks of the solutions to cut out, lines to write on, and the
    solutions on pages of their own. Print the .html with a browser; for a .pdf, Chrome, Edge or
    Chromium is needed.

    \b
    learnblock lesson worksheet 1-03-square --to square.pdf --language es
    """  # noqa: D301 - click wants the character itself
    from learnblock.lessons.reading import find_lesson  # noqa: PLC0415 - `--help`
    from learnblock.lessons.worksheet import worksheet  # noqa: PLC0415 - as above
    from learnblock.standalone.browser import printed  # noqa: PLC0415 - as above
    from learnblock.storage.files import save  # noqa: PLC0415 - as above

    opened = find_lesson(lesson)
    target = target or Path(f"{opened.name}.html")
    file_type = target.suffix.lower()
    if file_type not in {".html", ".pdf"}:
        raise usage_error("picture-unknown-sheet", file=str(target))
    page = worksheet(opened, words or language())
    save(target, page.encode() if file_type == ".html" else printed(page))
    say("cli-wrote", file=str(target))
