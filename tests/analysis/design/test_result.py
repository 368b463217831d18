"""What a design tells: its front, the knee, neighbours, what to give up; a pick in round figures, which passes a check."""

import tomllib

import numpy as np
import pytest
import tomli_w
from conftest import CONFIGS

import afmcalc as api
from afmcalc.analysis.design.design import with_neighbours
from afmcalc.analysis.design.similar import requirements_like
from afmcalc.engines import build
from afmcalc.spec import read_spec

FILE = CONFIGS / "requirements.toml"
BASE = tomllib.loads(FILE.read_text(encoding="utf-8"))
FEW = ["--set", "search.pairs=[8, 10, 12]", "--set", "search.mean_radius=[0.1, 0.12]"]


@pytest.fixture(scope="module")
def example():
    return api.design(BASE)


def test_each_variant_is_counted_as_if_it_were_alone(example):
    assert [each.variant for each in example.of_variants] == BASE["variants"]
    for each in example.of_variants:
        alone = api.design(BASE | {"variants": [each.variant]})
        assert alone.of_variants is None
        assert (each.candidates, each.feasible) == (alone.candidates, alone.feasible)
        assert {name: count for name, count in each.excluded.items() if count} == alone.excluded
        assert each.on_front == sum(row.variant == each.variant for row in example.front)


@pytest.mark.parametrize("pairs", [6, 8, 16])
def test_the_knee_is_farthest_from_the_line_between_the_ends(pairs):
    """Das, 1999: of two objectives, each over its range, by the distance of points from a line."""
    data = BASE | {"objectives": ["closing_force", "accuracy_factor"], "search": BASE["search"] | {"pairs": pairs}}
    result = api.design(data)
    at = np.array([[row.closing_force, row.accuracy_factor] for row in result.front])
    at = (at - at.min(axis=0)) / np.ptp(at, axis=0)
    along, away = at[-1] - at[0], at - at[0]
    assert result.knee == int(np.argmin(along[0] * away[:, 1] - along[1] * away[:, 0])) + 1 not in (1, result.on_front)
    assert [row.number for row in result.front if row.mark == "knee"] == [result.knee]
    single = api.design(data | {"objectives": ["closing_force"]})
    assert (single.knee, single.on_front) == (None, 1)


def test_a_neighbour_is_the_nearest_that_is_better_in_something(example):
    """Distances one by one: each objective in parts of its range over the front."""
    values = {row.number: {name: row.objective(name) for name in example.objectives} for row in example.front}
    spans = {name: np.ptp([each[name] for each in values.values()]) for name in example.objectives}
    for here in list(values)[::29]:
        now, told = values[here], with_neighbours(example, here)
        parts = {number: [(each[name] - now[name]) / spans[name] for name in spans] for number, each in values.items()}
        away = {number: sum(part**2 for part in each) for number, each in parts.items()}
        better = [[away[number] for number in values if values[number][name] < now[name] * (1 - 1e-9)] for name in spans]  # fmt: skip
        numbers = {trade.number for trade in told.neighbours}
        nearest = sorted({min(each) for each in better if each})
        assert sorted(away[number] for number in numbers) == pytest.approx(nearest)
        for trade in told.neighbours:
            there, was = values[trade.number][trade.objective], now[trade.objective]
            assert (trade.value, trade.instead_of, trade.change) == pytest.approx((there, was, there / was - 1))
            assert trade.verdict == ("gains" if there < was else "gives up")
        for number in numbers:  # nothing on a front is a gain alone
            assert {trade.verdict for trade in told.neighbours if trade.number == number} == {"gains", "gives up"}


def test_the_front_is_numbered_sorted_and_cut(answered, example):
    assert [row.number for row in example.front] == list(range(1, example.on_front + 1))
    front = answered("design", FILE, *FEW, "--json").json["result"]["front"]
    few = answered("design", FILE, *FEW, "--sort", "torque_max", "--top", 3, "--json").json["result"]["front"]
    assert few == sorted(front, key=lambda row: row["torque_max"])[:3]
    assert answered("design", FILE, *FEW, "--sort", "closing_forc").code == 2
    assert answered("design", FILE, *FEW, "--explain", "2222").code == 2


