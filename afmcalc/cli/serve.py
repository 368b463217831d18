"""The command that serves a page on which a clutch is designed live."""

import os
import socket
import sys
from collections.abc import Callable
from dataclasses import replace
from threading import Thread
from typing import Annotated, Any, Literal

from typer import Option

from ..errors import AfmcalcError, FileError, reason
from ..messages import say, told, translate
from .options import Common, SpecArgument, common_options, need_drawing
from .streams import tell


@common_options("File that the page saves to, .toml or .json.")
def serve(
    spec: SpecArgument = None,
    port: Annotated[int, Option(min=0, max=65535, help="Port of this machine; 0: any that is free.")] = 0,
    browser: Annotated[bool, Option("--browser/--no-browser", help="Open the page in the browser.")] = True,
    units: Annotated[Literal["engineer", "si"], Option(help="Units: mm, kN, MPa, deg, or SI.")] = "engineer",
    *,
    common: Common,
) -> None:
    """A page in the browser on which a clutch is designed live; Ctrl-C ends it.

    Every change is calculated at once, as the other commands calculate it. The page is for this machine alone. It
    saves to --output FILE, with --force to SPEC itself.

    \b
    afmcalc serve clutch.toml
    afmcalc serve clutch.toml -o changed.toml
    afmcalc serve clutch.toml --force --no-browser --port 8000
    """  # noqa: D301
    need_drawing("web")
    import webbrowser
    from hashlib import sha256
    from secrets import token_urlsafe

    from uvicorn import Config, Server

    from ..render.units import shown_in
    from ..spec.parse import bytes_of, decoded
    from ..web.answers import search_of
    from ..web.app import Page
    from ..web.form import Base, State

    common.keep(spec, spec=True)
    raw, name = bytes_of(common.given_instead("torque") if spec is None else spec)
    base = Base(name, decoded(raw, name).text, spec, tuple(common.overrides), sha256(raw).hexdigest())
    requirements = search_of(State(base).spec)
    target = common.output or (spec if common.force and spec and os.path.isfile(spec) else "")
    listening, token = _listen(port), token_urlsafe(24)
    port = listening.getsockname()[1]

    def ready() -> None:
        url = f"http://127.0.0.1:{port}/{token}/"
        tell(told("note: {text}", text=say("serving {url}", url=url)))
        sys.stderr.flush()
        if browser:
            Thread(target=webbrowser.open, args=[url], daemon=True).start()  # one of the terminal does not return

    page = Page(base, requirements, units, target, _saver(replace(common, output=target))).app(port, token, ready)
    # no log, no waiting for connections at the end: what is wrong is told on the page
    how: dict[str, Any] = {"log_config": None, "log_level": "critical", "access_log": False, "server_header": False}
    how |= {"http": "h11", "ws": "none", "loop": "asyncio", "lifespan": "on", "timeout_graceful_shutdown": 0}
    with shown_in(units):
        Server(Config(page, **how)).run([listening])


def _listen(port: int) -> socket.socket:
    """Open a port of this machine, for this machine alone."""
    # said to be TCP: only then asyncio sends an answer without waiting 40 ms for more
    listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    if os.name == "posix":  # elsewhere it would let two programs share the port
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind(("127.0.0.1", port))
        listening.listen()
    except OSError as error:
        listening.close()
        raise FileError("--port {port}: cannot be served: {why}", port=port, why=reason(error)) from None
    return listening


def _saver(common: Common) -> Callable[[dict[str, Any]], tuple[str, str]]:
    """Return what writes a spec to the file named on the command line, and to no other."""

    def save(data: dict[str, Any]) -> tuple[str, str]:
        nonlocal common
        file = common.output
        if not file:
            raise AfmcalcError("nothing to save to: start with --output FILE, or with --force to save to SPEC")
        wrote = say("wrote {output}", output=file)
        common.write_spec(data, say("Saved by afmcalc serve."), wrote)
        common = replace(common, force=True)  # what was saved is saved over
        return file, translate(wrote)

    return save
