"""What no one but the page may ask of the server, and what nobody may."""

import json
import os
import socket
import struct
import threading
import time
from contextlib import ExitStack, suppress
from pathlib import Path

import pytest
from conftest import several
from serving import Answer, answer_of, proc, spec_in, until, web

pytestmark = web
LIVE = {"base": 0, "fields": {}, "pinned": None}
MIB = 1 << 20
LIMIT = 64 * 1024


def request(served, method="POST", path=None, body=b"", drop=(), **headers):
    """A request byte by byte; headers of the page but for those dropped or changed."""
    path = served.root + "live" if path is None else path
    sent = {"Host": served.host, **served.headers, "Content-Length": str(len(body)), "Connection": "close"}
    sent |= {name.replace("_", "-"): value for name, value in headers.items()}
    lines = [f"{name}: {value}" for name, value in sent.items() if name not in drop]
    return "\r\n".join([f"{method} {path} HTTP/1.1", *lines, "", ""]).encode("latin-1") + body


def asked(served, *args, **kwargs) -> Answer:
    return answer_of(served.raw(request(served, *args, **kwargs)))


def is_alive(served):
    assert served.live({})["fragments"]["numbers"]


def keeps_quiet(served, answer):
    """Neither the token nor anything of the clutch is in a refusal."""
    assert served.root.strip("/").encode() not in answer.body
    assert b"control_unit" not in answer.body
    assert len(answer.body) < 500


# where it listens


@pytest.mark.exhaustive
def test_the_token_is_long_and_new_each_time(served, serve, tmp_path):
    other = serve(spec_in(tmp_path))
    assert served.root != other.root
    for server in (served, other):
        assert server.url.startswith("http://127.0.0.1:")
        assert len(server.root.strip("/")) >= 22  # 128 bits


@proc
def test_it_listens_on_127_0_0_1_alone(served):
    listening = set()
    for table in ("tcp", "tcp6"):
        with suppress(OSError):
            for line in Path(f"/proc/net/{table}").read_text(encoding="utf-8").splitlines()[1:]:
                _, local, _, state, *_ = line.split()
                if state == "0A" and int(local.rpartition(":")[2], 16) == served.port:
                    listening.add(local.rpartition(":")[0])
    assert listening == {f"{struct.unpack('=I', socket.inet_aton('127.0.0.1'))[0]:08X}"}


def test_no_other_address_of_this_machine_answers(served):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asking:
        try:
            asking.connect(("192.0.2.1", 9))  # nothing is sent
        except OSError:
            pytest.skip("this machine has no other address")
        own = asking.getsockname()[0]
    if own.startswith("127."):
        pytest.skip("this machine has no other address")
    with pytest.raises(OSError, match="refused|unreachable|timed out"):
        socket.create_connection((own, served.port), timeout=2)


# who asks


@pytest.mark.parametrize(
    "host",
    [
        "evil.example",
        "evil.example:{port}",
        "127.0.0.1",
        "127.0.0.1:1",
        "127.0.0.1:{port}.evil.example",
        "127.0.0.1:{port}@evil.example",
        "evil.example@127.0.0.1:{port}",
        "127.0.0.1.evil.example:{port}",
        "localhost.evil.example:{port}",
        "0.0.0.0:{port}",
        "[::1]:{port}",
        "127.1:{port}",
        "2130706433:{port}",
        "",
        "127.0.0.1:{port}, evil.example",
        "127.0.0.1:{port} evil.example",
        "127.0.0.1:{port}\t",
    ],
)
def test_a_foreign_host_is_refused(served, host):
    for method in ("GET", "POST"):
        path = served.root + ("live" if method == "POST" else "")
        answer = asked(served, method, path, json.dumps(LIVE).encode(), Host=host.format(port=served.port))
        if host.endswith("\t"):  # blanks about a value are none of it
            assert answer.status in (200, 400, 403)
        else:
            assert answer.status in (400, 403), answer
            keeps_quiet(served, answer)


