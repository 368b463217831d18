"""A page in a real headless browser, driven over Chromium's debugging pipe."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from afmcalc.render.report.sheets import NAMES, arguments

PATH = next((path for name in NAMES if (path := shutil.which(name))), None)
REASON = f"no headless browser on the path ({', '.join(NAMES[:3])}, …): the report is not opened in one"
_SECONDS = 60


class Page:
    """One page; ``problems`` collects console errors, exceptions and whatever it tried to load."""

    def __init__(self, browser: "_Pipe", session: str) -> None:
        self._browser, self._session = browser, session
        self.problems: list[str] = []
        self.requests: list[str] = []
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def call(self, method: str, **parameters: Any) -> Any:
        answer, events = self._browser.call(method, parameters, self._session)
        for event in events:
            self._note(event)
        return answer

    def _note(self, event: dict[str, Any]) -> None:
        kind, about = event["method"], event.get("params", {})
        if kind == "Runtime.exceptionThrown":
            self.problems.append(str(about["exceptionDetails"]["text"]))
        elif kind == "Log.entryAdded" and about["entry"]["level"] in ("error", "warning"):
            self.problems.append(str(about["entry"]["text"]))
        elif kind == "Runtime.consoleAPICalled":
            self.problems.append(str(about["args"]))
        elif kind == "Network.requestWillBeSent":
            self.requests.append(str(about["request"]["url"]))

    def open(self, file: Path) -> None:
        self.call("Page.navigate", url=file.as_uri())
        self.evaluate(
            "new Promise(done => document.readyState == 'complete' ? done(1) : addEventListener('load', done))"
        )

    def resize(self, width: int, height: int = 900) -> None:
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def scheme(self, name: str) -> None:
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])

    def evaluate(self, expression: str) -> Any:
        answer = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        return answer["result"].get("value")

    def screenshot(self) -> bytes:
        answer = self.call("Page.captureScreenshot", captureBeyondViewport=True)
        return base64.b64decode(answer["data"])

    def pdf(self) -> bytes:
        return base64.b64decode(self.call("Page.printToPDF", preferCSSPageSize=True)["data"])


class _Pipe:
    """Messages to and from the browser: JSON, each ended by a zero byte."""

    def __init__(self, read: int, write: int) -> None:
        self._read, self._write, self._count, self._rest = read, write, 0, b""

    def call(self, method: str, parameters: dict[str, Any], session: str | None) -> tuple[Any, list[Any]]:
        self._count += 1
        message = {"id": self._count, "method": method, "params": parameters}
        os.write(self._write, json.dumps(message | ({"sessionId": session} if session else {})).encode() + b"\0")
        events = []
        while True:
            answer = self._receive()
            if answer.get("id") == self._count:
                assert "error" not in answer, answer
                return answer["result"], events
            if "method" in answer:
                events.append(answer)

    def _receive(self) -> Any:
        while b"\0" not in self._rest:
            assert select.select([self._read], [], [], _SECONDS)[0], "the browser does not answer"
            part = os.read(self._read, 1 << 20)
            assert part, "the browser has ended"
            self._rest += part
        message, _, self._rest = self._rest.partition(b"\0")
        return json.loads(message)


@contextmanager
def opened() -> Iterator[Page]:
    """Start a browser with an empty profile, give a page of it, end it."""
    assert PATH is not None
    to_browser, from_browser = os.pipe(), os.pipe()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [*arguments(PATH, profile), "--remote-debugging-pipe", "about:blank"]
        ends = to_browser[0], from_browser[1]
        # the browser reads the pipe as its file 3 and writes it as its file 4
        shell = f'exec 13<&{ends[0]} 14>&{ends[1]}; exec "$@" 3<&13 4>&14'
        running = subprocess.Popen(
            ["bash", "-c", shell, "bash", *command], pass_fds=ends, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        for end in ends:
            os.close(end)
        pipe = _Pipe(from_browser[0], to_browser[1])
        try:
            target = pipe.call("Target.createTarget", {"url": "about:blank"}, None)[0]["targetId"]
            session = pipe.call("Target.attachToTarget", {"targetId": target, "flatten": True}, None)[0]["sessionId"]
            yield Page(pipe, session)
            pipe.call("Browser.close", {}, None)
        finally:
            os.close(from_browser[0])
            os.close(to_browser[1])
            try:
                running.wait(10)
            except subprocess.TimeoutExpired:
                running.kill()
                running.wait()
