"""The program: ``afmcalc``, or ``python -m afmcalc``."""

from .cli.signals import ignore, watch


def program() -> None:
    """Run it; Ctrl-C may come at any moment, also while all else is imported."""
    watch()
    from .cli.entry import main

    try:
        main()
    finally:
        ignore()


if __name__ == "__main__":
    program()