def test_localhost_is_this_machine(served):
    body = json.dumps(LIVE).encode()
    host = f"localhost:{served.port}"
    assert asked(served, body=body, Host=host, Origin=f"http://{host}").status == 200
    assert asked(served, "GET", served.root, Host=host, drop=["Origin"]).status == 200


def test_no_host_and_two_hosts_are_refused(served):
    body = json.dumps(LIVE).encode()
    assert asked(served, body=body, drop=["Host"]).status in (400, 403)
    old = request(served, body=body, drop=["Host"]).replace(b"HTTP/1.1", b"HTTP/1.0")
    assert answer_of(served.raw(old)).status in (400, 403)
    two = request(served, body=body).replace(b"Origin:", b"Host: evil.example\r\nOrigin:")
    assert answer_of(served.raw(two)).status in (400, 403)


@pytest.mark.parametrize(
    "origin",
    [
        "http://evil.example",
        "http://evil.example:{port}",
        "null",
        "",
        "https://127.0.0.1:{port}",
        "http://127.0.0.1:1",
        "http://127.0.0.1",
        "http://127.0.0.1:{port}.evil.example",
        "http://127.0.0.1:{port}/",
        "http://127.0.0.1:{port} http://evil.example",
        "file://",
        "chrome-extension://abcdefgh",
    ],
)
def test_a_foreign_origin_is_refused(served, origin):
    origin = origin.format(port=served.port)
    for path in ("live", "tab/accuracy", "tab/design", "save", "form"):
        answer = asked(served, path=served.root + path, body=json.dumps(LIVE).encode(), Origin=origin)
        assert answer.status == 403, (path, answer)
        keeps_quiet(served, answer)


def test_a_rebound_name_is_refused_with_its_own_origin(served):
    """DNS rebinding: the browser takes evil.example for 127.0.0.1, and Host and Origin agree."""
    host = f"evil.example:{served.port}"
    for path in ("live", "save", "form"):
        answer = asked(served, path=served.root + path, body=b"{}", Host=host, Origin=f"http://{host}")
        assert answer.status in (400, 403)
        keeps_quiet(served, answer)


def test_two_origins_are_refused(served):
    two = request(served, body=b"{}").replace(b"Origin:", b"Origin: http://evil.example\r\nOrigin:")
    assert answer_of(served.raw(two)).status in (400, 403)
    after = request(served, body=b"{}", Origin=f"http://{served.host}\r\nOrigin: http://evil.example")
    assert answer_of(served.raw(after)).status in (400, 403)


@pytest.mark.parametrize("site", ["cross-site", "same-site", "none"])
def test_without_an_origin_another_site_is_refused(served, site):
    answer = asked(served, body=json.dumps(LIVE).encode(), drop=["Origin"], Sec_Fetch_Site=site)
    assert answer.status == 403


WRONG = ["", "x", "{short}", "{token}x", "{lower}", "x{token}", "{token}%00", "%20{token}", "{token}.", "favicon.ico"]


@pytest.mark.parametrize("wrong", WRONG)
def test_without_the_token_there_is_nothing(served, wrong):
    token = served.root.strip("/")
    wrong = wrong.format(token=token, short=token[:-1], lower=token.swapcase())
    nothing = asked(served, "GET", "/nothing")
    assert nothing.status == 404
    for method, rest in (("GET", "/"), ("GET", "/page.js"), ("POST", "/live"), ("POST", "/save"), ("GET", "")):
        answer = asked(served, method, f"/{wrong}{rest}", body=json.dumps(LIVE).encode())
        assert (answer.status, answer.body) == (404, nothing.body), (method, wrong, rest)
        keeps_quiet(served, answer)
        assert set(answer.headers) == set(nothing.headers)
        assert token not in str(answer.headers)