@pytest.mark.parametrize("format_", ["table", "csv", "json"])
def test_that_there_is_no_candidate_is_said_once(format_, afmcalc, tmp_path):
    """To people: on standard error, with the exit code; as data: in the JSON. Nothing is written."""
    none = ["design", FILE, "--set", "wanted.accuracy_factor=1.01", "--set", "search.mean_radius=0.1"]
    run = afmcalc(*none, "--format", format_)
    assert (run.code, run.err.count("error: "), run.out.count("no-candidate")) == (2, 1, format_ == "json")
    assert afmcalc(*none, "--pick", 1, "-o", tmp_path / "x.toml").code == 2
    assert not list(tmp_path.iterdir())


def test_what_is_missed_together_is_given_up_together(afmcalc):
    def design(*given):
        return afmcalc("design", FILE, *FEW, *(f"--set={each}" for each in given), "--json").json["result"]

    names = ["accuracy_factor", "surface_pressure"]
    result = design("wanted.accuracy_factor=1.01", "limits.surface_pressure=1 kPa")
    rows = result["attainable"]
    assert (result["front"], result["excluded"]["accuracy_factor"]) == ([], result["candidates"])
    assert [(row["requirement"], row["together"]) for row in rows] == [(name, " + ".join(names)) for name in names]
    assert design(*(f"{row['key']}={row['relax_to']!r}" for row in rows))["feasible"] == rows[0]["feasible"] > 0


def test_a_space_too_short_is_told_with_the_length_it_needs():
    """Four plates of 8 mm and four discs of 3 mm."""
    space = {
        "disc_thickness": 0.003,
        "plate_thickness": 0.008,
        "housing_wall": 0.006,
        "bore": 0.03,
        "hub_diameter": 0.045,
    }
    data = BASE | {
        "variants": ["conventional"],
        "wanted": {"nominal_torque": 100},
        "envelope": space | {"length": 0.03},
    }
    result = api.design(data | {"search": BASE["search"] | {"pairs": 4}})
    (missed,) = (row for row in result.attainable if row.requirement == "length")
    assert (missed.limit, missed.best, result.front) == (0.03, pytest.approx(0.044), [])


def test_a_quick_look_says_so_and_what_it_lets_through_is_not_written(afmcalc):
    """One conventional clutch; its trip is hotter by far."""
    one = {"variants": '["conventional"]', "search.pairs": 6, "search.mean_radius": 0.06, "springs": "", "fixed.closing_room": "",
           "wanted.peak_torque": "", "wanted.accuracy_factor": "", "wanted.torque_max": "", "wanted.temperature": "40.01 degC",
           "drive.event": "", "drive.driven_inertia": 0.01, "drive.motor": "", "drive.motor_torque": 70, "heat.conductivity": ""}  # fmt: skip
    command = ["design", CONFIGS / "conveyor.toml", *(f"--set={path}={value}" for path, value in one.items()), "--no-simulate"]  # fmt: skip
    run = afmcalc(*command, "--json").json
    assert run["result"]["front"]
    assert "front-not-simulated" in {each["code"] for each in run["findings"]}
    assert afmcalc(*command, "--pick", 1).code == 2


@pytest.mark.parametrize("name", ["default", "indirect", "unlike-materials", "envelope", "machine-clutch"])
def test_a_clutch_is_found_by_what_it_answers(name):
    clutch = build(read_spec(f"example:{name}"))
    need = tomllib.loads(tomli_w.dumps(requirements_like(clutch)))
    assert need["variants"] == [clutch.spec.variant]
    assert api.design(need, simulate=False).front


FEWER = ["--set", "search.pairs=[8, 12]", "--set", "search.mean_radius=0.12"]


