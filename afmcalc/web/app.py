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
from ..render.report.page import template
from .base import Base, data_to_save, refusal
from .form import form_of
from .worker import Worker

HERE = Path(__file__).parent
_LARGEST = 64 << 10
"""Bytes of a body."""
_SLOWEST = 10.0
"""Seconds in which a body must be here, and in which what is shown live must be calculated."""
_LONG = 120.0
"""Seconds that a tab may take."""
_TABS = ("accuracy", "drive", "heat", "tolerance", "design", "explanation", "report")
_MOST_BASES = 20
_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; "
    "connect-src 'self'; frame-src blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
_HEADERS = {
    "Content-Security-Policy": _POLICY,
    "Cache-Control": "no-store",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
}

Save = Callable[[dict[str, Any]], tuple[str, str]]
"""Writes a spec, and gives the name of the file and what was done."""


class Gate:
    """Lets through what comes from our own page: the right host and token, no other site, no large body."""

    def __init__(self, app: ASGIApp, port: int, token: str) -> None:
        """Gate an application that is served at a port under a token."""
        self._app, self._token = app, token.encode()
        self._hosts = (f"127.0.0.1:{port}", f"localhost:{port}")

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Hand a request on, or refuse it; every answer carries the headers that keep others out."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return

        async def send_with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                # of what is refused no more is read
                headers = _HEADERS | ({"Connection": "close"} if message["status"] >= 400 else {})
                message["headers"] = [*message["headers"], *((k.encode(), v.encode()) for k, v in headers.items())]
            await send(message)

        if status := self._refused(Request(scope)):
            await PlainTextResponse(_STATUS[status], status)(scope, receive, send_with_headers)
            return
        await self._app({**scope, "path": f"/{scope['path'].split('/', 2)[2]}"}, receive, send_with_headers)

    def _refused(self, request: Request) -> int:
        """Status of a request that is refused, 0 of one that is not."""
        headers, asks = request.headers, request.method in ("GET", "HEAD")
        if len(headers.getlist("host")) != 1 or headers["host"] not in self._hosts:
            return 403
        # what no browser sends has neither header; a browser sends an origin with what changes something
        if any(origin != f"http://{headers['host']}" for origin in headers.getlist("origin")):
            return 403
        if headers.get("sec-fetch-site", "same-origin") not in ("same-origin", *(["none"] if asks else [])):
            return 403
        parts = request.scope["path"].encode().split(b"/", 2)
        if len(parts) != 3 or not secrets.compare_digest(parts[1], self._token):
            return 404
        return 0


_STATUS = {403: "Forbidden", 404: "Not Found"}


