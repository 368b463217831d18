"""``python -m afmcalc``."""

from .cli.entry import main

main()
