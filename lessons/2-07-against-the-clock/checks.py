"""Whether the countdown, the points and the end of the game are as the task says."""

POINTS = {"star": 1, "gem": 3}
#: The score that wins.
ENOUGH = 6
#: Seconds: the start, how late an event may come, and when the game ends too soon for one.
START, LATE, ENDING = 0.5, 2, 0.5


def counts_down_from_20(run):
    return counts_down(run, 20)


def counts_down_from_60(run):
    return counts_down(run, 60)


def counts_down(run, seconds):
    begun = lines(run, "countdown")
    if not begun or begun[0]["t"] > START:
        return "no_countdown"
    if len(begun) > 1:
        return "begun_again", {"count": len(begun)}
    if begun[0].get("seconds") != seconds:
        return "seconds", {"seconds": begun[0].get("seconds", 0)}
    return True


def is_over_in_time(run):
    """Whether the program ends the game, when the time is up."""
    ups, ends = lines(run, "time-up"), lines(run, "lost", "won")
    if not ups:
        return "not_up"
    if not ends:
        return "goes_on"
    if ends[0]["game"] == "won":
        return "is_won"
    if not 0 <= ends[0]["t"] - ups[0]["t"] <= LATE:
        return "other_time", {"seconds": ends[0]["t"]}
    return True


def counts_stars_and_gems(run):
    """Whether each thing adds its points, and nothing else does."""
    if not any(kind(line) == "gem" for line in lines(run, "collected")):
        return "no_gem"
    return counts(run, POINTS)


def counts_stars(run):
    """Whether each star adds a point, and nothing else does."""
    return counts(run, {"star": 1, "gem": 0})


def counts(run, points):
    collected = [line for line in lines(run, "collected") if line["t"] < run.time - ENDING]
    changes = lines(run, "score")
    expected = sum(points[kind(line)] for line in lines(run, "collected"))
    score = changes[-1]["score"] if changes else 0
    # What was collected at the very end may not have counted any more.
    if expected - score not in {0, 1}:
        return "score", {"score": score, "expected": expected}
    for line in collected:
        if points_after(changes, line["t"]) != points[kind(line)]:
            return "points", {"thing": (kind(line), {}), "points": points_after(changes, line["t"])}
    return True


def points_after(changes, time):
    """By how much the score changed at the first time after another one."""
    before = next((line["score"] for line in reversed(changes) if line["t"] < time), 0)
    after = next((line["score"] for line in changes if time <= line["t"] <= time + LATE), before)
    return after - before


def wins_above_five(run):
    """Whether the game is won as soon as the score is enough, and not before."""
    won = lines(run, "won")
    if not won:
        return "not_won"
    scores = [line["score"] for line in lines(run, "score") if line["t"] <= won[0]["t"]]
    score = scores[-1] if scores else 0
    if score < ENOUGH or any(earlier >= ENOUGH for earlier in scores[:-1]):
        return "won_at", {"score": score}
    return True


def lines(run, *kinds):
    return [line for line in run.game if line["game"] in kinds]


def kind(line):
    """What was collected, such as star."""
    return line["thing"].split()[0]
