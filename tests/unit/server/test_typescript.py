"""The page's types match the messages of the server."""

from learnblock.server.typescript import typescript
from places import ROOT

WRITTEN = ROOT / "frontend" / "src" / "protocol" / "messages.ts"


def test_the_types_of_the_page_are_up_to_date():
    # To update: python -m learnblock.server.typescript > frontend/src/protocol/messages.ts
    assert typescript() == WRITTEN.read_text(encoding="utf-8")


def test_a_field_with_a_default_may_be_absent():
    assert "  paused?: boolean;" in typescript()


def test_a_message_is_recognised_by_its_kind():
    assert '  kind: "EditText";' in typescript()


def test_a_message_sent_as_an_array_is_a_tuple():
    assert "export type Place = [block: string, blocktext: number," in typescript()
