"""Whether the robot asks its camera before it shows a feeling."""

#: The question that fits a feeling.
QUESTIONS = {
    "joy": "is_any_face_happy",
    "surprise": "is_any_face_surprised",
    "sadness": "is_any_face_sad",
}

NEVER = {"en": "The robot never shows a face.", "es": "El robot no pone nunca una cara."}


def asks_before_each_face(run):
    """Whether the fitting question was asked since the face before, for each face shown."""
    if not run.shows:
        return NEVER
    before = -1.0
    for number, (time, face) in enumerate(run.shows, 1):
        asked = {name for at, name in run.calls if before < at <= time}
        # A neutral face is for when nobody is there: then all questions were in vain.
        wanted = {QUESTIONS[face]} if face in QUESTIONS else set(QUESTIONS.values())
        if not asked & wanted:
            return {
                "en": f"The robot shows face number {number} without asking what it sees.",
                "es": f"El robot pone la cara número {number} sin preguntar qué ve.",
            }
        before = time
    return True
