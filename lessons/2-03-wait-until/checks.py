"""What the robot reports: one word at each step, and another one at the end, in either language."""

CLEAR = {"clear", "libre"}
WALL = {"wall", "pared"}
FEW = {"en": "There are too few words.", "es": "Hay muy pocas palabras."}
STEPS = {
    "en": "The word clear does not come once at each step.",
    "es": "La palabra libre no sale una vez en cada paso.",
}
END = {
    "en": "At the end there has to be the word wall, once.",
    "es": "Al final tiene que salir la palabra pared, una vez.",
}


def reports(run):
    words = [text.strip(" .!").lower() for _, text in run.prints]
    if len(words) < 4:
        return FEW
    *steps, last = words
    if last not in WALL:
        return END
    driven = sum(skill == "drive_distance" for _, skill in run.calls)
    if not CLEAR.issuperset(steps) or (driven and len(steps) != driven):
        return STEPS
    return True
