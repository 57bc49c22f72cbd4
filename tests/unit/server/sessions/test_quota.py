"""How many projects a page may make."""

import pytest

from learnblock.errors import LearnBlockError
from learnblock.server.sessions.quota import Quota


class Clock:
    now = 0.0

    def __call__(self):
        return self.now


def test_more_than_the_quota_is_refused_with_the_time_to_wait():
    clock = Clock()
    quota = Quota(2, 60.0, clock)
    quota.take()
    clock.now = 10.0
    quota.take()
    with pytest.raises(LearnBlockError, match=r"2 projects. Wait 51 seconds"):
        quota.take()


def test_after_the_time_it_may_take_again():
    clock = Clock()
    quota = Quota(1, 60.0, clock)
    for clock.now in (0.0, 60.0, 120.0):
        quota.take()


def test_a_page_that_makes_projects_without_end_is_refused(page, projects):
    for _ in range(30):
        page.say("New", name="many")
    page.say("ListProjects")
    messages = page.until("Projects")
    refused = [one for one in messages if one["kind"] == "Failed"]
    assert {one["message"]["code"] for one in refused} == {"server-too-many-projects"}
    assert len(refused) == 10
    assert len(messages[-1]["projects"]) == 20
