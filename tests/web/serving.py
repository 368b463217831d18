"""The real ``afmcalc serve`` as a process of its own, and what may be asked of it."""

import http.client
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
import uuid
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from html.parser import HTMLParser
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

PROGRAM = [sys.executable, "-m", "afmcalc"]
CONFIGS = Path(__file__).parents[2] / "configs"
_SECONDS = 60
"""After which nothing is waited for any longer."""

MISSING = [name for name in ("starlette", "uvicorn", "jinja2", "matplotlib") if not find_spec(name)]
web = pytest.mark.skipif(bool(MISSING), reason=f"the extra web is not installed: no {', '.join(MISSING)}")
proc = pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="processes are counted in /proc")


def command_line(*arguments: object, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    """A command of the program as a process of its own."""
    given = [*PROGRAM, *(str(argument) for argument in arguments)]
    return subprocess.run(given, cwd=folder, capture_output=True, text=True, timeout=_SECONDS, check=False)


@dataclass(frozen=True)
class Answer:
    """What the server answered: status, headers by lower-case name, body."""

    status: int
    headers: dict[str, str]
    body: bytes

    @property
    def json(self) -> Any:
        return json.loads(self.body)


def answer_of(received: bytes) -> Answer:
    """The first answer in what came over a socket; status 0 where there is none."""
    head, _, body = received.partition(b"\r\n\r\n")
    first, *lines = head.decode("latin-1").split("\r\n")
    status = re.match(r"HTTP/1\.[01] (\d{3})", first)
    pairs = (line.partition(":") for line in lines)
    return Answer(int(status[1]) if status else 0, {name.lower(): value.strip() for name, _, value in pairs}, body)


class Served:
    """A running server."""

    def __init__(self, folder: Path, *arguments: object) -> None:
        self.mark = f"AFMCALC_TEST={uuid.uuid4().hex}"
        self.folder = folder
        name, _, value = self.mark.partition("=")
        given = [*PROGRAM, "serve", *(str(argument) for argument in arguments), "--no-browser", "--port", "0"]
        # what a background job of a shell ignores would be ignored by the server too
        if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
            signal.signal(signal.SIGINT, signal.default_int_handler)
        self.process = subprocess.Popen(
            given, cwd=folder, env={**os.environ, name: value}, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
        )  # fmt: skip
        self.output: list[str] = []
        self._reading = threading.Thread(target=self._read, daemon=True)
        self._reading.start()
        try:
            until(lambda: "http://" in self.said or self.process.poll() is not None, 30)
        except AssertionError:
            self.end()
            raise AssertionError(f"no address is said: {self.said}") from None
        if not (served := re.search(r"http://\S+", self.said)):
            code = self.process.wait()
            self.end()
            raise AssertionError(f"the server ended with {code}: {self.said}")
        self.url = served[0]
        parts = urlsplit(self.url)
        self.host, self.port, self.root = parts.netloc, int(parts.port or 0), parts.path
        self.origin = f"http://{self.host}"

    def _read(self) -> None:
        assert self.process.stdout
        self.output.extend(iter(self.process.stdout.readline, ""))

    @property
    def said(self) -> str:
        """What it has printed."""
        return "".join(self.output)

    # what the page asks
    @property
    def headers(self) -> dict[str, str]:
        return {"Content-Type": "application/json", "Origin": self.origin, "Sec-Fetch-Site": "same-origin"}

    def ask(self, method: str, path: str, body: object = None, **headers: str | None) -> Answer:
        """One request as the page sends it, but for ``headers``, None leaves one out."""
        changed = {name.replace("_", "-").title(): value for name, value in headers.items()}
        sent = {name: value for name, value in {**self.headers, **changed}.items() if value is not None}
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=_SECONDS)
        try:
            connection.putrequest(method, path, skip_host="Host" in sent, skip_accept_encoding=True)
            content = body if isinstance(body, bytes) else b"" if body is None else json.dumps(body).encode()
            for name, value in {**sent, "Content-Length": str(len(content))}.items():
                connection.putheader(name, value)
            connection.endheaders(content)
            response = connection.getresponse()
            return Answer(response.status, {k.lower(): v for k, v in response.getheaders()}, response.read())
        finally:
            connection.close()

    def get(self, path: str = "", **headers: str | None) -> Answer:
        return self.ask("GET", self.root + path, **headers)

    def post(self, path: str, body: object, **headers: str | None) -> Answer:
        return self.ask("POST", self.root + path, body, **headers)

    def live(self, fields: dict[str, str], *, base: int = 0, pinned: object = None) -> Any:
        """The answer to one change."""
        answer = self.post("live", {"base": base, "fields": fields, "pinned": pinned})
        assert answer.status == 200, answer
        return answer.json

    def tab(self, name: str, fields: dict[str, str], **options: str) -> list[Any]:
        """All lines of a tab's answer."""
        answer = self.post(f"tab/{name}", {"base": 0, "fields": fields, "pinned": None, "options": options})
        assert answer.status == 200, answer
        return [json.loads(line) for line in answer.body.splitlines()]

    @contextmanager
    def streaming(self, name: str, fields: dict[str, str], **options: str) -> Iterator[Iterator[Any]]:
        """The lines of a tab's answer as they come; leaving ends the connection."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=_SECONDS)
        body = json.dumps({"base": 0, "fields": fields, "pinned": None, "options": options})
        connection.request("POST", f"{self.root}tab/{name}", body, self.headers)
        response = connection.getresponse()
        assert response.status == 200
        try:
            yield (json.loads(line) for line in response if line.strip())
        finally:
            response.close()
            connection.close()

    def raw(self, request: bytes, seconds: float = 10) -> bytes:
        """What comes back to these bytes until the server closes, or nothing comes for a while."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=seconds) as connection:
            received = b""
            with suppress(OSError):
                connection.sendall(request)
            with suppress(OSError):
                while more := connection.recv(65536):
                    received += more
            return received

    # its processes
    def family(self) -> dict[int, str]:
        """Processes alive that this server or one of its children started, with their state, orphans too."""
        return {pid: state for pid, state in _marked(self.mark) if state not in "ZX"}

    def memory(self) -> int:
        """Bytes of memory that all of them hold; what they share counts once for each."""
        return sum(_resident(pid) for pid in self.family())

    def busy(self, seconds: float = 0.5) -> float:
        """Seconds of processor time that they take in a second."""
        before, begun = self._ticks(), time.monotonic()
        time.sleep(seconds)
        return (self._ticks() - before) / os.sysconf("SC_CLK_TCK") / (time.monotonic() - begun)

    def _ticks(self) -> int:
        return sum(sum(map(int, fields[11:13])) for pid in self.family() if (fields := _stat(pid)))

    def interrupt(self) -> None:
        """Ctrl-C in the terminal: all processes of the group get it."""
        os.killpg(self.process.pid, signal.SIGINT)

    def end(self) -> None:
        """End whatever still runs."""
        with suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGINT)
        with suppress(subprocess.TimeoutExpired):
            self.process.wait(5)
        for pid in self.family():
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        self.process.wait(5)
        self._reading.join(5)
        self.process.stdout.close()  # type: ignore[union-attr]
        assert "Traceback" not in self.said, self.said


