"""The words of questions, in English and Spanish, and what they mean.

All words are in small letters and without accents. A word that ends in a star stands for all words
that begin like it.
"""

import re
import unicodedata
from collections.abc import Collection, Iterator
from difflib import get_close_matches
from enum import StrEnum
from functools import cache
from string import ascii_lowercase


class Concept(StrEnum):
    """What a word of a question means."""

    NOT = "not"
    NOTHING = "nothing"
    KEEP = "keep"
    LONG = "long"
    FIRST = "first"
    AGAIN = "again"
    STOP = "stop"
    TURN = "turn"
    CURVE = "curve"
    LEFT = "left"
    RIGHT = "right"
    BACK = "back"
    FORWARD = "forward"
    MOVE = "move"
    AVOID = "avoid"
    CRASH = "crash"
    FALL = "fall"
    SLOW = "slow"
    FAST = "fast"
    LEAVE = "leave"
    FOLLOW = "follow"
    SEARCH = "search"
    SEE = "see"
    TRACK = "track"
    WALL = "wall"
    EDGE = "edge"
    TAG = "tag"
    END = "end"
    ERROR = "error"
    PROGRAM = "program"
    GOAL = "goal"
    PRINT = "print"
    SAY = "say"
    SHOW = "show"
    FACE = "face"
    JOY = "joy"
    SADNESS = "sadness"
    ANGER = "anger"
    FEAR = "fear"
    DISGUST = "disgust"
    SURPRISE = "surprise"
    NEUTRAL = "neutral"
    LAMP = "lamp"
    SOUND = "sound"
    SCREEN = "screen"
    CAMERA = "camera"
    PEN = "pen"
    COLOUR = "colour"
    #: Only a part of a sentence.
    FILLER = "filler"


EMOTIONS = (
    Concept.JOY,
    Concept.SADNESS,
    Concept.ANGER,
    Concept.FEAR,
    Concept.DISGUST,
    Concept.SURPRISE,
    Concept.NEUTRAL,
)

