"""HTTP server of the page: connections, access, routes, and the worker that answers each request."""

import asyncio
import json
import os
import secrets
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import aclosing, asynccontextmanager
from hashlib import sha256
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response, StreamingResponse
from starlette.routing import Route
from starlette.types import ASGIApp, Message, Receive, Scope, Send
from uvicorn.protocols.http.h11_impl import H11Protocol

from .. import __version__
from ..equations.terms import term_of
from ..errors import AfmcalcError, FileError, unexpected
from ..messages import named, say, spoken, translate
from ..spec import Spec
from ..spec.edit import saved
from ..spec.parse import PREFIX, example_names, example_text, parse
from .form import RESULTS, TUNED, Base, State, form_of, refusal, refused, search_of
from .fragments import template
from .worker import Worker

HERE = Path(__file__).parent
_LARGEST = 64 << 10
"""Largest body of a request, bytes."""
_SLOWEST, _LONG = 10.0, 120.0
"""Time limits, s: for receiving the body of a request and for a live calculation; for the calculation of a tab."""
_FILES = ("pdf", "dxf", "csv")
_CALCULATED = ("accuracy", "drive", "heat", "tolerance", "design", "report", "check", "live")
_ASKED = {*_CALCULATED, *_FILES, "help", "mend"}
"""Calculations, of which a newer one ends that of the same page; and what else a worker is asked."""
_MOST_BASES, _OF_A_FRONT = 200, 100
"""Largest number of clutches kept besides that of the command line; how many numbers a front of a design reserves."""
_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; "
    "connect-src 'self'; frame-src blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_HEADERS = {
    "Content-Security-Policy": _POLICY,
    "Cache-Control": "no-store",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
}

_OPENED = ("navigate", "document")
"""Values of Sec-Fetch-Mode and Sec-Fetch-Dest when the page is opened in a browser tab."""


def gate(app: ASGIApp, port: int, token: str) -> ASGIApp:
    """Middleware that passes only requests of our own page, with the right host and token, and none of other sites.

    ``app`` is served at ``port`` under the path ``/token/``; every response carries the security headers.
    """
    names = ("127.0.0.1", "localhost")
    # a browser leaves out the default port of HTTP
    hosts = [*(f"{name}:{port}" for name in names), *(names if port == 80 else ())]

    def barred(request: Request) -> Response | None:
        """Response 403 or 404 that refuses a request; None if the request may pass."""
        headers, parts = request.headers, request.scope["path"].encode().split(b"/", 2)
        own = len(headers.getlist("host")) == 1 and headers["host"] in hosts
        # programs other than browsers send neither of these headers; a browser sends Origin with every POST
        own = own and all(origin == f"http://{headers['host']}" for origin in headers.getlist("origin"))
        sites = ("same-origin", "none") if request.method in ("GET", "HEAD") else ("same-origin",)
        # the file that opens the page in a browser belongs to no site
        opened = request.method == "GET" and (headers.get("sec-fetch-mode"), headers.get("sec-fetch-dest")) == _OPENED
        if not own or not (opened or headers.get("sec-fetch-site", "same-origin") in sites):
            return PlainTextResponse("Forbidden", 403)
        if len(parts) != 3 or not secrets.compare_digest(parts[1], token.encode()):
            return PlainTextResponse("Not Found", 404)
        return None

    async def guarded(scope: Scope, receive: Receive, send: Send) -> None:
        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                # the body of a refused request is not read
                headers = _HEADERS | ({"Connection": "close"} if message["status"] >= 400 else {})
                message["headers"] = [*message["headers"], *((k.encode(), v.encode()) for k, v in headers.items())]
            await send(message)

        if scope["type"] != "http":
            await app(scope, receive, send)
        elif response := barred(Request(scope)):
            await response(scope, receive, send_with_headers)
        else:
            await app({**scope, "path": f"/{scope['path'].split('/', 2)[2]}"}, receive, send_with_headers)

    return guarded


def protocol(seconds: float = 10.0, most: int = 100) -> type[H11Protocol]:
    """Protocol of which at most ``most`` connections may wait, each at most ``seconds``, for the head of a request."""
    waiting: dict[H11Protocol, asyncio.TimerHandle] = {}

    class Patient(H11Protocol):
        """Connection that is closed if no request has come in time."""

        def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
            """Wait for the first request; if too many connections wait, close the one that has waited longest."""
            super().connection_made(transport)
            self._wait()
            if len(waiting) > most:
                next(iter(waiting)).transport.abort()

        def data_received(self, data: bytes) -> None:
            """Stop waiting if the head of the request is now complete."""
            super().data_received(data)
            if self.cycle and not self.cycle.response_complete:
                self._stop()

        def on_response_complete(self) -> None:
            super().on_response_complete()
            self._wait()

        def connection_lost(self, exc: Exception | None) -> None:
            super().connection_lost(exc)
            self._stop()

        def _wait(self) -> None:
            self._stop()
            if not self.transport.is_closing():
                waiting[self] = self.loop.call_later(seconds, self.transport.abort)

        def _stop(self) -> None:
            if timer := waiting.pop(self, None):
                timer.cancel()

    return Patient