class Page:
    """What is served: one clutch and those that a design gave, changed by forms; it keeps nothing else."""

    def __init__(self, base: Base, requirements: str, units: str, target: str, save: Save) -> None:
        """Serve a clutch, and requirements to search around it.

        ``target`` is the file that ``save`` writes, empty where there is none.
        """
        self._bases = {0: base}
        self._front: dict[int, Base] = {}
        self._made = 1
        self._requirements, self._target, self._save = requirements, target, save
        self._live = Worker(units, _SLOWEST, newest=False)
        self._tabs = Worker(units, _LONG, newest=True)

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
                self._live.close()
                self._tabs.close()

        routes = [
            Route("/", self._page),
            Route("/page.css", _style),
            Route("/page.js", _script),
            Route("/live", self._answer_live, methods=["POST"]),
            Route("/tab/{name}", self._answer_tab, methods=["POST"]),
            Route("/save", self._answer_save, methods=["POST"]),
            Route("/form", self._answer_form, methods=["POST"]),
        ]
        served = Starlette(routes=routes, lifespan=lifespan, exception_handlers={Exception: _fault})
        served.router.redirect_slashes = False
        return Gate(served, port, token)

    async def _page(self, request: Request) -> Response:
        number = request.query_params.get("base", "0")
        base = self._base(int(number) if number.isdecimal() and len(number) < 9 else -1)
        page = template("page.html", HERE).render(
            language=spoken(), version=__version__, name=named(base.spec().name), source=base.label,
            target=self._target, groups=form_of(base), base=int(number),
            requirements=self._requirements,
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

    def _job(self, name: str, body: Mapping[str, Any]) -> dict[str, Any]:
        """Return what the process is asked for a request."""
        pinned = body.get("pinned") or None
        if not isinstance(pinned, dict | None):
            raise HTTPException(400)
        return {
            "name": name,
            "base": self._base(body.get("base")),
            "fields": _texts(body.get("fields")),
            "pinned": pinned and (self._base(pinned.get("base")), _texts(pinned.get("fields"))),
            "options": _texts(body.get("options", {})),
            "first": self._made,
        }

    async def _answer_live(self, request: Request) -> Response:
        job = self._job("live", await _body(request))
        async with aclosing(self._live.ask(job, request.is_disconnected)) as answers:
            async for answer in answers:
                if "progress" not in answer:
                    return _json(answer)
        return Response(status_code=204)

    async def _answer_tab(self, request: Request) -> Response:
        name = request.path_params["name"]
        if name not in _TABS:
            raise HTTPException(404)
        job = self._job(name, await _body(request))

        async def lines() -> AsyncIterator[str]:
            async with aclosing(self._tabs.ask(job, request.is_disconnected)) as answers:
                async for answer in answers:
                    self._keep(answer.pop("bases", []))
                    yield json.dumps(answer) + "\n"

        return StreamingResponse(lines(), media_type="application/x-ndjson")

    def _keep(self, bases: list[list[Any]]) -> None:
        """Keep what a front gave, in place of an earlier front."""
        if bases:
            self._front = {self._made + at: Base.of(base) for at, base in enumerate(bases)}
            self._made += len(bases)

    async def _answer_save(self, request: Request) -> Response:
        body = await _body(request)
        try:
            data = data_to_save(self._base(body.get("base")), _texts(body.get("fields")))
            file, message = self._save(data)
        except AfmcalcError as error:
            return _json(refusal(error))
        return _json({"saved": file, "message": message})

    async def _answer_form(self, request: Request) -> Response:
        number = (await _body(request)).get("base")
        form = template("parts.html", HERE).module.form(form_of(self._base(number)), number)  # type: ignore[attr-defined]
        return _json({"html": str(form), "base": number})


async def _body(request: Request) -> dict[str, Any]:
    """Return the JSON object that a request carries."""
    if request.headers.get("content-type", "").partition(";")[0].strip().lower() != "application/json":
        raise HTTPException(415)
    length = request.headers.get("content-length", "0")
    if not length.isdecimal() or int(length) > _LARGEST:
        raise HTTPException(413)
    raw = b""
    try:
        async with asyncio.timeout(_SLOWEST):
            async for part in request.stream():
                raw += part
                if len(raw) > _LARGEST:
                    raise HTTPException(413)
        body = json.loads(raw)
    except TimeoutError:
        raise HTTPException(408) from None
    except (ValueError, RecursionError):
        raise HTTPException(400) from None
    if not isinstance(body, dict):
        raise HTTPException(400)
    return body


def _texts(given: object) -> dict[str, str]:
    if not isinstance(given, dict) or not all(isinstance(text, str) for text in given.values()):
        raise HTTPException(400)
    return given


def _json(answer: Mapping[str, Any], status: int = 200) -> Response:
    """Answer in ASCII: a text that is none, half a pair of surrogates, is told as well."""
    return Response(json.dumps(answer), status, media_type="application/json")


async def _fault(request: Request, error: Exception) -> Response:
    return _json({"errors": {}, "problems": unexpected(error)[1]}, 500)


async def _style(request: Request) -> Response:
    report = HERE.parent / "render" / "report" / "page.css"
    text = "\n".join(file.read_text(encoding="utf-8") for file in (report, HERE / "page.css"))
    return Response(text, media_type="text/css")


async def _script(request: Request) -> Response:
    return Response((HERE / "page.js").read_text(encoding="utf-8"), media_type="text/javascript")
