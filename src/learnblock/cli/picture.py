"""`learnblock picture`: a program as a picture of its blocks."""

from pathlib import Path
from typing import Any, cast

import click

from learnblock.cli.console import EXISTING_FILE, say, usage_error, warn
from learnblock.cli.language import language
from learnblock.i18n import languages


@click.command("picture")
@click.argument("file", type=EXISTING_FILE)
@click.option(
    "--to",
    "target",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="The picture, as .svg or .png  [default: the program's name with .svg]",
)
@click.option(
    "--language",
    "words",
    type=click.Choice(languages()),
    help="Language of the blocks  [default: the language of the output]",
)
@click.option(
    "--theme",
    type=click.Choice(["light", "dark", "contrast"]),
    default="light",
    show_default=True,
    help="Colours of the picture.",
)
def picture_command(file: Path, target: Path | None, words: str | None, theme: Any) -> None:
    """Draw a program's blocks as SVG or PNG.

    The picture has its letters and icons inside, and an SVG the program as its alternative text.
    Chrome, Edge or Chromium draws it, without a window and without the network.

    \b
    learnblock picture examples/square.bt --to square.png --language es
    """  # noqa: D301 - click wants the character itself
    from learnblock.project.files.programs import read  # noqa: PLC0415 - `--help`
    from learnblock.standalone.pictures import PictureType, picture  # noqa: PLC0415 - as above
    from learnblock.storage.files import save  # noqa: PLC0415 - as above

    target = target or Path(f"{file.stem}.svg")
    file_type = target.suffix.lower().removeprefix(".")
    if file_type not in {"svg", "png"}:
        raise usage_error("picture-unknown-type", file=str(target))
    program = read(file, warn).tree
    save(target, picture(program, cast("PictureType", file_type), words or language(), theme))
    say("cli-wrote", file=str(target))
