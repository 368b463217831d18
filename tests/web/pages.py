"""The page of ``afmcalc serve`` asked in this process by ASGI: no socket, no process of a worker."""

import asyncio
import contextvars
import json
import re
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from html.parser import HTMLParser
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import unquote_to_bytes, urlsplit

import pytest
from conftest import CONFIGS, Run

MISSING = [name for name in ("starlette", "uvicorn", "jinja2", "matplotlib") if not find_spec(name)]
web = pytest.mark.skipif(bool(MISSING), reason=f"the extra web is not installed: no {', '.join(MISSING)}")
TABS = ["accuracy", "drive", "heat", "tolerance", "design", "report"]


@dataclass(frozen=True)
class Answer:
    """Answer of the server: status, headers by lower-case name, body."""

    status: int
    headers: dict[str, str]
    body: bytes

    @property
    def json(self) -> Any:
        return json.loads(self.body)


class Here:
    """Stand-in for a ``Worker`` that answers in this process, not in one of its own; it records the jobs."""

    jobs: list[Any] = []

    def __init__(self, units: str, limit: float, *, newest: bool) -> None:
        pass

    def start(self) -> None:
        pass

    def end(self, *, closed: bool = False) -> None:
        pass

    async def ask(self, job: Any, gone: Any, page: str = "") -> Any:
        from afmcalc.web.replies import answer

        self.jobs.append(job)
        yield json.loads(json.dumps(answer(job["state"], job)))


def finished(coroutine: Any) -> Any:
    """Result of a coroutine, which is run in a new thread: in this thread a browser may keep an event loop running."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(contextvars.copy_context().run, asyncio.run, coroutine).result()


class Site:
    """What ``afmcalc serve …`` would serve; ``listening``: the address it would listen on, None if it refuses to."""

    def __init__(self, afmcalc: Callable[..., Run], *arguments: object) -> None:
        self.listening: tuple[str, int] | None = None
        self.known: dict[str, str] = {}
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("afmcalc.web.app.Worker", Here)
            patch.setattr("uvicorn.Server.run", lambda server, sockets: self._started(server.config.app, *sockets))
            self.run = afmcalc("serve", *arguments, "--no-browser")
        if self.listening:
            parts = urlsplit(re.findall(r"http://\S+", self.run.err)[0])
            self.host, self.root, self.origin = parts.netloc, parts.path, f"http://{parts.netloc}"

    def _started(self, app: Any, socket: Any) -> None:
        self._app, self._context, self.listening = app, contextvars.copy_context(), socket.getsockname()
        socket.close()
        events = iter([{"type": "lifespan.startup"}, {"type": "lifespan.shutdown"}])

        async def receive() -> Any:
            return next(events)

        async def send(message: Any) -> None:
            assert message["type"].endswith("complete")

        finished(app({"type": "lifespan", "asgi": {"version": "3.0"}, "state": {}}, receive, send))

    def ask(self, method: str, path: str, body: object = None, whole: bool = True, **headers: Any) -> Answer:
        """One request as the page sends it but for ``headers``: None leaves one out, a list sends it more than once.

        ``body`` is bytes, several parts of them, or an object to send as JSON; the rest never comes if not ``whole``.
        """
        parts = list(body) if isinstance(body, tuple) else [body if isinstance(body, bytes) else _json(body)]
        sent: dict[str, Any] = {"host": self.host, "content-type": "application/json", "origin": self.origin}
        sent |= {"sec-fetch-site": "same-origin", "content-length": str(sum(map(len, parts)))}
        sent |= {name.replace("_", "-"): value for name, value in headers.items()}
        pairs = [(n, v) for n, given in sent.items() for v in (given if isinstance(given, list) else [given])]
        path, _, query = path.partition("?")
        scope = {
            "type": "http", "asgi": {"version": "3.0"}, "http_version": "1.1", "method": method, "scheme": "http",
            "path": unquote_to_bytes(path).decode("utf-8", "replace"), "raw_path": path.encode(), "root_path": "",
            "query_string": query.encode(), "client": ("127.0.0.1", 9), "server": self.listening,
            "headers": [(name.encode(), value.encode("latin-1")) for name, value in pairs if value is not None],
        }  # fmt: skip
        got: list[Any] = []

        async def receive() -> Any:
            if not parts:
                await asyncio.Event().wait()
            part = parts.pop(0)
            return {"type": "http.request", "body": part, "more_body": bool(parts) or not whole}

        async def send(message: Any) -> None:
            got.append(message)

        try:
            self._context.copy().run(finished, asyncio.wait_for(self._app(scope, receive, send), 60))
        except Exception:
            if not got:  # else the page was told of it, with 500
                raise
        head, *rest = got
        named = {name.decode().lower(): value.decode() for name, value in head["headers"]}
        return Answer(head["status"], named, b"".join(message.get("body", b"") for message in rest))

    def get(self, path: str = "", **headers: Any) -> Answer:
        return self.ask("GET", self.root + path, **headers)

    def post(self, path: str, body: object, **headers: Any) -> Answer:
        return self.ask("POST", self.root + path, body, **headers)

    def live(self, fields: dict[str, str], *, base: int = 0, pinned: object = None) -> Any:
        """The answer to one change."""
        answer = self.post("live", {"base": base, "fields": fields, "pinned": pinned})
        assert answer.status == 200, answer
        return answer.json

    def tab(self, name: str, fields: dict[str, str], **options: str) -> Any:
        """The last line of a tab's answer."""
        answer = self.post(f"tab/{name}", {"base": 0, "fields": fields, "pinned": None, "options": options})
        assert answer.status == 200, answer
        return json.loads(answer.body.splitlines()[-1])

    def save(self, fields: dict[str, str], **more: object) -> Any:
        """The answer to the button, which tells what the page knows of the file."""
        answer = self.post("save", {"base": 0, "fields": fields, **self.known, **more})
        assert answer.status == 200, answer
        self.known = {"known": answer.json["known"]} if "known" in answer.json else self.known
        return answer.json


def _json(body: object) -> bytes:
    return b"" if body is None else json.dumps(body).encode()


def spec_in(folder: Path, name: str = "default", file: str = "clutch.toml") -> Path:
    """A copy of a shipped spec that a test may write."""
    (folder / file).write_bytes((CONFIGS / f"{name}.toml").read_bytes())
    return folder / file


def sets(fields: dict[str, str]) -> list[str]:
    """Fields of a form as options of the command line."""
    return [part for key, text in fields.items() for part in ("--set", f"{key}={text}")]


class _Tags(HTMLParser):
    def __init__(self, html: str) -> None:
        super().__init__()
        self.tags: list[dict[str, str]] = []
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append({name: value or "" for name, value in attrs})


def tags(html: str, attribute: str) -> dict[str, dict[str, str]]:
    """Attributes of each tag that has the attribute, by its value."""
    return {tag[attribute]: tag for tag in _Tags(html).tags if attribute in tag}


def cells(html: str) -> dict[str, str]:
    """Paths and values of the numbers in a fragment."""
    return {path: tag.get("data-value", "") for path, tag in tags(html, "data-path").items()}


def at(result: Any, path: str) -> Any:
    """The value at a dotted path of a JSON answer; a number in it counts."""
    for name in path.split("."):
        result = result[int(name)] if isinstance(result, list) else result[name]
    return result


def is_shown(shown: dict[str, str], result: Any) -> None:
    """Every number shown is that of the result."""
    assert len(shown) >= 10
    for path, text in shown.items():
        assert at(result, path) == (float(text) if text else None), path
