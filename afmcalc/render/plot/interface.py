"""What a kind of plot is, and which there are."""

from collections.abc import Callable, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from ...errors import AfmcalcError
from ...messages import say
from ...spec.suggest import did_you_mean

if TYPE_CHECKING:
    from .chart import Sheet


class Kind(NamedTuple):
    """One kind of plot: a module of this package of that name, with a function ``sheet(request)``."""

    about: str
    """What it shows, for the help."""
    takes: Literal["clutch", "clutches", "names", "requirements"]
    """What ``Request.subjects`` holds: one clutch, one or more, words (the papers' figures), or requirements."""
    options: tuple[str, ...] = ()
    """Fields of the request it heeds; any other that is given is refused."""


KINDS = {
    "torque": Kind("torque against friction, scatter band, both adjustment methods", "clutches"),
    "accuracy": Kind("accuracy factor against any key, --sweep NAME[=RANGE]", "clutches", ("sweep",)),
    "overload": Kind("trip over friction, and accuracy over the reduced gain (S22 fig. 3)", "clutch"),
    "life": Kind("cycles against the scatter band", "clutches", ("sweep", "model")),
    "pocket": Kind("section through ball and pockets, to scale", "clutch"),
    "tolerance": Kind("histogram of the torque with quantiles, by the [tolerance] block", "clutch"),
    "pareto": Kind("Pareto front of a design, on the grid and refined", "requirements"),
    "paper": Kind("a figure of the papers from the formulas: F11-2, S19-2, S21-2, …", "names"),
}
"""Name → kind, in the order of the help. A new kind is a file and a row."""


_SINGLE = {"clutch": "SPEC", "names": "NAME", "requirements": "REQUIREMENTS"}
"""What stands alone, as the help calls it."""


class Request(NamedTuple):
    """What to draw."""

    subjects: Sequence[Any]
    sweep: str | None = None
    model: str | None = None
    progress: Callable[[int], None] = lambda done: None
    """Is told how many candidates of a design are behind."""


def kind_of(name: str) -> Kind:
    """Return the kind of a name.

    Raises:
        AfmcalcError: there is none.
    """
    if name not in KINDS:
        raise AfmcalcError(
            say(
                "no plot {name!r}{hint}; there are: {kinds}",
                name=name,
                hint=did_you_mean(name, KINDS),
                kinds=", ".join(KINDS),
            )
        )
    return KINDS[name]


def check_request(name: str, request: Request) -> None:
    """Refuse subjects or options that are not for a kind.

    Raises:
        AfmcalcError: no such kind, or what is refused.
    """
    kind = kind_of(name)
    if kind.takes in _SINGLE and len(request.subjects) != 1:
        raise AfmcalcError(
            say(
                "plot {name} takes one {what}, not {count}",
                name=name,
                what=_SINGLE[kind.takes],
                count=len(request.subjects),
            )
        )
    for option in ("sweep", "model"):
        if getattr(request, option) is not None and option not in kind.options:
            raise AfmcalcError(say("plot {name} has no use for --{option}", name=name, option=option))


def sheet_of(name: str, request: Request) -> "Sheet":
    """Calculate and lay out a plot, importing only its kind.

    Raises:
        AfmcalcError: no such kind, subjects or options that are not for it, or an analysis that does not apply.
    """
    check_request(name, request)
    make: Callable[[Request], Sheet] = import_module(f".kinds.{name}", __package__).sheet
    return make(request)
