"""Register of all formulas of the papers, each with its function or proof, and of the papers' misprints."""

import tomllib
from functools import cache
from importlib.resources import files
from typing import Any, Literal

from ..errors import AfmcalcError
from ..findings import Finding
from ..messages import did_you_mean, say, spoken
from ..result import Answer, Result, described
from . import PAPERS


class Formula(Result):
    """One formula of a paper."""

    id: str = described("formula")
    status: Literal["as printed", "recovered", "mended", "covered"] = described("status")
    misprint: str | None = described("misprint")
    function: str | None = described("equation function")
    proof: str | None = described("proof", detail=True)
    says: str = described("says")
    printed: str | None = described("printed", detail=True)
    correct: str | None = described("should be", detail=True)
    covered_by: str | None = described("covered by", detail=True)
    not_reached: str | None = described("why no command calculates it", optional=True, detail=True)


class Misprint(Result):
    """One misprint or contradiction of a paper."""

    id: str = described("misprint")
    where: str = described("where")
    printed: str = described("printed")
    correct: str = described("should be")
    why: str = described("why")
    proof: str | None = described("proof", detail=True)
    status: Literal["in print", "as extracted", "criticism", "repeats another", "withdrawn"] = described("status")
    certainty: Literal["proved", "contradicts its own text", "as extracted", "modelling", "withdrawn"] = described(
        "certainty"
    )
    quote: str | None = described("in the words of the paper", optional=True, detail=True)
    reading: str | None = described("right if read as", optional=True, detail=True)
    repeats: str | None = described("repeats", optional=True, detail=True)


class EquationsResult(Answer):
    """The register, or the part of it asked for."""

    numbered: int = described("numbered formulas in the papers asked for")
    accounted: int = described("of them implemented or covered")
    formulas: list[Formula] | None = described("formulas", optional=True)
    misprints: list[Misprint] | None = described("misprints and contradictions", optional=True)


@cache
def register() -> list[Formula]:
    """Entries of the register, in the order of the papers."""
    optional = ("misprint", "function", "proof", "printed", "correct", "covered_by")
    return [Formula(**{**dict.fromkeys(optional), **entry}) for entry in data("register.toml")["formula"]]


@cache
def misprints() -> list[Misprint]:
    """Misprints in the order of their numbers; withdrawn misprints keep their numbers."""
    return [Misprint(**{"status": "in print", "proof": None, **entry}) for entry in data("misprints.toml")["misprint"]]


@cache
def data(name: str) -> dict[str, Any]:
    """Data of a TOML file of this package."""
    return tomllib.loads(files("afmcalc.papers").joinpath(name).read_text(encoding="utf-8"))


def references() -> dict[str, str]:
    """Key of a source → reference in the user's language, in the order of the list."""
    return {key: entry[spoken()] for key, entry in sources().items()}


def sources() -> dict[str, Any]:
    """Key of a source → its references by language, and the pattern of its citations."""
    return data("references.toml")


def check_papers(papers: list[str]) -> None:
    """Check the keys of papers. Raises AfmcalcError if there is no such paper."""
    for paper in papers:
        if paper not in PAPERS:
            raise AfmcalcError(
                "--paper {paper}: no such paper{hint}; papers: {papers}",
                paper=paper, hint=did_you_mean(paper, PAPERS), papers=", ".join(PAPERS),
            )  # fmt: skip


def papers(papers: list[str], ids: list[str], *, show_misprints: bool = False) -> tuple[EquationsResult, list[Finding]]:
    """Return formulas of the register by paper or by id, such as ``S21 (15)``; without arguments all formulas.

    Raises AfmcalcError if there is no such paper or formula.
    """
    check_papers(papers)
    chosen = [entry for entry in register() if not papers or entry.id.split()[0] in papers]
    known = [entry.id for entry in chosen]
    for name in ids:
        if name not in known:
            where = {
                "M": say("; papers --misprints lists misprints"),
                "P": say("; papers --claims has the printed figures"),
            }
            hint = where.get(name[:1]) if name[1:].isdecimal() else None
            raise AfmcalcError("--id {name}: no such formula{hint}", name=name, hint=hint or did_you_mean(name, known))
    chosen = [entry for entry in chosen if not ids or entry.id in ids]
    numbered = [entry for entry in chosen if "unnumbered" not in entry.id]
    accounted = [entry for entry in numbered if entry.function or entry.covered_by or entry.proof]
    slips = [m for m in misprints() if not papers or m.where.split()[0] in papers] if show_misprints else None
    result = EquationsResult(
        numbered=len(numbered), accounted=len(accounted),
        formulas=None if show_misprints else chosen, misprints=slips,
    )  # fmt: skip
    return result, []
