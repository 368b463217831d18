"""The quantities of the equations: each symbol of the papers once, with what it means and its SI unit.

A signature names them by these types, ``closing_force: ClosingForce``; the catalogue reads them from there.
Modules of equations import all of them.
"""

from typing import Annotated, Any, NamedTuple, TypeAlias

Number: TypeAlias = Any
"""Anything with ``+ - * / **``: a float, a NumPy array of any shape, a pint quantity, a SymPy expression.

No static type covers all four.
"""


class Term(NamedTuple):
    """An argument or result of an equation."""

    symbol: str
    """Symbol of the papers, e.g. ``F_п``."""
    meaning: str
    unit: str
    """SI unit, ``1`` for a pure number."""


# The clutch, its pairs and its friction
MeanRadius = Annotated[Number, Term("R_cp", "mean friction radius", "m")]
BallCircleRadius = Annotated[Number, Term("r", "radius of the ball circle", "m")]
TanWallAngle = Annotated[Number, Term("tan α", "wall angle from the axis", "1")]
Pairs = Annotated[Number, Term("z", "friction pairs", "1")]
BypassPairs = Annotated[Number, Term("z_1", "pairs that bypass the control unit", "1")]
ControlledPairs = Annotated[Number, Term("z_2", "pairs whose torque passes the balls", "1")]
Gain = Annotated[Number, Term("C", "feedback gain", "1")]
ClosingForce = Annotated[Number, Term("F_п", "closing-spring force as set", "N")]
FrictionDriven = Annotated[Number, Term("f_2", "friction of the controlled pairs", "1")]
FrictionDriving = Annotated[Number, Term("f_1", "friction of the bypass pairs", "1")]
NormalForce = Annotated[Number, Term("N", "normal force on the pairs", "N")]
GroupPairs = Annotated[Number, Term("z_i", "pairs of the group", "1")]
GroupFriction = Annotated[Number, Term("f_i", "friction of the group", "1")]
FrictionDrivingMax = Annotated[Number, Term("f_1max", "largest friction of the bypass pairs", "1")]
SlipTorque = Annotated[Number, Term("T", "slip torque", "N*m")]
ReleaseForce = Annotated[Number, Term("F_p", "release force of the control unit", "N")]
GainLimit = Annotated[Number, Term("C_max", "largest feedback gain", "1")]

# Accuracy
FrictionDrivingMin = Annotated[Number, Term("f_1min", "smallest friction of the bypass pairs", "1")]
FrictionDrivenMin = Annotated[Number, Term("f_2min", "smallest friction of the controlled pairs", "1")]
FrictionDrivenMax = Annotated[Number, Term("f_2max", "largest friction of the controlled pairs", "1")]
TorqueMax = Annotated[Number, Term("T_max", "largest torque", "N*m")]
TorqueMin = Annotated[Number, Term("T_min", "smallest torque", "N*m")]
CornerTorqueMax = Annotated[Number, Term("T_max", "largest torque at a corner", "N*m")]
CornerTorqueMin = Annotated[Number, Term("T_min", "smallest torque at a corner", "N*m")]
PeakMax = Annotated[
    Number,
    Term("P_max", "at f_max the larger of the sustained torque and the bypass pairs' under the full spring", "N*m"),
]
PeakMin = Annotated[
    Number,
    Term("P_min", "at f_min the larger of the sustained torque and the bypass pairs' under the full spring", "N*m"),
]
FrictionRatioMax = Annotated[Number, Term("n", "f_2max/f_1max", "1")]
FrictionRatioMin = Annotated[Number, Term("p", "f_2min/f_1min", "1")]
FrictionMin = Annotated[Number, Term("f_min", "smallest coefficient of friction", "1")]
FrictionMax = Annotated[Number, Term("f_max", "largest coefficient of friction", "1")]
Scatter = Annotated[Number, Term("ΔT", "torque scatter band", "N*m")]
AccuracyFactor = Annotated[Number, Term("K_т", "accuracy factor", "1")]
BestAccuracyFactor = Annotated[Number, Term("K_best", "smallest accuracy factor that can be reached", "1")]

