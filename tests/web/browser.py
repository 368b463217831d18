"""Pages of the server in Debian's Chromium, driven by Playwright; nothing is downloaded."""

import shutil
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from pages import MISSING
from serving import Served

NAMES = ("chromium", "chromium-browser", "google-chrome")
PATH = next((path for name in NAMES if (path := shutil.which(name))), None)
AXE = Path(__file__).with_name("axe.min.js")

_LACKING = [
    *(f"the extra web is not installed: no {name}" for name in MISSING),
    *([] if find_spec("playwright") else ["playwright is not installed (extra test)"]),
    *([] if PATH else [f"no headless browser on the path ({', '.join(NAMES)})"]),
]
browser = pytest.mark.skipif(bool(_LACKING), reason=f"the page is not opened in a browser: {'; '.join(_LACKING)}")


class Opened:
    """The page of a server; ``problems`` has whatever the console says, ``requests`` what was loaded."""

    def __init__(self, chromium: Any, served: Served, width: int = 1280, scheme: str = "light", **more: Any) -> None:
        self.served = served
        self.context = chromium.new_context(viewport={"width": width, "height": 900}, color_scheme=scheme, **more)
        self.context.grant_permissions(["clipboard-read", "clipboard-write"], origin=f"http://{served.host}")
        self.context.set_default_timeout(20_000)
        self.problems: list[str] = []
        self.requests: list[str] = []
        self.page = self.tab()

    def tab(self) -> Any:
        """Open the page in a new tab of the browser, and wait for its first answer."""
        page = self.context.new_page()
        page.on("console", lambda message: self.problems.append(message.text) if message.type != "log" else None)
        page.on("pageerror", lambda error: self.problems.append(str(error)))
        page.on("request", lambda request: self.requests.append(request.url))
        page.goto(self.served.url)
        page.wait_for_selector("#numbers [data-path]")
        return page

    def field(self, key: str) -> Any:
        return self.page.locator(f'[name="{key}"]')

    def unfold(self) -> None:
        self.page.evaluate("document.querySelectorAll('#form details, form details').forEach(one => one.open = true)")

    def put(self, key: str, text: str) -> None:
        """Write a text into a field, without waiting for the answer."""
        self.unfold()
        field = self.field(key)
        if field.evaluate("field => field.tagName") == "SELECT":
            field.select_option(text)
        else:
            field.fill(text)

    def answered(self, part: str) -> None:
        """Wait until the command that the page shows contains a text."""
        has = "part => document.querySelector('#command').textContent.includes(part)"
        self.page.wait_for_function(has, arg=part)

    def told(self, key: str) -> str:
        """The sentence at a field, once it is shown."""
        place = self.page.locator(f'[id="error-{key}"]')
        place.wait_for(state="visible")
        return str(place.inner_text())

    @property
    def cells(self) -> dict[str, str]:
        """Every number shown, by its path."""
        collect = "cells => Object.fromEntries(cells.map(one => [one.dataset.path, one.dataset.value]))"
        found: dict[str, str] = self.page.locator("#numbers [data-path]").evaluate_all(collect)
        return found

    def open(self, name: str) -> None:
        """Open a tab and wait until it answers."""
        self.page.click(f"#tab-{name}")
        if name == "design":  # a search takes long, so it starts only by a button
            self.page.click(f"#panel-{name} .start")
        self.page.wait_for_function(
            """name => { const panel = document.getElementById(`panel-${name}`)
              return panel.getAttribute('aria-busy') == 'false'
                && (panel.querySelector('.answer').children.length || panel.querySelector('.problems li, .error:not([hidden])')) }""",
            arg=name, timeout=60_000,
        )  # fmt: skip

    def axe(self) -> list[str]:
        """Serious and critical faults of accessibility."""
        self.page.evaluate(AXE.read_text(encoding="utf-8"))
        found = self.page.evaluate("axe.run(document, {resultTypes: ['violations']})")
        return [
            f"{fault['id']} ({fault['impact']}): {fault['nodes'][0]['html'][:160]} … {len(fault['nodes'])}"
            for fault in found["violations"]
            if fault["impact"] in ("serious", "critical")
        ]

    def close(self) -> None:
        self.context.close()