def test_a_token_in_the_query_or_a_header_is_none(served):
    token = served.root.strip("/")
    for path in (f"/?token={token}", f"/live?{token}", f"/;{token}", f"/#{token}"):
        assert asked(served, "GET", path, Cookie=f"token={token}", Authorization=f"Bearer {token}").status in (400, 404)


# what is asked

OUTSIDE = [
    "../../etc/passwd",
    "../../../../../../etc/passwd",
    "..%2f..%2f..%2f..%2fetc%2fpasswd",
    "%2e%2e/%2e%2e/%2e%2e/etc/passwd",
    "%252e%252e%252fetc/passwd",
    "..\\..\\etc\\passwd",
    "..%5c..%5cetc%5cpasswd",
    "....//....//etc/passwd",
    "/etc/passwd",
    "%2fetc%2fpasswd",
    "file:///etc/passwd",
    "page.css/../page.html",
    "page.css/../../../pyproject.toml",
    "page.css%00.html",
    "page.html",
    "parts.html",
    "server.py",
    "__init__.py",
    "clutch.toml",
    ".",
    "./page.css",
    "..;/page.css",
    "page.css/",
    "PAGE.CSS",
    "static/page.css",
    "tab/../live",
    "tab/../../etc/passwd",
    "tab/%2e%2e%2f%2e%2e%2fetc%2fpasswd",
    "tab/os",
    "tab/",
    "tab/__class__",
    "\x00",
    "page.css\x00",
    "\xff\xfe",
    "%ff%fe",
    "%",
    "%zz",
    "a" * 5000,
    "a/" * 2000,
]


@pytest.mark.parametrize("path", OUTSIDE, ids=[repr(path)[:40] for path in OUTSIDE])
def test_no_path_leads_out(served, path):
    for method in ("GET", "POST"):
        answer = asked(served, method, served.root + path, body=json.dumps(LIVE).encode())
        assert answer.status in (400, 404, 405, 414), answer
        keeps_quiet(served, answer)
        assert b"root:" not in answer.body


@pytest.mark.parametrize(
    "address", ["http://evil.example{root}", "http://{host}{root}../x", "//evil.example{root}", "*", "x"]
)
def test_whole_addresses_and_none(served, address):
    answer = asked(served, "GET", address.format(root=served.root, host=served.host))
    assert answer.status in (400, 403, 404), answer
    keeps_quiet(served, answer)


@pytest.mark.parametrize(
    "method", ["TRACE", "OPTIONS", "CONNECT", "PUT", "DELETE", "PATCH", "PROPFIND", "get", "X" * 200]
)
def test_other_methods_are_refused(served, method):
    for path in ("", "live", "save"):
        answer = asked(served, method, served.root + path, Access_Control_Request_Method="POST", X_Secret="4711")
        assert answer.status in (400, 403, 404, 405, 501), answer
        assert b"4711" not in answer.body
        assert not [name for name in answer.headers if name.startswith("access-control")]


@pytest.mark.parametrize("path", ["live", "save", "form", "tab/accuracy", "tab/design"])
def test_what_is_posted_cannot_be_got(served, path):
    for method in ("GET", "HEAD"):
        answer = asked(served, method, f"{served.root}{path}?base=0&fields=%7B%7D", drop=["Origin"])
        assert answer.status in (404, 405)


def test_the_page_cannot_be_posted(served):
    for path in ("", "page.css", "page.js"):
        assert served.post(path, LIVE).status in (404, 405)


@pytest.mark.parametrize(
    "kind",
    [
        None,
        "",
        "text/plain",
        "application/x-www-form-urlencoded",
        "multipart/form-data; boundary=x",
        "application/jsonx",
        "text/plain; application/json",
        "text/html, application/json",
    ],
)
def test_only_json_is_read(served, kind):
    for path in ("live", "save", "form", "tab/accuracy"):
        assert served.post(path, LIVE, content_type=kind).status == 415


def test_json_may_name_its_encoding(served):
    assert served.post("live", LIVE, content_type="application/json; charset=utf-8").status == 200