# Adjustment
NominalTorque = Annotated[Number, Term("T_н", "nominal torque", "N*m")]
SettingMargin = Annotated[Number, Term("β_н", "torque margin, 1 for min-friction", "1")]
TorquePerForce = Annotated[Number, Term("a_set", "slip torque per spring force at the friction of the setting", "m")]
TorqueAtSetting = Annotated[
    Number, Term("T_set", "slip torque at the friction of the setting, with the force as set", "N*m")
]
TorquePerForceMean = Annotated[Number, Term("a_cp", "slip torque per spring force at f_cp", "m")]
TorquePerForceMin = Annotated[Number, Term("a_min", "slip torque per spring force at f_min", "m")]
Margin = Annotated[Number, Term("β_н", "torque margin", "1")]
FrictionMean = Annotated[Number, Term("f_cp", "mean coefficient of friction", "1")]

# Overload
Friction = Annotated[Number, Term("f", "coefficient of friction", "1")]
LoopGain = Annotated[Number, Term("v", "loop gain at f", "1")]
ClutchNominalTorque = Annotated[Number, Term("T_н.муф", "nominal torque of the clutch, T_муф at f_min", "N*m")]
LoopGainMin = Annotated[Number, Term("u", "loop gain at f_min", "1")]
PotentialTorque = Annotated[Number, Term("T_п", "potential torque", "N*m")]
MachineTorque = Annotated[Number, Term("T_н.маш", "nominal torque of the machine", "N*m")]
LoadRise = Annotated[Number, Term("ΔT'", "load rise until slip", "N*m")]
ReducedGain = Annotated[Number, Term("zC", "reduced gain (z − z_1) C", "1")]
ExpectedTorque = Annotated[Number, Term("T_муф", "expected slip torque at f_max", "N*m")]
ActuationTorque = Annotated[Number, Term("T_act", "the larger of T_ср and T_муф at f_max", "N*m")]
EquilibriumTorqueMax = Annotated[Number, Term("T_eq.max", "load at slip at f_max", "N*m")]
EquilibriumTorqueMin = Annotated[Number, Term("T_eq.min", "load at slip at f_min", "N*m")]
ReducedGainOfPairs = Annotated[Number, Term("z C", "reduced gain of all pairs", "1")]

# Life
SideTorque = Annotated[Number, Term("T", "torque of the side in question, T' on the unprotected one", "N*m")]
PolarSectionModulus = Annotated[Number, Term("W_p", "polar section modulus", "m^3")]
DynamicFactor = Annotated[Number, Term("k_д", "dynamic factor of the unprotected side", "1")]
StressLow = Annotated[Number, Term("τ_min", "smallest stress of the cycle", "Pa")]
StressHigh = Annotated[Number, Term("τ_max", "largest stress of the cycle", "Pa")]
MeanStressSensitivity = Annotated[Number, Term("ψ_τ", "sensitivity to the mean stress", "1")]
UltimateStrength = Annotated[Number, Term("τ_u", "ultimate strength in shear", "Pa")]
EnduranceLimit = Annotated[Number, Term("τ_limb", "endurance limit in shear", "Pa")]
DamagingStress = Annotated[Number, Term("τ", "damaging stress", "Pa")]
FatigueExponent = Annotated[Number, Term("m_τ", "exponent of the S-N line", "1")]
BaseCycles = Annotated[Number, Term("N_0", "base cycles of the S-N line", "1")]
MeanDamage = Annotated[Number, Term("D_m", "mean damage of a slip over f_min … f_max", "1")]
ShearStress = Annotated[Number, Term("τ", "shear stress", "Pa")]
EquivalentStress = Annotated[Number, Term("τ_eq", "equivalent alternating stress, to be held against τ_−1", "Pa")]
Cycles = Annotated[Number, Term("N_ц", "cycles to failure", "1")]