def _digest(path: str) -> str:
    """SHA-256 of a file; empty if there is no file."""
    if not os.path.exists(path):
        return ""
    if not os.path.isfile(path):
        raise FileError("{path}: is no file that could be replaced", path=path)
    return sha256(Path(path).read_bytes()).hexdigest()


class Page:
    """State of the server: its first clutch, and clutches of designs and files; the page's forms hold all changes."""

    def __init__(self, base: Base, units: str, path: str, rewrite: Callable[[Spec, bool], None]) -> None:
        """Serve a page that starts from ``base`` and saves to ``path`` by ``rewrite``, told if it may overwrite.

        If ``path`` is empty, the page cannot save.
        """
        self._bases, self._made = {0: base}, 1
        self._others = set[int]()
        """Numbers of those bases that are other clutches than the clutch of the command line."""
        self._path, self._rewrite = path, rewrite
        self._begun = _digest(path) if path else ""
        """Digest of the file when serve began; empty if there was no file."""
        self._live = Worker(units, _SLOWEST, newest=False)
        self._tabs, self._check = (Worker(units, _LONG, newest=True) for _ in range(2))

    def app(self, port: int, token: str, ready: Callable[[], None]) -> ASGIApp:
        """ASGI application behind a ``gate``; it calls ``ready`` as soon as it serves."""

        @asynccontextmanager
        async def lifespan(app: Starlette) -> AsyncIterator[None]:
            self._live.start()
            self._tabs.start()
            ready()
            try:
                yield
            finally:
                for worker in (self._live, self._tabs, self._check):
                    worker.end(closed=True)

        posts = {"live": self._answer, "tab/{name}": self._answer, "open": self._open, "save": self._write}
        routes = [Route("/", self._page), Route("/page.css", _file), Route("/page.js", _file)]
        routes += [Route(f"/{path}", endpoint, methods=["POST"]) for path, endpoint in posts.items()]
        handlers: dict[Any, Any] = dict.fromkeys((Exception, AfmcalcError), _failed)
        served = Starlette(routes=routes, lifespan=lifespan, exception_handlers=handlers)
        served.router.redirect_slashes = False
        return gate(served, port, token)

    async def _page(self, request: Request) -> Response:
        asked = request.query_params.get("base", "0")
        number = int(asked) if asked.isdecimal() and len(asked) < 9 else -1
        state = State(self._base(number))
        results = {name: translate(term_of(name).meaning) for name in RESULTS}
        page = template("page.html").render(
            language=spoken(), version=__version__, name=named(state.spec.name), source=state.base.label,
            target=self._path, known=self._begun, groups=form_of(state), base=number,
            requirements=search_of(state.spec), examples=example_names(), files=_FILES, results=results, tuned=TUNED,
            swept="C" if state.spec.control_unit else "f_max",
        )  # fmt: skip
        return HTMLResponse(page)

    def _base(self, number: object) -> Base:
        """Base with a number, else error 404; the bases used last are kept."""
        if type(number) is not int or number not in self._bases:
            raise HTTPException(404)
        self._bases[number] = self._bases.pop(number)
        return self._bases[number]

    def _keep(self, number: int, base: Base) -> None:
        self._bases[number] = base
        if len(self._bases) > _MOST_BASES:
            self._bases.pop(next(other for other in self._bases if other))

    def _state(self, body: object) -> State:
        return State(self._base(_table(body).get("base")), _table(_table(body).get("fields"), str))

    async def _answer(self, request: Request) -> Response:
        """Progress and answer, each a line of JSON."""
        body, tab = await _body(request), request.path_params.get("name")
        if tab == "live" or (name := tab or "live") not in _ASKED:
            raise HTTPException(404)
        pinned, options = body.get("pinned"), _table(body.get("options", {}), str)
        pinned = self._state(pinned) if pinned else None
        job: dict[str, Any] = {
            "name": name,
            "state": self._state(body),
            "pinned": pinned,
            "options": options,
            "first": self._made,
        }
        self._made += _OF_A_FRONT * (name == "design")
        worker = {"live": self._live, "help": self._live, "check": self._check}.get(name, self._tabs)
        # other requests of a page do not end the calculation of a tab or a check
        page = str(body.get("page"))[:80] + ("" if name in _CALCULATED else f" {name}")

        async def lines() -> AsyncIterator[str]:
            try:
                async with aclosing(worker.ask(job, request.is_disconnected, page)) as answers:
                    async for answer in answers:
                        for at, base in enumerate(answer.pop("bases", [])[:_OF_A_FRONT]):
                            self._keep(job["first"] + at, Base(*base))
                        yield json.dumps(answer) + "\n"
            except Exception as error:
                yield json.dumps(refusal(*unexpected(error)[1])) + "\n"

        return StreamingResponse(lines(), media_type="application/x-ndjson")

    async def _write(self, request: Request) -> Response:
        body = await _body(request)
        state, known = self._state(body), str(body.get("known", self._begun))
        anyway, path = body.get("anyway") is True, self._path
        if body.get("download") is True:
            text = saved(spec := state.spec, {}, spec, "clutch.toml")
            return _json({"text": text, "message": say("The spec is in the downloads.")})
        if path and body["base"] in self._others and not anyway:
            return _json({"message": say("{path} holds another clutch: nothing is written", path=path)})
        # in a thread, so that a slow disk does not delay other requests
        answer = await asyncio.to_thread(self._save, state.spec, known, anyway)
        if "saved" in answer:
            self._others.discard(body["base"])
        return _json(answer)

    def _save(self, spec: Spec, known: str, anyway: bool) -> dict[str, Any]:
        """Write a spec; return a message and the file's new digest, or only a message if it changed since ``known``."""
        if not (path := self._path):
            raise AfmcalcError("nothing to save to: start with --save FILE, or with --force to save to SPEC")
        before = _digest(path)
        if known and known != before and not anyway:
            return {"message": say("{path} was changed by another program: nothing is written", path=path)}
        self._rewrite(spec, bool(known and before) or anyway)
        return {"saved": path, "message": say("wrote {output}", output=path), "known": _digest(path)}

    async def _open(self, request: Request) -> Response:
        """Form of a clutch, and its heading, for the number of a base, an example, or the text of a file."""
        body = await _body(request)
        if "base" in body:
            number = body["base"]
            state = State(self._base(number))
            spec = state.spec
        else:
            label, text = (str(body.get(name, "")) for name in ("label", "text"))
            if example := str(body.get("example", "")):
                label, text = f"{PREFIX}{example}", example_text(example)
            state = State(Base(label, text, label if example else "-"))
            if "catalogues" in parse(state.base.source):
                raise AfmcalcError("{label}: names lists of its own: start afmcalc serve with it", label=label)
            spec, number = state.spec, self._made
            self._made += 1
            self._keep(number, state.base)
            self._others.add(number)
        macros: Any = template("parts.html").module
        told = {"html": str(macros.form(form_of(state), number)), "name": named(spec.name)}
        return _json(told | {"source": state.base.label, "requirements": search_of(spec)})