HOSTILE = {
    "empty": b"",
    "no JSON": b"{",
    "a list": b"[]",
    "a number": b"1",
    "null": b"null",
    "nothing named": b"{}",
    "deep": b"[" * 30_000,
    "deep and closed": b'{"base": 0, "fields": ' + b"[" * 20_000 + b"]" * 20_000 + b"}",
    "a huge integer": b'{"base": ' + b"9" * 20_000 + b', "fields": {}}',
    "an infinite base": b'{"base": 1e999, "fields": {}}',
    "not UTF-8": b'{"base": 0, "fields": {"name": "\xff\xfe"}}',
    "UTF-16": '{"base": 0, "fields": {}}'.encode("utf-16"),
    **{
        f"base {base!r}": json.dumps({"base": base, "fields": {}}).encode()
        for base in (-1, 1, 99999, 1.5, True, "0", "../x", None, [], {})
    },
    **{
        f"fields {fields!r:.40}": json.dumps({"base": 0, "fields": fields}).encode()
        for fields in (
            None,
            [],
            "x",
            1,
            {"name": 1},
            {"name": None},
            {"name": ["x"]},
            {"name": {}},
            {"": ""},
            {"=": "="},
        )
    },
    **{
        f"pinned {pinned!r:.40}": json.dumps({"base": 0, "fields": {}, "pinned": pinned}).encode()
        for pinned in (1, "x", [], {}, {"base": 7, "fields": {}}, {"base": 0, "fields": {"name": 1}})
    },
    "half a character": b'{"base": 0, "fields": {"name": "\\ud800"}}',
    "half a character in a key": b'{"base": 0, "fields": {"\\ud800": "1"}}',
    "NUL": b'{"base": 0, "fields": {"name": "a\\u0000b", "control_unit.gain": "\\u0000"}}',
    "many keys": json.dumps({"base": 0, "fields": {f"k{n}": "1" for n in range(3000)}}).encode(),
    "a long key": json.dumps({"base": 0, "fields": {"a." * 20_000: "1"}}).encode(),
    "a long number": json.dumps({"base": 0, "fields": {"control_unit.gain": "9" * 60_000}}).encode(),
    "a deep value": json.dumps({"base": 0, "fields": {"control_unit.gain": "[" * 50_000}}).encode(),
    "a deep table": json.dumps({"base": 0, "fields": {"control_unit": "{a=" * 15_000}}).encode(),
    "names of Python": json.dumps({"base": 0, "fields": {"__class__": "x", "name.__class__": "x"}}).encode(),
    "a template": json.dumps(
        {"base": 0, "fields": {"name": "{{7*7}}{% raw %}", "control_unit.gain": "{{7*7}}"}}
    ).encode(),
}


@pytest.mark.parametrize("body", HOSTILE.values(), ids=list(HOSTILE))
def test_hostile_bodies_are_answered(served, body):
    """Refused, or a sentence: never a fault of the server."""
    for path in ("live", "save", "form", "tab/accuracy"):
        answer = served.post(path, body)
        assert answer.status in (200, 400, 404, 409, 413, 422), (path, answer)
        assert b"Traceback" not in answer.body
        assert b"49" not in answer.body or b"{{7*7}}" not in body or path != "live"
        if answer.status == 200 and path == "live":
            assert answer.json.keys() & {"fragments", "errors", "problems"}
    is_alive(served)


NAMES = [
    "<script>alert(1)</script>",
    '"><img src=x onerror=alert(1)>',
    "'; alert(1)//",
    "</title><svg onload=alert(1)>",
]


@pytest.mark.parametrize("name", NAMES)
def test_texts_are_escaped(served, name):
    """As a value and as a key; the command is copied into a shell."""
    answer = served.live({"name": name})
    assert not [html for html in answer["fragments"].values() if html and name in html]
    for fields in ({"control_unit.gain": name}, {name: "1"}, {"variant": name}):
        wrong = served.live(fields)
        assert wrong["errors"] or wrong["problems"]
        assert "fragments" not in wrong or not any(name in str(html) for html in wrong["fragments"].values())


