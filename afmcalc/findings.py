"""Findings (remarks on a valid design) and their sentences."""

from dataclasses import dataclass
from math import isfinite
from typing import Annotated, Literal

from pydantic import Field

from .messages import filled

Level = Literal["info", "warning", "error"]


@dataclass(frozen=True)
class Finding:
    """Remark on a design, with the value it is about and the limit of that value."""

    level: Annotated[
        Level, Field(description="info: worth knowing; warning: not as the law or the wish says; error: must change")
    ]
    code: Annotated[str, Field(description="short name that scripts may rely on")]
    message: Annotated[str, Field(description="what it means, in a sentence")]
    value: Annotated[float | None, Field(description="the number in question, SI")] = None
    limit: Annotated[float | None, Field(description="what it is held against, SI")] = None
    path: Annotated[str | None, Field(description="spec key it belongs to")] = None


def finding(
    code: str,
    level: Level,
    *,
    value: float | None = None,
    limit: float | None = None,
    path: str | None = None,
    **values: object,
) -> Finding:
    """Finding with the sentence of its code in ``FINDINGS``, filled with ``value``, ``limit``, ``path`` and ``values``.

    ``code``: as in ``Finding``, or ``code/case`` if the code has several sentences; ``values``: further fields of the
    sentence, SI. Raises OverflowError if a number is not finite.
    """
    # NumPy floats become Python floats
    value, limit = (number if number is None or type(number) is int else float(number) for number in (value, limit))
    values |= {"value": value, "limit": limit, "path": path}
    if not all(isfinite(number) for number in values.values() if isinstance(number, float)):
        raise OverflowError
    return Finding(level, code.partition("/")[0], filled(FINDINGS[code], values), value, limit, path)


