"""The gate of the page: its guests, the parts of a request that are read, the headers of every answer."""

import json
import os
import socket
import tomllib

import pytest
from conftest import CONFIGS
from pages import Here, Site, finished, spec_in, web
from sources import DATA

pytestmark = web
LIVE = {"base": 0, "fields": {}, "pinned": None}
POSTS = ["live", "save", "open", "tab/accuracy", "tab/design"]
LIMIT = 64 * 1024


@pytest.fixture(autouse=True)
def jobs(monkeypatch):
    """Jobs that the workers get; they give an empty answer."""

    async def ask(self, job, gone, page):
        self.jobs.append(job)
        yield {"fragments": {}}

    monkeypatch.setattr(Here, "ask", ask)
    monkeypatch.setattr(Here, "jobs", [])
    return Here.jobs


def refused(site, status, method, path, body=LIVE, **headers):
    """Assert a refusal: it has no token and nothing of the clutch, and no other origin may read it."""
    answer = site.ask(method, path, body, **headers)
    assert answer.status == status, (method, path, headers, answer)
    told = answer.body + str(answer.headers).encode()
    assert not [secret for secret in (site.root.strip("/"), "control_unit", "root:") if secret.encode() in told]
    assert len(answer.body) < 500
    is_safe(answer)
    assert Here.jobs == []
    return answer


POLICY = {"default-src": "'none'", "frame-ancestors": "'none'", "base-uri": "'none'", "form-action": "'none'"}
POLICY |= {"script-src": "'self'", "connect-src": "'self'", "style-src": "'self' 'unsafe-inline'"}
POLICY |= {"img-src": "'self' data:", "frame-src": "blob:"}
"""Sources that only the drawings and the report need, besides the server itself."""
SAFE = {"x-content-type-options": "nosniff", "referrer-policy": "no-referrer", "cache-control": "no-store"}
SAFE |= {"cross-origin-resource-policy": "same-origin"}


def is_safe(answer):
    parts = answer.headers["content-security-policy"].split(";")
    assert dict(part.strip().split(" ", 1) for part in parts) == POLICY
    assert SAFE.items() <= answer.headers.items()
    assert not [name for name in answer.headers if name.startswith("access-control") or name == "set-cookie"]
    assert (answer.headers.get("connection") == "close") == (answer.status >= 400)


SERVED = {
    ("GET", ""): "text/html; charset=utf-8",
    ("GET", "page.css"): "text/css; charset=utf-8",
    ("GET", "page.js"): "text/javascript; charset=utf-8",
    **{("POST", path): "application/json" for path in ("save", "open")},
    **{("POST", path): "application/x-ndjson" for path in ("live", "tab/accuracy")},
}


@pytest.mark.parametrize(("method", "path"), SERVED)
def test_what_is_served_and_to_whom(site, method, path):
    """Served are the page itself, programs that are no browser, the name localhost; a typed address only with GET."""
    other = f"localhost:{site.host.partition(':')[2]}"
    for headers in ({}, {"origin": None, "sec_fetch_site": None}, {"host": other, "origin": f"http://{other}"}):
        answer = site.ask(method, site.root + path, LIVE, **headers)
        assert answer.status == 200
        assert answer.headers["content-type"] == SERVED[method, path]
        is_safe(answer)
    typed = site.ask(method, site.root + path, LIVE, origin=None, sec_fetch_site="none")
    assert typed.status == (200 if method == "GET" else 403)
    opposite = "GET" if method == "POST" else "POST"
    Here.jobs.clear()
    refused(site, 405, opposite, site.root + path)


ASKED = tomllib.loads((DATA / "requests.toml").read_text(encoding="utf-8"))
HOSTS = [*ASKED["hosts"], None, ["127.0.0.1:{port}"] * 2]
SITES = ["cross-site", "same-site", "none", ""]


def test_who_is_not_the_page_is_refused(site):
    """Refused are a foreign host name (DNS rebinding, also with its own origin), another origin, another site."""
    port = site.host.partition(":")[2]

    def filled(value):
        return (
            [each.format(port=port) for each in value] if isinstance(value, list) else value and value.format(port=port)
        )

    for host in map(filled, HOSTS):
        refused(site, 403, "GET", site.root, host=host)
        for origin in (None, f"http://{host}"):
            refused(site, 403, "POST", site.root + "live", host=host, origin=origin)
    for path in POSTS:
        for origin in map(filled, ASKED["origins"]):
            refused(site, 403, "POST", site.root + path, origin=origin)
        for name in SITES:
            refused(site, 403, "POST", site.root + path, origin=None, sec_fetch_site=name)
    refused(site, 403, "GET", site.root, sec_fetch_site="cross-site")


