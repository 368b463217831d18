"""Bytes sent to a real server: incomplete requests, too large, too slow, or too many at once."""

import time
from contextlib import ExitStack

import pytest
from pages import web
from serving import proc

pytestmark = [web, proc, pytest.mark.tool]
MIB = 1 << 20
LIVE = b'{"base": 0, "fields": {}, "pinned": null}'


def request(served, method="POST", path=None, body=LIVE, drop=(), **headers):
    """Bytes of a request, with the headers that the page sends, except those dropped or changed."""
    sent = {"Host": served.host, **served.headers, "Content-Length": str(len(body)), "Connection": "close"}
    sent |= {name.replace("_", "-"): value for name, value in headers.items()}
    lines = [f"{name}: {value}" for name, value in sent.items() if name not in drop]
    path = served.root + "live" if path is None else path
    return "\r\n".join([f"{method} {path} HTTP/1.1", *lines, "", ""]).encode("latin-1") + body


@pytest.fixture(autouse=True)
def is_alive(served):
    """Assert after every test that the server answers and holds no more memory than before."""

    def settled():
        assert served.live({})["fragments"]["numbers"]
        while not served.is_quiet():
            pass
        return served.memory()

    before = settled()
    yield
    assert settled() - before < 20 * MIB


def test_what_is_no_request_is_refused(served):
    """Two hosts or none, an invalid character, an injected header, another protocol."""
    upgrade = {"Connection": "Upgrade", "Upgrade": "websocket", "Sec_WebSocket_Version": "13"}
    after = {"Origin": f"http://{served.host}\r\nOrigin: http://evil.example"}
    for status, sent in (
        (200, request(served)),
        (400, request(served, drop=["Host"])),
        (403, request(served, drop=["Host"]).replace(b"HTTP/1.1", b"HTTP/1.0")),
        (400, request(served).replace(b"Origin:", b"Host: evil.example\r\nOrigin:")),
        (403, request(served, **after)),
        (400, request(served, path=f"{served.root}\x00")),
        (400, request(served, path=f"{served.root}x y")),
        (400, request(served, Content_Length="-1")),
        (404, request(served, path=f"http://{served.host}{served.root}live")),
        (405, request(served, "GET", served.root + "live", Sec_WebSocket_Key="dGhlIHNhbXBsZSBub25jZQ==", **upgrade)),
    ):
        assert served.raw(sent)[0].status == status, sent
    for injected in ("%0d%0aX-Evil:%201", "%0aX-Evil:%201", "%E5%98%8A%E5%98%8DX-Evil:1"):
        for path in (f"{served.root}{injected}", f"{served.root}?base=0{injected}", f"/{injected}"):
            assert "x-evil" not in served.raw(request(served, "GET", path))[0].headers


def test_no_more_is_read_than_is_allowed(served):
    """A large body, a body or a head without an end; the answer is lost if the connection is reset."""
    large = request(served, body=b"", Content_Length=str(100 * MIB))
    chunked = request(served, body=b"", drop=["Content-Length"], Transfer_Encoding="chunked")
    head = request(served, body=b"").removesuffix(b"\r\n")
    piece = b" " * MIB
    for status, first, part in (
        (413, large, piece),
        (413, chunked, b"100000\r\n" + piece + b"\r\n"),
        (400, head, b"X: " + b"y" * MIB),
    ):
        answer, sent = served.raw(first, *[part] * 100)
        assert answer.status in (status, 0)
        assert sent < 20 * MIB, "buffers of the system hold a few MiB"
    answer, _ = served.raw(chunked, b"".join(b"400\r\n" + b" " * 1024 + b"\r\n" for _ in range(70)))
    assert answer.status == 413
    assert served.raw(large)[0].status == 413, "before anything comes of it"


def test_half_requests_hold_up_nobody(served):
    """A hundred half requests at once delay no answer; half a body is refused after ten seconds."""
    half = request(served, body=b"{" * 1000)[:-500]
    with ExitStack() as stack:
        for cut in range(100):
            connection = stack.enter_context(served.connected())
            connection.sendall(half[: 20 + cut * len(half) // 101])
        assert served.live({})["fragments"]
        begun = time.monotonic()
        answer, _ = served.raw(half)
        assert (answer.status, time.monotonic() - begun < 40) == (408, True)