# Indirect regulation
KeyFriction = Annotated[Number, Term("f_1", "friction coefficient at the key", "1")]
HubDiameter = Annotated[Number, Term("d", "hub diameter at the key", "m")]
FrictionSet = Annotated[Number, Term("f_set", "friction at the setting (f_min or f_cp)", "1")]
IndirectClosingForce = Annotated[Number, Term("F_п", "closing-spring force as set (S21: F_п1)", "N")]
NetGain = Annotated[Number, Term("κ", "C − 2 R f_1/d, gain net of the key's friction", "1")]
ClosingStiffness = Annotated[Number, Term("c_1", "stiffness of the closing spring", "N/m")]
ControlStiffness = Annotated[Number, Term("c_2", "stiffness of the control spring", "N/m")]
SleeveStiffness = Annotated[Number, Term("D", "stiffness against which the sleeve moves", "N/m")]
ControlForce = Annotated[Number, Term("F_п2", "control-spring force at the stop", "N")]
TensedControlForce = Annotated[Number, Term("F_2", "force of the control spring where the sleeve is", "N")]
ControlForceAsMade = Annotated[Number, Term("F_п2", "control-spring force as made", "N")]
RisingTorqueMax = Annotated[Number, Term("T_max", "largest slip torque, friction rising", "N*m")]
ReturningTorqueMin = Annotated[
    Number, Term("T_ret,min", "smallest slip torque, friction falling from f_max under load", "N*m")
]
ClosingForceAtStop = Annotated[Number, Term("F_п1", "closing-spring force at the stop", "N")]
NetGainReturning = Annotated[Number, Term("κ₊", "C + 2 R f_1/d", "1")]
FeedbackPart = Annotated[Number, Term("κ_p", "part of κ that is proportional to the parameter", "1")]
Travel = Annotated[Number, Term("x", "axial travel of the sleeve", "m")]
NominalTorqueRatio = Annotated[Number, Term("K_п", "nominal torque over that of the base clutch", "1")]

# Curved pockets
InitialGain = Annotated[Number, Term("C_0", "gain at the stop", "1")]
GainSlope = Annotated[Number, Term("C_1", "how the gain grows with travel", "1/m")]
StraightStiffness = Annotated[Number, Term("D", "D(f) of a straight pocket, at κ of the stop", "N/m")]
SlopeFeedback = Annotated[Number, Term("w", "feedback that a metre of travel adds, z f C_1", "1/m")]
TangentStiffness = Annotated[
    Number, Term("k_t", "stiffness of the balance where the sleeve is; D(f) of a straight pocket", "N/m")
]
LeavingFriction = Annotated[
    Number, Term("f_L", "friction at which the sleeve leaves its stop, f_set or by the forces as made", "1")
]
LeavingStiffness = Annotated[Number, Term("D", "D(f_L) of a straight pocket", "N/m")]
SpringPart = Annotated[Number, Term("F_part", "part of F_п1 − c_1 x proportional to the parameter", "N")]
ForceElasticity = Annotated[Number, Term("∂ln N/∂ln p", "elasticity of the normal force in a parameter p", "1")]

# The sleeve in motion
Turn = Annotated[Number, Term("φ", "turn of the balls", "rad")]
GainAtStop = Annotated[Number, Term("C", "feedback gain at the stop", "1")]
TurnRate = Annotated[Number, Term("φ'", "speed of the turn of the balls", "rad/s")]
GainAtSleeve = Annotated[Number, Term("C", "feedback gain where the sleeve is", "1")]
BalancedTravel = Annotated[Number, Term("x", "travel of the sleeve, where springs and balls balance", "m")]
SpringWork = Annotated[Number, Term("W", "work stored in the springs at the turning point", "J")]
NetGainAtSleeve = Annotated[Number, Term("κ", "net gain where the sleeve is; κ₊ while it returns", "1")]
SpringBallTorque = Annotated[Number, Term("T_b", "torque of the springs through the balls, S/κ", "N*m")]
SleeveMass = Annotated[Number, Term("m", "mass of the sleeve", "kg")]
NetGainEitherWay = Annotated[Number, Term("κ", "net gain; κ₊ while the sleeve returns", "1")]
SpringMoment = Annotated[Number, Term("S", "moment of both springs", "N*m")]
SleeveInertia = Annotated[Number, Term("μ", "inertia of the sleeve's mass, counted in the turn of the balls", "kg*m^2")]
TorqueBeforeBalls = Annotated[Number, Term("M", "torque on the inertia before the balls", "N*m")]
InertiaBeforeBalls = Annotated[Number, Term("J_1", "inertia before the balls", "kg*m^2")]
TorqueBehindBalls = Annotated[Number, Term("L", "torque of the load on the inertia behind the balls", "N*m")]
InertiaBehindBalls = Annotated[Number, Term("J_2", "inertia behind the balls", "kg*m^2")]
BallTorque = Annotated[Number, Term("T_b", "torque through the balls", "N*m")]
PairsTimesFriction = Annotated[Number, Term("zf", "pairs times friction", "1")]
NetGainOrReturning = Annotated[Number, Term("κ or κ₊", "net gain while the sleeve leaves its stop or returns", "1")]
TorqueAlone = Annotated[Number, Term("T_b0", "torque that the balls would pass without friction of the pack", "N*m")]
TorqueShare = Annotated[Number, Term("j", "share of the pack's torque that the balls pass", "1")]
TravelRate = Annotated[Number, Term("x'", "speed of the sleeve", "m/s")]

