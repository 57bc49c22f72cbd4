"""What a class does as a service of a hub, without one."""

import asyncio
from types import SimpleNamespace

import httpx
import pytest
from starlette.requests import Request

from learnblock.classroom.app import create_app
from learnblock.classroom.badges import Badges, Visitors
from learnblock.classroom.forward import Forwarder
from learnblock.classroom.hub_class import HubLogin, HubService, HubUser
from learnblock.classroom.room import Room
from learnblock.classroom.roster import Roster
from learnblock.classroom.servers import ServerAddress
from learnblock.errors import LearnBlockError
from learnblock.server.messages import AtSeat, HandIn, Work
from learnblock.server.messages.base import Role

ENVIRONMENT = {
    "JUPYTERHUB_SERVICE_URL": "http://127.0.0.1:8421",
    "JUPYTERHUB_API_URL": "http://127.0.0.1:8081/hub/api",
    "JUPYTERHUB_API_TOKEN": "secret",
    "JUPYTERHUB_CLIENT_ID": "service-class-7b",
    "JUPYTERHUB_SERVICE_PREFIX": "/services/class-7b/",
    "JUPYTERHUB_BASE_URL": "/",
}


def service():
    return HubService.of(ENVIRONMENT, "http://hub.example/", "7b", "teachers-7b")


def test_the_hub_tells_where_the_service_listens_and_is_reached():
    assert service().listen == ("127.0.0.1", 8421)
    assert service().address == "http://hub.example/services/class-7b"


def test_a_class_that_no_hub_has_started_says_so():
    with pytest.raises(LearnBlockError, match="JUPYTERHUB_SERVICE_URL"):
        HubService.of({}, "http://hub.example", "7b", "teachers-7b")


def test_a_login_needs_the_cookie_of_the_browser_that_began_it():
    login = HubLogin(service())
    _, state = login.begin()
    for known in ({}, {login.cookie: "other"}):
        request = SimpleNamespace(query_params={"state": state, "code": "x"}, cookies=known)
        with pytest.raises(LearnBlockError, match="not begun here"):
            asyncio.run(login.user(request))


@pytest.mark.parametrize(
    ("proxies", "is_secure"),
    [("https", True), ("https,http", True), ("http, https", False), ("http", False), ("", False)],
)
def test_cookies_are_kept_back_from_http_where_browsers_come_by_https(tmp_path, proxies, is_secure):
    roster = Roster(tmp_path, "7b")
    room = Room(roster, "http://a", servers=SimpleNamespace())
    visitors = Visitors(Badges(roster), "class")
    app = create_app(room, visitors, hosts=["hub.example"], hub=HubLogin(service()))

    async def login():
        transport = httpx.ASGITransport(app)
        async with httpx.AsyncClient(transport=transport, base_url="http://hub.example") as browser:
            headers = {"x-forwarded-proto": proxies}
            return await browser.get("/services/class-7b/", headers=headers)

    cookie = asyncio.run(login()).headers["set-cookie"]
    assert ("; secure" in cookie.lower()) == is_secure


@pytest.mark.parametrize("path", ["../../bob/learnblock/", "a/../../../hub/api/user", ".."])
def test_no_request_is_passed_on_to_other_servers_of_the_hub(path):
    scope = {"type": "http", "method": "GET", "headers": [], "path_params": {"path": path}}
    place = ServerAddress("hub.example", "/user/ana/learnblock/")
    with pytest.raises(httpx.InvalidURL):
        asyncio.run(Forwarder().ask(Request(scope), place))


def test_a_user_keeps_one_place_in_the_class(tmp_path):
    roster = Roster(tmp_path, "7b")
    user = HubUser("ana.garcia@school.example", is_teacher=False)
    first = roster.admit(user.id, user.name)
    assert roster.admit(user.id, user.name) == first
    assert [pupil.name for pupil in Roster(tmp_path, "7b").pupils] == [user.name]


def test_a_full_class_admits_no_more(tmp_path, monkeypatch):
    monkeypatch.setattr("learnblock.classroom.roster.MOST_PUPILS", 1)
    roster = Roster(tmp_path, "7b")
    roster.admit("a" * 10, "ana")
    with pytest.raises(LearnBlockError, match="full"):
        roster.admit("b" * 10, "leo")


def test_only_pages_at_the_step_without_a_hand_in_are_asked_for_their_work(tmp_path):
    roster = Roster(tmp_path, "7b")
    pupils = [roster.admit(name * 10, name) for name in "abc"]
    room = Room(roster, "http://a", servers=SimpleNamespace())
    orders = []
    for pupil, step in zip(pupils, (2, 2, 3), strict=True):
        desk = room.desk(pupil)
        page = Page(pupil.id, orders)
        desk.joined(page)
        desk.see(page, AtSeat(Work(lesson_name="first", step=step)))
    handed_in = {("first", 2): None}
    room.hand_ins.of_pupil = lambda pupil: handed_in if pupil == pupils[1].id else {}
    asyncio.run(room.gather("first", 2))
    assert orders == [(pupils[0].id, HandIn())]


class Page:
    """A page of a pupil, which remembers what its server is asked for."""

    is_teacher = False
    role = Role.PUPIL

    def __init__(self, pupil, orders):
        self._pupil = pupil
        self._orders = orders

    def tell(self, message):
        pass

    async def order(self, message):
        self._orders.append((self._pupil, message))