def test_the_file_that_opens_the_browser_leads_to_the_page(site):
    """A file belongs to no site: it may navigate to the page if it knows the token, but not query or frame it."""
    opened = {"sec_fetch_site": "cross-site", "sec_fetch_mode": "navigate", "sec_fetch_dest": "document"}
    assert site.get(**opened, origin=None).status == 200
    refused(site, 404, "GET", "/", **opened, origin=None)
    for other in ({"sec_fetch_dest": "iframe"}, {"sec_fetch_mode": "cors"}, {"sec_fetch_dest": "empty"}):
        refused(site, 403, "GET", site.root, **(opened | other), origin=None)
    refused(site, 403, "POST", site.root + "live", **opened, origin=None)


def test_a_browser_leaves_port_80_out():
    """A browser leaves port 80 out of host and origin."""
    from starlette.applications import Starlette

    from afmcalc.web.app import gate

    async def status(port, host):
        async def send(message):
            got.append(message.get("status"))

        got, headers = [], [(b"host", host.encode()), (b"origin", f"http://{host}".encode())]
        scope = {"type": "http", "method": "GET", "path": "/token/x", "headers": headers, "query_string": b""}
        await gate(Starlette(), port, "token")(scope, None, send)
        return got[0]

    for port, host, wanted in (
        (80, "127.0.0.1", 404),
        (80, "localhost:80", 404),
        (80, "localhost.", 403),
        (81, "127.0.0.1", 403),
    ):
        assert finished(status(port, host)) == wanted


def test_without_the_token_there_is_nothing(site, afmcalc):
    """The answer is the same whether a path exists or not; the token has at least 128 bits, and is new each time."""
    token = site.root.strip("/")
    assert len(token) >= 22
    assert Site(afmcalc).root != site.root
    nothing = refused(site, 404, "GET", "/nothing")
    wrong = [
        "", "x", token[:-1], f"{token}x", token.swapcase(), f"x{token}", f"{token}%00", f"%20{token}", "favicon.ico",
    ]  # fmt: skip
    for each in wrong:
        for method, rest in (("GET", "/"), ("GET", "/page.js"), ("POST", "/live"), ("POST", "/save"), ("GET", "")):
            answer = refused(site, 404, method, f"/{each}{rest}")
            assert (answer.body, answer.headers) == (nothing.body, nothing.headers), (each, rest)
    for path in ("/?token={}", "/live?{}", "/;{}", "/x/{}/"):
        cookie, bearer = f"token={token}", f"Bearer {token}"
        assert site.ask("GET", path.format(token), cookie=cookie, authorization=bearer).status == 404


def test_no_path_leads_out(site):
    for path in (*ASKED["outside"], "a" * 5000, "a/" * 2000):
        for method in ("GET", "POST"):
            refused(site, 404, method, site.root + path)
    for tab in ("os", "__class__", "live", "save", "torque", "", "%00"):
        refused(site, 404, "POST", f"{site.root}tab/{tab}")
    for method in ("TRACE", "OPTIONS", "PUT", "DELETE", "PATCH", "PROPFIND", "get", "X" * 200):
        for path in ("", *POSTS):
            refused(site, 405, method, site.root + path, access_control_request_method="POST")


def test_only_json_is_read(site):
    form, many = "application/x-www-form-urlencoded", "text/html, application/json"
    for kind in (None, "", "text/plain", form, "multipart/form-data; boundary=x", "application/jsonx", many):
        for path in POSTS:
            refused(site, 415, "POST", site.root + path, content_type=kind)
    assert site.post("live", LIVE, content_type="Application/JSON; charset=utf-8").status == 200


UNREADABLE = [
    b"", b"{", b"[]", b"1", b"null", b"[" * 30_000, b'{"base": 0, "fields": ' + b"[" * 20_000 + b"]" * 20_000 + b"}",
    b'{"base": ' + b"9" * 20_000 + b', "fields": {}}', b'{"base": 0, "fields": {"name": "\xff\xfe"}}',
    *(json.dumps({"base": 0, "fields": fields}).encode()
      for fields in (None, [], "x", 1, {"name": 1}, {"name": None}, {"name": ["x"]}, {"name": {}})),
]  # fmt: skip
BASES = [-1, 1, 99999, 1.5, 0.0, True, False, "0", "../x", None, [], {}, float("inf")]