# Walls and contact
Sleeves = Annotated[Number, Term("m", "sleeves that the ball moves in: 1 or 2", "1")]
TanAngleAtStop = Annotated[Number, Term("tan α_0", "tangent of the wall angle at the stop", "1")]
PathSteepening = Annotated[Number, Term("Y''", "second derivative of the path of the ball's centre", "1/m")]
PathDepth = Annotated[Number, Term("ξ", "way of the ball along the axis from its place at the stop", "m")]
BallRadius = Annotated[Number, Term("r_ш", "ball radius", "m")]
SinAngleAtBall = Annotated[Number, Term("sin α", "where the ball is", "1")]
PathPlace = Annotated[Number, Term("Y", "place on the path, around the ball circle", "m")]
CosAngleAtBall = Annotated[Number, Term("cos α", "where the ball is", "1")]
FaceGap = Annotated[Number, Term("s", "gap between the faces", "m")]
CurvedWallForce = Annotated[Number, Term("F_n", "force of the curved wall on the ball", "N")]
SinSumOfAngles = Annotated[Number, Term("sin(α + α_0)", "sine of the wall angles of both sleeves together", "1")]
SinSeatAngle = Annotated[Number, Term("sin α_0", "sine of the angle of the seat's walls", "1")]
CosSeatAngle = Annotated[Number, Term("cos α_0", "cosine of the angle of the seat's walls", "1")]
PathRadius = Annotated[Number, Term("ρ", "radius of curvature of the path", "m")]
CurvatureRatio = Annotated[Number, Term("A/B", "ratio of the relative curvatures", "1")]
AxisRatio = Annotated[Number, Term("k", "minor over major semi-axis", "1")]
IntegralB = Annotated[Number, Term("𝐁", "complete elliptic integral of modulus √(1 − k²)", "1")]
IntegralD = Annotated[Number, Term("𝐃", "complete elliptic integral of modulus √(1 − k²)", "1")]
Pi = Annotated[Number, Term("π", "a symbol under SymPy", "1")]

# Synthesis of the control unit
EdgeClearance = Annotated[Number, Term("y", "clearance of the contact from the pocket's edge", "m")]
SinWallAngle = Annotated[Number, Term("sin α", "sine of the wall angle", "1")]
CosWallAngle = Annotated[Number, Term("cos α", "cosine of the wall angle", "1")]
PocketDepth = Annotated[Number, Term("h_1", "pocket depth to the virtual apex", "m")]
SinHalfPitch = Annotated[Number, Term("sin(π/n)", "sine of half the pitch angle of n balls", "1")]
BallPitch = Annotated[Number, Term("t_ш", "distance between the centres of neighbouring balls", "m")]
PocketWidth = Annotated[Number, Term("b", "width of the pocket's mouth", "m")]
PassedTorque = Annotated[Number, Term("T", "torque that passes the balls", "N*m")]
Balls = Annotated[Number, Term("n", "number of balls", "1")]
NumeratorConstant = Annotated[Number, Term("a", "constant of the numerator", "1")]
NumeratorSlope = Annotated[Number, Term("b", "slope of the numerator", "1")]
DenominatorConstant = Annotated[Number, Term("a'", "constant of the denominator", "1")]
DenominatorSlope = Annotated[Number, Term("b'", "slope of the denominator", "1")]
RadiusRatio = Annotated[Number, Term("q", "r/R", "1")]
BallModulus = Annotated[Number, Term("E_1", "elastic modulus of the ball", "Pa")]
BallPoisson = Annotated[Number, Term("ν_1", "Poisson's ratio of the ball", "1")]
WallModulus = Annotated[Number, Term("E_2", "elastic modulus of the pocket wall", "Pa")]
WallPoisson = Annotated[Number, Term("ν_2", "Poisson's ratio of the pocket wall", "1")]
AllowablePressureOnFlat = Annotated[Number, Term("p_0", "allowable maximum contact pressure", "Pa")]
ContactModulus = Annotated[Number, Term("E_c", "contact modulus of ball and wall", "Pa")]
AllowablePressure = Annotated[Number, Term("p_0,allow", "allowable maximum contact pressure", "Pa")]
ContactForce = Annotated[Number, Term("F_n", "normal force on the ball", "N")]
AllowableForce = Annotated[Number, Term("F_n,allow", "force at which the ball reaches the allowable pressure", "N")]

