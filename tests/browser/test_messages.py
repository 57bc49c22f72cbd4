"""Messages between robots, as blocks."""

from playwright.sync_api import expect

PROGRAM = """\
when go = function.received("go"):
    function.set_move(function.message_value("go"), 0)
    function.send("done", 5)
end

main:
    pass
end
"""


def test_messages_have_blocks_with_a_name_and_an_optional_value(pupil):
    pupil.write("blocktext", PROGRAM)
    for kind in ("lb_when_received", "lb_skill_message_value", "lb_skill_send"):
        expect(pupil.blocks(kind)).to_have_count(1)
    sent = pupil.take("Events", "lb_skill_send")
    pupil.put_into(sent, pupil.blocks("lb_main").get_attribute("data-id"))
    pupil.sees("blocktext", 'function.send("go")')
    pupil.picture("messages")
