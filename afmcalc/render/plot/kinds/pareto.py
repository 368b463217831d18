"""The Pareto front of a design: the first objective against the others, each clutch with its number."""

from ....analysis.design.rows import DesignResult, DesignRow
from ....analysis.figures import ParetoFigure
from ....messages import joined, say, term, told, translate
from ..chart import Chart, ChartAxis, Line, Sheet, axis_of

_QUANTITIES = {
    "closing_force": term("closing force"),
    "accuracy_factor": term("accuracy factor"),
    "pairs": term("friction pairs"),
    "ball_diameter": term("standard ball"),
    "travel": term("travel of the sleeve"),
    "control_force": term("control-spring force"),
    "closing_deflection": term("deflection of the closing spring"),
    "control_deflection": term("deflection of the control spring"),
}


def sheet(found: ParetoFigure) -> Sheet:
    """Draw the front that a search found."""
    result = found.result
    x, *others = _axes(result.objectives)
    by_pairs = _name_points(result, x, others)
    charts = [_chart(result, x, y, by_pairs=by_pairs) for y in others if not (by_pairs and y == "pairs")]
    return Sheet(translate("Pareto front"), charts, _caption(result), name=found.name or "")


def _name_points(result: DesignResult, x: str, others: list[str]) -> bool:
    """Whether the friction pairs name the points: where they are no axis, and few enough to be told apart."""
    few = len({row.pairs for row in result.front}) <= _FEW
    return few and x != "pairs" and (len(others) > 1 or "pairs" not in others)


_FEW = 9


def _axes(objectives: list[str]) -> list[str]:
    """Objectives in the order of the axes: friction pairs along x of two, else last, where they name the points."""
    rest = [name for name in dict.fromkeys(objectives) if name != "pairs"]
    if "pairs" not in objectives:
        return rest
    return ["pairs", *rest] if len(rest) == 1 else [*rest, "pairs"]


def _chart(result: DesignResult, x: str, y: str, *, by_pairs: bool) -> Chart:
    groups: dict[tuple[str, int], list[DesignRow]] = {}
    for row in result.front:
        groups.setdefault((row.variant, row.pairs if by_pairs else 0), []).append(row)
    variants, pairs = (sorted(set(part)) for part in zip(*groups, strict=True))
    lines = []
    for (variant, z), rows in sorted(groups.items()):
        # colour tells the pairs, shape the variant; where there is one of either, both tell the other
        place = pairs.index(z) if by_pairs else variants.index(variant)
        named = ([translate(variant, "value")] if len(variants) > 1 or not by_pairs else []) + (
            [f"z = {z}"] if by_pairs else []
        )
        marker = variants.index(variant) if len(variants) > 1 else place
        style = _COLOURED[place % len(_COLOURED)]
        lines.append(
            Line(
                ", ".join(named),
                _values(rows, x),
                _values(rows, y),
                style=style,
                points=True,
                marker=marker,
                names=[str(row.number) for row in rows],
            )
        )
    if len(pairs) > 1:
        lines = _tagged(lines, [z for _, z in sorted(groups)])
    bounds = (*_ends(_values(result.front, x)), *_ends(_values(result.front, y)))
    return Chart(_axis(x), _axis(y), [*lines, *_knee(result, x, y)], bounds=bounds)


def _knee(result: DesignResult, x: str, y: str) -> list[Line]:
    rows = [row for row in result.front if row.number == result.knee]
    if not rows:
        return []
    at = _values(rows, x), _values(rows, y)
    named = [str(row.number) for row in rows]
    return [
        Line(
            told("knee: no. {number}", number=named[0]),
            *at,
            style=_INK,
            points=True,
            marker=0,
            filled=True,
            names=named,
        )
    ]


_INK = 4
"""The style in the colour of the text."""
_COLOURED = (0, 1, 2, 3, 5, 6)


def _tagged(lines: list[Line], pairs: list[int]) -> list[Line]:
    """Name each number of pairs once, at the end of the line that reaches furthest."""
    named = list(lines)
    for z in set(pairs):
        own = [number for number, each in enumerate(pairs) if each == z]
        place = max(own, key=lambda number: lines[number].x[-1] or 0.0)
        named[place] = lines[place]._replace(tag=f"z = {z}")
    return named


def _axis(name: str) -> ChartAxis:
    return axis_of(DesignRow, name, quantity=translate(_QUANTITIES[name]))


def _values(rows: list[DesignRow], name: str) -> list[float]:
    return [row.objective(name) for row in rows]


def _ends(values: list[float]) -> tuple[float, float]:
    low, high = min(values), max(values)
    room = 0.04 * (high - low) or 0.04 * abs(high) or 1.0
    return low - room, high + room


def _caption(result: DesignResult) -> str:
    names = [_axis(name).symbol for name in result.objectives]
    listed = told("{names} and {last}", names=", ".join(names[:-1]), last=names[-1])
    counts: dict[str, int] = {}
    for row in result.front:
        counts[row.variant] = counts.get(row.variant, 0) + 1
    variants = joined(
        say("{count:,} {variant}", count=count, variant=term(variant)) for variant, count in sorted(counts.items())
    )
    variants = say("all {variant}", variant=term(next(iter(counts)))) if len(counts) == 1 else variants
    said = told(
        "{feasible:,} of {candidates:,} candidates meet every requirement; the {front:,} drawn are beaten by no other "
        "in {listed} together ({variants}). Numbers are those of --pick.",
        feasible=result.feasible, candidates=result.candidates, front=len(result.front), listed=listed,
        variants=variants,
    )  # fmt: skip
    lacking = any(getattr(row, name) is None for row in result.front for name in result.objectives)
    free = translate("What a variant does not have costs nothing: it lies at 0.")
    return f"{said} {free}" if lacking else said
