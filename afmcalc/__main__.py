"""Entry point of ``afmcalc`` and ``python -m afmcalc``."""

import sys


def program() -> None:
    """Run the command line; Ctrl-C exits with code 130, even during the imports."""
    try:
        _tune()
        from .cli.main import main

        main()
    except KeyboardInterrupt:
        sys.exit(130)


def _tune() -> None:
    """Save time: collect garbage rarely, do not search imported modules at exit, use one thread for matrices."""
    import atexit
    import gc
    import os

    gc.set_threshold(100_000, 50, 50)
    atexit.register(gc.freeze)
    # otherwise pydantic searches every installed distribution for plugins
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    # matrices here have 121 rows at most: threads that wait for each other take a hundred times as long
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


if __name__ == "__main__":
    program()
