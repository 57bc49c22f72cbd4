"""Questions as a person writes them, in English or Spanish: "not turn left at 8.9"."""

import re
import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import replace
from difflib import get_close_matches

from learnblock.blocks.labels import label
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase, languages, translate
from learnblock.i18n.names import goal_phrase
from learnblock.runtime.log.nodes import Kind, Node
from learnblock.why import wording
from learnblock.why.history import History
from learnblock.why.questions import Ask, Question, askable

_TIME = re.compile(
    r"(?:\b(?:at|by|until|before|around|after|t|en|a los|a las|a)\b|@|=)\s*"
    r"(?:el segundo|second|t\s*=?)?\s*"
    r"(\d+(?:[.,]\d+)?)\s*(?:s|sec|seconds|segundos)?\s*$"
)
_LINE = re.compile(r"\b(?:line|block|linea|bloque)\s+(\d+)\b")
_NOT = re.compile(r"\b(?:not|no|never|nunca|didnt|doesnt|wasnt|isnt|hasnt)\b|n't\b|n’t\b")
_OPENING = re.compile(
    r"^(?:why|por que|porque|what made|did|does|do|is|was|has|have|the|robot|it|el|la|se|ha|ran|run"
    r"|still|todavia|program|programa|my|mi|then|keeps?|sigue|hizo|hace|esta|estaba)\b\s*"
)
_QUOTED = re.compile(r"[\"'“«](.+?)[\"'”»]")

#: Words for movements, the more exact ones first; without accents.
_MOVEMENTS = (
    (r"curve\w* (?:to the )?left|curva a la izquierda", wording.CURVE_LEFT),
    (r"curve\w* (?:to the )?right|curva a la derecha", wording.CURVE_RIGHT),
    (r"(?:turn|spin|rotat|go|gir|dobl)\w*(?: \w+)*? (?:left|izquierda)", wording.SPIN_LEFT),
    (r"(?:turn|spin|rotat|go|gir|dobl)\w*(?: \w+)*? (?:right|derecha)", wording.SPIN_RIGHT),
    (r"^(?:turn|spin|rotate|gir(?:ar|a|o))\w*$|\bcurv", ""),
    (r"back(?:wards?|s? up|ing)?\b|reverse|atras|retroced\w*", wording.BACK),
    (
        r"(?:drive|drove|go|move|moving|driving)\w*(?: straight)?(?: on| ahead| forwards?)?$"
        r"|straight|forwards?\b|avanz\w*|recto|adelante"
        r"|\b(?:so|too|very|tan|demasiado|muy) (?:slow|fast|lent|despacio|rapid)",
        wording.FORWARD,
    ),
    (
        r"st(?:op|opp?ed|and|ood|anding)(?: still)?$|par(?:ar|a|o|ado)$|quieto|deten\w*|detuv\w*",
        wording.STAND,
    ),
)
#: Behind the words of blocks, such as "turn around".
_TURNS = re.compile(r"^(?:turn|spin|rotat|gir|dobl)")
_PROGRAM_ENDS = re.compile(r"\bprogram (?:stop|over)|\bse (?:paro|detuvo) el prog")
_NOW = re.compile(
    r"^(?:what|que)\b.*\b(?:do|doing|happen\w*|hac\w+|pas\w+)\b|^(?:what|que|now|ahora)$"
)
_ENDS = re.compile(
    r"^(?:end|ended|fail|failed|error|crash|finish|finished"
    r"|terminar|termino|acabar|acabo|fallar|fallo)\b"
)
_BUMPS = re.compile(r"\b(?:bump|bumped|collide|collided|hit|chocar|choco|choque|tropez\w*)\b")
_GOALS = re.compile(r"\b(?:goal|reach|reached|objetivo|meta|alcanz\w+)\b")
_SHOWS = re.compile(r"^(?:show|showed|mostrar|mostro)\b\s*")
_EMOTIONS = ("joy", "sadness", "anger", "fear", "disgust", "surprise", "neutral")
_PRINTS = re.compile(r"^(?:print|printed|say|escribir|escribio|imprimir)\b\s*")
_SAYS = re.compile(r"^(?:say|said|decir|dijo)\b\s*")
_PRINTED = re.compile(r"\b(?:printed|escribio|imprimio)\b")
_VARIABLES = re.compile(
    r"^(?:variable|value of|value|valor de|valor|la variable|the value of"
    r"|cambio|tiene|vale|valia)\s+"
)
_DIRECTIONS = re.compile(r"\b(?:left|right|izquierda|derecha)\b")
_QUOTES = re.compile(r"[\"'“”«»]")
#: How similar a text has to be to the words of a block, so that a slip of a key is understood.
_ALIKE = 0.85
#: Words for what a robot has, and for the skills that use it.
_DEVICES = (
    (r"\b(?:lamp|light|led|luz|luces|lampara)s?\b", r"led|RGBled"),
    (
        r"\b(?:sound|noise|tone|note|music|beep|sonido|sonar|musica|nota)s?\b",
        r"play_|rest|.*_action",
    ),
    (r"\b(?:speak|talk|say|hablar|hablo|decir|dijo)\b", r"say_Text|play_audio"),
    (r"\b(?:screen|pantalla|show text)\b", r"show_|matrix_|clear_screen"),
    (r"\b(?:camera|camara|look (?:down|up))\b", r"look_|setAngleCamera|.*_camera"),
    (r"\b(?:face|emotion|cara|emocion)s?\b", r"express"),
    (r"\b(?:pen|draw|lapiz|dibujar|dibujo)\b", r"pen_|.*_pen"),
)
_NEGATED = {
    Ask.MOVEMENT: Ask.NOT_MOVEMENT,
    Ask.SKILL: Ask.NOT_SKILL,
    Ask.PRINT: Ask.NOT_PRINT,
    Ask.WHEN: Ask.NOT_WHEN,
    Ask.LINE: Ask.NOT_LINE,
}


