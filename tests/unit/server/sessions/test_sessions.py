"""One person runs the programs of some projects at once."""

import pytest

from learnblock.errors import LearnBlockError
from learnblock.server.sessions.periods import Periods
from learnblock.server.sessions.sessions import MOST_RUNS, Sessions


class Project:
    """An open project, as far as its runs are counted."""

    is_running = False


@pytest.fixture
def projects():
    return [Project() for _ in range(MOST_RUNS + 1)]


def sessions_of(projects, *, for_one):
    sessions = Sessions(None, Periods(), for_one=for_one)
    sessions._open = {str(number): project for number, project in enumerate(projects)}
    return sessions


@pytest.fixture
def sessions(projects):
    return sessions_of(projects, for_one=True)


def test_one_too_many_is_refused_in_words(sessions, projects):
    for project in projects[1:]:
        project.is_running = True
    with pytest.raises(LearnBlockError) as refused, sessions.starting(projects[0]):
        pass
    assert refused.value.phrase.code == "server-too-many-runs"
    # What runs already may be started again.
    with sessions.starting(projects[1]):
        pass
    projects[1].is_running = False
    with sessions.starting(projects[0]):
        pass


def test_those_that_are_about_to_run_count(sessions, projects):
    for project in projects[2:]:
        project.is_running = True
    with (
        sessions.starting(projects[0]),
        pytest.raises(LearnBlockError),
        sessions.starting(projects[1]),
    ):
        pass
    with sessions.starting(projects[1]):
        pass


def test_several_people_may_run_more(projects):
    sessions = sessions_of(projects, for_one=False)
    for project in projects[1:]:
        project.is_running = True
    with sessions.starting(projects[0]):
        pass
