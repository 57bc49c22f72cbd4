"""The page of a grading: one file without scripts, which shows what every program did."""

import base64
import hashlib
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from importlib.resources import files
from typing import TextIO

from learnblock import language as notations
from learnblock.errors import FileError
from learnblock.i18n import Phrase, translate
from learnblock.lessons.checks import Check
from learnblock.lessons.describing import title_of
from learnblock.lessons.grading.grading import Grading, Row
from learnblock.lessons.grading.html import escaped, tag
from learnblock.lessons.grading.likeness import Pair, Print, alike, print_of
from learnblock.lessons.grading.pictures import Pictures
from learnblock.lessons.grading.summary import StepOutcome, Summary, most_missed, summary_of
from learnblock.lessons.grading.table import stars
from learnblock.lessons.grading.values import DIFFERS, HandedIn, HintResult, Result, Texts
from learnblock.lessons.texts import in_language
from learnblock.shell import command_line

#: The most pictures of a pupil: what failed comes first.
MOST_PICTURES = 3
_KINDS = {
    "same": "grade-page-kind-same",
    "renamed": "grade-page-kind-renamed",
    "alike": "grade-page-kind-alike",
}
#: The headings of the overview's groups, in its order.
_GROUPS = {
    StepOutcome.MISSED: "grade-page-to-look-at",
    StepOutcome.DONE: "grade-page-done",
    StepOutcome.ABSENT: "grade-page-without",
}
_MARKS = {"met": "✓", "failed": "✗"}
#: LearnBlock's mark: the page's frontend/src/features/start/logo.tsx.
_LOGO = (
    '<svg width="36" height="36" viewBox="0 0 40 40" aria-hidden="true">'
    '<rect width="40" height="40" rx="11" fill="#4338ca"/><path fill="#ffc531" d="M9 13a4 4 0 0 1'
    " 4-4h2.5c.8 0 1.2.5 1.7 1l.9.9c.4.4.9.6 1.4.6h1c.5 0 1-.2 1.4-.6l.9-.9c.5-.5.9-1 1.7-1H27a4"
    ' 4 0 0 1 4 4v5H9z"/><rect x="9" y="19.5" width="22" height="11.5" rx="4" fill="#fff"/>'
    '<path stroke="#4338ca" stroke-width="3.6" stroke-linecap="round" d="M15.8 24.4v1.8m8.4-1.8'
    'v1.8"/></svg>'
)
#: The headings of the columns before and after the checks.
_BEFORE = ("grade-page-robot", "grade-page-variant", "grade-page-seed")
_AFTER = ("grade-page-ended", "grade-page-seconds", "grade-page-checked", "grade-page-trace")


