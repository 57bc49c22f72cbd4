"""Messages of EBO and RCIS as strings for the fuzzer, whose letters are bytes."""

from learnblock.ice.encoding import Writer
from learnblock.ice.interface import write_all
from learnblock.ice.messages import (
    HEADER,
    MessageKind,
    open_reply,
    read_header,
    read_reply,
    read_request,
    reply,
    request,
    request_opening,
)
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.ice.robocomp.recognition import Picture
from learnblock.ice.server import Servant, _answer
from learnblock.ice.types import Dictionary, Sequence, Structure, Type
from learnblock.perception.robocomp.serving import Emotions, Tags

KNOWN = {layout: interfaces(layout) for layout in Layout}
OPERATIONS = [
    operation
    for layout in Layout
    for interface in KNOWN[layout].values()
    for operation in interface.operations
]


class Anything:
    """An object that does nothing on any request."""

    def __getattr__(self, name):
        return lambda *_: None


#: Objects that read their arguments; all others do nothing.
LOOKING = {"apriltag": Tags(None), "emotionrecognition": Emotions(None)}
SERVANTS = {
    name: Servant(interface, LOOKING.get(name, Anything()))
    for name, interface in KNOWN[Layout.TOOL].items()
}


def example_of(kind: Type):
    """Return a value of a type."""
    if isinstance(kind, Structure):
        return kind.kind(**{name: example_of(member) for name, member in kind.members})
    if isinstance(kind, Dictionary):
        return {"servo": example_of(kind.value)}
    if isinstance(kind, Sequence):
        return b"\x07\x08" if str(kind.element) == "byte" else [example_of(kind.element)] * 2
    return "text" if str(kind) == "string" else 1


def request_texts():
    """Return a request for each operation."""
    for name, interface in KNOWN[Layout.TOOL].items():
        for operation in interface.operations:
            values = [example_of(kind) for kind in operation.takes]
            yield request_text(name, operation, values)
            if operation.name == "processimage":
                yield request_text(name, operation, [Picture(4, 6, 3, bytes(range(72)))])


def request_text(name, operation, values):
    """Return a request with values."""
    opening = request_opening(name, operation.name, operation.mode)
    parameters = Writer()
    write_all(parameters, operation.takes, values)
    return request(7, opening, parameters.encapsulated()).decode("latin-1")


def reply_texts():
    """Return a reply for each operation, after two bytes that choose the operation."""
    opening = request_opening("it", "it", OPERATIONS[0].mode)
    question = read_request(request(7, opening, Writer().encapsulated())[HEADER.size :])
    for number, operation in enumerate(OPERATIONS):
        gives = Writer()
        write_all(gives, operation.gives, [example_of(kind) for kind in operation.gives])
        yield (number.to_bytes(2, "big") + reply(question, gives)).decode("latin-1")


def read_asked(text):
    """Read a message as a component does, and reply to it."""
    data = text.encode("latin-1", "ignore")
    kind, _ = read_header(data[: HEADER.size].ljust(HEADER.size))
    if kind is MessageKind.REQUEST:
        _answer(SERVANTS, read_request(data[HEADER.size :]))


def read_answer(text):
    """Read a message as a client does."""
    data = text.encode("latin-1", "ignore")
    operation = OPERATIONS[int.from_bytes(data[:2], "big") % len(OPERATIONS)]
    read_header(data[2 : 2 + HEADER.size].ljust(HEADER.size))
    _, body = read_reply(data[2 + HEADER.size :])
    results = open_reply(body)
    for kind in operation.gives:
        kind.read(results)
