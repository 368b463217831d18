"""The program: ``afmcalc``, or ``python -m afmcalc``."""

from .cli.signals import leave, watch


def program() -> None:
    """Run it and end the process; Ctrl-C may come at any moment, also while all else is imported."""
    watch()
    from .cli.entry import main

    try:
        main()
    except SystemExit as end:
        leave(end.code if isinstance(end.code, int) else 0)


if __name__ == "__main__":
    program()