def parse(text: str, history: History) -> Question:
    """The question that a text asks about a run.

    Raises:
        LearnBlockError: it asks for nothing that the run knows.
    """
    return _Parsing(text, history).question()


class _Parsing:
    """One question on its way from text."""

    def __init__(self, text: str, history: History) -> None:
        self._text = text
        self._history = history
        self._plain = plain = _plain(text)
        found = _TIME.search(plain)
        self._time = float(found[1].replace(",", ".")) if found else None
        rest = plain[: found.start()].strip() if found else plain
        self._is_negative = bool(_NOT.search(rest))
        self._without_time = rest
        self._rest = _without_opening(_QUOTES.sub(" ", _NOT.sub(" ", rest)))

    def question(self) -> Question:
        for reading in (
            self._listed,
            self._goal_by_name,
            self._line,
            self._now,
            self._named,
            self._skill_by_name,
            self._print,
            self._emotion,
            self._ending,
            self._words,
        ):
            found = reading()
            if found is not None:
                return found
        if not self._rest and self._time is not None:
            return Question(Ask.NOW, "", self._time)
        raise self._not_understood()

    def _made(self, ask: Ask, subject: str) -> Question:
        return Question(_NEGATED.get(ask, ask) if self._is_negative else ask, subject, self._time)

    def _listed(self) -> Question | None:
        """A question in the words of the lists."""
        wanted = _without_quotes(self._without_time)
        for one in askable(self._history):
            words = (translate(one.phrase, language) for language in languages())
            if any(_without_quotes(_plain(text)) == wanted for text in words):
                return replace(one, time=self._time)
        return None

    def _now(self) -> Question | None:
        return Question(Ask.NOW, "", self._time) if _NOW.match(self._without_time) else None

    def _line(self) -> Question | None:
        found = _LINE.search(self._rest)
        return self._made(Ask.LINE, found[1]) if found else None

    def _named(self) -> Question | None:
        """A `when` or a variable."""
        stated = _VARIABLES.match(self._rest)
        words = [_VARIABLES.sub("", self._rest), *self._rest.split()[:3]]
        whens = {_plain(node.name): node.name for node in self._history.nodes if node.is_when}
        # Python's own names have an underscore behind them.
        written = [name for name in self._history.writes if name not in ("_", "robot")]
        names = {_plain(name.removesuffix("_")): name for name in written}
        names |= {_plain(name): name for name in written}
        for word in words:
            name = word.removeprefix("when ").split(" ")[0] if word else ""
            name = word.removeprefix("when ").split(" ")[0] if name != "when" else name
            if name in whens and not stated and self._is_about(name):
                return self._made(Ask.WHEN, whens[name])
            is_direction = _DIRECTIONS.search(self._rest.removeprefix(name))
            if name in names and self._is_about(name) and not is_direction:
                return Question(Ask.VALUE, names[name], self._time)
        return None

    def _is_about(self, name: str) -> bool:
        """Whether a name is the subject, and not a word such as in "turn left"."""
        first = _VARIABLES.sub("", self._rest).removeprefix("when ").removeprefix("activate ")
        return first.split(" ")[0] == name

    def _skill_by_name(self) -> Question | None:
        called = {_plain(node.name): node.name for node in self._calls()}
        known = {_plain(name): name for name in wording.blocks()}
        if self._rest == "turn":
            # A movement, which other skills make as well.
            return None
        first = re.sub(r"\(.*\)", "", self._rest).removeprefix("function.")
        name = called.get(first.removeprefix("robot.")) or known.get(first.removeprefix("robot."))
        return self._made(Ask.SKILL, name) if name else None

    def _called(self) -> Iterable[str]:
        return dict.fromkeys(node.name for node in self._calls())

    def _calls(self) -> list[Node]:
        nodes = self._history.nodes
        return [node for node in nodes if node.kind is Kind.CALL and node.base == "robot"]

    def _print(self) -> Question | None:
        quoted = _QUOTED.search(self._text)
        found = _PRINTS.match(self._rest) or (quoted and _PRINTED.search(self._rest))
        if not found or self._is_said():
            return None
        printed = {str(line["print"]) for line in self._history.recorded.lines if "print" in line}
        if quoted and quoted[1] in printed and not self._is_negative:
            return Question(Ask.PRINTED, quoted[1], self._time)
        subject = quoted[1] if quoted else self._rest[found.end() :]
        return self._made(Ask.PRINT, subject)

    def _is_said(self) -> bool:
        """Whether the program says something aloud, and prints no such text."""
        found = _SAYS.match(self._rest)
        text = self._rest[found.end() :] if found else ""
        prints = (node.text for node in self._history.nodes if node.name == "print")
        is_printed = any(text in _plain(one) for one in prints)
        return bool(text) and not is_printed and bool(self._used(self._called()))

    def _ending(self) -> Question | None:
        if _ENDS.match(self._rest) or _PROGRAM_ENDS.search(self._plain):
            return Question(Ask.END, "", self._time)
        if _BUMPS.search(self._rest):
            return Question(Ask.BUMP, "", self._time)
        return Question(Ask.GOAL, "", self._time) if _GOALS.search(self._rest) else None

    def _goal_by_name(self) -> Question | None:
        """A goal by its name alone, or behind the word for goal."""
        rest = " ".join(_GOALS.sub(" ", self._rest).split())
        for goal in self._history.recorded.ending.get("goals") or ():
            name = str(goal["name"])
            phrase = goal_phrase(name)
            names = {name}
            if isinstance(phrase, Phrase):
                names |= {translate(phrase, one) for one in languages()}
            if rest and rest in map(_plain, names):
                is_reached = goal.get("state") == "reached" and not self._is_negative
                return Question(Ask.REACHED if is_reached else Ask.GOAL, name, self._time)
        return None

    def _emotion(self) -> Question | None:
        """An emotion in the words of a language: "show joy"."""
        found = _SHOWS.match(self._rest)
        rest = self._rest[found.end() :] if found else ""
        for emotion in _EMOTIONS if rest and not self._is_negative else ():
            phrase = Phrase("why-emotion", emotion=emotion)
            if rest in {emotion, *(_plain(translate(phrase, one)) for one in languages())}:
                return Question(Ask.EMOTION, emotion, self._time)
        return None

    def _words(self) -> Question | None:
        """A skill in the words of its block, or a movement."""
        by_words = {words: name for name in [*wording.blocks()] for words in _words_of(name)}
        for pattern, movement in _MOVEMENTS:
            if re.search(pattern, self._rest):
                return self._made(Ask.MOVEMENT, movement)
        for words in (self._rest, f"look {self._rest}"):
            if words in by_words:
                return self._made(Ask.SKILL, by_words[words])
        if name := self._used(self._called()):
            return self._made(Ask.SKILL, name)
        if _TURNS.match(self._rest):
            return self._made(Ask.MOVEMENT, "")
        near = get_close_matches(self._rest, by_words, n=1, cutoff=_ALIKE)
        return self._made(Ask.SKILL, by_words[near[0]]) if near else None

    def _used(self, called: Iterable[str]) -> str | None:
        """The skill of the program that uses the device that the question names."""
        for words, skills in _DEVICES:
            if re.search(words, self._rest):
                return next((name for name in called if re.match(skills, name)), None)
        return None

    def _not_understood(self) -> LearnBlockError:
        return LearnBlockError("why-not-understood", question=self._text)


def _words_of(name: str) -> Iterator[str]:
    """The words of a skill's block in each language, without its numbers and units."""
    block = wording.blocks().get(name)
    for language in languages() if block else ():
        text = re.sub(r"\(.*?\)\S*|mm/s|°/s", " ", label(block, language))  # type: ignore[arg-type] # there is one
        yield re.sub(r"\s+(?:at|by|to|a)$", "", " ".join(_plain(text).replace(",", " ").split()))


def _without_quotes(text: str) -> str:
    return " ".join(_QUOTES.sub(" ", text).split())


def _without_opening(text: str) -> str:
    while found := _OPENING.match(text):
        if found.end() == len(text):
            return ""
        text = text[found.end() :]
    return text.strip()


def _plain(text: str) -> str:
    """A text in small letters without accents, question marks and double spaces."""
    apart = unicodedata.normalize("NFKD", text.casefold())
    plain = "".join(one for one in apart if not unicodedata.combining(one))
    return " ".join(re.sub(r"[¿?!¡:]", " ", plain).split())
