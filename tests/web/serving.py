"""The real ``afmcalc serve`` as a process of its own, with functions to query it."""

import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
import uuid
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from pages import Answer

PROGRAM = [sys.executable, "-m", "afmcalc"]
_SECONDS = 60  # Longest time to wait for an answer
proc = pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="processes are counted in /proc")


def answer_of(received: bytes) -> Answer:
    """The first answer in the bytes received over a socket; status 0 if there is none."""
    head, _, body = received.partition(b"\r\n\r\n")
    first, *lines = head.decode("latin-1").split("\r\n")
    status = re.match(r"HTTP/1\.[01] (\d{3})", first)
    pairs = (line.partition(":") for line in lines)
    return Answer(int(status[1]) if status else 0, {name.lower(): value.strip() for name, _, value in pairs}, body)


class Served:
    """A running server of a spec."""

    def __init__(self, spec: Path, *arguments: object) -> None:
        self.spec, self.mark = spec, f"AFMCALC_TEST={uuid.uuid4().hex}"
        name, _, value = self.mark.partition("=")
        given = [*PROGRAM, "serve", str(spec), *map(str, arguments), "--no-browser", "--port", "0"]
        # a background job of a shell ignores SIGINT, and the server would inherit that
        if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
            signal.signal(signal.SIGINT, signal.default_int_handler)
        self.process = subprocess.Popen(
            given, env={**os.environ, name: value}, stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
        )  # fmt: skip
        assert self.process.stdout
        self.said = next(line for line in self.process.stdout if "http://" in line)
        self._reading = threading.Thread(target=self._read, daemon=True)
        self._reading.start()
        self.url = self.said.split()[-1]
        parts = urlsplit(self.url)
        self.host, self.port, self.root = parts.netloc, int(parts.port or 0), parts.path
        self.headers = {"Content-Type": "application/json", "Origin": f"http://{self.host}"}

    def _read(self) -> None:
        for line in self.process.stdout or ():
            self.said += line

    def post(self, path: str, body: object) -> Any:
        """The answer to a request of the page; None if the server ends before it answers."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=_SECONDS)
        try:
            connection.request("POST", self.root + path, json.dumps(body), self.headers)
            return json.loads(connection.getresponse().read().splitlines()[-1])
        except (OSError, http.client.HTTPException):
            return None
        finally:
            connection.close()

    def live(self, fields: dict[str, str]) -> Any:
        """The answer to one change."""
        return self.post("live", {"base": 0, "fields": fields, "pinned": None})

    def tab(self, name: str, fields: dict[str, str], **options: str) -> Any:
        """The last line of a tab's answer."""
        return self.post(f"tab/{name}", {"base": 0, "fields": fields, "pinned": None, "options": options})

    @contextmanager
    def streaming(self, name: str, **options: str) -> Iterator[Iterator[Any]]:
        """Yield the lines of a tab's answer as they come; leaving the context ends the connection."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=_SECONDS)
        body = json.dumps({"base": 0, "fields": {}, "pinned": None, "options": options})
        connection.request("POST", f"{self.root}tab/{name}", body, self.headers)
        response = connection.getresponse()
        try:
            yield (json.loads(line) for line in response if line.strip())
        finally:
            response.close()
            connection.close()

    def connected(self) -> socket.socket:
        return socket.create_connection(("127.0.0.1", self.port), timeout=_SECONDS)

    def raw(self, *request: bytes) -> tuple[Answer, int]:
        """Send bytes as they are; return the answer, and the number of bytes that the server took."""
        with self.connected() as connection:
            received, sent = b"", 0
            with suppress(OSError):
                for part in request:
                    connection.sendall(part)
                    sent += len(part)
            with suppress(OSError):
                while more := connection.recv(65536):
                    received += more
            return answer_of(received), sent

    # its processes
    def family(self) -> set[int]:
        """Processes still alive that this server or one of its children started, also orphans."""
        return {pid for pid in _marked(self.mark) if (_stat(pid) or "Z")[0] not in "ZX"}

    def memory(self) -> int:
        """Memory of all these processes, bytes; shared memory counts once for each process."""
        return sum(int((_read(f"/proc/{pid}/statm") or "0 0").split()[1]) for pid in self.family()) * 4096

    def ticks(self) -> int:
        """Processor time that these processes have taken, in hundredths of a second."""
        return sum(sum(map(int, fields[11:13])) for pid in self.family() if (fields := _stat(pid)))

    def is_quiet(self) -> bool:
        """True if nothing is calculated."""
        before = self.ticks()
        time.sleep(0.5)
        return self.ticks() - before <= 2

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


def until(condition: Any, seconds: float = 20) -> None:
    """Wait until a condition holds."""
    begun = time.monotonic()
    while not condition():
        assert time.monotonic() - begun < seconds, f"not within {seconds} s"
        time.sleep(0.02)


def _marked(mark: str) -> Iterator[int]:
    for folder in Path("/proc").iterdir():
        if folder.name.isdecimal():
            with suppress(OSError):
                if mark.encode() in (folder / "environ").read_bytes().split(b"\0"):
                    yield int(folder.name)


def _read(file: str) -> str:
    with suppress(OSError):
        return Path(file).read_text(encoding="utf-8")
    return ""


def _stat(pid: int) -> list[str]:
    """Fields of /proc/PID/stat from the state on."""
    return _read(f"/proc/{pid}/stat").rpartition(")")[2].split()
