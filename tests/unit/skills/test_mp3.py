import pytest


@pytest.mark.parametrize(
    ("skill", "args", "command"),
    [
        ("select_audio", (2, 7), ("MP3.select", 2, 7)),
        ("send_action", (), ("MP3.action", "Play")),
        ("modify_volume", (), ("MP3.volume", 5)),
        ("modify_volume", (900,), ("MP3.volume", 100)),
        ("modify_EQ", (), ("MP3.equalizer", "NO")),
        ("modify_loop", (), ("MP3.loop", "Loop all")),
    ],
)
def test_the_music_player_gets_its_commands(robot, skill, args, command):
    getattr(robot, skill)(*args)

    assert [command] == robot.commands