async def _body(request: Request) -> dict[str, Any]:
    """JSON object in the body of a request; raises HTTPException for any other body."""
    if request.headers.get("content-type", "").partition(";")[0].strip().lower() != "application/json":
        raise HTTPException(415)
    length, raw = request.headers.get("content-length", "0"), b""
    if not length.isdecimal() or int(length) > _LARGEST:
        raise HTTPException(413)
    try:
        async with asyncio.timeout(_SLOWEST):
            async for part in request.stream():
                raw += part
                if len(raw) > _LARGEST:
                    raise HTTPException(413)
        return _table(json.loads(raw))
    except TimeoutError:
        raise HTTPException(408) from None
    except (ValueError, RecursionError):
        raise HTTPException(400) from None


def _table(given: object, of: type = object) -> dict[str, Any]:
    if not isinstance(given, dict) or not all(isinstance(value, of) for value in given.values()):
        raise HTTPException(400)
    return given


def _json(answer: Mapping[str, Any], status: int = 200) -> Response:
    """Response with JSON in ASCII, which can also represent lone surrogates."""
    return Response(json.dumps(answer), status, media_type="application/json")


async def _failed(request: Request, error: Exception) -> Response:
    if isinstance(error, AfmcalcError):
        return _json(refused(error))
    return _json(refusal(*unexpected(error)[1]), 500)


async def _file(request: Request) -> Response:
    """Response with the script, or with the style sheets of the report and of the page, in this order."""
    files, kind = [HERE / "page.js"], "text/javascript"
    if request.url.path.endswith(".css"):
        files, kind = [HERE.parent / "render" / "report" / "page.css", HERE / "page.css"], "text/css"
    return Response("\n".join(file.read_text(encoding="utf-8") for file in files), media_type=kind)
