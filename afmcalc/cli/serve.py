"""The command that serves a page on which a clutch is designed live."""

import gc
import os
import socket
import sys
from threading import Thread
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from ..errors import AfmcalcError, FileError, reason
from ..messages import say
from .files import tell, write
from .options import Common, SpecArgument, need_drawing

if TYPE_CHECKING:
    from ..spec import Spec


def serve(
    common: Common,
    spec: SpecArgument = None,
    port: Annotated[int, Option(min=0, max=65535, help="Port of this machine; 0: any that is free.")] = 0,
    browser: Annotated[bool, Option("--browser/--no-browser", help="Open the page in the browser.")] = True,
    save: Annotated[str | None, Option(metavar="FILE", help="File that the page saves the spec to.")] = None,
) -> None:
    """A page in the browser on which a clutch is designed live; Ctrl-C ends it.

    Every change is calculated at once, as the other commands calculate it. Only this machine can open the page. It
    saves to the FILE of --save, or with --force to SPEC itself.

    \b
    afmcalc serve clutch.toml
    afmcalc serve clutch.toml --save changed.toml
    afmcalc serve clutch.toml --force --no-browser --port 8000
    """
    need_drawing("web")
    import webbrowser
    from pathlib import Path
    from secrets import token_urlsafe
    from tempfile import TemporaryDirectory

    from uvicorn import Config, Server

    from ..render.amounts import shown_in
    from ..web.app import Page, protocol
    from ..web.form import Base

    if common.output or common.json or common.format:
        raise AfmcalcError("serve shows a page: it has no --output, --format and --json")
    common.keep(spec, save=save)
    source = common.read(spec).label
    common.note_default()
    base = Base(source, source.text, spec, tuple(common.overrides), source.digest)
    target = save or (spec if common.force and spec and os.path.isfile(spec) else "")

    def rewrite(changed: "Spec", force: bool) -> None:
        common.force = force
        common.save_spec(changed, {}, target)

    listening, token = _listen(port), token_urlsafe(24)
    port = listening.getsockname()[1]

    def ready() -> None:
        url = f"http://127.0.0.1:{port}/{token}/"
        tell(say("note: {text}", text=say("serving {url}", url=url)))
        sys.stderr.flush()
        if browser:
            start = os.path.join(folder, "afmcalc.html")
            write(f'<meta http-equiv="refresh" content="0; url={url}">', start)
            # in a thread, because a browser that runs in the terminal blocks
            Thread(target=webbrowser.open, args=[Path(start).as_uri()], daemon=True).start()

    page = Page(base, common.units, target, rewrite).app(port, token, ready)
    # no log, since the page itself shows errors, and no waiting for open connections at the end
    how: dict[str, Any] = {"log_config": None, "log_level": "critical", "access_log": False, "server_header": False}
    how |= {"http": protocol(), "ws": "none", "loop": "asyncio", "lifespan": "on", "timeout_graceful_shutdown": 0}
    how |= {"backlog": 100}  # number of connections accepted at once, before any of them is closed
    # objects loaded by now stay: if they are not counted, garbage of connections is collected soon
    gc.freeze()
    gc.collect()
    gc.set_threshold(500, 3, 1)
    with shown_in(common.units), TemporaryDirectory(prefix="afmcalc-") as folder:
        Server(Config(page, **how)).run([listening])


def _listen(port: int) -> socket.socket:
    """Listening socket on a port of 127.0.0.1; 0: any free port."""
    # asyncio turns off delayed sending only for a socket declared as TCP; otherwise an answer waits 40 ms
    listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    if os.name == "posix":  # on Windows this option would let two programs share the port
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listening.bind(("127.0.0.1", port))
        listening.listen()
    except OSError as error:
        listening.close()
        raise FileError("--port {port}: cannot be served: {why}", port=port, why=reason(error)) from None
    return listening