# What is wanted
WantedAccuracyFactor = Annotated[Number, Term("K_т wanted", "accuracy factor that is wanted", "1")]
WantedTorque = Annotated[Number, Term("T wanted", "torque that is wanted", "N*m")]
ReducedGainLimit = Annotated[Number, Term("largest zC", "largest reduced gain, 5 by S22", "1")]

# The friction surface
InnerRadius = Annotated[Number, Term("r_i", "inner radius of the friction surface", "m")]
OuterRadius = Annotated[Number, Term("r_o", "outer radius of the friction surface", "m")]
AxialForce = Annotated[Number, Term("F", "axial force on the ring", "N")]

# The drive
DampingRatio = Annotated[Number, Term("ζ", "damping ratio of the driven half on the shaft", "1")]
ShaftStiffness = Annotated[Number, Term("k", "torsional stiffness of the shaft", "N*m/rad")]
DrivenInertia = Annotated[Number, Term("J_2", "inertia of the driven half", "kg*m^2")]
Twist = Annotated[Number, Term("φ", "twist of the shaft", "rad")]
ShaftDamping = Annotated[Number, Term("d", "damping of the shaft", "N*m*s/rad")]
TwistRate = Annotated[Number, Term("φ'", "speed of the twist, ω_2 − ω_3", "rad/s")]
SpeedBeforeLock = Annotated[Number, Term("ω_0", "speed before the lock", "rad/s")]
Deceleration = Annotated[Number, Term("a", "deceleration of the tool, ω_0/t_b", "rad/s^2")]
SlidingTorque = Annotated[Number, Term("T", "sliding torque", "N*m")]
LoadBefore = Annotated[Number, Term("T_0", "load before the event", "N*m")]
StaticRatio = Annotated[Number, Term("r_s", "static over sliding friction", "1")]
StribeckDecay = Annotated[Number, Term("e", "1 at rest, 0 at high sliding speed", "1")]
MotorSpeed = Annotated[Number, Term("ω", "speed of the motor side", "rad/s")]
SynchronousSpeed = Annotated[Number, Term("ω_s", "synchronous speed, reduced to the clutch", "rad/s")]
BreakdownTorque = Annotated[Number, Term("M_b", "breakdown torque of the motor", "N*m")]
BreakdownSlip = Annotated[Number, Term("s_b", "slip at breakdown", "1")]
MotorSlip = Annotated[Number, Term("s", "slip of the motor", "1")]
MotorRunTorque = Annotated[Number, Term("M", "torque of the motor", "N*m")]
DriveTorque = Annotated[Number, Term("M", "torque on the driving inertia", "N*m")]
DriveInertia = Annotated[Number, Term("J_1", "driving inertia", "kg*m^2")]
LoadTorque = Annotated[Number, Term("L", "torque of the load on the driven inertia", "N*m")]
LoadInertia = Annotated[Number, Term("J_2", "driven inertia", "kg*m^2")]
TorqueBetween = Annotated[Number, Term("T", "torque between the two inertias", "N*m")]
ControlledTorque = Annotated[Number, Term("T_2", "torque through the balls", "N*m")]
BalancedNormalForce = Annotated[Number, Term("N_eq", "normal force in balance with the load", "N")]
ForceLag = Annotated[Number, Term("τ", "time by which the normal force lags the load", "s")]
TorqueGrowth = Annotated[Number, Term("f T'(f)", "growth of the torque with friction", "N*m")]
StribeckSpeed = Annotated[Number, Term("v_s", "sliding speed in which static friction decays", "m/s")]
MotorTorque = Annotated[Number, Term("M_1", "torque of the motor", "N*m")]

