"""From a source to a spec: a file in TOML or JSON, standard input, an example, plain data; and lists of balls."""

import math
import re
import sys
from collections.abc import Mapping, Sequence
from copy import deepcopy
from importlib.resources import files
from os import PathLike

from pydantic import BaseModel

from ..errors import AfmcalcError
from .edit import Overrides, apply_overrides
from .fields import Broken, keys_below
from .models import Spec
from .parse import BUILT_IN, check_size, is_json, parse, text_of, toml_of
from .problems import make_spec
from .quantity import asked_unit, parse_quantity
from .rules import given_in
from .source import Source


def read_spec(source: str | PathLike[str] | Mapping[str, object] | None = None, overrides: Overrides = ()) -> Spec:
    """Read a clutch spec.

    Args:
        source: path of a TOML or JSON file, ``"-"`` for standard input, ``"example:NAME"`` for a file that ships,
            None for the built-in base clutch; or plain data of the same structure.
            JSON printed by any command counts: its ``spec`` block is taken.
        overrides: ``"path=value"`` strings applied before validation, an empty value removes the key; or path → value,
            None removes the key. A name or a symbol stands for its path.

    Returns:
        The validated spec, SI inside.

    Raises:
        SpecError: every problem found, with file, line, key, value and what is allowed.
        FileError: the file cannot be read.
    """
    if isinstance(source, Mapping):
        data = deepcopy(dict(source))
        apply_overrides(data, overrides)
        return make_spec(data)
    return spec_of(text_of(source), overrides)


def spec_of(source: Source, overrides: Overrides = ()) -> Spec:
    """Read a clutch spec from its text; see ``read_spec``."""
    return make_spec(*data_of(source, overrides, Spec))


def data_of(
    source: Source, overrides: Overrides, model: type[BaseModel]
) -> tuple[dict[str, object], Source, list[Broken]]:
    """Parse a text and override its values.

    What it is called then asks after numbers without a unit; those that cannot be meant in SI are returned. JSON is
    what programs write, in SI: there only an override may be meant otherwise.
    """
    data = parse(source)
    changed = apply_overrides(data, overrides, model) if overrides else {}
    in_si, keys = is_json(source), keys_below(model)
    questions, broken = [], []
    for path, value in given_in(data).items():
        # center and ends of what scatters are in the unit of its key
        key = keys.get(path) or keys.get(re.sub(r"^tolerance\.fields\.|\.(center|min|max)$", "", path))
        if key and key.unit not in (None, "1") and (path in changed or not in_si):
            numbers = value if isinstance(value, list) else [value]
            if isinstance(value, dict):
                numbers = [number for name, number in value.items() if name in ("start", "stop", "step")]
            try:
                questions += [asked_unit(number, key.unit, path) for number in numbers if not isinstance(number, str)]
            except ValueError as error:
                broken.append((path, str(error)))
    by = "--set" if source.name is BUILT_IN else ""
    return data, Source(source, source.text, dict.fromkeys(changed, by), filter(None, questions)), broken


def diameters(source: str | PathLike[str] | None = None) -> list[float]:
    """Standard ball diameters in ascending order, m.

    Source: ISO 3290-1, nominal diameters, for the list that ships.

    Args:
        source: TOML file with ``diameters = […]`` in mm (or strings with units), or CSV file (named ``….csv``) with the
            heading ``diameter_mm`` and one diameter a line; None for the list that ships.

    Raises:
        FileError: the file cannot be read.
        AfmcalcError: the file is no such list.
    """
    if source is None:
        label = Source("balls.csv", files("afmcalc.spec").joinpath("balls.csv").read_text(encoding="utf-8"))
    else:
        label = text_of(source)
    if label.lower().endswith(".csv"):
        return sorted(_of_csv(label))
    data = toml_of(label)
    check_size(data, label)
    listed = data.get("diameters")
    if not isinstance(listed, list) or not listed:
        raise AfmcalcError(
            "{label}: diameters must be a list of ball diameters in mm, for example [5, 6, 6.35]", label=label
        )
    return sorted(_diameter(item, label) for item in listed)


def _of_csv(source: Source) -> list[float]:
    lines = [line.strip() for line in source.text.splitlines()]
    heading, *cells = [line for line in lines if line and not line.startswith("#")] or [""]
    if heading != "diameter_mm" or not cells:
        raise AfmcalcError(
            "{label}: must begin with the heading {heading}, then one ball diameter in mm a line",
            label=source,
            heading="diameter_mm",
        )
    for cell in cells:
        if not re.fullmatch(r"\d{1,300}(\.\d+)?", cell, re.ASCII):
            raise AfmcalcError(
                "{label}: line {line}: {cell!r} is no diameter in mm, such as 6.35",
                label=source,
                line=lines.index(cell) + 1,
                cell=cell,
            )
    return [_diameter(float(cell), source) for cell in cells]


def _diameter(item: object, label: str) -> float:
    """Read one entry: a number in mm, or a string with a unit."""
    if isinstance(item, str):
        try:
            value = parse_quantity(item, "m")
        except ValueError as error:
            raise AfmcalcError("{label}: diameters: {item!r}: {why}", label=label, item=item, why=error) from None
    elif isinstance(item, int | float) and not isinstance(item, bool):
        value = item / 1000 if abs(item) <= sys.float_info.max else math.inf
    else:
        raise AfmcalcError("{label}: diameters: {item!r} is no diameter; give numbers in mm", label=label, item=item)
    if not 0 < value < math.inf:
        raise AfmcalcError("{label}: diameters: {item!r} must be greater than 0 and finite", label=label, item=item)
    return value


def next_size(sizes: Sequence[float], wanted: float) -> float | None:
    """Smallest size not below the wanted one; None when the list ends before it."""
    return next((size for size in sizes if size >= wanted * (1 - 1e-12)), None)