# files


CATALOGUE = '[materials.canary]\nname = "canary"\nmin = 0.2\nmax = 0.3\n'


@pytest.mark.parametrize(
    "key",
    [
        "catalogues.materials",
        "catalogues.discs",
        "catalogues.balls",
        "catalogues",
        " catalogues.materials",
        "catalogues .materials",
        '"catalogues".materials',
        'catalogues."materials"',
        "catalogues.materials ",
        "control_unit.gain=0.5\ncatalogues.materials",
    ],
)
def test_no_key_of_a_form_names_a_file(served, tmp_path, key):
    """An existing file and one that is missing get one answer."""
    there, missing = tmp_path / "there.toml", tmp_path / "other.toml"
    there.write_text("secret = 4711 4711", encoding="utf-8")
    for path in ("live", "tab/accuracy", "save"):
        answers = []
        for file in (there, missing, "/etc/passwd", "/dev/zero"):
            value = f'{{materials = "{file}"}}' if key == "catalogues" else str(file)
            answer = served.post(path, {"base": 0, "fields": {key: value}, "pinned": None})
            text = answer.body.decode()
            assert answer.status in (200, 400, 403, 404, 422)
            assert "4711" not in text
            assert "root:" not in text
            if answer.status == 200:
                last = json.loads(text.splitlines()[-1])
                assert last.get("errors") or last.get("problems"), last
            answers.append(text.replace(json.dumps(str(file))[1:-1], "FILE").partition('"ms"')[0])
        assert answers[0] == answers[1], path
    pinned = served.live({}, pinned={"base": 0, "fields": {key: str(there)}})
    assert "4711" not in json.dumps(pinned)


def test_no_pipe_is_opened(served, tmp_path):
    """Opening it would wait for ever."""
    os.mkfifo(tmp_path / "pipe")
    begun = time.monotonic()
    for key in (
        "catalogues.materials",
        "catalogues.discs",
        "catalogues.balls",
        "friction.material",
        "closing_spring.disc",
    ):
        served.live({key: str(tmp_path / "pipe")})
    assert time.monotonic() - begun < 5


def test_requirements_name_no_file(served, tmp_path):
    text = served.get().body.decode()
    assert "requirements" in text
    there = tmp_path / "there.toml"
    there.write_text("secret = 4711 4711", encoding="utf-8")
    for file in (there, tmp_path / "gone.toml"):
        asking = f'[catalogues]\nmaterials = "{file}"\n[wanted]\nnominal_torque = "100 N*m"\n'
        last = served.tab("design", {}, requirements=asking)[-1]
        assert last.get("errors") or last.get("problems"), last
        assert "4711" not in json.dumps(last)
        assert "4711" not in served.live({"name": "x"})["fragments"]["numbers"]


# how much


def _sent_until_refused(served, head, piece, most):
    """Bytes that were taken before the connection ended, what was answered, seconds."""
    begun, sent, received = time.monotonic(), 0, b""
    with socket.create_connection(("127.0.0.1", served.port), timeout=10) as connection:
        with suppress(OSError):
            connection.sendall(head)
            while sent < most:
                connection.sendall(piece)
                sent += len(piece)
        with suppress(OSError):
            while more := connection.recv(65536):
                received += more
    return sent, answer_of(received), time.monotonic() - begun


@proc
@pytest.mark.parametrize("path", ["live", "save", "tab/design", "form", "nothing", "../wrong/live"])
def test_a_large_body_is_not_read(served, path):
    before = served.memory()
    head = request(served, path=served.root + path, Content_Length=str(100 * MIB))
    sent, answer, seconds = _sent_until_refused(served, head, b"x" * MIB, 100 * MIB)
    assert sent < 20 * MIB, "buffers of the system hold a few MiB"
    assert answer.status in (0, 413, 404)  # 0: the answer is lost where the connection is reset
    assert seconds < 10
    assert served.memory() - before < 10 * MIB
    is_alive(served)


