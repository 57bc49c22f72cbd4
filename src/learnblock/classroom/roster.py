"""The pupils of a class, as its file keeps them."""

import re
import secrets
import shutil
import threading
import time
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from itertools import count
from pathlib import Path
from typing import Annotated

import msgspec

from learnblock import names
from learnblock.blocks.block_sets import EVERYTHING, BuiltIn
from learnblock.classroom.join_words import new_join_word
from learnblock.classroom.pins import Picture, Pin, new_pictures
from learnblock.errors import LearnBlockError
from learnblock.project.files.lesson_folder import LessonName
from learnblock.storage.files import save
from learnblock.storage.home import home
from learnblock.storage.learned_types import learned

#: The most pupils of a class.
MOST_PUPILS = 60
#: The pupils who join without the teacher's consent, and for how many more it is given.
EXPECTED, MORE = 34, 5
#: The most pupils with one name: each of them makes it slower to recognise the others.
MOST_ALIKE = 4
FILE = "class.json"
_VERSION = 1
#: A larger file is not ours.
_LARGEST = 1_000_000
#: The name of a class.
_TITLE = re.compile(r"\w(?:[\w .-]{0,38}\w)?")

PupilId = Annotated[str, msgspec.Meta(pattern="^[a-z0-9]{10}$")]


class AsksTeacherError(LearnBlockError):
    """So many pupils have joined that the teacher has to let a new one in."""


class Pupil(msgspec.Struct, frozen=True):
    """A pupil.

    Args:
        id: names the pupil's folder and address.
        name: the first name, as the pupil wrote it.
        pin: the four pictures.
        joined: seconds since 1970.
        badges: counts the PINs, since a new one makes browsers ask for it again.
    """

    id: PupilId
    name: str
    pin: Pin
    joined: float
    badges: int = 0


class ClassFile(msgspec.Struct, frozen=True):
    """What the file of a class has.

    Args:
        version: of the format.
        title: the name of the class.
        word: with which pupils join.
        key: gives access to the teacher's wall; only the teacher has it.
        secret: signs what browsers keep.
        open: whether new pupils can join.
        expected: how many pupils may join before the teacher is asked.
        lesson: with which pupils begin who have no project yet; None for none.
        project: the name of the projects that are made for it.
        blocks: the block set of the projects that pupils begin themselves.
        pupils: in the order in which they joined.
    """

    version: int
    title: str
    word: str
    key: str
    secret: str
    open: bool = True
    expected: int = EXPECTED
    lesson: LessonName | None = None
    project: str = ""
    blocks: BuiltIn = EVERYTHING
    pupils: tuple[Pupil, ...] = ()


