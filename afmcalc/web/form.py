"""Form of the page: the base from which it starts, its state as overrides of ``--set``, and its fields."""

import shlex
from collections import namedtuple
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from functools import cache
from typing import Any, NamedTuple

from tomli_w import dumps

from ..engines import build
from ..errors import AfmcalcError, SpecError
from ..messages import translate
from ..render.amounts import display
from ..spec import Spec, resolved
from ..spec.catalogues import friction_materials
from ..spec.fields import Key, block_at, words_of
from ..spec.keys import keys
from ..spec.parse import PREFIX, Source
from ..spec.read import as_override, data_of, spec_of
from ..spec.rules import given_in
from ..spec.write import written
from ..units import in_unit
from ..variants import VARIANTS
from .entered import as_spec, at_field, unit_at_field, unit_shown

_REFUSED = ("catalogues.", "tolerance.fields")
"""Prefixes of keys that the form leaves out, because they name files or contain tables."""


class Base(NamedTuple):
    """Spec from which a page starts: its label, its text, and the overrides of the command line.

    ``argument``: SPEC, None for the built-in clutch, ``-`` for a text without a file; ``digest``: SHA-256 of the text.
    """

    label: str
    text: str
    argument: str | None
    overrides: Sequence[str] = ()
    digest: str = ""

    @property
    def source(self) -> Source:
        """Text of the clutch with its label, ready to be read as a spec."""
        return Source(f"{PREFIX}default" if self.argument is None else self.label, self.text, digest=self.digest)


class State(NamedTuple):
    """State of a form: path of a key → its text, if the text differs from the base; empty for a removed key."""

    base: Base
    fields: Mapping[str, str] = {}

    @property
    def overrides(self) -> list[str]:
        """Overrides, as for ``--set``, that give this state; raises AfmcalcError for a key not in the form."""
        known = {path: key_at(path) for path in self.fields}
        texts = self._of_base
        changed = {path: text.strip() for path, text in self.fields.items() if text.strip() != texts.get(path, "")}
        gone = _emptied(texts, changed)
        left = (f"{path}={as_spec(known[path], text)}" for path, text in changed.items() if not path.startswith(gone))
        return [*self.base.overrides, *(table.removesuffix(".") + "=" for table in gone), *left]

    @property
    def spec(self) -> Spec:
        """Spec of this state."""
        return spec_of(self.base.source, self.overrides)

    @property
    def texts(self) -> dict[str, str]:
        """Path of every given key → its text in the form."""
        return {path: text for path, text in {**self._of_base, **self.fields}.items() if text.strip()}

    @property
    def calculated(self) -> dict[str, str]:
        """Path of each key at whose field a sum or product is typed → the result of the sum or product."""
        known = {path: key_at(path) for path in self.fields}
        told = {path: as_spec(key, self.fields[path]) for path, key in known.items()}
        changed = {path: text for path, text in told.items() if not text.startswith(self.fields[path].strip())}
        return {path: text.removesuffix(f" {unit_at_field(known[path])}") for path, text in changed.items()}

    @property
    def _of_base(self) -> dict[str, str]:
        given = given_in(data_of(self.base.source, self.base.overrides)[0])
        return {path: _text(key, given[path]) for path, key in keys().items() if path in given}

    def command(self, *words: str) -> str:
        """Command line for a POSIX shell that calculates this state; ``words``: the command and its options."""
        name, *options = words
        sets = [part for override in self.overrides for part in ("--set", override)]
        spec = [] if self.base.argument is None else [self.base.argument]
        line = shlex.join(["afmcalc", name, *spec, *sets, *options])
        if spec != ["-"]:
            return line
        end = "SPEC"
        while end in self.base.text.splitlines():
            end += "_"
        return f"{line} <<'{end}'\n{self.base.text.rstrip()}\n{end}"


@cache
def editable() -> dict[str, Key]:
    """Path → key, for every key of the form."""
    return {path: key for path, key in keys().items() if not path.startswith(_REFUSED)}


def key_at(path: str) -> Key:
    """Key of the form at a path; raises AfmcalcError if the form has none."""
    if path not in editable():
        raise AfmcalcError("{path:.80}: is no key of the form", path=path)
    return editable()[path]


def _text(key: Key, value: Any) -> str:
    """Text at the field of a key for a value of a spec."""
    if key.about and not isinstance(value, list):
        with suppress(ValueError):
            return at_field(key, key.about.read(value))
    return as_override(value)


def _tables(paths: Iterable[str]) -> set[str]:
    """Paths of the tables that contain the keys, each with a final dot."""
    return {path[: at + 1] for path in paths for at, sign in enumerate(path) if sign == "."}