def test_a_body_too_long_is_refused_before_it_comes(served):
    """Nothing of it is sent; one of a byte less than allowed is read."""
    answer = answer_of(served.raw(request(served, Content_Length=str(LIMIT + 1))))
    assert answer.status == 413
    answer = answer_of(served.raw(request(served, Content_Length="9" * 30)))
    assert answer.status in (400, 413)
    body = json.dumps(LIVE).encode()
    assert served.post("live", body + b" " * (LIMIT - len(body))).status == 200
    assert served.post("live", body + b" " * (LIMIT - len(body) + 1)).status == 413


@proc
def test_an_endless_body_in_chunks_is_ended(served):
    before = served.memory()
    head = request(served, drop=["Content-Length"], Transfer_Encoding="chunked")
    sent, answer, seconds = _sent_until_refused(served, head, b"100000\r\n" + b" " * MIB + b"\r\n", 100 * MIB)
    assert sent < 20 * MIB
    assert answer.status in (0, 413)
    assert seconds < 10
    assert served.memory() - before < 10 * MIB
    slow = request(served, drop=["Content-Length"], Transfer_Encoding="chunked")
    answer = answer_of(served.raw(slow + b"".join(b"400\r\n" + b" " * 1024 + b"\r\n" for _ in range(70))))
    assert answer.status == 413
    is_alive(served)


@proc
def test_endless_headers_are_ended(served):
    before = served.memory()
    head = request(served).removesuffix(b"\r\n")
    sent, answer, _ = _sent_until_refused(served, head, b"X: " + b"y" * MIB, 50 * MIB)
    assert sent < 20 * MIB
    assert answer.status in (0, 400, 431)
    assert served.memory() - before < 10 * MIB
    is_alive(served)