# Heat and wear
MotorInertia = Annotated[Number, Term("J_1", "moment of inertia of the motor side", "kg*m^2")]
MotorSpeedAtSlip = Annotated[Number, Term("ω_0", "speed of the motor side as the slip begins", "rad/s")]
TimeSinceSlip = Annotated[Number, Term("t", "time since the slip began", "s")]
SlipSpeedStart = Annotated[Number, Term("ω_0", "slip speed as the slip begins", "rad/s")]
SlipSpeedEnd = Annotated[Number, Term("ω", "slip speed as it ends", "rad/s")]
SlipDuration = Annotated[Number, Term("t", "duration of the slip", "s")]
TripHeat = Annotated[Number, Term("Q", "heat of a trip", "J")]
PairArea = Annotated[Number, Term("A", "area of a pair", "m^2")]
SlipSpeed = Annotated[Number, Term("ω", "speed of slip", "rad/s")]
SlipPower = Annotated[Number, Term("P", "power of the slip", "W")]
DiscsMass = Annotated[Number, Term("m", "mass of the discs that take the heat", "kg")]
SpecificHeat = Annotated[Number, Term("c", "specific heat", "J/kg/K")]
Conductivity = Annotated[Number, Term("k", "thermal conductivity", "W/m/K")]
Density = Annotated[Number, Term("ρ", "density", "kg/m^3")]
Effusivity = Annotated[Number, Term("b", "√(k ρ c)", "W*s^0.5/m^2/K")]
TransformRoot = Annotated[Number, Term("√p", "root of the variable of the transform", "1/s^0.5")]
HeatThrough = Annotated[Number, Term("tanh(l √(p/a))", "how far the heat comes in 1/p; 1 in a half-space", "1")]
Time = Annotated[Number, Term("t", "time", "s")]
DiscDepth = Annotated[Number, Term("l", "depth to the middle of the disc", "m")]
ReachedTemperature = Annotated[Number, Term("Θ", "temperature that is reached", "K")]
StartTemperature = Annotated[Number, Term("Θ_0", "temperature at the start", "K")]
TemperatureLimit = Annotated[Number, Term("Θ_max", "largest temperature the discs may have", "K")]
TripRise = Annotated[Number, Term("ΔΘ", "rise of temperature by a trip", "K")]
Cooling = Annotated[Number, Term("α A_c", "heat given off per kelvin", "W/K")]
SurroundingTemperature = Annotated[Number, Term("Θ_0", "temperature of the surroundings", "K")]
LiningThickness = Annotated[Number, Term("s_w", "thickness that a pair may lose", "m")]
SpecificWear = Annotated[Number, Term("w", "volume worn per energy", "m^3/J")]
FollowingStiffness = Annotated[Number, Term("c_п", "stiffness of the spring that follows the pack", "N/m")]
PackForce = Annotated[Number, Term("F", "force on the pack at rest", "N")]
CoolingLogarithm = Annotated[
    Number, Term("λ", "−ln(1 − ΔΘ/(Θ_max − Θ_0)), of the share of the limit that a trip leaves", "1")
]

# What the law neglects
SplineFriction = Annotated[Number, Term("μ_s", "friction of the disc in its spline", "1")]
SplineRadius = Annotated[Number, Term("r_s", "radius of the spline", "m")]
NearerNormalForce = Annotated[Number, Term("N", "normal force on the pair nearer to the spring", "N")]
SplineShare = Annotated[
    Number,
    Term("ε", "share of its normal force that the disc's spline can hold, pair nearer to the spring", "1"),
]
NextSplineShare = Annotated[
    Number, Term("ε'", "share of its normal force that the disc's spline can hold, next pair", "1")
]
WallFriction = Annotated[Number, Term("μ", "friction of the cam on the wall", "1")]
BallMass = Annotated[Number, Term("m_ш", "mass of a ball", "kg")]
RotationSpeed = Annotated[Number, Term("ω", "speed of rotation", "rad/s")]
PairWear = Annotated[Number, Term("δ", "wear of a pair", "m")]
NextNormalForce = Annotated[Number, Term("N'", "normal force on the next pair", "N")]

