"""The server: who may ask, what is asked, and who answers."""

import asyncio
import json
import secrets
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import aclosing, asynccontextmanager
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response, StreamingResponse
from starlette.routing import Route
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from .. import __version__
from ..errors import AfmcalcError, unexpected
from ..messages import named, spoken
from .filled import template
from .form import Base, State, form_of, refusal
from .worker import Worker

HERE = Path(__file__).parent
_LARGEST = 64 << 10
"""Bytes of a body."""
_SLOWEST, _LONG = 10.0, 120.0
"""Seconds in which a body must be here, and what is shown live be calculated; and that a tab may take."""
_ASKED = ("check", "accuracy", "drive", "heat", "tolerance", "design", "explanation", "report")
_MOST_BASES = 20
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


class Gate:
    """Lets through what comes from our own page: the right host and token, no other site."""

    def __init__(self, app: ASGIApp, port: int, token: str) -> None:
        """Stand before an application that is served at a port under a token."""
        self._app, self._token = app, token.encode()
        self._hosts = (f"127.0.0.1:{port}", f"localhost:{port}")

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Hand a request on, or refuse it; every answer carries the headers that keep others out."""

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                # of what is refused no more is read
                headers = _HEADERS | ({"Connection": "close"} if message["status"] >= 400 else {})
                message["headers"] = [*message["headers"], *((k.encode(), v.encode()) for k, v in headers.items())]
            await send(message)

        if scope["type"] != "http":
            await self._app(scope, receive, send)
        elif refused := self._refused(Request(scope)):
            await refused(scope, receive, send_with_headers)
        else:
            await self._app({**scope, "path": f"/{scope['path'].split('/', 2)[2]}"}, receive, send_with_headers)

    def _refused(self, request: Request) -> Response | None:
        """Return the answer to a request that is refused."""
        headers, parts = request.headers, request.scope["path"].encode().split(b"/", 2)
        own = len(headers.getlist("host")) == 1 and headers["host"] in self._hosts
        # what is no browser sends neither of the next; a browser sends an origin with all that is posted
        own = own and all(origin == f"http://{headers['host']}" for origin in headers.getlist("origin"))
        sites = ("same-origin", "none") if request.method in ("GET", "HEAD") else ("same-origin",)
        if not own or headers.get("sec-fetch-site", "same-origin") not in sites:
            return PlainTextResponse("Forbidden", 403)
        if len(parts) != 3 or not secrets.compare_digest(parts[1], self._token):
            return PlainTextResponse("Not Found", 404)
        return None


class Page:
    """State of the server: one clutch and those that a design gave, changed by forms; it keeps nothing else."""

    def __init__(self, base: Base, requirements: str, units: str, target: str, save: Callable[[Any], Any]) -> None:
        """Serve a clutch, and a search around it; ``target``: what ``save`` writes, if anything."""
        self._bases, self._front, self._made = {0: base}, dict[int, Base](), 1
        self._requirements, self._target, self._save = requirements, target, save
        self._live = Worker(units, _SLOWEST, newest=False)
        self._tabs, self._check = (Worker(units, _LONG, newest=True) for _ in range(2))

    def app(self, port: int, token: str, ready: Callable[[], None]) -> ASGIApp:
        """Return the application."""

        @asynccontextmanager
        async def lifespan(app: Starlette) -> AsyncIterator[None]:
            self._live.start()
            self._tabs.start()
            ready()
            try:
                yield
            finally:
                self._live.end(closed=True)
                self._tabs.end(closed=True)
                self._check.end(closed=True)

        posts = {"live": self._answer_live, "tab/{name}": self._answer_tab, "save": self._write, "form": self._form}
        routes = [Route("/", self._page), Route("/page.css", _file), Route("/page.js", _file)]
        routes += [Route(f"/{path}", endpoint, methods=["POST"]) for path, endpoint in posts.items()]
        served = Starlette(routes=routes, lifespan=lifespan, exception_handlers={Exception: _fault})
        served.router.redirect_slashes = False
        return Gate(served, port, token)

    async def _page(self, request: Request) -> Response:
        asked = request.query_params.get("base", "0")
        number = int(asked) if asked.isdecimal() and len(asked) < 9 else -1
        state = State(self._base(number))
        page = template("page.html").render(
            language=spoken(), version=__version__, name=named(state.spec.name), source=state.base.label,
            target=self._target, groups=form_of(state), base=number, requirements=self._requirements,
            swept="C" if state.spec.control_unit else "f_max",
        )  # fmt: skip
        return HTMLResponse(page)

    def _base(self, number: object) -> Base:
        """Return a base by its number; one of the front that is asked for is kept, of these the last few."""
        if type(number) is int and number in self._front:
            self._bases[number] = self._front[number]
            if len(self._bases) > _MOST_BASES:
                self._bases.pop(next(other for other in self._bases if other))
        if type(number) is not int or number not in self._bases:
            raise HTTPException(404)
        return self._bases[number]

    def _state(self, body: object) -> State:
        return State(self._base(_table(body).get("base")), _table(_table(body).get("fields"), str))

    def _job(self, name: str, body: dict[str, Any]) -> dict[str, Any]:
        """Return what the process is asked for a request."""
        pinned, options = body.get("pinned"), _table(body.get("options", {}), str)
        pinned = self._state(pinned) if pinned else None
        return {"name": name, "state": self._state(body), "pinned": pinned, "options": options, "first": self._made}

    async def _answer_live(self, request: Request) -> Response:
        job = self._job("live", await _body(request))
        async with aclosing(self._live.ask(job, request.is_disconnected)) as answers:
            async for answer in answers:
                if "progress" not in answer:
                    return _json(answer)
        return Response(status_code=204)

    async def _answer_tab(self, request: Request) -> Response:
        job = self._job(request.path_params["name"], await _body(request))
        if job["name"] not in _ASKED:
            raise HTTPException(404)

        worker = self._check if job["name"] == "check" else self._tabs

        async def lines() -> AsyncIterator[str]:
            async with aclosing(worker.ask(job, request.is_disconnected)) as answers:
                async for answer in answers:
                    if bases := answer.pop("bases", []):  # in place of those of an earlier front
                        self._front = {job["first"] + at: Base(*base) for at, base in enumerate(bases)}
                        self._made = job["first"] + len(bases)
                    yield json.dumps(answer) + "\n"

        return StreamingResponse(lines(), media_type="application/x-ndjson")

    async def _write(self, request: Request) -> Response:
        state = self._state(await _body(request))
        try:
            return _json(dict(zip(("saved", "message"), self._save(state.spec), strict=True)))
        except AfmcalcError as error:
            return _json(refusal(error))

    async def _form(self, request: Request) -> Response:
        number = (await _body(request)).get("base")
        macros: Any = template("parts.html").module
        return _json({"html": str(macros.form(form_of(State(self._base(number))), number)), "base": number})


async def _body(request: Request) -> dict[str, Any]:
    """Return the JSON object that a request carries."""
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
    """Answer in ASCII: a text that is none, half a pair of surrogates, is told as well."""
    return Response(json.dumps(answer), status, media_type="application/json")


async def _fault(request: Request, error: Exception) -> Response:
    return _json({"errors": {}, "problems": unexpected(error)[1]}, 500)


async def _file(request: Request) -> Response:
    """Send the script, or the style after that of the report, whose colours and tables it has."""
    files, kind = [HERE / "page.js"], "text/javascript"
    if request.url.path.endswith(".css"):
        files, kind = [HERE.parent / "render" / "report" / "page.css", HERE / "page.css"], "text/css"
    return Response("\n".join(file.read_text(encoding="utf-8") for file in files), media_type=kind)