_TABLE = """\
slips-averaged | every slip swings the load from 0 to T(f) and back; every friction from f_min to f_max is taken as equally likely, and the life is that of the mean damage (Miner)
bad-spec | {where}: {problem}
friction-outside-range | friction {value:g} is outside the range of the spec, {least:g} to {largest:g}
sweep-beyond-gain-limit | {value} of {points} swept points lie above the gain limit 1/(z_1 f_1max): breakaway peaks there exceed the sustained torque, K_т,p is the accuracy factor with them
published-against-equilibrium | trust the equilibrium torque: at slip the load equals T_муф for every margin. The published T_ср = T_п − ΔT' (S22 (14)) swaps the weights of T_п and T_н.маш against the paper's own (12) (misprint M12); where the release force lags the load (impact), the trip lies between T_муф and T_п
elasticity-one-sided | at C_1 = C_1* = {limit:.4g 1/mm} K_т has its least value with a kink: each relative sensitivity holds for a change to one side only
elasticity-one-sided/key | K_т has a kink here: the relative sensitivity to {paths} holds for a smaller value only
margin-role | S22 sets the clutch at f_min: the margin is taken as T_н.муф/T_н.маш with T_н.муф = T(f_min) of the spring as set, not as the surplus force of the mean-friction setting
narrower-below-nominal | the narrower band is that of {method}, with which the torque falls to {value:.5g N·m} in service: below the clutch's nominal torque {limit:.5g N·m}, within the margin over the machine's {machine:.5g N·m}
narrower-below-nominal/machine | the narrower band is that of {method}, with which the torque falls to {value:.5g N·m} in service: below the nominal torque {limit:.5g N·m} of the clutch and that of the machine, {machine:.5g N·m}
variant-not-possible | not as {variant}: {lacks}
control-spring-re-set | both methods set the control spring by S21 (14), to {at_min:.5g kN} and {at_mean:.5g kN}: the clutch as made has {value:.5g kN}
pockets-re-cut | pockets that hold the torque are cut for their springs: springs set at f_min need the slope C_1 = {at_min:.5g 1/mm}, at the mean friction {at_mean:.5g 1/mm}; this clutch has {value:.5g 1/mm}
life-not-limited/extrapolated | {side} side: the damaging stress, {value:.4g MPa}, springs as set, is below the endurance limit {limit:.4g MPa}: life is not limited by fatigue (the number extrapolates the S-N line, as the paper does)
life-not-limited/no-number | {side} side: the damaging stress, {value:.4g MPa}, springs as set, is below the endurance limit {limit:.4g MPa}: life is not limited by fatigue (no number is given)
life-limited | protected side: fatigue limits its life to {cycles_extrapolated:,.0f} slips, springs as set: the damaging stress, {value:.4g MPa}, is above the endurance limit {limit:.4g MPa}
life-limited/unprotected | unprotected side: fatigue limits its life to {cycles_extrapolated_at_unprotected:,.0f} slips, springs as set: the damaging stress, {value:.4g MPa}, is above the endurance limit {limit:.4g MPa}
static-strength-exceeded | {name}: {value:.4g MPa} reaches the ultimate strength {limit:.4g MPa}: the shaft fails at once
mean-stress-rule | the paper's rule takes the mean stress as damaging and ignores the amplitude, so a wider band at equal mean costs no life (misprint M23); the rules of Serensen–Kinasoshvili (amplitude) and of Goodman (goodman) take it into account
service-factor-assumed | {path} is not given: {value:g} is taken, for a machine without shocks
machine-not-driven | at some friction the clutch carries {value:.5g N·m}, less than the {limit:.5g N·m} that the machine asks for by its plate: it slips in rated running
slips-at-start | switched on directly the motor gives up to {value:.5g N·m} at the clutch, which carries {limit:.5g N·m} to {torque_max:.5g N·m} in service, by the friction at hand: it may slip while a heavy machine starts
shaft-yields | the shaft yields: its largest stress, {value:.5g MPa}, is above its yield strength in shear by von Mises, {limit:.5g MPa}
bypass-peak | above the gain limit the bypass pairs alone may hold before the balls take over: the peak in the shaft is then up to {value:.4g N·m}, not {limit:.4g N·m}; requirements.peak_torque is judged by it
inertia-torque | where the tool stops faster than the shaft oscillates, the masses behind the discs twist the shaft by up to ω_0 √(k (J_2 + J_h)) = {value:.4g N·m} beyond the sliding torque ({limit:.4g N·m} at f_max): no clutch takes this away, only a softer shaft, less inertia behind the discs, less speed or a slower stop lowers it
inertia-torque/slow | the stop lasts longer than half a period of the shaft's oscillation ({swing:.4g s}): the masses behind the discs load the shaft with up to J a + √(J a [J a + 2 (T − T_0)]) = {value:.4g N·m} beyond the sliding torque ({limit:.4g N·m} at f_max), with J = J_2 + J_h, a = ω_0/t_b, the speed over the time of the stop; a softer shaft does not lower it, only less inertia behind the discs, less speed or a slower stop
ordinary-carries-hub | the ordinary clutch of equal T_н has no control unit: the hub turns with its driven half, J_2 + J_h = {value:.4g} kg·m² behind its discs
ordinary-slips-before-event | the ordinary clutch of equal T_н carries only {value:.5g N·m} somewhere in the friction range, less than the load of {limit:.5g N·m} before the event: it is no alternative
slips-before-event | at {at} the clutch carries {value:.5g N·m}, less than the load of {limit:.5g N·m} before the event: it slips all the time
drive-not-in-balance | before the event the motor gives {value:.5g N·m} against a load of {limit:.5g N·m}: the drive does not run steadily
motor-never-stops | at {at} the motor, up to {limit:.5g N·m}, overcomes the slipping clutch ({carries}): the slip does not end; give a cut-off (drive.cut_off)
motor-stops-at-cut-off | at {at} the motor, up to {limit:.5g N·m}, overcomes the slipping clutch ({carries}): the slip lasts until the cut-off after {off:.4g s} and beyond, {heat:.3g kJ} in the pack
energy-not-closed | the energy of the event does not close, {value:.2g} of it is missing: do not trust this result, and report the spec
release-lag | at f_max the drive trips at {value:.5g N·m}: {share:.0%} of the way from T_муф = {limit:.5g N·m}, where the release force follows at once, to T_п = {held:.5g N·m}, where it does not follow, all pairs sharing the load (S22 (22))
slip-outlasts-duration | at {at} the slip has not ended within the {value:.4g s} that are simulated
event-not-settled | at {at} the drive has neither come to rest nor to a steady run within the {value:.4g} s that are simulated: it may slip again, and the peak may yet rise (a motor that stalls swings the shaft up until it is switched off, drive.cut_off)
peak-not-converged | at {at} twice the time step changes the peak torque by {value:.2%}, more than {limit:.1%}, however fine the steps: the peak is that uncertain
ill-conditioned | at {at} heat and time of the slip are ill-conditioned: twice the time step changes them by {value:.0%}, as a sleeve that rattles against its stop, or a slip that judders and sticks again and again, does not do the same twice
sweep-not-settled | {value} of the swept drives have neither come to rest nor to a steady run as their simulation ends: their peaks may yet rise
event-contact-force | at {at_contact} the event presses a ball against its wall with {value:.5g kN}; {limit:.5g kN} is allowable
event-ball-leaves-pocket | at {at_travel} the sleeve travels {value:.5g mm} in the event: beyond {limit:.5g mm} the ball runs on the edge of its pocket
event-clearance | at {at_travel} the sleeve travels {travel_max:.5g mm} in the event, which leaves the ball {value:.4g mm} to the edge of its pocket instead of {limit:.4g mm}: a larger ball, or stiffer springs
event-spring-let-go | at {at_travel} the sleeve travels {value:.5g mm} in the event: at {limit:.5g mm} the closing spring presses no more
event-spring | in the event, where the sleeve travels {travel:.5g mm}, a spring does not hold: {what}
dynamic-factor-exceeded | the event loads the shaft with {value:.4g} times the sliding torque; the life of the unprotected side takes {limit:g}, as given; without drive.dynamic_factor it takes that of the event
judder | slow slip is not steady: friction that falls with speed takes {value:.3g N·m·s} from the damping of {limit:.3g N·m·s} (an ordinary clutch of equal T_н: {ordinary:.3g N·m·s}); it may judder as the slip ends
hub-too-large | a hub of {value:.5g mm} does not go into the clutch: balls and discs leave it {limit:.5g mm}
balls-overlap | {balls} balls of {value:.5g mm} do not fit on the ball circle: their centres are {limit:.5g mm} apart
default-clearance | {path} is not given: {value:g mm} is taken (S21: 2…3 mm)
laid-out-worn | the layout is that of a worn pack: as new the sleeves are {value:.4g mm} further apart
no-sleeve-travel | a direct clutch has no sleeve: x_max is 0; heat.lining, the wear of a pair, adds the play that the balls need as the pack wears
no-sleeve-travel/worn | a direct clutch has no sleeve: x_max is 0; the pocket has {value:.4g mm} of play for the wear of the pack
ball-reaches-axis | a ball of radius {value:.5g mm} reaches the axis: its centre lies {limit:.5g mm} from it
pockets-overlap | {balls} pockets cut into each other: each is {value:.5g mm} wide at the face, their centres are {limit:.5g mm} apart
parts-collide | {first} and {second} are in each other's way by {value:.4g mm}
odd-pairs | {value:.0f} pairs cannot be built so: discs that take turns between two plates of one half of the clutch make an even number
housing-too-wide | the housing around the discs is {value:.5g mm} wide: there is room for {limit:.5g mm}
clutch-too-long | the clutch is {value:.5g mm} long at least: there is room for {limit:.5g mm}
layout-without | not in the layout: {name}; give {path}
speed-from-plate | drive.speed is not given: {value:.5g rpm} is taken from [machine], the speed of the plate over the ratio
inertia-from-layout | {path} is not given: {value:.4g} kg·m² is taken from the layout, all parts of steel
depth-beyond-sleeve | the pockets, cut {value:.5g mm} deep, go through the sleeve of {limit:.5g mm}
no-standard-ball | no standard ball is as large as {value:.5g mm}, the largest is {limit:.5g mm}: change gain, springs, gap or list
ball-too-small | the ball given, {value:.5g mm}, is smaller than the {limit:.5g mm} that travel, gap and clearance need
wall-undercut | no curved wall for this ball: its radius is {value:.5g mm}, and from {limit:.5g mm} on it undercuts the wall; softer springs, a smaller gap or clearance make it possible
ball-slides-in-seat | the ball stays seated in the sleeve with the straight walls and slides there: the gain is that of rolling only as far as its friction is small
balls-not-given | the number of balls is not given: neither the contact force is calculated nor whether they fit
control-unit-not-judged | {path} is not given: whether balls and pockets can be made is not judged
contact-force-exceeded | the contact force {value:.5g kN} exceeds the allowable {limit:.5g kN}
contact-force-exceeded/hertz | the contact force {value:.5g kN} exceeds the {limit:.5g kN} that Hertz allows: the contact pressure is {contact_pressure:.5g MPa}, allowable {allowable_pressure:.5g MPa}
static-safety-assumed | {path} is not given: {value:g}, the static limit, where a ball is dented by 10⁻⁴ of its diameter; under shocks makers of bearings ask for {limit:g}
contact-assumed | control_unit.contact is not given: ball and wall are taken as hardened steel, {modulus:.5g GPa}, Poisson's ratio {poisson:g}, contact pressure at most {limit:.5g MPa}: it is {value:.5g MPa}
temperature-exceeded | discs or faces reach {value:.4g °C} in one trip: above the highest, {limit:.4g °C}, that {lining} allows
temperature-in-range | discs or faces reach {value:.4g °C} in one trip: within the printed range of what {lining} allows, which begins at {limit:.4g °C}
discs-melt | steel discs or their faces would reach {value:.4g °C} in one trip: iron melts at {limit:.0f °C} (CRC Handbook), steel below it; more mass, less heat or an earlier cut-off is needed
temperature-beyond-catalogue | discs or faces reach {value:.4g °C} in one trip: no material of the catalogue allows more than {limit:g °C} ({name})
faces-not-judged | the temperature of the faces is not known (it needs both radii): the mean of the discs, which is lower, is held against what {name} allows
lining-thick | no heat.lining: the lining is taken as endlessly thick, a lower bound of the surface temperature
discs-take-all | no heat.lining_conductivity, heat.lining_density and heat.lining_specific_heat: the discs take all the heat of the faces, an upper bound of their surface temperature
discs-of-steel | {listed} not given: the discs are taken as of steel, {density:g} kg/m³, {specific_heat:g} J/(kg·K), {conductivity:g} W/(m·K) (EN 1993-1-2 at 100 °C, rounded down)
discs-from-layout | heat.disc_mass is not given: {value:.3g} kg is taken from the layout, the discs of the pack over the faces, all of steel but what heat.lining allows to wear: it heats less than discs with a thicker lining do
discs-thick | no heat.disc_mass: the discs are taken as endlessly thick, a lower bound of their surface temperature
spring-slack-before-worn | the spring falls slack once each pair has worn by {value:.4g mm}, before its lining of {limit:.4g mm} is gone: trips until it is gone are not told
heat-not-told | not calculated: what the spec does not give the data for, {listed}
heat-not-judged | no temperature to hold the discs against: give requirements.temperature, or a material of the catalogue that has one
splines-lock | μ_s f R/r_s reaches {value:.3g}: from {limit:g} on a disc locks in its spline, and the pack no longer follows spring and balls
force-used-up | {path} takes {value:.5g kN} from the {limit:.5g kN} that press the pack: nothing is left of it
effect-on-accuracy | {effect}: K_т lies between {low:.4g} and {high:.4g}, the law says {limit:.4g}
effect-on-torque | {effect}: the torque changes by up to {value:+.1%}
worn-below-machine | with its lining worn off, the clutch carries at least {value:.5g N·m}: less than the machine's nominal torque {limit:.5g N·m}
worn-below-nominal | with its lining worn off, the clutch carries at least {value:.5g N·m}: less than its nominal torque {limit:.5g N·m}, not less than the machine's {machine:.5g N·m}
effect-not-told | not calculated: {listed}
pressure-disc-key-locks | the key of the pressure disc locks itself at a friction of {value:.3g} or more, and it reaches {limit:.3g}: the spring slackens and the pack does not; a ball spline or a larger diameter of the key mends it
requirement-missed | {name}: {shown}, but {bound} {required} is required
requirement-not-judged | {name} not judged: needs {needs}
unusual/friction | a coefficient of friction of {value:.4g} is unusual: {low:g}…{high:g} is usual, the materials of the catalogue have {least:g}…{most:g}
unusual/mean-radius | a mean friction radius of {value:.4g mm} is unusual: {low:g mm…}{high:g mm} is usual
unusual/pairs | {value:.0f} friction pairs are unusual: {low:g}…{high:g} are usual
unusual/margin | a torque margin of {value:.4g} is unusual: {low:g}…{high:g} is usual
unusual/pressure | the force on the pack, {value:.4g MPa} over a full disc of the mean radius, is unusual: {low:g MPa…}{high:g MPa} is usual
unusual/deflection | a spring deflected by {value:.4g mm} is unusual: up to {high:.4g mm}, the clutch's width at the mean radius, is usual
unusual/wall-angle | a wall angle of {value:.4g deg} is unusual: {low:.4g deg…}{high:.4g deg} is usual
unusual/ball-circle | a ball-circle radius of {value:.4g mm} is unusual: {low:.4g mm…}{high:.4g mm}, 0.2 to 2 times the mean friction radius, is usual
curved-springs | {path}: torque, accuracy, tolerance, simulation, heat and effects follow its true characteristic; sensitivities take a straight spring of the stiffness given
spring-too-weak | {path}: pressed flat or solid it gives {value:.5g kN}, less than the {limit:.5g kN} as set
spring-slack | {path}: let go by {value:.4g mm} in service it falls slack: as set it is pressed by {limit:.4g mm}
spring-beyond-range | {path}: used to {value:.3g} of its cone height; 0.15 to 0.75 is usual
spring-does-not-fit | {path}: {what} {value:.5g mm}, the room has {limit:.5g mm}
disc-overstressed | {path}: {value:.4g MPa} where the section turns, more than the {limit:.4g MPa} that a disc bears: it sets
coil-index | {path}: its index D/d is {value:.3g}; 4 to 20 is usual (EN 13906-1)
coil-solid | {path}: pressed by {value:.4g mm} in service it is solid before, at {limit:.4g mm}
coil-gaps-closed | {path}: pressed by {value:.4g mm} in service, more than the {limit:.4g mm} that leave its turns the gaps of EN 13906-1: they may touch
coil-buckles | {path}: pressed by {value:.4g mm} in service it buckles before, at {limit:.4g mm}: guide it (shaft or bore by its room, within a wire's thickness)
coil-overstressed | {path}: the shear stress in service is {value:.4g MPa}, more than the {limit:.4g MPa} that the wire bears at rest (0.56 R_m, EN 13906-1): it sets
coil-stress-solid | {path}: pressed solid the shear stress is {value:.4g MPa}, more than the {limit:.4g MPa} that the wire bears (0.56 R_m, EN 13906-1): keep it from that
coil-fatigue | {path}: it moves at every trip; with k_τ the shear stress is {value:.4g MPa}, more than the {limit:.4g MPa} that the wire, not shot peened, bears for ever (Goodman, Zimmerli)
wire-not-judged | {path}: EN 10270-1 has no wire of {value:.4g mm} (0.3 to 20 mm): its stress is not judged
stiffness-of-the-discs | {path} is {value:.5g N/mm}, that of the discs as set {limit:.5g N/mm}: the law takes their curve; leave the stiffness out, or the discs
no-spring | {path}: no part gives {value:.5g kN} as wanted; nearest is {part}, {size}, which misses {misses}
room-not-given | {path}.inner_diameter, {path}.outer_diameter or {path}.length is not given: there nothing bounds the spring but the width of the clutch, {limit:.4g mm}
any-stiffness | {path} is not given: any stiffness will do
mean-pressure-exceeded | surface pressure {value:.5g MPa} in the mean: above the largest, {limit:.5g MPa}, that {lining} allows
mean-pressure-in-range | surface pressure {value:.5g MPa} in the mean: within the printed range of what {lining} allows, which begins at {limit:.5g MPa}
peak-pressure-exceeded | surface pressure {value:.5g MPa} at the inner edge: above the largest, {limit:.5g MPa}, that {lining} allows
peak-pressure-in-range | surface pressure {value:.5g MPa} at the inner edge: within the printed range of what {lining} allows, which begins at {limit:.5g MPa}
ordinary-trips-at | an ordinary clutch in its place would trip at {least:.2f}…{value:.2f} times the rated torque, row {number} at {least:.2f}…{limit:.2f}
front-equals | {value:.0f} more candidates that pass the checks of the grid equal one of the front in every objective: of equals the first is told
no-candidate | none of {candidates:,} candidates holds every check; the nearest: {missed}
no-candidate/key | none of {candidates:,} candidates holds every check; the nearest: {missed}; what would do: {would_do}
returning-covered | when friction falls from f_max to f_min under a load that lasts, the torque falls to {value:.5g N·m}, below the clutch's nominal torque {limit:.5g N·m} and within its margin over the machine's {machine:.5g N·m}: the friction at the key holds the sleeve back
returning-below-nominal | when friction falls from f_max to f_min under a load that lasts, the torque falls to {value:.5g N·m}, below the nominal torque of the machine, {limit:.5g N·m}: the friction at the key holds the sleeve back
unexpected-verdict | {row}: {verdict}; on record is: {record}
below-nominal-torque | the torque falls to {value:.5g N·m} in service, below the clutch's nominal torque {limit:.5g N·m}
feedback-idle | the gain is 0: the control unit gives no release force, the clutch is an ordinary one
feedback-idle/key | C does not exceed 2 R f_1/d = {limit:.5g}: the key holds the sleeve, the clutch is an ordinary one
gain-above-limit | C = {value:.4g} is above 1/(z_1 f_1max) = {limit:.4g}: at f_max the bypass pairs alone may carry {breakaway_torque_at_f_max:.5g N·m} before the balls take over, the sustained torque is {torque_at_f_max:.5g N·m}
hysteresis | the key's friction gives hysteresis: under a load that lasts, the sleeve returns only when the friction at the discs has fallen by a factor of {value:.4g}, and the torque is then below that of rising friction; without load the sleeve returns to its stop
torque-falls-with-travel | C_1 = {value:.4g 1/mm} is above C_1* = {limit:.4g 1/mm}, at which the pockets hold the torque: a load that reaches {most:.5g N·m} makes the sleeve run off its stop, and the torque jumps, to {falls:.5g N·m} at f_max
torque-jumps | C_1 = {value:.4g 1/mm} is above C_1* = {limit:.4g 1/mm}, at which the pockets hold the torque, and above {jumping:.4g 1/mm}: the sleeve jumps off its stop even as friction rises in slip, and the torque jumps down from {most:.5g N·m}, to {falls:.5g N·m} at f_max
material | {name}: friction {low:g}…{high:g} from the catalogue ({source})
material/read | {name} is read as {row} ({about}, {condition}): friction {low:g}…{high:g} from the catalogue ({source})
lining-unknown | the lining may be any of {names}: friction {low:g}…{high:g} covers them all, and the least pressure and the least temperature that any of them allows count
nominal-torque-missed | closing_spring.force is given, so it decides: it gives a nominal torque of {value:.5g N·m} of the clutch, not the {limit:.5g N·m} of adjustment.nominal_torque
reduced-gain-above-limit | the reduced gain zC = {value:.4g} is above the recommended {limit:g} (S22)
torque-falls | the torque falls as the friction of both groups rises: the largest torque, {most:.5g N·m}, is at f_1 = {at:.4g}
accuracy-not-lasting | K_т = {accuracy_factor:.4g} holds as friction rises; under a load that lasts, friction falling again, K_т,h = {value:.4g} is above {limit:.4g}: requirements.accuracy_factor_hysteresis says what it may be
as-made | every sample has the springs of the nominal clutch; tolerance.setting may have each clutch set on the bench instead
each-adjusted | every sample is set on the bench, its springs by its own dimensions; tolerance.setting may have it keep those of the nominal clutch instead
number-without-unit | {path}: a number without a unit is in SI, {given}; {meant}? Write "{meant}" or "{given}"
few-samples | {value:.0f} samples are too few for the error of the outermost quantile, which is not told in full: at least {limit:.0f}
heavy-tails | a few samples of a heavy tail carry the variance of the torque: the standard errors of its standard deviation and of the Sobol indices are too small; quantiles and their errors hold
friction-fixed | friction does not scatter in [tolerance.fields]: the torque is taken at the mean friction
friction-independent | the correlation of f_1 and f_2 is not given: they are taken as independent (F11 has them together, 1)
miner | life by Miner's rule: friction varies from slip to slip, the rest from clutch to clutch; each slip loads the shaft with its torque, damage 1/N by the S-N line, extrapolated below the endurance limit as the paper does
peaks-interpolated | the peaks are interpolated between {value:.0f} events of the nominal clutch over the friction; all else that scatters counts through the slip torque alone
no-clutch | {value:.3g} of the samples are no clutch (feedback does not overcome the friction at the key, or the faces have no width); the figures are those of the others
solve-replaces | {path} of the spec gives way to the {by} found
solve-range | {target} is as wanted at every value of {name} between two of those found
solve-looked | {target} was calculated at {count} values of {name} from {low} to {high}, then between two of them: what it does beyond, or twice within one step, is not seen
not-attainable | {target} = {required} is not attainable by {name} from {low} to {high}: the nearest is {best}, at {name} = {place}
sweep-replaces | {path} of the spec gives way to the swept {by}
"""  # noqa: E501

FINDINGS = dict(line.split(" | ", 1) for line in _TABLE.splitlines())
"""``code`` or ``code/case`` of a finding → template of its sentence."""
