"""A game on the page: keys, stars, the score over the world, and the blocks of games."""

from playwright.sync_api import expect

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
