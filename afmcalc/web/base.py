"""What a page starts from, and what its form changes: the same as ``--set`` on a command line."""

import shlex
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from ..errors import AfmcalcError, SpecError
from ..messages import term, translate
from ..spec import Spec, resolved
from ..spec.edit import as_override
from ..spec.fields import Key, block_at
from ..spec.keys import keys
from ..spec.parse import BUILT_IN
from ..spec.read import data_of, spec_of
from ..spec.rules import given_in
from ..spec.source import Source

_REFUSED = ("catalogues.", "tolerance.fields")
"""Keys that are not for a form: they name files, or hold tables."""


@lru_cache(maxsize=1)
def editable() -> dict[str, Key]:
    """Every key that a form has."""
    return {path: key for path, key in keys().items() if not path.startswith(_REFUSED)}


class Base(NamedTuple):
    """A clutch that a page starts from."""

    label: str
    """What its text is called in messages."""
    text: str
    argument: str | None
    """SPEC as the command line has it: None of the built-in clutch, ``-`` of a text that is in no file."""
    overrides: tuple[str, ...] = ()
    """What the command line puts over it."""
    digest: str = ""
    """SHA-256 of the file as given."""

    @classmethod
    def of(cls, data: Sequence[Any]) -> "Base":
        """Return a base that JSON carried."""
        label, text, argument, overrides, digest = data
        return cls(label, text, argument, tuple(overrides), digest)

    @property
    def source(self) -> Source:
        """Its text, as a spec is read from it."""
        return Source(BUILT_IN if self.argument is None else term(self.label), self.text)

    def spec(self, overrides: Sequence[str] = ()) -> Spec:
        """Return the spec with further overrides."""
        return spec_of(self.source, [*self.overrides, *overrides])

    def changed(self, fields: Mapping[str, str]) -> list[str]:
        """Return the overrides that make the base what a form says.

        Raises:
            AfmcalcError: a key that is not for a form.
        """
        texts = _texts(self)
        changed = {path: text.strip() for path, text in fields.items() if text.strip() != texts.get(path, "")}
        for path in changed:
            if path not in editable():
                raise AfmcalcError("{path:.80}: is no key of the form", path=path)
        gone = _emptied(texts, changed)
        left = {path: text for path, text in changed.items() if not any(path.startswith(f"{table}.") for table in gone)}
        return [f"{path}={text}" for path, text in {**dict.fromkeys(gone, ""), **left}.items()]

    def texts(self, fields: Mapping[str, str]) -> dict[str, str]:
        """Return what a form shows of each key that is given."""
        return {path: text for path, text in {**_texts(self), **fields}.items() if text.strip()}

    def command(self, *words: str, fields: Mapping[str, str], options: Sequence[str] = ()) -> str:
        """Return the command line, for a POSIX shell, that gives the same; ``words``: the command."""
        sets = [part for override in (*self.overrides, *self.changed(fields)) for part in ("--set", override)]
        spec = [] if self.argument is None else [self.argument]
        line = shlex.join(["afmcalc", *words, *spec, *sets, *options])
        if self.argument != "-":
            return line
        end = "SPEC"
        while end in self.text.splitlines():
            end += "_"
        return f"{line} <<'{end}'\n{self.text.rstrip()}\n{end}"


@lru_cache(maxsize=32)
def _texts(base: Base) -> dict[str, str]:
    """Return the text of each key that a base has."""
    given = given_in(data_of(base.source, base.overrides, Spec)[0])
    return {path: as_override(given[path]) for path in keys() if path in given}


def _emptied(texts: Mapping[str, str], changed: Mapping[str, str]) -> list[str]:
    """Return the tables that nothing is left of, and that a spec may do without, outermost first."""
    left = {path for path, text in {**texts, **changed}.items() if text}
    tables = sorted({path[:at] for path in texts for at, sign in enumerate(path) if sign == "."})
    gone = [table for table in tables if not any(path.startswith(f"{table}.") for path in left) and _may_go(table)]
    return [table for table in gone if not any(table.startswith(f"{outer}.") for outer in gone)]


def _may_go(table: str) -> bool:
    *outer, name = table.split(".")
    model = block_at(outer, Spec)
    return model is not None and not model.model_fields[name].is_required()


def refusal(error: AfmcalcError, option: str = "") -> dict[str, Any]:
    """Return what a page is told of an error: sentences at the fields they are about, or at an option, and others."""
    if option:
        return {"errors": {option: error.told()}, "problems": []}
    if not isinstance(error, SpecError):
        return {"errors": {}, "problems": error.told().split("\n")}
    errors: dict[str, str] = {}
    problems, tables = [], {path[: at + 1] for path in editable() for at, sign in enumerate(path) if sign == "."}
    for problem in error.problems:
        sentence = translate(term(str(problem)))
        if problem.path in editable() or f"{problem.path}." in tables:
            errors.setdefault(problem.path, sentence)
        else:
            problems.append(sentence)
    return {"errors": errors, "problems": problems}


def data_to_save(base: Base, fields: Mapping[str, str]) -> dict[str, Any]:
    """Return what a file gets."""
    return resolved(base.spec(base.changed(fields)))