def test_half_requests_do_not_hold_up_others(served):
    half = request(served, body=b"{" * 1000)
    with ExitStack() as stack:
        for cut in range(60):
            connection = stack.enter_context(socket.create_connection(("127.0.0.1", served.port), timeout=10))
            connection.sendall(half[: 20 + cut * len(half) // 61])
        begun = time.monotonic()
        is_alive(served)
        assert time.monotonic() - begun < 2


ENDLESS = pytest.mark.xfail(strict=True, reason="uvicorn waits for the rest of a head for ever")


@pytest.mark.exhaustive
@pytest.mark.parametrize("part", ["body", pytest.param("head", marks=ENDLESS)])
def test_half_a_request_is_ended(served, part):
    half = request(served, body=b"{" * 1000)[: 30 if part == "head" else -500]
    begun = time.monotonic()
    with socket.create_connection(("127.0.0.1", served.port), timeout=40) as connection:
        connection.sendall(half)
        with suppress(ConnectionResetError):
            while connection.recv(65536):
                pass
    assert time.monotonic() - begun < 30


# what comes back

SAFE = {
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cache-control": "no-store",
}
ALLOWED = {("style-src", "'unsafe-inline'"), ("img-src", "data:"), ("font-src", "data:"), ("frame-src", "blob:")}
"""What the drawings and the report need beside what is the server's own."""


@pytest.mark.parametrize(
    ("method", "path", "status"),
    [
        ("GET", "", 200),
        ("GET", "page.css", 200),
        ("GET", "page.js", 200),
        ("POST", "live", 200),
        ("POST", "form", 200),
        ("POST", "tab/accuracy", 200),
        ("GET", "nothing", 404),
        ("GET", "../nothing", 404),
        ("GET", "live", 405),
    ],
)
def test_headers_keep_others_out(served, method, path, status):
    answer = served.ask(method, served.root + path, LIVE if method == "POST" else None)
    assert answer.status in (status, 404)
    assert SAFE.items() <= answer.headers.items()
    assert not [name for name in answer.headers if name.startswith("access-control") or name == "set-cookie"]
    policy = dict(part.strip().partition(" ")[::2] for part in answer.headers["content-security-policy"].split(";"))
    assert policy["default-src"] == "'none'"
    assert policy["frame-ancestors"] == "'none'"
    assert policy["base-uri"] == "'none'"
    assert policy["form-action"] in ("'none'", "'self'")
    assert policy.get("script-src", "'self'") == "'self'"
    assert policy.get("connect-src", "'self'") == "'self'"
    for part, sources in policy.items():
        for source in sources.split():
            assert source in ("'none'", "'self'") or (part, source) in ALLOWED


def test_errors_too_have_the_headers(served):
    for answer in (
        served.post("live", LIVE, origin="http://evil.example"),
        served.post("live", LIVE, host="evil.example"),
        served.post("live", LIVE, content_type="text/plain"),
        served.post("live", b"{"),
        served.post("live", b" " * (LIMIT + 1)),
    ):
        assert answer.status >= 400
        assert SAFE.items() <= answer.headers.items(), answer


def test_kinds_are_named(served):
    kinds = {"": "text/html", "page.css": "text/css", "page.js": ("text/javascript", "application/javascript")}
    for path, kind in kinds.items():
        assert served.get(path).headers["content-type"].startswith(kind), path
        assert "charset=utf-8" in served.get(path).headers["content-type"].lower()
    assert served.post("live", LIVE).headers["content-type"].startswith("application/json")


@pytest.mark.parametrize(
    "injected", ["%0d%0aX-Evil:%201", "%0aX-Evil:%201", "%E5%98%8A%E5%98%8DX-Evil:1", "\rX-Evil: 1"]
)
def test_no_header_is_injected(served, injected):
    for path in (
        f"{served.root}{injected}",
        f"{served.root}?base=0{injected}",
        f"/{injected}",
        f"{served.root}tab/{injected}",
    ):
        for method in ("GET", "POST"):
            answer = asked(served, method, path, body=b"{}")
            assert "x-evil" not in answer.headers


@pytest.mark.parametrize(
    "base", ["-1", "1", "99999999999999999999", "x", "1e3", "0x0", "", "0&base=1", "../../x", "%00", "%D9%A3"]
)
def test_a_base_is_a_number_that_there_is(served, base):
    answer = asked(served, "GET", f"{served.root}?base={base}", drop=["Origin"])
    assert answer.status in (200, 400, 404)
    assert b"Traceback" not in answer.body
    assert answer_of(served.raw(request(served, "GET", f"{served.root}?base=0", drop=["Origin"]))).status == 200


def test_it_does_not_become_a_websocket(served):
    upgrade = {"Connection": "Upgrade", "Upgrade": "websocket", "Sec_WebSocket_Version": "13"}
    sent = request(served, "GET", served.root, Sec_WebSocket_Key="dGhlIHNhbXBsZSBub25jZQ==", **upgrade)
    assert answer_of(served.raw(sent, seconds=1)).status != 101
    is_alive(served)


# all at once


def test_two_tabs_get_their_own_answers(served):
    """Eight clients, each with a gain of its own, and one that pins another's."""
    wrong = []

    def ask(gain):
        for _ in range(several(1, 20)):
            answer = served.live(
                {"control_unit.gain": gain}, pinned={"base": 0, "fields": {"control_unit.gain": "0.9"}}
            )
            if f"control_unit.gain={gain}" not in answer["command"]:
                wrong.append((gain, answer["command"]))

    threads = [threading.Thread(target=ask, args=(f"0.{n}5",)) for n in range(1, 9)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_many_connections_do_no_harm(served):
    with ExitStack() as stack:
        for _ in range(several(50, 300)):
            stack.enter_context(socket.create_connection(("127.0.0.1", served.port), timeout=10))
        is_alive(served)
    until(lambda: served.get().status == 200)
