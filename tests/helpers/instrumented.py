"""Run instrumented programs in tests."""

from typing import Any

from learnblock.runtime.log.instrumenting import instrument


def execute(source: str, variables: dict[str, Any], *, told: bool = True) -> dict[str, Any]:
    """Run a program, instrumented or not; return its variables."""
    program = instrument(source).tree if told else source
    exec(compile(program, "program.py", "exec"), variables)  # noqa: S102 - our own programs
    return variables