class Page:
    """The page.

    Args:
        grading: the grading.
        language: of the page.
        lesson: what the teacher called the lesson.
    """

    def __init__(self, grading: Grading, language: str, lesson: str) -> None:
        self._grading = grading
        self._plan = grading.plan
        self._language = language
        self._lesson = lesson
        self._step = self._plan.opened.step(self._plan.step)

    def write(self, file: TextIO) -> None:
        """Write it, one part after the other, so that a class of any size fits into memory."""
        style = files(__package__).joinpath("page.css").read_text("utf-8")
        digest = base64.b64encode(hashlib.sha256(style.encode()).digest()).decode()
        policy = f"default-src 'none'; style-src 'sha256-{digest}'; img-src data:"
        title = self._text("grade-page-title", lesson=self._lesson_title, step=self._plan.step)
        file.write("<!doctype html>\n")
        file.write(f'<html lang="{escaped(self._language)}"><head><meta charset="utf-8">')
        file.write(f'<meta http-equiv="Content-Security-Policy" content="{escaped(policy)}">')
        file.write('<meta name="viewport" content="width=device-width, initial-scale=1">')
        file.write(f"<title>{escaped(title)}</title><style>{style}</style></head><body>\n")
        file.write(tag("header", _LOGO, tag("h1", escaped(title)), class_="bar") + "<main>\n")
        for part in self._parts():
            file.write(part + "\n")
        file.write("</main></body></html>\n")

    def _parts(self) -> Iterator[str]:
        yield tag("div", *self._figures(), class_="figures")
        yield tag("p", self._escaped("grade-page-no-mark"), class_="note")
        side = tag("div", *map(_card, (self._clusters(), self._alike())), class_="side")
        overview = tag("section", *self._overview(), class_="card overview")
        yield tag("div", overview, side, class_="columns")
        yield tag("h2", self._escaped("grade-page-pupils"))
        if self._pictures:
            yield self._pictures.worlds()
        for index, handed_in in enumerate(self._plan.handed_in):
            yield self._pupil(index, handed_in)

    def _figures(self) -> Iterator[str]:
        """The class in a few figures."""
        outcomes = [summary.outcome for summary in self._summaries]
        absent = outcomes.count(StepOutcome.ABSENT)
        count = len(outcomes) - absent
        tried = self._escaped("grade-page-tried", tries=len(self._plan.attempts))
        yield self._figure("grade-page-programs", count, tried)
        of = self._escaped("grade-page-of", count=count)
        yield self._figure("grade-page-done", outcomes.count(StepOutcome.DONE), of)
        if absent:
            yield self._figure("grade-page-without", absent)
        if missed := most_missed(self._summaries):
            place, programs = missed
            title = self._check_titles[place]
            yield self._figure("grade-page-most-missed", programs, title)

    def _figure(self, code: str, number: int, words: str = "") -> str:
        figure = tag("p", tag("strong", str(number)), " ", words)
        return tag("div", tag("p", self._escaped(code)), figure, class_="card")

    def _text(self, code: str, /, **values: str | float) -> str:
        return translate(Phrase(code, **values), self._language)

    def _escaped(self, code: str, /, **values: str | float) -> str:
        return escaped(self._text(code, **values))

    def _in_language(self, texts: Texts) -> str:
        return escaped(in_language(texts, self._language)) if texts else ""

    @property
    def _lesson_title(self) -> str:
        return in_language(self._plan.opened.lesson.title, self._language)

    @property
    def _checks(self) -> Sequence[Check]:
        return self._step.check

    @cached_property
    def _check_titles(self) -> list[str]:
        return [escaped(title_of(check, self._language)) for check in self._checks]

    @cached_property
    def _pictures(self) -> Pictures | None:
        world = self._plan.opened.described_world(self._plan.step)
        return (
            Pictures(world, tuple(attempt.variant for attempt in self._plan.attempts))
            if world
            else None
        )

    @cached_property
    def _summaries(self) -> list[Summary]:
        return [
            summary_of(self._grading, handed_in, self._checks) for handed_in in self._plan.handed_in
        ]

    def _overview(self) -> Iterator[str]:
        yield tag("h2", self._escaped("grade-page-overview"))
        heads = [
            self._escaped("grade-page-pupil"),
            *self._check_titles,
            self._escaped("grade-page-done"),
        ]
        heads.append(self._escaped("grade-page-first-hint"))
        groups = filter(None, (self._group(outcome, len(heads)) for outcome in _GROUPS))
        yield _table(self._text("grade-page-overview"), heads, *groups)

    def _group(self, outcome: StepOutcome, columns: int) -> list[str]:
        """The rows of the pupils who did alike, under their heading."""
        rows = [
            self._line(index, summary)
            for index, summary in enumerate(self._summaries)
            if summary.outcome is outcome
        ]
        if not rows:
            return []
        heading = f"{self._escaped(_GROUPS[outcome])} · {len(rows)}"
        head = tag("th", heading, scope="rowgroup", colspan=columns)
        return [tag("tr", head, class_="group"), *rows]

    def _line(self, index: int, summary: Summary) -> str:
        counts = (*summary.met, summary.done)
        cells = [_count(number, summary.finished) for number in counts]
        hint = self._in_language(summary.hint.levels[0]) if summary.hint else ""
        remark = self._in_language(summary.refused) or hint
        kind = "open" if summary.outcome is StepOutcome.ABSENT else None
        cells.append(tag("td", remark, class_=kind))
        return tag("tr", tag("th", self._link(index), scope="row"), *cells)

    def _clusters(self) -> Iterator[str]:
        """Programs with the same failing checks and the same first hint."""
        groups: Mapping[tuple[tuple[int, ...], str], list[int]] = defaultdict(list)
        for index, summary in enumerate(self._summaries):
            if summary.failing:
                groups[summary.failing, summary.hint.rule if summary.hint else ""].append(index)
        several = [(key, group) for key, group in groups.items() if len(group) > 1]
        several.sort(key=lambda pair: (-len(pair[1]), pair[1]))
        yield tag("h2", self._escaped("grade-page-clusters"))
        if not several:
            yield tag("p", self._escaped("grade-page-no-clusters"), class_="dim")
        for (failing, _), group in several:
            first = self._summaries[group[0]]
            missed = " · ".join(self._check_titles[place].rstrip(".") for place in failing)
            hint = self._in_language(first.hint.levels[0]) if first.hint else ""
            names = ", ".join(self._link(index) for index in group)
            yield tag(
                "div",
                tag("h3", self._escaped("grade-page-cluster", count=len(group)), " ", missed),
                tag("p", hint) if hint else "",
                tag("p", names),
                class_="likes",
            )

    def _link(self, index: int) -> str:
        return tag("a", escaped(self._plan.handed_in[index].pupil), href=f"#pupil-{index}")

    def _alike(self) -> Iterator[str]:
        yield tag("h2", self._escaped("grade-page-alike"))
        yield tag("p", self._escaped("grade-page-alike-note"), class_="dim")
        likeness = alike([_print(handed_in) for handed_in in self._plan.handed_in], self._given)
        if not likeness.pairs:
            yield tag("p", self._escaped("grade-page-none-alike"))
        for pair in likeness.pairs:
            yield self._pair(pair)
        if more := likeness.total - len(likeness.pairs):
            yield tag("p", self._escaped("grade-page-more-alike", count=more))

    @cached_property
    def _given(self) -> Print | None:
        """What pupils started with: their programs share it by right."""
        steps = self._plan.opened.lesson.step[: self._plan.step]
        file = next((step.program for step in reversed(steps) if step.program), None)
        if file is None:
            return None
        text = self._plan.opened.program(file)
        return _print(HandedIn("", "", text, file.endswith(".py")))

    def _pair(self, pair: Pair) -> str:
        sides = (
            tag(
                "div",
                tag("p", self._link(index)),
                tag("pre", escaped(self._plan.handed_in[index].text)),
            )
            for index in (pair.first, pair.second)
        )
        first, second = (self._plan.handed_in[index].pupil for index in (pair.first, pair.second))
        what = self._escaped(_KINDS[pair.kind], share=round(pair.share * 100))
        summary = tag("summary", escaped(f"{first}, {second}"), ": ", what)
        return tag("details", summary, tag("div", *sides, class_="sides"), class_="pair")

    def _pupil(self, index: int, handed_in: HandedIn) -> str:
        rows = [*self._grading.rows_of(handed_in)]
        summary = self._summaries[index]
        name = escaped(handed_in.pupil)
        if handed_in.absence:
            reason = tag("span", self._in_language(summary.refused), class_="mark open")
            heading = tag("summary", name, " ", reason)
            return tag("details", heading, id=f"pupil-{index}", class_="card pupil open")
        done = self._escaped("grade-page-done-in", done=summary.done, tries=len(rows))
        kind = "met" if summary.outcome is StepOutcome.DONE else "failed"
        heading = tag(
            "summary", name, " ", tag("span", f"{_MARKS[kind]} {done}", class_=f"mark {kind}")
        )
        body = tag("div", *self._details(handed_in, rows, summary), class_="pupil-body")
        return tag("details", heading, body, id=f"pupil-{index}", class_="card pupil", open="")

    def _details(self, handed_in: HandedIn, rows: Sequence[Row], summary: Summary) -> Iterator[str]:
        if run := self._ways(rows) + self._hints(rows):
            yield tag("div", run, class_="run")
        if not handed_in.reason:
            yield self._runs(handed_in.pupil, rows)
        yield from self._remarks(rows, summary)
        command = tag("code", escaped(self._command(handed_in)))
        yield tag("p", self._escaped("grade-page-again"), " ", command, class_="dim")
        program = tag("pre", escaped(handed_in.text))
        yield tag("details", tag("summary", self._escaped("grade-page-program")), program)

    def _remarks(self, rows: Sequence[Row], summary: Summary) -> Iterator[str]:
        if summary.refused:
            yield tag("p", self._in_language(summary.refused), class_="failed")
        if any(row.result and row.result.checked == DIFFERS for row in rows):
            yield tag("p", self._escaped("grade-page-differs"), class_="failed")
        if failure := next((row.failure for row in rows if row.failure), None):
            reason = translate(failure, self._language)
            yield tag("p", self._escaped("grade-page-not-made", error=reason), class_="failed")

    def _ways(self, rows: Sequence[Row]) -> str:
        pictures = self._pictures
        if pictures is None:
            return ""
        driven = [row for row in rows if row.result and row.result.path]
        # What failed is more interesting; otherwise in their order.
        driven.sort(key=lambda row: row.result is not None and stars(self._checks, row.result) > 0)
        ways = [self._way(pictures, row) for row in driven[:MOST_PICTURES]]
        return tag("div", *ways, class_="ways") if ways else ""

    def _way(self, pictures: Pictures, row: Row) -> str:
        assert row.result  # noqa: S101 - it has a path
        attempt = row.attempt
        place = self._text(
            "grade-page-attempt",
            robot=attempt.robot,
            variant=str(attempt.variant),
            seed=str(attempt.seed),
        )
        drawn = pictures.picture(attempt, row.result.path, escaped(place))
        return tag("figure", drawn, tag("figcaption", escaped(place)))

    def _runs(self, pupil: str, rows: Sequence[Row]) -> str:
        heads = [*map(self._escaped, _BEFORE), *self._check_titles, *map(self._escaped, _AFTER)]
        return _table(pupil, heads, [tag("tr", *self._cells(row)) for row in rows])

    def _cells(self, row: Row) -> Iterator[str]:
        for value in (row.attempt.robot, row.attempt.variant, row.attempt.seed):
            yield tag("td", escaped(value))
        result = row.result
        if result is None:
            what = "grade-page-not-run" if row.failure else "grade-page-not-finished"
            columns = len(self._checks) + 4
            yield tag("td", self._escaped(what), colspan=columns, class_="open")
            return
        for place in range(len(self._checks)):
            yield self._verdict(result, place)
        ended = " ".join(filter(None, (escaped(result.ended), self._in_language(result.reason))))
        yield tag("td", ended)
        yield tag("td", f"{result.seconds:.1f}")
        yield tag("td", escaped(result.checked))
        yield tag("td", tag("code", escaped(result.trace_sha256[:16])), title=result.trace_sha256)

    def _verdict(self, result: Result, place: int) -> str:
        if place >= len(result.checks):
            return tag("td", tag("span", "–", class_="mark"), class_="failed")
        check = result.checks[place]
        mark = tag("span", _MARKS.get(check.state, "–"), class_="mark")
        reason = self._in_language(check.reason)
        return tag("td", mark, " " + reason if reason else "", class_=check.state)

    def _hints(self, rows: Sequence[Row]) -> str:
        hints: dict[str, HintResult] = {}
        for row in rows:
            for hint in row.result.hints if row.result else ():
                hints.setdefault(hint.rule, hint)
        if not hints:
            return ""
        listed = (self._hint(hint) for hint in [*hints.values()][:MOST_PICTURES])
        heading = tag("h3", self._escaped("grade-page-hints"))
        return tag("div", heading, tag("ul", *listed), class_="hints")

    def _hint(self, hint: HintResult) -> str:
        levels = tag("ol", *(tag("li", self._in_language(level)) for level in hint.levels))
        return tag("li", self._in_language(hint.because), levels)

    def _command(self, handed_in: HandedIn) -> str:
        robots = dict.fromkeys(attempt.robot for attempt in self._plan.attempts)
        variants = len(self._plan.attempts) // max(len(robots), 1) - 1
        return command_line(
            "learnblock", "grade", handed_in.file, "--lesson", self._lesson,
            "--step", self._plan.step, "--robots", ",".join(robots),
            "--variants", variants, "--out", "again",
        )  # fmt: skip


def _card(parts: Iterator[str]) -> str:
    return tag("section", *parts, class_="card")


def _table(name: str, heads: Sequence[str], *groups: Sequence[str]) -> str:
    """A table, which can be scrolled by keyboard alone where it is too wide."""
    head = tag("thead", tag("tr", *(tag("th", head, scope="col") for head in heads)))
    table = tag("table", head, *(tag("tbody", *rows) for rows in groups))
    return tag("div", table, class_="wide", role="group", aria_label=name, tabindex=0)


def _count(number: int, finished: int) -> str:
    kind = "met" if finished and number == finished else "failed" if number < finished else "open"
    words = f"{_MARKS[kind]} {number}/{finished}" if finished else "–"
    return tag("td", tag("span", words, class_="mark"), class_=kind)


def _print(handed_in: HandedIn) -> Print | None:
    if handed_in.reason is not None or not handed_in.text:
        return None
    notation = notations.from_python if handed_in.is_python else notations.parse
    try:
        return print_of(notation(handed_in.text, handed_in.file))
    except (FileError, RecursionError):
        return None