_WORDS: dict[Concept, str] = {
    Concept.NOT: (
        "not no never nunca jamas tampoco nt didnt doesnt dont wasnt isnt hasnt havent wont"
        " cant cannot arent werent couldnt without sin dosnt dosent"
    ),
    Concept.NOTHING: "nothing nada",
    Concept.KEEP: (
        "keep* kept still todavia aun continu* sigue* siga* seguia* constant* always siempre"
        " forever"
    ),
    Concept.STOP: (
        "stop* halt* brake* braking stand* stood still paro paraba parar parado parada paras"
        " pare paran deten* detien* detuv* fren* quiet* inmovil* wait* esper* stuck frozen"
        " freez* froze atasc* atranc* bloqueado bloqueada bloquea trabado"
    ),
    Concept.TURN: (
        "turn* spin* spun rotat* gir* dobl* tuerc* torc* bend* bent veer* steer* vuelta*"
        " circle* circulo* swerv* desvi* swing*"
    ),
    Concept.CURVE: "curv*",
    Concept.LEFT: "left* izquierd* izq",
    Concept.RIGHT: "right derech* der",
    Concept.BACK: (
        "back backs backed backing backward* revers* retroced* atras vuelve* volv* regres*"
        " return* retreat*"
    ),
    Concept.FORWARD: "forward* straight ahead adelante recto recta avanz* approach* acerc* advanc*",
    Concept.MOVE: (
        "move* moving drive* drove driving driven go goes going gone went travel* mover* movi*"
        " movio muev* anda andar andaba camin* ir va van iba fue conduc* arranc* roll* walk* run"
        " runs running corr* viaj*"
    ),
    Concept.AVOID: "avoid* away evit* esquiv* apart* alej* escap* dodge* huy* hui*",
    Concept.CRASH: (
        "crash* bump* bang* hit hits hitting collid* collision* choc* choqu* golp* estrell*"
        " tropez* tropiez* smash* slam* knock* touch* toc*"
    ),
    Concept.FALL: "fall* fell drop* cae caen caer* cayo caia caido caida",
    Concept.SLOW: "slow* lent* despacio",
    Concept.FAST: "fast* quick* rapid* deprisa speed* veloc*",
    Concept.LEAVE: (
        "leave* leaving lose* losing lost off pierde* perd* sale salio salir sali* saliendo"
    ),
    Concept.FOLLOW: "follow* seguir* sigui*",
    Concept.SEARCH: "search* seek* look* find* found busc* encontr* encuentr* mira mirar miro",
    Concept.SEE: (
        "see sees saw seen seeing notic* sens* detect* recogni* ve ver vio veia visto reconoc*"
        " sinti*"
    ),
    Concept.TRACK: "track linea pista camino raya",
    Concept.WALL: (
        "wall* box* block* thing* obstacle* pared* caja* bloque* cosa* muro* objeto* obstaculo*"
        " crate* barrel* bench* barril* banco* object* stuff something algo ball* pelota*"
    ),
    Concept.EDGE: "edge* table* borde* mesa* cliff* suelo floor ground",
    Concept.TAG: "tag* marker* sign* etiqueta* marca* cartel*",
    Concept.END: "end ended ends ending finish* over termin* acab* quit* exit* fin",
    Concept.ERROR: (
        "error* fail* broke broken break* bug* fallo fallar falla fallado exception* traceback"
        " mistake* rompe* rompi* roto averi*"
    ),
    Concept.PROGRAM: "program* code codigo script dance* danc* song* bail* cancion* melod*",
    Concept.GOAL: "goal* objetivo* meta* target* alcanz* reach* mission mision",
    Concept.PRINT: (
        "print* write* wrote writing written escrib* escrito imprim* imprima* output console"
        " consola text texto* message* mensaje*"
    ),
    Concept.SAY: (
        "say says said saying dice* dijo decir dicho speak* talk* habl* repeat*"
        " repit* count* cuenta*"
    ),
    Concept.SHOW: "show* display* mostr* muestr* ensen* put* pone* pon puso poner",
    Concept.FACE: "face* cara* carita* express* emotion* emocion* feel* siente* sentimiento*",
    Concept.JOY: (
        "joy* happy happi* smil* laugh* glad cheer* content* feliz alegr* sonri* rie reir risa"
        " celebrat* celebr*"
    ),
    Concept.SADNESS: "sad sadness sadly sadder cry* cries triste* llor* pena",
    Concept.ANGER: "anger angry mad furious enfad* enoj* ira",
    Concept.FEAR: "fear* scare* scary afraid fright* terrif* miedo* asust*",
    Concept.DISGUST: "disgust* yuck* asco asque*",
    Concept.SURPRISE: "surpris* sorpr* amaz* astonish* asombr*",
    Concept.NEUTRAL: "neutral* emotionless",
    Concept.LAMP: "lamp* light* led leds luz luces lampara* semaforo* bombilla*",
    Concept.SOUND: (
        "sound* noise* tone* note* music* beep* sonido* sonar* suena* nota* musica* pitido* ruido*"
    ),
    Concept.SCREEN: "screen* pantalla*",
    Concept.CAMERA: "camera* camara*",
    Concept.PEN: "pen draw* drawing drew lapiz dibuj* pint*",
    Concept.COLOUR: (
        "colour* color colors colores red green blue yellow orange purple white black pink rojo"
        " roja rojos rojas verde* azul* amarill* naranja* morad* lila* violeta* blanc* negr*"
        " rosa*"
    ),
    Concept.FILLER: (
        "why what how when where which who whose that this these those the a an and or but if"
        " then than so too very just only even really please my your its it he she they them his"
        " her robot does did do is was are were be been being has have had will would can could"
        " should made make makes making get gets got to of on in into onto at by for from with"
        " as im me i you we there here now yet already some any all every each one two three"
        " time times way because after before until between around about up down out much many"
        " more most little bit good bad want wanted came come comes coming instead happen* want*"
        " need* suppos* try tries trying began begin* start* front side sides both another other"
        " same again once por que porque pq xq q k como cuando donde cual el la los las lo un"
        " una unos unas de del al en y e o u si se su sus mi mis tu te le les ha han hay es esta"
        " estan estaba era son ser estar hace hacer hizo hacia hago haga con para contra sobre"
        " hasta desde entre antes despues muy tan tanto tanta todo toda todos todas mas menos"
        " solo ya ahi aqui alli este ese esa cada vez veces rato tiempo primero luego entonces"
        " pero yo nos lugar momento debe deberia tiene tener tenia pasa paso pasar ocurr* llega"
        " llegar llego empez* empiez* quier* queria robots segundo segundos second seconds sec s"
        " doing done haciendo tell tells told delante detras encima debajo girl boy man"
        " woman men kid hombre mujer chico chica"
    ),
}

