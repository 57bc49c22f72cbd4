"""Pickles are read opcode by opcode, and nothing in them is run."""

import io
import os
import pickle
import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.errors import LearnBlockError, ProjectError
from learnblock.importing import pickle_reader
from learnblock.importing.pickle_reader import Object, Point, read_pickle
from old_projects import STYLES, Pickler, Spot, Thing, examples, read_text


def code_of(data: bytes) -> str:
    with pytest.raises(ProjectError) as caught:
        read_pickle(data, "old.blockProject")
    return caught.value.diagnostics[0].code


PLAIN = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(2**31), 2**31 - 1)
    | st.floats(allow_nan=False)
    | st.text("añé'\"\\ \n"),
    lambda inner: st.lists(inner) | st.dictionaries(st.text("abc"), inner) | st.tuples(inner),
    max_leaves=8,
)
#: Each example of these tests is a whole file.
FEW = settings(max_examples=30)


@pytest.mark.parametrize("style", STYLES)
@FEW
@given(value=PLAIN)
def test_every_plain_value_comes_back_from_every_version(style, value):
    assert value == read_pickle(Pickler(style).dumps(value), "old.blockProject")


@pytest.mark.parametrize("protocol", range(4))
@FEW
@given(value=PLAIN)
def test_what_python_pickles_comes_back(protocol, value):
    assert value == read_pickle(pickle.dumps(value, protocol), "old.blockProject")


@pytest.mark.parametrize("style", STYLES)
def test_objects_that_contain_each_other_come_back(style):
    block, other = Thing("block"), Thing("connection")
    block.state.update(connections=[other], pos=Spot(1.5, -2))
    other.state.update(parent=block)
    found = read_pickle(Pickler(style).dumps(block), "old.blockProject")
    assert isinstance(found, Object)
    assert found.state["pos"] == Point(1.5, -2)
    assert found.state["connections"][0].state["parent"] is found


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"S'ni\\xc3\\xb1o'\n.", "niño"),
        (b"S'ni\\xf1o'\n.", "niño"),
        (b'S"it\'s"\n.', "it's"),
        (b"U\x05ni\xf1o!.", "niño!"),
        (b"V\\ud83d\\ude00\n.", "\N{GRINNING FACE}"),
    ],
)
def test_texts_of_python_2_are_utf_8_or_else_latin_1(data, text):
    assert text == read_pickle(data, "old.blockProject")


class Attack:
    """Runs a command when Python unpickles it."""

    def __reduce__(self):
        return os.system, ("touch hacked",)


@pytest.mark.parametrize("protocol", range(6))
def test_a_pickle_that_would_run_a_command_is_refused_and_runs_nothing(protocol, tmp_path):
    data = pickle.dumps((Attack(), [], [], [], []), protocol)
    os.chdir(tmp_path)
    assert code_of(data) == "forbidden"
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "data",
    [
        b"c__builtin__\neval\n(S'1'\ntR.",
        b"cos\nsystem\n.",
        b"c__builtin__\nid\n(I1\ntR.",
        b"c__builtin__\nobject\n)R.",
        b"(i__builtin__\neval\n.",
        b"(cBlock\nConnection\nI1\no.",
        b"Pname\n.",
        b"\x82\x01.",
        b"\x80\x04\x95\x00\x00\x00\x00\x00\x00\x00\x00N.",
    ],
)
def test_what_no_project_contains_is_refused(data):
    assert code_of(data) == "forbidden"


@pytest.mark.parametrize(
    "data",
    [
        b"", b".", b"I", b"Ix\n.", b"t.", b"(.", b"S'a\n.", b"X\xff\xff\xff\xffa.", b"g7\n.", b"a.",
        b"Na.", b"(NNNd.", b"((td.", b"((I2\ntI1\nd.", b"]s.", b"b.", b"N}b.", b"p1\n.", b"R.",
        b"cPySide.QtCore\nQPointF\n(S'a'\nNtR.", b"\x8b\xff\xff\xff\xff.", b"V\\u12\n.", b"2.",
        b"L" + b"9" * 100 + b"L\n.", b"T\xff\xff\xff\xff.", b"F1e\n.", b"X\x01\x00\x00\x00\xff.",
    ],
)  # fmt: skip
def test_a_damaged_file_is_refused(data):
    assert code_of(data) == "damaged"


def test_a_file_that_is_too_large_too_deep_or_too_long_is_refused():
    assert code_of(b" " * (pickle_reader.LARGEST + 1)) == "too-large"
    assert code_of(b"(" * (pickle_reader.DEEPEST + 2)) == "too-deep"
    assert code_of(b"N0" * pickle_reader.MOST_STEPS) == "too-many"


def test_a_value_that_repeats_itself_is_read_in_time():
    bomb = b"N" + b"2\x86" * 200_000 + b"."
    start = time.process_time()
    read_pickle(bomb, "old.blockProject")
    assert time.process_time() - start < 5


CORPUS = examples()


@FEW
@given(st.data())
def test_a_damaged_project_gives_our_own_error_and_nothing_else(data):
    original = data.draw(st.sampled_from(CORPUS))
    damaged = bytearray(original)
    for _ in range(data.draw(st.integers(1, 6))):
        start = data.draw(st.integers(0, len(damaged)))
        end = start + data.draw(st.integers(0, 20))
        other = data.draw(st.sampled_from(CORPUS))
        begin = data.draw(st.integers(0, len(other)))
        piece = data.draw(st.binary(max_size=4) | st.just(other[begin : begin + 40]))
        damaged[start:end] = piece
    try:
        read_text(bytes(damaged).decode("latin-1"))
    except LearnBlockError:
        return


def test_the_writer_of_the_tests_writes_valid_pickles():
    class Plain(pickle.Unpickler):
        def find_class(self, module, name):
            made = type(name, (), {"__init__": lambda _, *__: None})
            return (lambda kind, *_: kind()) if name == "_reconstructor" else made

    for style, data in zip(STYLES, examples(), strict=True):
        loaded = Plain(io.BytesIO(data), encoding=style.encoding or "ASCII").load()
        assert {block.name for block in loaded[0].values()} >= {"main", "if", "front_obstacle"}
