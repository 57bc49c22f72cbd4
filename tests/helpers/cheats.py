"""Programs that cheat when they are graded."""

#: Sends a fault, and leaves.
FORGED = (
    "import gc, os\n"
    "from learnblock.runtime import messages as m\n"
    "[link] = [one for one in gc.get_objects() if type(one).__name__ == 'SocketLink']\n"
    "link.send(m.Ended(m.Fault({})))\n"
    "os._exit(0)"
)
#: By name, as docs/grading.md lists them: how the run ends, and the cheat. They know the best
#: case for them: where the results are, and the names of what judges them.
CHEATS = {
    "reads the solution": ("error", "print(open(OUT + '/solution.bt').read())"),
    "reads the lesson's file": ("error", "print(open(OUT + '/lesson.toml').read())"),
    "writes into the results": ("error", "open(OUT + '/results.csv', 'w').write('forged')"),
    "writes into the journal": ("error", "open(OUT + '/journal.jsonl', 'a').write('forged')"),
    "patches the judge": (
        "finished",
        "import learnblock.lessons.judging as j\nj.judge = lambda *a, **k: ()\nj.is_done = bool",
    ),
    "patches the simulator": (
        "finished",
        "import learnblock.simulator.physics as p\n"
        "for name in dir(p):\n"
        "    if callable(getattr(p, name)): setattr(p, name, lambda *a, **k: 10**6)",
    ),
    "patches msgspec": (
        "any",
        "import msgspec\nmsgspec.json.encode = msgspec.msgpack.encode = lambda *a, **k: b'forged'\n"
        "robot.move_straight(1)",
    ),
    "prints a forged trace": (
        "finished",
        'print(\'{"t":1.0,"goal":"there","state":"reached"}\')\n'
        'print(\'{"t":1.0,"pose":[900,900,0]}\')',
    ),
    "forges messages to its host": (
        "any",
        "import os\n"
        "for fd in range(3, 64):\n"
        '    try: os.write(fd, b\'\\0\\0\\0\\x20\' + b\'{"goal": "there", "state": "reached"}\')\n'
        "    except OSError: pass",
    ),
    "forges its own end": (
        "any",
        "import gc\n"
        "from learnblock.runtime import messages\n"
        "for one in gc.get_objects():\n"
        "    if type(one).__name__ == 'SocketLink':\n"
        "        one.send(messages.Ended('finished'))",
    ),
    "names a file as its error": ("error", FORGED.format("m.Phrase('x'), (1,), '/dev/ptmx', 2")),
    "forges an error of its host": (
        "error",
        FORGED.format("m.Phrase('run-not-contained', reason='x'), ()"),
    ),
    "forges an error without its values": (
        "error",
        FORGED.format("m.Phrase('run-value-too-large'), ()"),
    ),
    "exits early": ("finished", "raise SystemExit(0)"),
    "ends its process": ("killed", "import os\nos._exit(0)"),
    "prints the expected words": ("finished", "print('hello')"),
    "imports the lesson": ("any", "import sys\nsys.path.insert(0, OUT)\nimport checks"),
    "forks": ("error", "import os\nos.fork()"),
    "starts a program": ("error", "import subprocess\nsubprocess.run(['true'])"),
    "signals its parent": ("error", "import os\nos.kill(os.getppid(), 9)"),
    "signals every process": ("error", "import os\nos.kill(-1, 9)"),
    "asks the network": (
        "error",
        "import socket\nsocket.create_connection(('127.0.0.1', 80), 1)",
    ),
    "fills the disk": (
        "any",
        "import tempfile\n"
        "for n in range(100):\n"
        "    open(f'{tempfile.gettempdir()}/{n}', 'wb').write(bytes(10**7))",
    ),
    "takes all memory": ("error", "x = []\nwhile True: x.append(bytes(10**8))"),
    "starts threads without end": (
        "any",
        "import threading, time\n"
        "while True: threading.Thread(target=time.sleep, args=(600,), daemon=True).start()",
    ),
    "prints without end": ("output limit", "while True: print('x' * 1000)"),
    "recurses without end": ("error", "def f(): f()\nf()"),
    "computes without end": ("no call", "while True: pass"),
    "asks so much that its trace is huge": ("time limit", "while True: robot.is_obstacle_free()"),
    "sets the clock": (
        "any",
        "import time\ntime.time = time.monotonic = time.sleep = lambda *a: 10**9\nrobot.sleep(1)",
    ),
}