#: Words that mean something else together, in the order of the search.
_TOGETHER: tuple[tuple[str, str], ...] = (
    (r"\b(?:i )?(?:dont|do not|cant|cannot) (?:know|understand|get|see) (?=why|what)", ""),
    (r"\bno (?:se|entiendo|comprendo|veo) (?=por que|porque|que)", ""),
    (r"\b(?:no|nt|not|never|nunca) (?:para|deja|paran?|dejan?) de\b", "keep"),
    (r"\b(\w*nt|not|never|wont) (?:stop|quit|finish) (?=\w+ing\b)", "keep "),
    (
        r"\b(?:again and again|over and over|all the time|without stopping)\b"
        r"|\b(?:todo el (?:rato|tiempo)|una y otra vez|sin (?:parar|cesar))\b",
        "keep",
    ),
    (r"\b(?:round and round|in circles?|in a circle|around and around)\b", "turn"),
    (r"\b(?:turn(?:s|ed)?|go(?:es)?|going|went) (?:a)?round\b", "turn"),
    (r"\bda(?:r|n|ndo|ba)? (?:muchas )?vueltas?\b", "turn"),
    (r"\bse da (?:un golpe )?(?:contra|con)\b", "crash"),
    (r"\b(?:run|ran|runs|drive|drove|drives|go|goes|went|running|driving) into\b", "crash"),
    (r"\b(?:right|straight) (?:away|now|at the start)\b|\bat once\b", "immediately"),
    (
        r"\bimmediately\b|\b(?:so|too|very) (?:early|soon)\b|\btan pronto\b|\bdemasiado pronto\b"
        r"|\ben ?seguida\b|\bde inmediato\b|\bat (?:the )?(?:very )?(?:start|beginning|first)\b"
        r"|\bal (?:principio|inicio|empezar|comienzo)\b|\bnada mas empezar\b",
        "firsttime",
    ),
    (r"\bat (?:the )?(?:very )?end\b|\bal (?:final|acabar|terminar)\b", " "),
    (
        r"\b(?:so|too|very|that|for) long\b|\b(?:tanto|demasiado|mucho) (?:tiempo|rato)\b"
        r"|\b(?:so|too) (?:far|much)\b|\btan lejos\b|\bdemasiado lejos\b",
        "longtime",
    ),
    (
        r"\b(?:only|just|solo|solamente) (?:does it )?(\w+ )?(?:once|one time|una vez)\b",
        r"\1 oncemore",
    ),
    (r"\bonce only\b", "oncemore"),
    (
        r"\b(?:come|came|comes|coming|go|goes|went|going|drive|drives|drove) back(?:wards?)?\b",
        "back",
    ),
    (r"\b(?:hacia|para|marcha|da|va) atras\b|\bmarcha atras\b", "back"),
    (r"\b(?:left|leaves?|leaving|lost|loses?|losing|off) (?:\w+ )?(?:line|track)\b", "leave track"),
    (r"\bfollow(?:s|ing|ed)? (?:\w+ )?(?:line|track)\b|\bwith the line\b", "follow track"),
    (r"\bsig(?:ue|uio|uiendo|a) (?:la|el) (?=linea|pista|camino|raya)", "follow "),
    (r"\b(?:black|red|blue|the) line\b(?! \d)", "track"),
    (r"\b(?:look(?:s|ed|ing)?|search\w*|seek\w*) (?:for|around)\b", "search"),
    (r"\ben marcha\b", "move"),
    (r"\bpara que\b", " "),
    (r"\bpara\b(?= *$|(?= (?:en|a|de|delante|ante|al|cuando|nunca|solo)\b))", "paro"),
    (r"\b(no|se) para\b", r"\1 paro"),
    (r"\bnot? (?:enough|longer)\b", "not"),
)
_TOGETHER_COMPILED = tuple((re.compile(pattern), to) for pattern, to in _TOGETHER)
_MADE_WORDS = {"firsttime": Concept.FIRST, "longtime": Concept.LONG, "oncemore": Concept.AGAIN}

