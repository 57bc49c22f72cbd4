"""What a class does as a service of a hub, without one."""

import asyncio
from types import SimpleNamespace

import httpx
import pytest
from starlette.requests import Request

import small_lesson
from learnblock.classroom.app import create_app
from learnblock.classroom.badges import Badges, Visitors
from learnblock.classroom.forward import Forwarder
from learnblock.classroom.hub_class import HubLogin, HubService, HubUser
from learnblock.classroom.lesson_works import LessonWorkFile
from learnblock.classroom.messages import LessonOffer
from learnblock.classroom.record import record_of
from learnblock.classroom.room import Room
from learnblock.classroom.roster import Roster
from learnblock.classroom.servers import ServerAddress
from learnblock.errors import LearnBlockError
from learnblock.lessons.reading import unpack
from learnblock.project.files.lesson_work import LessonWork
from learnblock.server.messages import AtSeat, GiveLesson, HandIn, StartLesson, Work
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


@pytest.fixture
def own_lesson(own_home):
    """The name of a lesson of the teacher's own, in the folder of the service."""
    small_lesson.put_in(own_home)
    return small_lesson.NAME


def hub_room(tmp_path, lesson):
    roster = Roster(tmp_path, "7b")
    roster.admit("a" * 10, "ana")
    offer = LessonOffer(lesson, "Mine", 1, 30, ("sim-ebo",), (), own=True)
    return Room(roster, "http://a", [offer], servers=SimpleNamespace())


@pytest.mark.parametrize("is_here", [True, False])
def test_an_own_lesson_is_given_to_a_pupils_server_before_it_starts(tmp_path, own_lesson, is_here):
    room = hub_room(tmp_path, own_lesson)
    (ana,) = room.roster.pupils
    orders = []
    if is_here:
        room.desk(ana).joined(Page(ana.id, orders))
    asyncio.run(room.hand_out(StartLesson(own_lesson, "Mine")))
    sent = [order for _, order in orders] or asyncio.run(room.first_lesson(ana))
    given, started = sent
    assert (given.lesson, started) == (own_lesson, StartLesson(own_lesson, "Mine"))
    assert unpack(f"{own_lesson}.lblesson", given.content).teacher is None
    assert not room.roster.folder_of(ana).exists()


def test_a_class_at_a_hub_begins_with_an_own_lesson(tmp_path, own_lesson):
    room = hub_room(tmp_path, own_lesson)
    room.roster.prepare(own_lesson, "Mine", "basics")
    first = asyncio.run(room.first_lesson(room.roster.pupils[0]))
    assert [type(message) for message in first] == [GiveLesson, StartLesson]


def test_the_teacher_hears_of_a_lesson_that_no_message_holds(tmp_path, own_lesson, monkeypatch):
    monkeypatch.setattr("learnblock.classroom.offers.LARGEST_LESSON", 100)
    with pytest.raises(LearnBlockError, match="too large"):
        asyncio.run(hub_room(tmp_path, own_lesson).hand_out(StartLesson(own_lesson, "Mine")))


def test_the_wall_shows_who_lacks_a_lesson_until_it_is_handed_out_again(tmp_path, own_lesson):
    room = hub_room(tmp_path, own_lesson)
    (ana,) = room.roster.pupils
    desk = room.desk(ana)
    desk.lesson_refused()
    assert desk.seat().lacks_lesson
    asyncio.run(room.hand_out(StartLesson(own_lesson, "Mine")))
    assert not desk.seat().lacks_lesson


def test_a_record_at_a_hub_has_what_the_pupils_server_tells_with_the_lessons_aims(
    tmp_path, own_lesson
):
    room = hub_room(tmp_path, own_lesson)
    (ana,) = room.roster.pupils
    kept = room.desk(ana).lesson_works
    kept.keep((LessonWork(own_lesson, 1000.0, 2, {"1": ("quiz",)}, runs=3, hints=1),))
    record = record_of(room.roster, room.hand_ins, ana, teaches=True, kept=kept)
    [lesson] = record.lessons
    assert (lesson.title["es"], lesson.stars, lesson.runs, lesson.hints) == (
        "Primer viaje",
        1,
        3,
        1,
    )
    assert [aim.say for aim in lesson.aims] == ["Drive and stop"]


def test_damaged_work_in_lessons_is_none(tmp_path):
    kept = LessonWorkFile(tmp_path)
    (tmp_path / "lessons.json").write_text('[{"lesson": "../evil"}]')
    assert kept.works() is None


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
