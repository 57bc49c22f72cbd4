"""The command `why`: answers to questions about a run."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.console import EXISTING_FILE, json_option, print_json, say, text

if TYPE_CHECKING:
    from learnblock.why.questions import Question
    from learnblock.why.sentences import Explanation, Sentence


@click.command("why")
@click.argument("log", type=EXISTING_FILE, metavar="LOG")
@click.argument("question", required=False)
@click.option("--more", is_flag=True, help="Also print the causes of less importance.")
@json_option
def why_command(
    log: Path,
    question: str | None,
    more: bool,  # noqa: FBT001 - a click flag
    as_json: bool,  # noqa: FBT001
) -> None:
    """Answer a question about a run.

    For example why the robot turned, or why it did not. The log is written by learnblock run --why.
    Without a question, the command lists what you can ask. A time is in seconds.

    \b
    learnblock run examples/avoid.bt --world arena --why avoid.why
    learnblock why avoid.why
    learnblock why avoid.why "turn left at 12.5"
    learnblock why avoid.why "not look happy at 11.5" --more
    """  # noqa: D301 - click wants the character itself
    from learnblock import why  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.why.answers import answer  # noqa: PLC0415
    from learnblock.why.parser import parse  # noqa: PLC0415
    from learnblock.why.questions import questions  # noqa: PLC0415
    from learnblock.why.things import seen_in_run  # noqa: PLC0415

    history = why.EventHistory(why.read(log))
    if question is None:
        _list(questions(history), as_json=as_json)
        return
    parsed = parse(question, history)
    reply = answer(history, parsed, seen_in_run(history.recorded))
    if as_json:
        print_json(_plain(parsed, reply))
    else:
        _print(reply, more=more)


def _list(questions: "tuple[Question, ...]", *, as_json: bool) -> None:
    if as_json:
        print_json([_question(question) for question in questions])
        return
    for question in questions:
        click.echo(text(question.phrase))


def _print(reply: "Explanation", *, more: bool) -> None:
    for sentence in (*reply.sentences, *(reply.more if more else ())):
        click.echo(text(sentence.phrase))
    if reply.more and not more:
        say("why-there-is-more", count=len(reply.more), err=True)


def _plain(question: "Question", reply: "Explanation") -> dict[str, Any]:
    """An answer for tools, its texts in the reader's language."""
    return {
        "question": _question(question),
        "sentences": [_sentence(sentence) for sentence in reply.sentences],
        "more": [_sentence(sentence) for sentence in reply.more],
    }


def _question(question: "Question") -> dict[str, Any]:
    return {
        "ask": str(question.ask),
        "subject": question.subject,
        "time": question.time,
        "text": text(question.phrase),
    }


def _sentence(sentence: "Sentence") -> dict[str, Any]:
    return {
        "text": text(sentence.phrase),
        "code": sentence.phrase.code,
        "line": sentence.line,
        "time": sentence.time,
        "event": sentence.event,
    }
