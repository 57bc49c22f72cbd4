"""A game on the page: keys, stars, the score over the world, and the blocks of games."""

from playwright.sync_api import expect

#: Bytes that a film of some seconds has at least.
FILM = 20_000
STARS = """when forward = function.is_key_pressed("up"):
    function.drive_distance(50, 150)
end

when star = function.collected("star"):
    function.change_score(1)
end
"""


def test_a_game_is_played_by_keys_and_its_score_is_over_the_world(sit_down, server):
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    game = pupil.page.get_by_role("group", name="Game", exact=True)
    groups = pupil.page.locator(".lbGroupIcon:visible")
    expect(game).to_be_hidden()
    before = groups.count()
    pupil.choose("World", "Catch the stars")
    # The group of blocks comes with the world.
    expect(groups).to_have_count(before + 1)
    pupil.write("blocktext", STARS)
    expect(pupil.blocks("lb_when_collected")).to_have_count(1)
    pupil.press("Run")
    expect(game.get_by_role("img", name="Score: 0")).to_be_visible()
    pupil.page.keyboard.down("ArrowUp")
    # The world counts one, the program another.
    expect(game.get_by_role("img", name="Score: 2")).to_be_visible()
    pupil.page.keyboard.up("ArrowUp")
    expect(game.get_by_role("img", name="Lives: 3")).to_be_visible()
    pupil.picture("a game")
    pupil.open_category("Game")
    pupil.picture("blocks of games")


def test_a_game_is_made_from_an_empty_project_and_won(sit_down, server):
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    pupil.choose("World", "Catch the stars")
    forward = pupil.take("Events", "lb_when_is_key_pressed")
    pupil.take("Move", "lb_skill_drive_distance", to=lambda: pupil.inside(forward))
    star = pupil.take("Events", "lb_when_collected", to=lambda: pupil.below(forward))
    pupil.take("Game", "lb_skill_win_game", to=lambda: pupil.inside(star))
    expect(pupil.block(forward).locator(".lb_skill_drive_distance")).to_have_count(1)
    expect(pupil.block(star).locator(".lb_skill_win_game")).to_have_count(1)
    pupil.press("Run")
    # The score may be shown a moment before the world has the keys.
    expect(pupil.page.locator(".world-hint")).to_have_text("The program listens to space.")
    expect(pupil.page.get_by_role("img", name="Score: 0")).to_be_visible()
    pupil.page.keyboard.down("Space")
    end = pupil.page.get_by_role("region", name="You win")
    expect(end).to_be_focused()
    pupil.page.keyboard.up("Space")
    expect(end.get_by_text("Score: 1")).to_be_visible()
    expect(pupil.page.get_by_text("Goal not reached")).to_have_count(0)
    pupil.picture("a game is won")
    end.get_by_role("button", name="Play again").click()
    expect(end).to_be_hidden()
    expect(pupil.page.get_by_role("img", name="Score: 0")).to_be_visible()


ROUND = """main:
    function.change_score(3)
    function.turn(720)
    function.drive_distance(300)
    function.win_game()
end
"""


def test_the_end_of_a_game_is_watched_again_and_saved_as_a_film(sit_down, server):
    pupil = sit_down(server, reduced_motion="reduce", empty=True)
    pupil.choose("Speed", "Fastest")
    pupil.write("blocktext", ROUND)
    pupil.press("Run")
    end = pupil.page.get_by_role("region", name="You win")
    end.get_by_role("button", name="Watch again").click()
    replay = pupil.page.get_by_role("region", name="Replay")
    expect(replay.get_by_text("The last 10 seconds")).to_be_visible()
    expect(pupil.page.locator(".status .state").first).to_contain_text("Looking back")
    expect(end).to_be_hidden()
    pupil.picture("a game is watched again")
    with pupil.page.expect_download(timeout=60_000) as started:
        replay.get_by_role("button", name="Save as film").click()
    assert started.value.path().stat().st_size > FILM
    # Then it is as before, and the keyboard is at its end.
    expect(replay).to_be_hidden()
    expect(end).to_be_focused()
