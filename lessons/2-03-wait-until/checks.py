"""What the robot reports: one word at each step, and another one at the end, in any language."""


def reports(run):
    words = [text.strip(" .!").lower() for _, text in run.prints]
    if len(words) < 4:
        return "too_few"
    *steps, last = words
    if last not in run.texts["wall"]:
        return "not_at_the_end"
    driven = sum(skill == "drive_distance" for _, skill in run.calls)
    if not set(steps) <= set(run.texts["clear"]) or (driven and len(steps) != driven):
        return "not_at_each_step"
    return True
