"""Whether the robot asks its camera before it shows a feeling, and stays with each friend."""

from itertools import pairwise

#: The question that fits a feeling.
QUESTIONS = {
    "expressJoy": "is_any_face_happy",
    "expressSurprise": "is_any_face_surprised",
    "expressSadness": "is_any_face_sad",
}
#: Degrees in 0.1 s from which on it turns, and the seconds that it stays before, at least.
TURNING = 2
STAYS = 1.7


def asks_before_each_face(run):
    """Whether the fitting question was asked since the face before, for each face shown."""
    if not run.shows:
        return "never_shown"
    asked, number = set(), 0
    for _, skill in run.calls:
        asked.add(skill)
        if not skill.startswith("express"):
            continue
        number += 1
        # A neutral face is for when nobody is there: then all questions were in vain.
        wanted = {QUESTIONS[skill]} if skill in QUESTIONS else set(QUESTIONS.values())
        if not asked & wanted:
            return "without_asking", {"number": number}
        asked.clear()
    return True


def stays_with_each_friend(run):
    """Whether it waits two seconds after each face that it shows."""
    turns = [before[0] for before, after in pairwise(run.path) if is_turn(before, after)]
    for number, (shown, _) in enumerate(run.shows, 1):
        next_turn = min((time for time in turns if time >= shown), default=run.time)
        if next_turn - shown < STAYS:
            return "no_wait", {"number": number}
    return True


def is_turn(before, after):
    return abs((after[3] - before[3] + 180) % 360 - 180) > TURNING
