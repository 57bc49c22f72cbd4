"""Help: fast in English, complete in every other language."""

import re
import subprocess
import sys

import click
import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.cli.commands import COMMANDS, load
from learnblock.cli.help_texts import COMMON_CODES, english
from learnblock.cli.usage_errors import AROUND, CODES, translated
from learnblock.i18n import languages
from places import ROOT

WORDS = ROOT / "src" / "learnblock" / "i18n"


def help_codes(language):
    lines = (WORDS / language / "help.ftl").read_text("utf-8").splitlines()
    return [line.partition(" ")[0] for line in lines if line.startswith("help-")]


@pytest.mark.parametrize("language", languages()[1:])
def test_each_command_and_option_has_help_in_each_language_and_no_entry_is_left_over(language):
    asked = {*COMMON_CODES.values(), *CODES.values(), *AROUND.values(), *dict(english(main, ()))}
    for name in COMMANDS:
        asked |= dict(english(load(name), (name,))).keys()
    written = help_codes(language)
    assert sorted(asked) == sorted(written)


@pytest.mark.parametrize("name", COMMANDS)
def test_the_list_of_commands_shows_the_first_sentence_of_each_help(name):
    first = load(name).help.partition("\n\n")[0]
    assert f"{COMMANDS[name].summary}." == " ".join(first.split())


def test_english_help_imports_no_command_and_no_words():
    code = (
        "import sys; from learnblock.cli import main\n"
        "try: main(['--help'])\n"
        "except SystemExit: pass\n"
        "print(*sys.modules, file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={"LEARNBLOCK_LANGUAGE": "en", "PATH": ""},
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = set(done.stderr.split())
    commands = {f"learnblock.cli.{place.module}" for place in COMMANDS.values()}
    assert not loaded & {*commands, "fluent.runtime", "learnblock.errors", "msgspec", "numpy"}


@pytest.mark.parametrize(
    ("arguments", "environment", "expected"),
    [
        (["--language", "es", "--help"], {}, "Uso: "),
        (["--help"], {"LEARNBLOCK_LANGUAGE": "es"}, "Uso: "),
        (["--help"], {"LC_ALL": "es_ES.UTF-8"}, "Uso: "),
        (["--help"], {"LANG": "de_DE.UTF-8", "LC_ALL": "", "LC_MESSAGES": ""}, "Usage: "),
        (["--language", "en", "--help"], {"LEARNBLOCK_LANGUAGE": "es"}, "Usage: "),
        (["--language", "es", "robots", "set", "--help"], {}, "Uso: "),
    ],
)
def test_the_reader_s_language_is_that_of_the_option_or_the_environment(
    arguments, environment, expected
):
    shown = CliRunner().invoke(main, arguments, env={"LEARNBLOCK_LANGUAGE": None, **environment})
    assert shown.exit_code == 0
    assert shown.output.startswith(expected)


def test_translated_help_keeps_the_examples_and_the_options_of_the_command():
    shown = CliRunner().invoke(main, ["--language", "es", "robots", "set", "--help"]).output
    assert "Muestra o cambia los ajustes de un robot real." in shown
    assert "  learnblock robots set ev3 wheel_radius 28\n" in shown
    assert "--default" in shown
    assert "Opciones:" in shown


def test_errors_are_in_the_reader_s_language():
    command = ["--language", "es", "robots", "set", "cozmo", "--default"]
    shown = CliRunner().invoke(main, command)
    assert shown.exit_code == 2
    assert "--default lleva el nombre de un ajuste" in shown.output


CALLED = {
    "check no.bt": "El valor de 'FILE...' no es válido: No existe el archivo 'no.bt'.",
    "check .": "El valor de 'FILE...' no es válido: '.' es una carpeta, no un archivo.",
    "run": "Falta 'FILE[@ROBOT[:COUNT]]...'.",
    "run --robt x": "No hay ninguna opción '--robt'. ¿Quieres decir '--robot'?",
    "run --robot": "La opción '--robot' necesita un valor.",
    "run --seed x": "El valor de '--seed' no es válido: 'x' no es un número entero.",
    "run --for x": "El valor de '--for' no es válido: 'x' no es un número.",
    "run --for 0": "El valor de '--for' no es válido: 0.0 está fuera del intervalo x>0.",
    "convert setup.py": "El valor de 'FILE' no es válido: No existe el archivo 'setup.py'.",
    "demo x": "Sobra un argumento: x.",
    "foo": "No hay ninguna orden 'foo'.",
    "robots foo": "No hay ninguna orden 'foo'.",
}


@pytest.mark.parametrize("command", CALLED)
def test_a_wrong_call_is_reported_in_the_reader_s_language_alone(command, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shown = CliRunner().invoke(main, ["--language", "es", *command.split()])
    assert shown.exit_code == 2
    *usage, error = shown.stderr.splitlines()
    assert error == f"Error: {CALLED[command]}"
    assert not re.search(r"Usage|OPTIONS|COMMAND|for help", " ".join(usage))


def test_a_wrong_call_of_the_whole_is_in_the_language_of_the_system():
    shown = CliRunner().invoke(main, ["--nix"], env={"LEARNBLOCK_LANGUAGE": "es"})
    assert shown.exit_code == 2
    assert shown.stderr.startswith("Uso: ")
    assert "No hay ninguna opción '--nix'." in shown.stderr


def test_a_message_that_is_ours_or_not_known_is_left_as_it_is():
    with main.make_context("learnblock", ["--language", "es", "worlds"]):
        assert translated("Elige un valor.") == "Elige un valor."
        assert translated("Invalid value: Elige.") == "El valor no es válido: Elige."


def test_help_does_not_change_the_commands_that_english_uses():
    CliRunner().invoke(main, ["--language", "es", "run", "--help"])
    command = load("run")
    assert isinstance(command, click.Command)
    assert command.help.startswith("Run programs")
