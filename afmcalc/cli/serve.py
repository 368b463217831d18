"""The command that serves a page on which a clutch is designed live."""

import os
import socket
import sys
from collections.abc import Callable
from threading import Thread
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from ..errors import AfmcalcError, FileError, reason
from ..messages import say
from .files import tell
from .options import Common, SpecArgument, need_drawing, with_common

if TYPE_CHECKING:
    from ..spec import Spec


@with_common
def serve(
    spec: SpecArgument = None,
    port: Annotated[int, Option(min=0, max=65535, help="Port of this machine; 0: any that is free.")] = 0,
    browser: Annotated[bool, Option("--browser/--no-browser", help="Open the page in the browser.")] = True,
    save: Annotated[str | None, Option(metavar="FILE", help="File that the page saves the spec to.")] = None,
    *,
    common: Common,
) -> None:
    """A page in the browser on which a clutch is designed live; Ctrl-C ends it.

    Every change is calculated at once, as the other commands calculate it. The page is for this machine alone. It
    saves to --save FILE, with --force to SPEC itself.

    \b
    afmcalc serve clutch.toml
    afmcalc serve clutch.toml --save changed.toml
    afmcalc serve clutch.toml --force --no-browser --port 8000
    """  # noqa: D301
    need_drawing("web")
    import webbrowser
    from hashlib import sha256
    from secrets import token_urlsafe

    from uvicorn import Config, Server

    from ..render.amounts import shown_in
    from ..spec.parse import bytes_of, decoded
    from ..web.app import Page
    from ..web.form import Base, State
    from ..web.replies import search_of

    if common.output or common.json or common.format:
        raise AfmcalcError("serve shows a page: it has no --output, --format and --json")
    common.keep(spec, save=save)
    raw, name = bytes_of(common.source(spec))
    common.note_default()
    base = Base(name, decoded(raw, name).text, spec, tuple(common.overrides), sha256(raw).hexdigest())
    requirements = search_of(State(base).spec)
    target = save or (spec if common.force and spec and os.path.isfile(spec) else "")
    listening, token = _listen(port), token_urlsafe(24)
    port = listening.getsockname()[1]

    def ready() -> None:
        url = f"http://127.0.0.1:{port}/{token}/"
        tell(say("note: {text}", text=say("serving {url}", url=url)))
        sys.stderr.flush()
        if browser:
            Thread(target=webbrowser.open, args=[url], daemon=True).start()  # one of the terminal does not return

    page = Page(base, requirements, common.units, target, _saver(common, target)).app(port, token, ready)
    # no log, no waiting for connections at the end: what is wrong is told on the page
    how: dict[str, Any] = {"log_config": None, "log_level": "critical", "access_log": False, "server_header": False}
    how |= {"http": "h11", "ws": "none", "loop": "asyncio", "lifespan": "on", "timeout_graceful_shutdown": 0}
    with shown_in(common.units):
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


def _saver(common: Common, target: str) -> "Callable[[Spec], tuple[str, str]]":
    """Return the function that writes a spec to the file named on the command line, and to no other."""

    def save(spec: "Spec") -> tuple[str, str]:
        if not target:
            raise AfmcalcError("nothing to save to: start with --save FILE, or with --force to save to SPEC")
        common.save_spec(spec, {}, spec, target)
        common.force = True  # what was saved is saved over
        return target, say("wrote {output}", output=target)

    return save
