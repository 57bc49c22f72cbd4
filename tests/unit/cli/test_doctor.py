from click.testing import CliRunner

from learnblock.cli import main
from learnblock.i18n import Phrase
from learnblock.runtime.containment import survey
from learnblock.runtime.containment.survey import AttemptResult

HELD = AttemptResult(Phrase("doctor-read"), True, Phrase("doctor-by-landlock", version=7))
FREE = AttemptResult(
    Phrase("doctor-network"), False, Phrase("doctor-other-system", system="Darwin")
)


def doctor(monkeypatch, *findings, language="en"):
    monkeypatch.setattr(survey, "survey", lambda: findings)
    return CliRunner().invoke(main, ["--language", language, "doctor"]).output


def test_what_contains_programs_is_printed_with_the_reason(monkeypatch):
    output = doctor(monkeypatch, HELD)
    assert "refused  Read files that are not its own: by Landlock (version 7)" in output
    assert "Run only programs that you trust" not in output


def test_what_does_not_contain_them_is_printed_with_advice(monkeypatch):
    output = doctor(monkeypatch, HELD, FREE)
    assert "ALLOWED  Use the network: on Darwin, only Python itself refuses it" in output
    assert "Run only programs that you trust on this computer." in output


def test_it_speaks_spanish(monkeypatch):
    assert "PERMITIDO  Usar la red" in doctor(monkeypatch, FREE, language="es")