class Roster:
    """The file of a class, which is written with every change.

    Several threads may use it.

    Args:
        folder: of the class; a new class is made if it has none.
        title: the name of a new class.

    Raises:
        LearnBlockError: the file is damaged or belongs to a newer version.
        OSError: it can't be read or written.
    """

    def __init__(self, folder: Path, title: str) -> None:
        self.folder = folder
        self._lock = threading.Lock()
        #: Checked where there is no such pupil, so that a stranger can't tell by the time it takes.
        self._unused_pin = Pin.of(new_pictures())
        file = read_class(folder)
        self._file = file or _new_class(title)
        # Another process may write to one that is there, as while an open class is graded.
        if file is None:
            self._save(self._file)

    @property
    def title(self) -> str:
        """The name of the class."""
        return self._file.title

    @property
    def word(self) -> str:
        """The word with which pupils join."""
        return self._file.word

    @property
    def key(self) -> str:
        """The teacher's key."""
        return self._file.key

    @property
    def secret(self) -> str:
        """What signs the badges of browsers."""
        return self._file.secret

    @property
    def is_open(self) -> bool:
        """Whether new pupils can join."""
        return self._file.open

    @property
    def lesson(self) -> str | None:
        """The lesson with which pupils begin who have no project yet."""
        return self._file.lesson

    @property
    def project(self) -> str:
        """The name of the projects that are made for that lesson."""
        return self._file.project

    @property
    def blocks(self) -> BuiltIn:
        """The block set of the projects that pupils begin themselves."""
        return self._file.blocks

    @property
    def pupils(self) -> tuple[Pupil, ...]:
        """The pupils, in the order in which they joined."""
        return self._file.pupils

    def find(self, id: str) -> Pupil | None:  # noqa: A002 - as in `Pupil`
        """The pupil with this id, if there is one."""
        return next((pupil for pupil in self.pupils if pupil.id == id), None)

    def folder_of(self, pupil: Pupil) -> Path:
        """The folder with everything that a pupil has made."""
        return self.folder / "pupils" / pupil.id

    def add(self, name: str) -> tuple[Pupil, tuple[Picture, ...]]:
        """Add a pupil, and return it with the pictures, which are not stored.

        Raises:
            LearnBlockError: this is not a name, or see `require_place`.
        """
        name = checked_name(name)
        with self._lock:
            self.require_place(name)
            pictures = self._free_pictures(name)
            id = secrets.token_hex(5)  # noqa: A001 - as in `Pupil`
            pupil = Pupil(id, name, Pin.of(pictures), time.time())
            self._change(pupils=(*self.pupils, pupil))
        return pupil, pictures

    def admit(self, id: str, name: str) -> Pupil:  # noqa: A002 - as in `Pupil`
        """The pupil with this id, whom others have recognised; a new one is added.

        Raises:
            LearnBlockError: the class is full.
        """
        with self._lock:
            if pupil := self.find(id):
                return pupil
            if len(self.pupils) >= MOST_PUPILS:
                raise LearnBlockError("class-full", most=MOST_PUPILS)
            pupil = Pupil(id, name, Pin.of(new_pictures()), time.time())
            self._change(pupils=(*self.pupils, pupil))
        return pupil

    def recognise(self, name: str, pictures: Sequence[Picture]) -> Pupil | None:
        """The pupil with this name and these pictures, if there is one.

        It takes as long for a name that is not in the class.
        """
        alike = self._alike(name)
        fits = [pupil for pupil in alike if pupil.pin.fits(pictures)]
        if not alike:
            self._unused_pin.fits(pictures)
        return fits[0] if fits else None

    def require_place(self, name: str) -> None:
        """Check that a new pupil can join.

        Raises:
            LearnBlockError: the class is closed or full, the teacher has to be asked, or there are
                too many of this name.
        """
        if not self.is_open:
            raise LearnBlockError("class-closed")
        if len(self.pupils) >= MOST_PUPILS:
            raise LearnBlockError("class-full", most=MOST_PUPILS)
        if len(self.pupils) >= self._file.expected:
            raise AsksTeacherError("class-asks-teacher")
        if len(self._alike(name)) >= MOST_ALIKE:
            raise LearnBlockError("class-name-taken", name=name, most=MOST_ALIKE)

    def _alike(self, name: str) -> list[Pupil]:
        """The pupils whose names are the same but for spelling."""
        wanted = names.folded(name)
        return [pupil for pupil in self.pupils if names.folded(pupil.name) == wanted]

    def renew_pin(self, pupil: Pupil) -> tuple[Picture, ...]:
        """Give a pupil other pictures, and return them; browsers ask for them again."""
        with self._lock:
            pictures = self._free_pictures(pupil.name)
            renewed = msgspec.structs.replace(pupil, pin=Pin.of(pictures), badges=pupil.badges + 1)
            self._replace(pupil, renewed)
        return pictures

    def expect_more(self) -> None:
        """Let a few more new pupils join than so far."""
        with self._lock:
            self._change(expected=max(self._file.expected, len(self.pupils)) + MORE)

    def remove(self, pupil: Pupil) -> None:
        """Delete a pupil with everything that the pupil has made.

        Raises:
            OSError: some of the files can't be deleted; the pupil stays in the class.
        """
        with self._lock:
            folder = self.folder_of(pupil)
            if folder.exists():
                shutil.rmtree(folder)
            self._change(pupils=tuple(other for other in self.pupils if other.id != pupil.id))

    def prepare(self, lesson: str | None, project: str, blocks: BuiltIn) -> None:
        """Set with which lesson pupils begin, and the block set of their own projects."""
        with self._lock:
            self._change(lesson=lesson, project=project, blocks=blocks)

    def let_join(self, *, open: bool) -> None:  # noqa: A002 - as in the file
        """Let new pupils join, or no more."""
        with self._lock:
            self._change(open=open)

    def renew_word(self) -> None:
        """Take another word for joining."""
        with self._lock:
            self._change(word=new_join_word())

    def _free_pictures(self, name: str) -> tuple[Picture, ...]:
        """Pictures that no pupil with the same name has."""
        while True:
            pictures = new_pictures()
            if self.recognise(name, pictures) is None:
                return pictures

    def _replace(self, pupil: Pupil, other: Pupil) -> None:
        self._change(
            pupils=tuple(other if member.id == pupil.id else member for member in self.pupils)
        )

    def _change(self, **values: object) -> None:
        changed = msgspec.structs.replace(self._file, **values)
        self._save(changed)
        self._file = changed

    def _save(self, file: ClassFile) -> None:
        save(self.folder / FILE, msgspec.json.encode(file), private=True)