def _emptied(texts: Mapping[str, str], changed: Mapping[str, str]) -> tuple[str, ...]:
    """Optional tables that have no key left, outermost first."""
    gone, left = tuple[str, ...](), _tables([path for path, text in {**texts, **changed}.items() if text])
    for table in sorted(_tables(texts) - left):
        *outer, name = table.removesuffix(".").split(".")
        model = block_at(outer, Spec)
        if model and not model.model_fields[name].is_required() and not table.startswith(gone):
            gone += (table,)
    return gone


RESULTS = ("nominal_torque", "torque_min", "torque_max", "accuracy_factor", "trip_ratio_min", "trip_ratio_max")
TUNED: tuple[str, ...] = ("closing_spring.force", "control_unit.gain", "friction_group.pairs")
TUNED += ("friction_group.mean_radius", "friction_group.outer_radius", "adjustment.nominal_torque")
"""Results that the page can hold constant, and keys that it can change for this."""


def refusal(*problems: str, **errors: str) -> dict[str, Any]:
    """Answer with sentences about fields or options (``errors``) and other sentences (``problems``)."""
    return {"errors": errors, "problems": problems}


def refused(error: AfmcalcError, option: str = "") -> dict[str, Any]:
    """Answer to an error, which is about an ``option`` or about the keys of a spec."""
    if option:
        return refusal(**{option: str(error)})
    if not isinstance(error, SpecError):
        return refusal(*str(error).split("\n"))
    known = {*editable(), *(table.removesuffix(".") for table in _tables(editable()))}
    first = {problem.path: str(problem) for problem in error.problems[::-1] if problem.path in known}
    problems = (str(problem) for problem in error.problems if problem.path not in known)
    return refusal(*problems, **dict(reversed(first.items())))


Field = namedtuple(
    "Field", "key label symbol unit text required kind choices whole bounds least most",
    defaults=("text", (), False, "", None, None),
)  # fmt: skip
"""Field of one key; the limits of its slider are in the unit of the text."""
Group = namedtuple("Group", "key fields groups given")
"""Table of the spec with its fields and subtables; ``given``: number of keys given."""

_ORDER = (
    *("machine", "requirements", "envelope", "shaft", "friction", "friction_group", "control_unit", "closing_spring"),
    *("control_spring", "adjustment", "drive", "heat", "fatigue", "tolerance", "drawing", "report"),
)
"""Tables in the order of a design."""


def form_of(state: State) -> list[Group]:
    """Groups of a filled-in form: name and variant, the tables in the order of a design, and what a search needs."""
    top = _group(state.texts, "")
    tables = sorted(top.groups, key=lambda group: _ORDER.index(group.key))
    return [Group("", top.fields[:2], [], 0), *tables, Group("search", top.fields[2:], [], 0)]


def _group(texts: Mapping[str, str], table: str) -> Group:
    model = block_at(table.split(".")[:-1], Spec)
    assert model is not None
    fields, groups = [], []
    for name, info in model.model_fields.items():
        path = table + name
        if path in editable():
            fields.append(_field(path, info, texts.get(path, "")))
        elif any(other.startswith(f"{path}.") for other in editable()):
            groups.append(_group(texts, f"{path}."))
    given = sum(bool(field.text) for field in fields) + sum(group.given for group in groups)
    return Group(table.removesuffix("."), fields, groups, given)


def _field(path: str, info: Any, text: str) -> Field:
    key = editable()[path]
    field = Field(path, translate(key.description), key.symbol or "", unit_shown(key), text, info.is_required())
    if about := key.about:
        unit = unit_at_field(key)
        least, most = (in_unit(limit, unit) if unit else limit for limit in about.limits)
        signs = {"gt": ">", "ge": "≥", "lt": "<", "le": "≤"}
        bounds = ", ".join(f"{signs[kind]} {display(end, about.unit)}" for kind, end in about.bounds)
        return field._replace(kind="number", whole=about.whole, bounds=bounds, least=least, most=most)
    words = [*VARIANTS] if path == "variant" else words_of(info.annotation)
    if path.startswith("friction.") and path.endswith(".material"):
        words = [*friction_materials()]
    choices = [(word, translate(word, "value")) for word in words]
    return field._replace(kind="choice" if choices else "text", choices=choices)


def search_of(spec: Spec) -> str:
    """Text of a spec's objectives and [search]; a spec without [search] gets a search around its clutch."""
    pairs, least = spec.friction_group.pairs, spec.least_pairs
    search: dict[str, Any] = {
        "friction_group.pairs": [pairs + more for more in (-2, 0, 2, 4) if pairs + more >= least],
        "adjustment.nominal_torque": [float(build(spec).nominal_torque)],
    }
    if spec.control_unit is not None and (gain := spec.control_unit.gain):
        search["control_unit.gain"] = [float(f"{share * gain:.3g}") for share in (0.5, 0.75, 1.0, 1.25, 1.5)]
    told = {"objectives": spec.objectives or ["closing_force", "accuracy_factor"]}
    return dumps(written(told | {"search": resolved(spec).get("search") or search}))