def changed(**tables):
    """The example with tables changed, None: without the key."""
    data = dict(BASE)
    for name, value in tables.items():
        merged = {**BASE.get(name, {}), **value} if isinstance(value, dict) and name != "friction" else value
        data[name] = (
            {key: item for key, item in merged.items() if item is not None} if isinstance(value, dict) else value
        )
    return data


@pytest.mark.parametrize("asked", ["knee", "03"])
def test_a_pick_is_asked_for_by_number_or_as_the_knee(asked, afmcalc, answered, tmp_path):
    front, target = answered("design", FILE, *FEWER, "--json").json["result"], tmp_path / "picked.toml"
    number = front["knee"] if asked == "knee" else 3
    run = afmcalc("design", FILE, *FEWER, "--pick", asked, "--json", "-o", target)
    (row,) = run.json["result"]["picked"]
    assert row["number"] == number
    assert row["pairs"] == run.json["spec"]["friction_group"]["pairs"] == front["front"][number - 1]["pairs"]
    assert run.json["result"]["front"] == front["front"]
    again = afmcalc("torque", target, "--json").json
    assert (again["spec"], again["result"]["closing_force"]) == (run.json["spec"], row["closing_force"])
    assert afmcalc("check", target, "--json").json["result"] == run.json["result"]["verdict"]
    for wrong in ("0", "222", "²", "9" * 5000, "kne"):
        assert afmcalc("design", FILE, *FEWER, "--pick", wrong, "--set", "search.gain=[0.4, 0.6]").code == 2


@pytest.mark.parametrize("contact_force", [5000.0, None])
def test_no_ball_beyond_what_hardened_steel_bears(contact_force):
    """Johnson, Contact Mechanics, (4.24): p_0³ = 6 F E_c²/(π³ r²), 206 GPa and 0.3; a limit of the force instead knows no balls."""
    need = changed(objectives=["closing_force", "ball_diameter"], limits={"contact_force": contact_force})
    modulus, front = 206e9 / (2 * (1 - 0.3**2)), api.design(need).front
    most = max((24 * row.contact_force * modulus**2 / (np.pi**3 * row.ball_diameter**2)) ** (1 / 3) for row in front)
    assert most > 4.2e9 if contact_force else 0.9 * 4.2e9 < most <= 4.2e9 * (1 + 1e-9)


def test_a_friction_material_limits_the_pressure_at_the_inner_edge():
    """Cork: 55 kPa, the lower end of the printed range."""
    result = api.design(changed(objectives=["accuracy_factor", "closing_force"], friction={"material": "cork-dry"}))
    assert result.excluded["material_pressure"] > 0
    edge = [row.closing_force / (2 * np.pi * row.inner_radius * (row.outer_diameter / 2 - row.inner_radius)) for row in result.front]  # fmt: skip
    assert 0.9 * 55e3 < max(edge) <= 55e3 * (1 + 1e-9)


ANGLE = {"wall_angle": {"start": 0.1, "stop": 0.5, "count": 17}, "gain": None}


@pytest.mark.parametrize("steering", [{}, pytest.param(ANGLE, marks=pytest.mark.slow)])
def test_figures_that_a_drawing_bears(steering):
    """Three digits for what is cut, of a degree too, four for the force."""
    need, few = changed(objectives=["closing_force", "accuracy_factor"], search=steering), []
    for number in (1, 8, 15):
        answer = api.design(need, pick=number)
        spec = api.Clutch(answer.spec).spec
        unit, group = spec.control_unit, spec.friction_group
        cut = np.degrees(unit.wall_angle) if steering else unit.gain
        figures = cut, 1e3 * unit.ball_circle_radius, 1e3 * group.inner_radius, 1e3 * group.outer_radius
        assert answer.picked[0].closing_force == float(f"{answer.picked[0].closing_force:.4g}")
        few.append(all(value == pytest.approx(float(f"{value:.3g}"), rel=1e-10) for value in figures))
    assert sum(few) >= 2