def names_of(pupils: Sequence[Pupil]) -> Mapping[str, str]:
    """What the teacher calls each pupil, by id: the name; pupils of one name have numbers, too.

    Args:
        pupils: in the order in which they joined.
    """
    bearers = Counter(pupil.name for pupil in pupils)
    names: dict[str, str] = {}
    taken = set(bearers)
    for pupil in pupils:
        names[pupil.id] = pupil.name if bearers[pupil.name] == 1 else _numbered(pupil.name, taken)
        taken.add(names[pupil.id])
    return names


def _numbered(name: str, taken: Collection[str]) -> str:
    """A name with the first number that makes it different from those that are taken."""
    return next(text for n in count(1) if (text := f"{name} {n}") not in taken)


def wall_address(address: str, key: str) -> str:
    """The address of the teacher's wall of the class at an address, with the key."""
    return f"{address}/teacher?key={key}"


def known_class(title: str) -> Roster:
    """The class with this name in the user's folder.

    Raises:
        LearnBlockError: there is none.
    """
    return Roster(known_folder(title), title)


def known_folder(title: str) -> Path:
    """The folder of the class with this name.

    Raises:
        LearnBlockError: there is none.
    """
    folder = class_folder(title)
    require_class(folder, title)
    return folder


def require_class(folder: Path, title: str) -> None:
    """Check that a folder is that of a class.

    Raises:
        LearnBlockError: it is not.
    """
    if not (folder / FILE).is_file():
        raise LearnBlockError("class-unknown", title=title, folder=str(folder))


def classes_folder() -> Path:
    """The folder with the classes of this user."""
    return home() / "classes"


def class_folder(title: str) -> Path:
    """Where a class is kept by default.

    Raises:
        LearnBlockError: no class can have this name.
    """
    if not _TITLE.fullmatch(title):
        raise LearnBlockError("class-bad-title")
    return classes_folder() / title


def checked_name(name: str) -> str:
    """A first name without spaces around it.

    Raises:
        LearnBlockError: it is empty, too long, or no name.
    """
    name = names.normalized(name)
    flaw = names.flaw_of_first_name(name)
    if flaw and flaw.hidden:
        raise LearnBlockError("class-hidden-character", character=flaw.hidden)
    if flaw:
        raise LearnBlockError("class-no-name", most=names.LONGEST)
    return name


def _new_class(title: str) -> ClassFile:
    return ClassFile(
        _VERSION, title, new_join_word(), secrets.token_urlsafe(24), secrets.token_urlsafe(32)
    )


def read_class(folder: Path) -> ClassFile | None:
    """The file of a class; None if there is none in the folder.

    Raises:
        LearnBlockError: it is damaged, or belongs to a newer version.
        OSError: it can't be read.
    """
    path = folder / FILE
    try:
        data = path.read_bytes()[: _LARGEST + 1]
    except FileNotFoundError:
        return None
    try:
        file = msgspec.json.decode(data, type=learned(ClassFile))
    except (msgspec.MsgspecError, UnicodeError, RecursionError) as error:
        raise LearnBlockError("class-damaged", file=str(path), reason=str(error)) from error
    if file.version > _VERSION:
        raise LearnBlockError("class-newer", file=str(path))
    return file
