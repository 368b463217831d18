"""The program: ``afmcalc``, or ``python -m afmcalc``."""

import sys


def program() -> None:
    """Run it; Ctrl-C may come at any moment, also while all else is imported."""
    try:
        _tune()
        from .cli.main import main

        main()
    except KeyboardInterrupt:
        sys.exit(130)


def _tune() -> None:
    """Save start-up time: what is imported stays, so the collector need not look at it, now or at the end."""
    import atexit
    import gc
    import os

    gc.set_threshold(100_000, 50, 50)
    atexit.register(gc.freeze)
    # else pydantic looks through every installed distribution for plugins
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")


if __name__ == "__main__":
    program()