# Disc springs
DiameterRatio = Annotated[Number, Term("δ", "outer over inner diameter", "1")]
LnDiameterRatio = Annotated[Number, Term("ln δ", "logarithm of the diameter ratio", "1")]
ThicknessWithoutFlats = Annotated[Number, Term("t", "thickness of the disc without flats", "m")]
ReducedThickness = Annotated[Number, Term("t'", "reduced thickness as made", "m")]
FreeHeight = Annotated[Number, Term("l_0", "free height of a disc", "m")]
YoungModulus = Annotated[Number, Term("E", "Young's modulus", "Pa")]
PoissonRatio = Annotated[Number, Term("ν", "Poisson's ratio", "1")]
FactorLoad = Annotated[Number, Term("K_1", "factor of the load", "1")]
FactorFlats = Annotated[Number, Term("K_4", "factor of the flats; 1 without", "1")]
OuterDiameter = Annotated[Number, Term("D_e", "outer diameter of a disc", "m")]
DiscThickness = Annotated[Number, Term("t", "thickness of the disc; with flats t'", "m")]
ConeHeight = Annotated[Number, Term("h_0", "l_0 − t, with flats l_0 − t'", "m")]
DiscDeflection = Annotated[Number, Term("s", "deflection of the disc", "m")]
MembraneFactor = Annotated[
    Number, Term("K_m", "factor of the membrane: of edge I and II K_2, of III and IV (K_2 − 2 K_3)/δ, of OM 0", "1")
]
BendingFactor = Annotated[
    Number, Term("K_b", "factor of bending: of I K_3, of II −K_3, of III −K_3/δ, of IV K_3/δ, of OM 3/π", "1")
]
ParallelDiscs = Annotated[Number, Term("n", "discs laid into each other", "1")]
SeriesPacks = Annotated[Number, Term("i", "such packs against each other", "1")]
StackForce = Annotated[Number, Term("n F", "force of the stack without friction", "N")]
SurfaceFriction = Annotated[Number, Term("w_M", "friction of the cones on each other; on the way back −w_M", "1")]
EdgeFriction = Annotated[Number, Term("w_R", "friction of the edges; on the way back −w_R", "1")]
InnerDiameter = Annotated[Number, Term("D_i", "inner diameter of a disc", "m")]
SpringForce = Annotated[Number, Term("F", "force of the spring", "N")]
FreeLength = Annotated[Number, Term("L_0", "length without load", "m")]
SpringMass = Annotated[Number, Term("m", "mass of the spring", "kg")]

# Coil springs
ShearModulus = Annotated[Number, Term("G", "shear modulus", "Pa")]
WireDiameter = Annotated[Number, Term("d", "wire diameter", "m")]
CoilDiameter = Annotated[Number, Term("D", "mean diameter of the coil", "m")]
CoilTurns = Annotated[Number, Term("n", "active coils", "1")]
CoilCorrection = Annotated[Number, Term("k_τ", "factor of the coil's curvature, 1 under a static load", "1")]
LargestWireDiameter = Annotated[Number, Term("d", "largest wire diameter", "m")]
EnduredAmplitude = Annotated[Number, Term("S_sa", "amplitude of a shear stress that is borne for ever", "Pa")]
EnduredMean = Annotated[Number, Term("S_sm", "mean of the shear stress that is borne for ever", "Pa")]
ShearStrength = Annotated[Number, Term("S_su", "shear strength", "Pa")]
LowerStress = Annotated[Number, Term("τ_U", "least shear stress of the stroke, with k_τ", "Pa")]
EnduredStress = Annotated[Number, Term("S_se", "shear stress that alternates about 0 and is borne for ever", "Pa")]
ModulusRatio = Annotated[Number, Term("G/E", "shear modulus over Young's modulus", "1")]
SeatingFactor = Annotated[Number, Term("ν", "factor of the seating, ½ between parallel plates", "1")]
BucklingRoot = Annotated[Number, Term("q", "what stands under the root in the deflection of buckling", "1")]