#: Shorter words are taken as they are written.
_SHORTEST_SLIP = 4
#: The same for a word that begins like a known one, and has a typo as well.
_LONGEST_END = 4
#: How similar a word has to be to one that is known.
_ALIKE = 0.8


def plain(text: str) -> str:
    """A text in small letters without accents, question marks and double spaces."""
    apart = unicodedata.normalize("NFKD", text.casefold())
    bare = "".join(character for character in apart if not unicodedata.combining(character))
    return " ".join(re.sub(r"[¿?!¡:]", " ", bare).split())


def words(text: str) -> list[str]:
    """The words of a plain text, those that belong together as one."""
    text = re.sub(r"['’`´]", "", text)
    text = " ".join(re.sub(r"[^\w.]", " ", text).replace(". ", " ").strip(".").split())
    for pattern, together in _TOGETHER_COMPILED:
        text = pattern.sub(together, text)
    return text.split()


def concept(word: str) -> Concept | None:
    """What a word means; None if it is unknown."""
    exact, stems = _table()
    if word in exact:
        return exact[word]
    return next(
        (stems[word[:size]] for size in range(len(word), 2, -1) if word[:size] in stems), None
    )


def corrected(word: str, others: Collection[str] = ()) -> str:
    """An unknown word without its typo, if it is similar to a known one.

    Args:
        word: as it was written.
        others: other known words, such as names of the program.
    """
    if len(word) < _SHORTEST_SLIP or not word.isalpha():
        return word
    exact, _ = _table()
    slips, exchanged = dict.fromkeys(_slips(word)), dict.fromkeys(_exchanged(word))
    for is_known, tried in (
        (others.__contains__, slips),
        (exact.__contains__, slips),
        (_is_nearly_whole, slips),
        (others.__contains__, exchanged),
        (exact.__contains__, exchanged),
    ):
        if likely := next((candidate for candidate in tried if is_known(candidate)), None):
            return likely
    known_words = [
        known_word for known_word in (*others, *exact) if len(known_word) >= _SHORTEST_SLIP
    ]
    near = get_close_matches(word, known_words, n=1, cutoff=_ALIKE)
    return near[0] if near else word


def _is_nearly_whole(word: str) -> bool:
    """Whether little is left of a word after a known beginning."""
    _, stems = _table()
    return any(
        word[:size] in stems for size in range(max(3, len(word) - _LONGEST_END), len(word) + 1)
    )


def _slips(word: str) -> Iterator[str]:
    """The candidates for a word with an extra letter, a missing one, or two swapped ones."""
    parts = [(word[:index], word[index:]) for index in range(len(word) + 1)]
    yield from (left + right[1] + right[0] + right[2:] for left, right in parts if len(right) > 1)
    yield from (left + right[1:] for left, right in parts if right)
    yield from (left + letter + right for left, right in parts for letter in ascii_lowercase)


def _exchanged(word: str) -> Iterator[str]:
    """The candidates for a word with one letter replaced; a short one is another word."""
    for index in range(len(word)) if len(word) > _SHORTEST_SLIP else ():
        yield from (word[:index] + letter + word[index + 1 :] for letter in ascii_lowercase)


@cache
def _table() -> tuple[dict[str, Concept], dict[str, Concept]]:
    """Whole words, and the beginnings of words, with their concepts."""
    exact: dict[str, Concept] = dict(_MADE_WORDS)
    stems: dict[str, Concept] = {}
    for meaning, written in _WORDS.items():
        for word in written.split():
            table = stems if word.endswith("*") else exact
            table.setdefault(word.removesuffix("*"), meaning)
    return exact, stems
