"""Aids of the page: formulas and sketches for a key, keys that clear a finding, a result held constant, files."""

from collections import namedtuple
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import Any

from .. import __version__
from ..analysis.asking import Answers
from ..analysis.check import check, check_at_once, simulating
from ..analysis.dossier import dossier
from ..analysis.explain.explain import derivations, noting, steps_of
from ..analysis.explain.formula import FormulaText
from ..analysis.explain.mend import changes, direction, remedies
from ..analysis.plot_data import Request, gathered
from ..analysis.solve import parse_target, quantity_at, solve, unit_of
from ..engines import Clutch, build
from ..equations.catalogue import Equation, equations
from ..equations.terms import quantity_of
from ..errors import AfmcalcError, need
from ..findings import FINDINGS, Finding
from ..formula_tree import symbol_tree
from ..messages import localized, say, spoken, translate, with_unit
from ..papers.handbook_text import sections
from ..render import renderer, shop_sheet
from ..render.dxf import dxf
from ..render.report import Subject, report
from ..render.report.blocks import Step, formula
from ..render.report.chapters import step_of
from ..render.report.pieces import said
from ..render.report.sheets import print_pdf
from ..result import Output
from ..spec import Spec, resolved
from ..spec.edit import replaced
from ..spec.fields import Key
from ..spec.quantity import Quantity
from ..spec.rules import given_in
from ..units import table
from .entered import as_spec, at_field, unit_shown
from .form import State, editable, key_at


def formulas(spec: Spec, path: str) -> list[Step]:
    """Formulas that contain the quantity of a key: with the numbers of a clutch, else from the laws of its table."""
    name, clutch, key = quantity_at(path), noting(spec), editable()[path]
    with suppress(AfmcalcError):  # steps noted before the error will do
        check_at_once(Answers(clutch))
    steps = [step for step in steps_of(clutch) if name in map(quantity_of, step.arguments.values())]
    if steps:
        return [step_of(each, spec.adjustment.method) for each in derivations({"": steps})[""][:_FORMULAS]]
    block = path.partition(".")[0]
    module = f"{_MODULES.get(block, block)}."
    laws = (law for law in equations().values() if law.name.startswith(module))
    pairs = ((law, [(one.symbol, one.unit) for one in law.arguments.values()]) for law in laws)
    using = (law for law, terms in pairs if name in law.arguments or (key.symbol, key.unit) in terms)
    return [step for law in using for step in _in_symbols(law)][:_FORMULAS]


def _in_symbols(law: Equation) -> Iterator[Step]:
    """Yield the formula of a law without numbers; a law that compares numbers has no formula."""
    symbols = {name: (translate(one.symbol), one.unit) for name, one in law.arguments.items()}
    with suppress(TypeError, KeyError):
        shown = formula(symbol_tree(translate(law.result.symbol)), FormulaText(law.function, symbols, {}).tree)
        where = [said(f"{one.symbol} – {translate(one.meaning)}") for one in law.arguments.values()]
        yield Step(said(f"{law.result.symbol}: {translate(law.about)}"), formula=shown, where=where)


_FORMULAS = 3
"""Largest number of formulas shown for a key."""
_MODULES = table("fatigue = life; shaft = machine; friction = drive; closing_spring control_spring = springs")
"""Table of the spec → module with the laws of its quantities, if the module has another name."""
_SKETCHES = table("control_unit = pocket; envelope friction_group shaft = section")
"""Table of the spec → drawing that shows its dimensions."""


def sketch(path: str) -> str:
    """Name of the drawing that shows the dimension of a key; empty if no drawing does."""
    key = key_at(path)
    return _SKETCHES.get(path.partition(".")[0], "") if key.unit in ("m", "rad") else ""


def entries(given: Mapping[str, Any]) -> dict[str, str]:
    """Path → text at its field, for values of a spec; empty to remove a key; a spring part has several fields."""
    flat = dict(given) | given_in(given)
    return {path: at_field(key, flat[path]) for path, key in editable().items() if path in flat}


Mending = namedtuple("Mending", "path text then entries", defaults=(None, {}))
"""A key that clears a finding, with a sentence; texts to enter at the fields, empty if the value takes an event."""


def mendings(spec: Spec, code: str, path: str) -> Iterator[Mending]:
    """Yield the keys that clear a finding, with values if the finding needs no simulation."""
    clutch = build(spec)
    before = check(clutch, without=simulating(clutch))[1]
    found = next((each for each in before if (each.code, each.path or "") == (code, path)), None)
    if found is None and code in FINDINGS:
        for name, way in sections(spoken())[code].ways_of(Finding("error", code, "", path=path)):
            yield Mending(name, direction(name, way))
    for remedy in remedies(spec, found, before, quick=True) if found else ():
        if remedy.clears is not None and remedy.path in editable():
            key = editable()[remedy.path]
            text = at_field(key, remedy.clears)
            given = entries(changes(spec, remedy.path, remedy.clears)) | {remedy.path: text}
            value = with_unit(localized(text), unit_shown(key))
            sentence = say("Set {path} to {value}", path=remedy.path, value=value)
            yield Mending(remedy.path, sentence, remedy.then, given)


def held(state: State, options: Mapping[str, str]) -> tuple[State, dict[str, str]]:
    """State in which a result has the wanted value, and the texts at the fields that had to change.

    ``options``: name of the result ``hold``, wanted value ``as``, and the key ``by`` that is to change.
    """
    name, spec = options["hold"], state.spec
    wanted = parse_target(f"{name}={as_spec(_target(name), options['as'])}")[1]
    result, _, findings = solve(build(spec), options["by"], name, wanted)
    if missed := next((each for each in findings if each.code == "not-attainable"), None):
        raise AfmcalcError("{why}", why=missed.message)
    given = entries({result.path: result.value} | dict.fromkeys(replaced(spec, [result.path])))
    return state._replace(fields={**state.fields, **given}), given


def now(clutch: Clutch, name: str) -> str:
    """Present value of a result, as the text at its field."""
    return f"{float(at_field(_target(name), clutch[name])):.5g}"


def _target(name: str) -> Key:
    """Field of a result, which is read and shown like the field of a key."""
    return Key(name, None, "", Quantity(unit_of(name)))


def _pdf(state: State) -> bytes:
    need("pdf")
    return print_pdf(report(Subject(dossier(state.spec), state.overrides)))[0]


def _dxf(state: State) -> bytes:
    need("cad")
    spec = state.spec
    return dxf(shop_sheet.section(gathered("section", Request([Answers(build(spec))])), spec))


def _csv(state: State) -> bytes:
    spec = state.spec
    output = Output("torque", __version__, resolved(spec), *Answers(build(spec)).ask("torque"))
    return renderer("csv")(output, False).encode()


FILES: Mapping[str, Callable[[State], bytes]] = {"pdf": _pdf, "dxf": _dxf, "csv": _csv}
"""Extension of a file → function that returns its content: report, section or torque."""