def test_what_is_no_request_of_a_page_is_refused(site):
    """Base and fields are checked, those of a pinned state too; the form takes only a base."""
    for body in UNREADABLE:
        for path in ("live", "save", "tab/design"):
            refused(site, 400, "POST", site.root + path, body)
    for base in BASES:
        body = {"base": base, "fields": {}}
        for path in POSTS:
            refused(site, 404, "POST", site.root + path, body)
        refused(site, 404, "POST", site.root + "live", LIVE | {"pinned": body})
    for pinned in (1, "x", [1], {"base": 0}, {"base": 0, "fields": {"name": 1}}):
        refused(site, 404 if pinned == {} else 400, "POST", site.root + "live", LIVE | {"pinned": pinned})
    for options in (1, [], "x", {"sweep": 1}, {"sweep": None}):
        refused(site, 400, "POST", site.root + "tab/accuracy", LIVE | {"options": options})
    for number in ("-1", "1", "9" * 20, "x", "1e3", "0x0", "", "../x", "%00", "%D9%A3"):
        refused(site, 404, "GET", f"{site.root}?base={number}")
    assert site.get("?base=0").status == 200


def test_no_more_is_read_than_is_allowed(site):
    """A body is too long by its header, or by the bytes that come, in one piece or in many."""
    body = json.dumps(LIVE).encode()
    fits, more = body.ljust(LIMIT), body.ljust(LIMIT + 1)
    for path in POSTS:
        assert site.post(path, fits).status == 200
        Here.jobs.clear()
        refused(site, 413, "POST", site.root + path, more)
        for length in (str(LIMIT + 1), "9" * 30, "-1", "x", "0x10", "1e3", ""):
            refused(site, 413, "POST", site.root + path, body, content_length=length)
        refused(site, 413, "POST", site.root + path, tuple([b" " * 1024] * 65), content_length=None)
        refused(site, 413, "POST", site.root + path, tuple([b" " * 1024] * 65), content_length="9")
    assert site.post("live", tuple(bytes([each]) for each in body), content_length=None).status == 200


def test_half_a_request_is_not_waited_for(site, monkeypatch):
    monkeypatch.setattr("afmcalc.web.app._SLOWEST", 0)
    for path in POSTS:
        refused(site, 408, "POST", site.root + path, b'{"base": 0, ', whole=False)


def test_a_worker_is_asked_what_the_page_asked(site, jobs):
    pinned = {"base": 0, "fields": {"control_unit.gain": "0.4"}}
    body = {"base": 0, "fields": {"name": "x"}, "pinned": pinned, "options": {"sweep": "C"}, "name": "save"}
    for path in ("live", "tab/heat"):
        assert site.post(path, body).status == 200
    for job, name in zip(jobs, ("live", "heat"), strict=True):
        assert job.keys() == {"name", "state", "pinned", "options", "first"}
        assert (job["name"], job["state"].fields, job["pinned"].fields) == (name, body["fields"], pinned["fields"])
        assert job["options"] == {"sweep": "C"}


def test_a_fault_of_our_own_is_said(site, monkeypatch):
    async def broken(self, job, gone, page):
        raise KeyError("control\x1b_unit")
        yield

    monkeypatch.setattr(Here, "ask", broken)
    answer = site.post("live", LIVE)
    assert (answer.status, answer.json["errors"]) == (200, {})
    assert "KeyError: 'control\\x1b_unit'" in answer.json["problems"][0]
    assert "Traceback" not in str(answer.json)


def test_what_cannot_be_served_is_told(afmcalc, tmp_path, monkeypatch):
    """Refused are a port that is taken or invalid, a missing file, no spec, an existing file, the spec itself."""
    monkeypatch.chdir(tmp_path)
    (spec_in(tmp_path, file="there.toml"), spec_in(tmp_path))
    with socket.create_server(("127.0.0.1", 0)) as other:
        taken = other.getsockname()[1]
        for arguments, code, said in ASKED["wrong"]:
            run = Site(afmcalc, *arguments.format(taken=taken).split()).run
            assert (run.code, run.out, said.format(taken=taken) in run.err) == (code, "", True), run
    assert sorted(os.listdir()) == ["clutch.toml", "there.toml"]
    assert (tmp_path / "there.toml").read_bytes() == (CONFIGS / "default.toml").read_bytes()


def test_it_listens_on_this_machine_alone(site):
    assert site.run.code == 0
    assert site.listening[0] == "127.0.0.1"
    assert site.host == f"127.0.0.1:{site.listening[1]}"
