"""The slowest messages that a page may send, one or more of each kind that is read or parsed."""

import base64
import io
import json
import pickle
import zipfile
from collections.abc import Callable, Iterator

from old_projects import main, project

#: A little less than the limits of the server.
TEXT = 249_000
MESSAGE = 3_900_000

Message = dict[str, object]


def filled(piece: str, size: int = TEXT) -> str:
    """Repeat a piece up to a size."""
    return piece * (size // len(piece))


def in_main(body: str) -> str:
    return f"main:\n{body}\nend\n"


#: By name: a text of a program.
PROGRAMS = {
    "assignments": filled("x = 1\n"),
    "a long sum": "x = 1" + filled(" + 1"),
    "open brackets": "x = " + filled("("),
    "closed brackets": "x = " + "(" * (TEXT // 2) + ")" * (TEXT // 2),
    "open lists": "x = " + filled("["),
    "a chain of dots": "x = a" + filled(".a"),
    "a chain of nots": "x = " + filled("not "),
    "a chain of signs": "x = " + filled("-") + "1",
    "comparisons": "x = 1" + filled(" < 1"),
    "digits": "x = " + filled("9"),
    "a string": 'x = "' + filled("a"),
    "backslashes": 'x = "' + filled("\\"),
    "unknown letters": filled("$"),
    "empty lines": filled("\n"),
    "comments": filled("# a\n"),
    "deep blocks": "".join(f"{'    ' * n}while True:\n" for n in range(340)),
    "one line of calls": filled("function.turn(90) "),
    "unknown words": "".join(f"mientras{n}\n" for n in range(17_000)),
    "names": "".join(f"name{n} = name{n + 1}\n" for n in range(8_500)),
    "functions": "".join(f"def f{n}():\n    pass\nend\n" for n in range(8_000)),
    "commas": "f(" + filled("a, ") + ")",
    "decimal commas": "x = " + filled("0,5 "),
    "quotes": filled('"'),
    "tabs": filled("\t "),
    "colons": filled("a:\n"),
    "lists over lines": "x = [1,\n" + filled("[1,\n"),
    "calls over lines": filled("f(1,\n2,\n"),
    "calls of lists": filled("x = values[i]\n"),
}
_PYTHON = {
    "assignments": PROGRAMS["assignments"],
    "a long sum": PROGRAMS["a long sum"],
    "brackets": PROGRAMS["open brackets"],
    "dots": PROGRAMS["a chain of dots"],
    "signs": PROGRAMS["a chain of signs"],
    "digits": PROGRAMS["digits"],
    "functions": "".join(f"def f{n}():\n    pass\n" for n in range(8_500)),
    "calls": filled("robot.turn(90)\n"),
    "an f-string": 'x = f"' + filled("{x}") + '"',
    "nested lambdas": "x = " + filled("lambda: ") + "1",
    "strings": "x = " + filled('"a" '),
    "tuples": "x = " + filled("1, "),
    "brackets in a string": 'x = "\\"' + filled("(", 200_000) + '" )',
}


def worst_messages() -> Iterator[tuple[str, Message]]:
    """Return each message with its name."""
    for name, text in PROGRAMS.items():
        yield f"EditText, {name}", _edit("blocktext", text)
    for name, text in _PYTHON.items():
        yield f"EditText in Python, {name}", _edit("python", text)
    for name, stacks in _workspaces():
        workspace = {"stacks": stacks, "variables": []}
        yield f"EditBlocks, {name}", {"kind": "EditBlocks", "edit": 1, "workspace": workspace}
    for kind, make in _OTHERS.items():
        for name, values in make():
            yield f"{kind}, {name}", {"kind": kind, **values}


def _edit(notation: str, text: str) -> Message:
    return {"kind": "EditText", "edit": 1, "notation": notation, "text": text[:250_000]}


# Blocks.


def _workspaces() -> Iterator[tuple[str, list[object]]]:
    number = {"type": "math_number", "fields": {"NUM": 1}}
    block = {"type": "lb_main", "id": "a"}
    most = MESSAGE // len(json.dumps(block) + ", ")
    yield "many stacks", [[{**block, "id": str(n)}] for n in range(most - 20_000)]
    yield "one stack", [[{"type": "lb_print", "id": str(n)} for n in range(most - 20_000)]]
    yield "empty stacks", [[] for _ in range(MESSAGE // 5)]
    yield "one id", [[block for _ in range(most)]]
    deep: dict[str, object] = {**number, "id": "0"}
    for n in range(90):
        deep = {"type": "math_arithmetic", "id": f"d{n}", "inputs": {"A": {"block": deep}}}
    yield "deep values", [[deep for _ in range(MESSAGE // len(json.dumps(deep) + ", "))]]
    state = {"items": list(range(MESSAGE // 9))}
    yield "a large mutator", [[{"type": "lb_when", "id": "w", "extraState": state}]]
    yield (
        "a long field",
        [[{"type": "lb_raw", "id": "r", "fields": {"CODE": "x" * (MESSAGE - 200)}}]],
    )


# Files.


def _tomls(size: int) -> Iterator[tuple[str, str]]:
    yield "dotted keys", filled("a.", size - 10) + "b=1"
    yield "quoted dots", filled('"a" . ', size - 10) + "b=1"
    yield "spaced dots", filled('"a b".', size - 10) + "b=1"
    yield "escaped dots", filled('"a\\"b".', size - 10) + "b=1"
    yield "tables", "".join(f"[a{n}]\n" for n in range(size // 10))
    yield "tables of tables", filled("[[a]]\n", size)
    yield "deep lists", "x = " + filled("[", size - 4)
    yield "dotted tables", "".join(f"[{'.'.join('abcdefgh')}.t{n}]\n" for n in range(size // 28))
    yield "keys", "".join(f"k{n}=1\n" for n in range(size // 10))
    yield "inline tables", "x = " + filled("{a=", size - 4)
    yield "digits", "x = " + filled("9", size - 4)
    yield "a string", 'x = """' + filled("a\\\n", size - 10)


def _block_sets() -> Iterator[tuple[str, Message]]:
    for name, text in _tomls(TEXT):
        yield name, {"filename": "a.toml", "text": text}


def _tags() -> Iterator[tuple[str, Message]]:
    for name, text in _tomls(TEXT):
        yield name, {"filename": "a.toml", "text": text}
    yield "lines", {"filename": "a.csv", "text": "".join(f"n{n},{n}\n" for n in range(19_000))}
    wrong = "".join(f"n{n},x\n" for n in range(2000))
    yield "wrong numbers", {"filename": "a.csv", "text": wrong + filled("\n", TEXT - len(wrong))}
    yield "quotes", {"filename": "a.csv", "text": filled('"')}
    yield "commas", {"filename": "a.csv", "text": filled(",")}


def _descriptions() -> Iterator[tuple[str, Message]]:
    for name, text in _tomls(65_000):
        yield name, {"name": "rover", "description": text}


def _imports() -> Iterator[tuple[str, Message]]:
    start = '{"learnblock": 1, "blocktext": '
    for name, rest in {
        "deep": filled("["),
        "lines": '["' + filled('", "') + '"]}',
        "a sum": json.dumps([PROGRAMS["a long sum"]]) + "}",
        "numbers": "[" + filled("1,") + "1]}",
    }.items():
        yield name, {"filename": "a.learnblock", "text": (start + rest)[:250_000]}
    for ending in ("bt", "py"):
        for name, text in PROGRAMS.items():
            yield f".{ending}, {name}", {"filename": f"a.{ending}", "text": text[:250_000]}


def _originals() -> Iterator[tuple[str, Message]]:
    size = TEXT * 3 // 4
    for name, data in {
        "numbers": pickle.dumps(list(range(size // 4)), 2),
        "marks": b"\x80\x02" + b"(" * size,
        "memo": b"\x80\x02]" + b"q\x00" * (size // 2),
        "lists": b"\x80\x02" + b"]" * size + b".",
        "doubled": b"\x80\x02]" + b"(h\x00h\x00eq\x00" * (size // 8),
    }.items():
        content = base64.b64encode(data).decode()
        yield name, {"filename": "a.blockProject", "content": content}
    for name, text in PROGRAMS.items():
        content = base64.b64encode(text.encode()[:size]).decode()
        yield f".lb, {name}", {"filename": "a.lb", "content": content}
    data = project(main(), libraries=[f"l{n}" for n in range(10)])
    content = base64.b64encode(data).decode()
    for name, text in PROGRAMS.items():
        library = base64.b64encode(text.encode()[:250_000]).decode()
        values = {"filename": "a.blockProject", "content": content}
        yield f"libraries, {name}", {**values, "libraries": {f"l{n}": library for n in range(10)}}


def _original_libraries() -> Iterator[tuple[str, Message]]:
    for name, text in PROGRAMS.items():
        content = base64.b64encode(text.encode()[:250_000]).decode()
        yield name, {"filename": "a.lb", "content": content}
    functions = "".join(f"def f{n}():\npass\nend\n" for n in range(10_000))
    content = base64.b64encode(functions.encode()[:250_000]).decode()
    words = base64.b64encode(b"[" * 250_000).decode()
    yield "functions", {"filename": "a.lb", "content": content, "configuration": words}


def _worlds() -> Iterator[tuple[str, Message]]:
    wall = {"from": [0, 0], "to": [100, 100]}
    size = {"size": [5000, 5000]}
    for name, world in {
        "walls": {"wall": [wall] * 60_000},
        "keys": {f"k{n}": 1 for n in range(200_000)},
        "numbers": {"floor": {"size": [1.0] * 800_000}},
        "boxes": {"floor": size, "box": [{"x": n % 70, "y": 1} for n in range(90_000)]},
        "points": {"floor": size, "line": [{"points": [[n % 90, 1] for n in range(250_000)]}]},
    }.items():
        yield name, {"world": {"title": "Mine", **world}}


def _sources() -> Iterator[tuple[str, Message]]:
    functions = "".join(f"def f{n}(robot): pass\n" for n in range(9_000))
    one = "def f(robot, " + "".join(f"a{n}: int = 1, " for n in range(9_000)) + "): pass\n"
    for name, source in {"functions": functions, "arguments": one, **_PYTHON}.items():
        values = {"request": 1, "name": "dance", "configuration": "[]"}
        yield name, {**values, "source": source[:250_000]}
    for name, text in {
        "braces": filled("{", 249_000),
        "entries": "[" + filled("{},", 249_000) + "{}]",
        "keys": "{" + "".join(f'"k{n}":1,' for n in range(9_000)) + '"z":1}',
        "a string": '["' + filled("\\\\", 249_000) + '"]',
    }.items():
        values = {"request": 1, "name": "dance", "source": "def f(robot): pass\n"}
        yield f"configuration of {name}", {**values, "configuration": text}


def _libraries() -> Iterator[tuple[str, Message]]:
    for name, files in {
        "a bomb": {"library.toml": "\0" * 400_000_000},
        "many files": {f"f{n}.py": "" for n in range(6_000)},
        "dotted keys": {"library.toml": filled("a.") + "b=1"},
        "functions": {"songs.py": "".join(f"def f{n}(robot): pass\n" for n in range(40_000))},
    }.items():
        content = base64.b64encode(_zipped(files)).decode()
        yield name, {"files": [{"filename": "songs.lblib", "content": content}]}


def _zipped(files: dict[str, str]) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return data.getvalue()


def _sets() -> Iterator[tuple[str, Message]]:
    names = [f"lb_skill_{n}" for n in range(1_000)]
    yield "names", {"set": {"name": "lesson", "show": {"blocks": names}}}
    yield "one name", {"set": {"name": "lesson", "hide": {"blocks": ["lb_main"] * 1_000}}}


def _settings() -> Iterator[tuple[str, Message]]:
    yield "a long text", {"robot": "ev3", "values": {"address": "x" * (MESSAGE - 200)}}
    yield "numbers", {"robot": "ev3", "values": {"wheel_radius": [1] * 1_000_000}}


def _trials() -> Iterator[tuple[str, Message]]:
    for name, source in _PYTHON.items():
        yield name, {"name": "dance", "source": source[:250_000], "arguments": []}


def _lessons() -> Iterator[tuple[str, Message]]:
    step = {"title": "Drive", "phase": "make", "text": "Drive.", "world": "empty"}
    lesson = {"title": "Drive", "level": 1, "minutes": 9, "aims": ["Drive"], "robots": ["sim-ebo"]}

    def message(count: int, **values: object) -> Message:
        steps = [{**step, **values} for _ in range(count)]
        return {"edited": {"content": {**lesson, "step": steps}}}

    yield "open fences", message(26, text=filled("```blocks\n", 8_000))
    yield "fences", message(26, text=filled("```blocks\npass\n```\n", 8_000))
    yield "pictures", message(30, text=filled("![", 8_000))
    yield "checks", message(30, check=[{"kind": "goals"} for _ in range(300)])
    yield "long lists", message(1, check=list(range(MESSAGE // 9)))
    texts = [PROGRAMS["assignments"][:59_000], filled("if True:\n", 59_000), filled("(", 59_000)]
    for name, text in zip(("assignments", "ifs", "brackets"), texts, strict=True):
        programs = [{"solution": {"text": text}} for _ in range(2)]
        edited = {"content": {**lesson, "step": [step] * 2}, "steps": programs}
        yield name, {"edited": edited}


_OTHERS: dict[str, Callable[[], Iterator[tuple[str, Message]]]] = {
    "ReadBlockSet": _block_sets,
    "ReadTags": _tags,
    "MakeRobot": _descriptions,
    "Import": _imports,
    "ImportOriginal": _originals,
    "ConvertLibrary": _original_libraries,
    "CheckWorld": _worlds,
    "CheckCustomBlock": _sources,
    "ReadLibraries": _libraries,
    "ChooseBlockSet": _sets,
    "ExportBlockSet": _sets,
    "ChangeSettings": _settings,
    "TryCustomBlock": _trials,
    "ExamineLesson": _lessons,
}
