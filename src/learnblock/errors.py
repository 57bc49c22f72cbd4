"""Every error LearnBlock raises, and the one shape in which it says what is wrong where.

Each exception belongs to the family `LearnBlockError` and to the builtin it is, so that
`except LearnBlockError` catches ours and `except ValueError` still works for those who never heard
of us. This module imports nothing of ours.
"""

import difflib
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

Severity = Literal["error", "warning"]


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One thing that is wrong in a file that a person wrote, and what to do about it.

    Args:
        code: a short stable name for scripts and tests, such as ``missing-colon``.
        message: one sentence that names the thing, its value and what was expected.
        line: 1 for the first line; 0 where the file as a whole is meant.
        column: 1 for the first character of the line; 0 where the whole line is meant.
        end_column: the column behind the last character meant; 0 where it is not known.
        severity: an ``error`` keeps the program from running, a ``warning`` does not.
    """

    code: str
    message: str
    line: int = 0
    column: int = 0
    end_column: int = 0
    severity: Severity = "error"

    def located(self, filename: str) -> str:
        """The form that editors and scripts read: ``FILE:LINE:COLUMN: code message``."""
        return f"{filename}:{self.line}:{self.column}: {self.code} {self.message}"

    def pointed(self, source: str) -> str:
        """The line of `source` it speaks of with a caret beneath, or "" where it names no line."""
        # Not splitlines: to an editor a form feed begins no line.
        lines = [line.removesuffix("\r") for line in source.split("\n")]
        if not 1 <= self.line <= len(lines):
            return ""
        text = lines[self.line - 1]
        start = min(max(self.column, 1), len(text) + 1) - 1
        # A tab stays a tab under the text, so that the caret stands where the eye expects it.
        indent = "".join("\t" if character == "\t" else " " for character in text[:start])
        width = max(1, min(self.end_column - 1, len(text)) - start)
        return f"{text}\n{indent}{'^' * width}"


class LearnBlockError(Exception):
    """The family of every error we raise."""


class FileError(LearnBlockError, ValueError):
    """A file that a person wrote is wrong: the base of the errors that carry diagnostics.

    Args:
        filename: as the user named it.
        diagnostics: at least one, in the order of the file.
        source: the file's text, for the caret; empty where there is none to show.
    """

    def __init__(self, filename: str, diagnostics: Iterable[Diagnostic], source: str = "") -> None:
        self.filename = filename
        self.diagnostics = tuple(diagnostics)
        self.source = source
        super().__init__("\n".join(diagnostic.located(filename) for diagnostic in self.diagnostics))

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        return type(self), (self.filename, self.diagnostics, self.source)


class ProgramError(FileError):
    """A program in Block-Text or Python cannot be read, or says what cannot be meant."""


class WorldError(FileError):
    """A world's description is wrong."""


class RobotDescriptionError(FileError):
    """A simulated robot's description is wrong."""


class BlockConfigurationError(FileError):
    """A block configuration is wrong."""


class OwnBlockError(FileError):
    """A block of one's own is wrong, or its name, or the file that it was exported to."""


class BlockSetError(FileError):
    """A set of blocks is wrong, or its name."""


class ProjectError(FileError):
    """A project's file or name is wrong, or it cannot be saved."""


class LibraryError(FileError):
    """A library is wrong, or what is to become one."""


class SettingsError(FileError):
    """A setting of a robot is wrong."""


class UnknownNameError(LearnBlockError, LookupError):
    """No robot, world, skill or example has this name."""

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        self.kind, self.name, self.known = kind, name, tuple(known)
        hint = did_you_mean(name, self.known) or "known are: " + ", ".join(self.known)
        super().__init__(f"there is no {kind} `{name}`; {hint}")

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        return type(self), (self.kind, self.name, self.known)


class NewNameError(LearnBlockError, ValueError):
    """A new robot, skill or world cannot have this name."""


class FileTakenError(LearnBlockError, FileExistsError):
    """A new file would replace one that is there."""


class KeyTakenError(LearnBlockError, ValueError):
    """A robot already has a device of this type under this key."""


class DeviceValueError(LearnBlockError, ValueError):
    """A device was given a value that no device of its type can take."""


class RobotConnectionError(LearnBlockError, ConnectionError):
    """The robot cannot be reached, or the link to it broke."""


class IceError(RobotConnectionError):
    """The family of what goes wrong with components that speak Ice."""


class IceEncodingError(IceError, ValueError):
    """A value has not the type that was agreed, or bytes hold no such value."""


class IceLinkError(IceError):
    """A component cannot be reached, does not answer in time, or the link to it broke."""


class IceRefusedError(IceError):
    """A component answered that it cannot do what it was asked for.

    Args:
        sentence: what it said.
        kind: the name of Ice's exception, such as ``OperationNotExistException``.
    """

    def __init__(self, sentence: str, kind: str) -> None:
        self.kind = kind
        super().__init__(sentence)

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        return type(self), (str(self), self.kind)


class NotWrittenError(LearnBlockError, NotImplementedError):
    """A robot's author has not yet filled in a function that its devices are built from."""


class MissingPackageError(LearnBlockError, ImportError):
    """A robot's own library is not installed."""


class RobotStoppedError(LearnBlockError, RuntimeError):
    """The robot was asked for something after it had been stopped and disconnected."""


class RobotAttributeError(LearnBlockError, AttributeError):
    """The robot has no skill of this name."""


class StillTurningError(LearnBlockError, TimeoutError):
    """A turn did not reach its angle within its time limit."""


class ProgramStopped(BaseException):
    """The program is being stopped from outside: by the user, a time limit or a signal.

    It derives from BaseException, as KeyboardInterrupt does, so that a pupil's ``except Exception``
    cannot swallow it.
    """


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """``did you mean `follow`?`` for the nearest of `known`, or "" when none is near."""
    folded = {candidate.casefold(): candidate for candidate in known}
    near = difflib.get_close_matches(name.casefold(), folded, n=1, cutoff=0.6)
    return f"did you mean `{folded[near[0]]}`?" if near else ""
