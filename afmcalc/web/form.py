"""Form of the page: the base it starts from, its state as ``--set`` would give it, and its fields."""

import math
import re
import shlex
from collections import namedtuple
from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import UnionType
from typing import Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin

from ..errors import AfmcalcError, SpecError
from ..messages import translate
from ..render.amounts import display, display_unit
from ..spec import Spec
from ..spec.catalogues import friction_materials
from ..spec.fields import Key, Quantity, block_at
from ..spec.keys import keys
from ..spec.parse import PREFIX, Source
from ..spec.read import as_override, data_of, spec_of
from ..spec.rules import given_in
from ..variants import VARIANTS

_REFUSED = ("catalogues.", "tolerance.fields")
"""Keys that are not for a form: they name files, or hold tables."""


class Base(NamedTuple):
    """A clutch that a page starts from: what its text is called, and what the command line puts over it.

    ``argument`` is SPEC there: None of the built-in clutch, ``-`` of a text in no file; ``digest`` that of the file.
    """

    label: str
    text: str
    argument: str | None
    overrides: Sequence[str] = ()
    digest: str = ""

    @property
    def source(self) -> Source:
        """Its text, as a spec is read from it."""
        return Source(f"{PREFIX}default" if self.argument is None else self.label, self.text)


class State(NamedTuple):
    """State of a form: texts of the keys that are not as in its base, empty of those taken out."""

    base: Base
    fields: Mapping[str, str] = {}

    @property
    def overrides(self) -> list[str]:
        """All that ``--set`` has to say; a key that is not for a form is an ``AfmcalcError``."""
        texts = _texts(*self.base[:3], tuple(self.base.overrides))
        changed = {path: text.strip() for path, text in self.fields.items() if text.strip() != texts.get(path, "")}
        for path in changed:
            if path not in editable():
                raise AfmcalcError("{path:.80}: is no key of the form", path=path)
        gone = _emptied(texts, changed)
        left = [f"{path}={text}" for path, text in changed.items() if not path.startswith(gone)]
        return [*self.base.overrides, *(table.removesuffix(".") + "=" for table in gone), *left]

    @property
    def spec(self) -> Spec:
        """The clutch."""
        return spec_of(self.base.source, self.overrides)

    @property
    def texts(self) -> dict[str, str]:
        """Text that the form shows of each key that is given."""
        texts = _texts(*self.base[:3], tuple(self.base.overrides))
        return {path: text for path, text in {**texts, **self.fields}.items() if text.strip()}

    def command(self, *words: str) -> str:
        """Return the command line, for a POSIX shell, that gives the same; ``words``: the command and its options."""
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


@lru_cache(maxsize=1)
def editable() -> dict[str, Key]:
    """Every key that a form has."""
    return {path: key for path, key in keys().items() if not path.startswith(_REFUSED)}


@lru_cache(maxsize=32)
def _texts(label: str, text: str, argument: str | None, overrides: tuple[str, ...]) -> dict[str, str]:
    """Return the text of each key that a base has."""
    given = given_in(data_of(Base(label, text, argument).source, overrides)[0])
    return {path: as_override(given[path]) for path in keys() if path in given}


def _tables(paths: Mapping[str, Any]) -> set[str]:
    """Return the tables that keys are in, with the dot at their end."""
    return {path[: at + 1] for path in paths for at, sign in enumerate(path) if sign == "."}


def _emptied(texts: Mapping[str, str], changed: Mapping[str, str]) -> tuple[str, ...]:
    """Return the tables that nothing is left of, and that a spec may do without, outermost first."""
    left, gone = [path for path, text in {**texts, **changed}.items() if text], tuple[str, ...]()
    for table in sorted(_tables(texts)):
        *outer, name = table.removesuffix(".").split(".")
        model = block_at(outer, Spec)
        may_go = model is not None and not model.model_fields[name].is_required()
        if may_go and not table.startswith(gone) and not any(path.startswith(table) for path in left):
            gone += (table,)
    return gone


def refusal(error: AfmcalcError, option: str = "") -> dict[str, Any]:
    """Return what a page is told of an error: sentences at the fields they are about, or at an option, and others."""
    if option:
        return {"errors": {option: str(error)}, "problems": []}
    if not isinstance(error, SpecError):
        return {"errors": {}, "problems": str(error).split("\n")}
    known = {*editable(), *(table.removesuffix(".") for table in _tables(editable()))}
    sentences = [(problem.path, str(problem)) for problem in error.problems]
    errors = {path: sentence for path, sentence in sentences[::-1] if path in known}  # of each the first
    problems = [sentence for path, sentence in sentences if path not in known]
    return {"errors": dict(reversed(errors.items())), "problems": problems}


Field = namedtuple(
    "Field", "key label symbol unit text required kind choices whole bounds low high step",
    defaults=("text", (), False, "", None, None, None),
)  # fmt: skip
"""One key; ends and step of the slider are in the unit that the text is written in."""
Group = namedtuple("Group", "key fields groups given")
"""One table of the spec, with the tables in it, and how many keys are given."""


def form_of(state: State) -> list[Group]:
    """Return the form of a clutch, filled in: keys that are in no table first, then the tables."""
    top = _group(state.texts, "")
    return [top._replace(groups=[]), *top.groups]


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
    about_key = translate(key.description), key.symbol or "", display_unit(key.unit or "")
    field = Field(path, *about_key, text, info.is_required())
    if about := key.about:
        low, high, step = _slider(about, text)
        ends = ((">", about.gt), ("≥", about.ge), ("<", about.lt), ("≤", about.le))
        bounds = ", ".join(f"{sign} {display(end, about.unit)}" for sign, end in ends if end is not None)
        return field._replace(kind="number", whole=about.whole, bounds=bounds, low=low, high=high, step=step)
    choices = _choices(path, info.annotation)
    kind: Any = "flag" if "true" in choices else "choice" if choices else "text"
    return field._replace(kind=kind, choices=[(choice, translate(choice, "value")) for choice in choices])


def _choices(path: str, annotation: Any) -> list[str]:
    """Words that may stand at a key; none where any may."""
    if path == "variant":
        return list(VARIANTS)
    if path.startswith("friction.") and path.endswith(".material"):
        return list(friction_materials())
    if get_origin(annotation) is Literal:
        return [str(word) for word in get_args(annotation)]
    if get_origin(annotation) is Annotated:
        annotation = get_args(annotation)[0]
    if get_origin(annotation) in (Union, UnionType):
        return [word for part in get_args(annotation) for word in _choices(path, part)]
    return ["true", "false"] if annotation is bool else []


_NUMBER = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*)")


def _slider(about: Quantity, text: str) -> tuple[float, float, float] | tuple[None, None, None]:
    """Return ends and step of a slider from 0 to twice a number, as far as it may go."""
    written = _NUMBER.fullmatch(text)
    if written is None or not (number := float(written[1])):
        return None, None, None
    try:
        scale = about.read(text if written[2] else number) / number
    except ValueError:
        return None, None, None
    least, most = (end / scale for end in about.limits)
    step = 1.0 if about.whole else 10.0 ** math.floor(math.log10(abs(number) / 100))
    low, high = max(least, min(0.0, 2 * number)), min(most, max(0.0, 2 * number))
    # an end that is not allowed itself is a step away
    low += step * (low == least and about.gt is not None)
    return low, high - step * (high == most and about.lt is not None), step