@contextmanager
def serving(folder: Path, *arguments: object) -> Iterator[Served]:
    """A server, ended after use."""
    served = Served(folder, *arguments)
    try:
        yield served
    finally:
        served.end()


def spec_in(folder: Path, name: str = "default", file: str = "clutch.toml") -> Path:
    """A copy of a shipped spec that a test may write."""
    return Path(shutil.copy(CONFIGS / f"{name}.toml", folder / file))


def until(condition: Any, seconds: float = 10) -> float:
    """Wait until a condition holds; return how long it took."""
    begun = time.monotonic()
    while not condition():
        if time.monotonic() - begun > seconds:
            raise AssertionError(f"not within {seconds} s")
        time.sleep(0.02)
    return time.monotonic() - begun


def _marked(mark: str) -> Iterator[tuple[int, str]]:
    for folder in Path("/proc").iterdir():
        if folder.name.isdecimal():
            with suppress(OSError):
                if mark.encode() in (folder / "environ").read_bytes().split(b"\0") and (fields := _stat(folder.name)):
                    yield int(folder.name), fields[0]


def _stat(pid: int | str) -> list[str]:
    """Fields of /proc/PID/stat from the state on."""
    with suppress(OSError):
        return Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return []


def _resident(pid: int) -> int:
    with suppress(OSError):
        return int(Path(f"/proc/{pid}/statm").read_text(encoding="utf-8").split()[1]) * os.sysconf("SC_PAGE_SIZE")
    return 0


class _Cells(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.cells: dict[str, str] = {}

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        if "data-path" in given:
            self.cells[given["data-path"] or ""] = given.get("data-value") or ""


def cells(html: str) -> dict[str, str]:
    """Paths and values of the numbers in a fragment."""
    parser = _Cells()
    parser.feed(html)
    return parser.cells


def at(result: Any, path: str) -> Any:
    """The value at a dotted path of a JSON answer; a number in it counts."""
    for name in path.split("."):
        result = result[int(name)] if isinstance(result, list) else result[name]
    return result
