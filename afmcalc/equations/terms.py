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
    unit: str
    """SI unit, ``1`` for a pure number."""
    meaning: str = ""
    """Meaning; empty for a result that no other equation takes, where the summary of the function explains it."""


# The clutch and its pairs
OuterRadius = Annotated[Number, Term("r_o", "m", "outer radius of the friction surface")]
InnerRadius = Annotated[Number, Term("r_i", "m", "inner radius of the friction surface")]
MeanRadius = Annotated[Number, Term("R_cp", "m", "mean friction radius")]
BallCircleRadius = Annotated[Number, Term("r", "m", "radius of the ball circle")]
TanWallAngle = Annotated[Number, Term("tan α", "1", "wall angle from the axis")]
Pairs = Annotated[Number, Term("z", "1", "friction pairs")]
BypassPairs = Annotated[Number, Term("z_1", "1", "pairs that bypass the control unit")]
ControlledPairs = Annotated[Number, Term("z_2", "1", "pairs whose torque passes the balls")]
Gain = Annotated[Number, Term("C", "1", "feedback gain")]
ClosingForce = Annotated[Number, Term("F_п", "N", "closing-spring force as set")]
NormalForce = Annotated[Number, Term("N", "N", "normal force on the pairs")]
GroupPairs = Annotated[Number, Term("z_i", "1", "pairs of the group")]
GroupFriction = Annotated[Number, Term("f_i", "1", "friction of the group")]
SlipTorque = Annotated[Number, Term("T", "N*m", "slip torque")]
ReleaseForce = Annotated[Number, Term("F_p", "N", "release force of the control unit")]
GainLimit = Annotated[Number, Term("C_max", "1", "largest feedback gain")]
AxialForce = Annotated[Number, Term("F", "N", "axial force on the ring")]

# Friction
Friction = Annotated[Number, Term("f", "1", "coefficient of friction")]
FrictionMin = Annotated[Number, Term("f_min", "1", "smallest coefficient of friction")]
FrictionMean = Annotated[Number, Term("f_cp", "1", "mean coefficient of friction")]
FrictionMax = Annotated[Number, Term("f_max", "1", "largest coefficient of friction")]
FrictionSet = Annotated[Number, Term("f_set", "1", "friction at the setting (f_min or f_cp)")]
FrictionDriving = Annotated[Number, Term("f_1", "1", "friction of the bypass pairs")]
FrictionDrivingMin = Annotated[Number, Term("f_1min", "1", "smallest friction of the bypass pairs")]
FrictionDrivingMax = Annotated[Number, Term("f_1max", "1", "largest friction of the bypass pairs")]
FrictionDriven = Annotated[Number, Term("f_2", "1", "friction of the controlled pairs")]
FrictionDrivenMin = Annotated[Number, Term("f_2min", "1", "smallest friction of the controlled pairs")]
FrictionDrivenMax = Annotated[Number, Term("f_2max", "1", "largest friction of the controlled pairs")]
FrictionRatioMin = Annotated[Number, Term("p", "1", "f_2min/f_1min")]
FrictionRatioMax = Annotated[Number, Term("n", "1", "f_2max/f_1max")]

# Accuracy
TorqueMax = Annotated[Number, Term("T_max", "N*m", "largest torque")]
TorqueMin = Annotated[Number, Term("T_min", "N*m", "smallest torque")]
PeakMax = Annotated[Number, Term("P_max", "N*m", "larger of sustained torque and the bypass pairs' peak, at f_max")]
PeakMin = Annotated[Number, Term("P_min", "N*m", "larger of sustained torque and the bypass pairs' peak, at f_min")]
Scatter = Annotated[Number, Term("ΔT", "N*m", "torque scatter band")]
AccuracyFactor = Annotated[Number, Term("K_т", "1", "accuracy factor")]
BestAccuracyFactor = Annotated[Number, Term("K_best", "1", "smallest accuracy factor that can be reached")]

# Adjustment
NominalTorque = Annotated[Number, Term("T_н", "N*m", "nominal torque")]
TorquePerForce = Annotated[Number, Term("a_set", "m", "slip torque per spring force at the friction of the setting")]
TorqueAtSetting = Annotated[Number, Term("T_set", "N*m", "slip torque at the friction of the setting")]
TorquePerForceMean = Annotated[Number, Term("a_cp", "m", "slip torque per spring force at f_cp")]
TorquePerForceMin = Annotated[Number, Term("a_min", "m", "slip torque per spring force at f_min")]
Margin = Annotated[Number, Term("β_н", "1", "torque margin")]

# Overload
LoopGain = Annotated[Number, Term("v", "1", "loop gain at f")]
ClutchNominalTorque = Annotated[Number, Term("T_н.муф", "N*m", "nominal torque of the clutch, T_муф at f_min")]
LoopGainMin = Annotated[Number, Term("u", "1", "loop gain at f_min")]
PotentialTorque = Annotated[Number, Term("T_п", "N*m", "potential torque")]
MachineTorque = Annotated[Number, Term("T_н.маш", "N*m", "nominal torque of the machine")]
LoadRise = Annotated[Number, Term("ΔT'", "N*m", "load rise until slip")]
ReducedGain = Annotated[Number, Term("zC", "1", "reduced gain (z − z_1) C")]
ExpectedTorque = Annotated[Number, Term("T_муф", "N*m", "expected slip torque at f_max")]
ActuationTorque = Annotated[Number, Term("T_act", "N*m", "the larger of T_ср and T_муф at f_max")]
EquilibriumTorqueMax = Annotated[Number, Term("T_eq.max", "N*m", "load at slip at f_max")]
EquilibriumTorqueMin = Annotated[Number, Term("T_eq.min", "N*m", "load at slip at f_min")]
ReducedGainOfPairs = Annotated[Number, Term("z C", "1", "reduced gain of all pairs")]

# Life
SideTorque = Annotated[Number, Term("T", "N*m", "torque of the side in question, T' on the unprotected one")]
PolarSectionModulus = Annotated[Number, Term("W_p", "m^3", "polar section modulus")]
DynamicFactor = Annotated[Number, Term("k_д", "1", "dynamic factor of the unprotected side")]
StressLow = Annotated[Number, Term("τ_min", "Pa", "smallest stress of the cycle")]
StressHigh = Annotated[Number, Term("τ_max", "Pa", "largest stress of the cycle")]
MeanStressSensitivity = Annotated[Number, Term("ψ_τ", "1", "sensitivity to the mean stress")]
UltimateStrength = Annotated[Number, Term("τ_u", "Pa", "ultimate strength in shear")]
EnduranceLimit = Annotated[Number, Term("τ_limb", "Pa", "endurance limit in shear")]
DamagingStress = Annotated[Number, Term("τ", "Pa", "damaging stress")]
FatigueExponent = Annotated[Number, Term("m_τ", "1", "exponent of the S-N line")]
BaseCycles = Annotated[Number, Term("N_0", "1", "base cycles of the S-N line")]
MeanDamage = Annotated[Number, Term("D_m", "1", "mean damage of a slip over f_min … f_max")]
ShearStress = Annotated[Number, Term("τ", "Pa", "shear stress")]
EquivalentStress = Annotated[Number, Term("τ_eq", "Pa", "equivalent alternating stress, to be held against τ_−1")]
Cycles = Annotated[Number, Term("N_ц", "1", "cycles to failure")]

# Indirect regulation
KeyFriction = Annotated[Number, Term("f_1", "1", "friction coefficient at the key")]
HubDiameter = Annotated[Number, Term("d", "m", "hub diameter at the key")]
IndirectClosingForce = Annotated[Number, Term("F_п", "N", "closing-spring force as set (S21: F_п1)")]
NetGain = Annotated[Number, Term("κ", "1", "C − 2 R f_1/d, gain net of the key's friction")]
ClosingStiffness = Annotated[Number, Term("c_1", "N/m", "stiffness of the closing spring")]
ControlStiffness = Annotated[Number, Term("c_2", "N/m", "stiffness of the control spring")]
SleeveStiffness = Annotated[Number, Term("D", "N/m", "stiffness against which the sleeve moves")]
ControlForce = Annotated[Number, Term("F_п2", "N", "control-spring force at the stop")]
TensedControlForce = Annotated[Number, Term("F_2", "N", "force of the control spring where the sleeve is")]
RisingTorqueMax = Annotated[Number, Term("T_max", "N*m", "largest slip torque, friction rising")]
ReturningTorqueMin = Annotated[Number, Term("T_ret,min", "N*m", "smallest slip torque, friction falling under load")]
ClosingForceAtStop = Annotated[Number, Term("F_п1", "N", "closing-spring force at the stop")]
NetGainReturning = Annotated[Number, Term("κ₊", "1", "C + 2 R f_1/d")]
FeedbackPart = Annotated[Number, Term("κ_p", "1", "part of κ that is proportional to the parameter")]
Travel = Annotated[Number, Term("x", "m", "axial travel of the sleeve")]
NominalTorqueRatio = Annotated[Number, Term("K_п", "1", "nominal torque over that of the base clutch")]

# Curved pockets
InitialGain = Annotated[Number, Term("C_0", "1", "gain at the stop")]
GainSlope = Annotated[Number, Term("C_1", "1/m", "how the gain grows with travel")]
StraightStiffness = Annotated[Number, Term("D", "N/m", "D(f) of a straight pocket, at κ of the stop")]
SlopeFeedback = Annotated[Number, Term("w", "1/m", "feedback that a metre of travel adds, z f C_1")]
TangentStiffness = Annotated[
    Number, Term("k_t", "N/m", "stiffness of the balance where the sleeve is; D of a straight pocket")
]
LeavingFriction = Annotated[Number, Term("f_L", "1", "friction at which the sleeve leaves its stop")]
LeavingStiffness = Annotated[Number, Term("D", "N/m", "D(f_L) of a straight pocket")]
SpringPart = Annotated[Number, Term("F_part", "N", "part of F_п1 − c_1 x proportional to the parameter")]
ForceElasticity = Annotated[Number, Term("∂ln N/∂ln p", "1", "elasticity of the normal force in a parameter p")]

# The sleeve in motion
Turn = Annotated[Number, Term("φ", "rad", "turn of the balls")]
GainAtStop = Annotated[Number, Term("C", "1", "feedback gain at the stop")]
TurnRate = Annotated[Number, Term("φ'", "rad/s", "speed of the turn of the balls")]
GainAtSleeve = Annotated[Number, Term("C", "1", "feedback gain where the sleeve is")]
SpringWork = Annotated[Number, Term("W", "J", "work stored in the springs at the turning point")]
SpringBallTorque = Annotated[Number, Term("T_b", "N*m", "torque of the springs through the balls, S/κ")]
SleeveMass = Annotated[Number, Term("m", "kg", "mass of the sleeve")]
NetGainEitherWay = Annotated[Number, Term("κ", "1", "net gain; κ₊ while the sleeve returns")]
SpringMoment = Annotated[Number, Term("S", "N*m", "moment of both springs")]
SleeveInertia = Annotated[Number, Term("μ", "kg*m^2", "inertia of the sleeve's mass, counted in the turn of the balls")]
BallTorque = Annotated[Number, Term("T_b", "N*m", "torque through the balls")]
PairsTimesFriction = Annotated[Number, Term("zf", "1", "pairs times friction")]
NetGainOrReturning = Annotated[Number, Term("κ or κ₊", "1", "net gain while the sleeve leaves its stop or returns")]
TorqueAlone = Annotated[Number, Term("T_b0", "N*m", "torque that the balls would pass without friction of the pack")]
TorqueShare = Annotated[Number, Term("j", "1", "share of the pack's torque that the balls pass")]
TravelRate = Annotated[Number, Term("x'", "m/s", "speed of the sleeve")]

# Walls and contact
Sleeves = Annotated[Number, Term("m", "1", "sleeves that the ball moves in: 1 or 2")]
TanAngleAtStop = Annotated[Number, Term("tan α_0", "1", "tangent of the wall angle at the stop")]
PathSteepening = Annotated[Number, Term("Y''", "1/m", "second derivative of the path of the ball's centre")]
PathDepth = Annotated[Number, Term("ξ", "m", "way of the ball along the axis from its place at the stop")]
BallRadius = Annotated[Number, Term("r_ш", "m", "ball radius")]
SinAngleAtBall = Annotated[Number, Term("sin α", "1", "where the ball is")]
PathPlace = Annotated[Number, Term("Y", "m", "place on the path, around the ball circle")]
CosAngleAtBall = Annotated[Number, Term("cos α", "1", "where the ball is")]
FaceGap = Annotated[Number, Term("s", "m", "gap between the faces")]
CurvedWallForce = Annotated[Number, Term("F_n", "N", "force of the curved wall on the ball")]
SinSumOfAngles = Annotated[Number, Term("sin(α + α_0)", "1", "sine of the wall angles of both sleeves together")]
SinSeatAngle = Annotated[Number, Term("sin α_0", "1", "sine of the angle of the seat's walls")]
CosSeatAngle = Annotated[Number, Term("cos α_0", "1", "cosine of the angle of the seat's walls")]
PathRadius = Annotated[Number, Term("ρ", "m", "radius of curvature of the path")]
CurvatureRatio = Annotated[Number, Term("A/B", "1", "ratio of the relative curvatures")]
AxisRatio = Annotated[Number, Term("k", "1", "minor over major semi-axis")]
IntegralB = Annotated[Number, Term("𝐁", "1", "complete elliptic integral of modulus √(1 − k²)")]
IntegralD = Annotated[Number, Term("𝐃", "1", "complete elliptic integral of modulus √(1 − k²)")]
Pi = Annotated[Number, Term("π", "1", "a symbol under SymPy")]

# Synthesis of the control unit
EdgeClearance = Annotated[Number, Term("y", "m", "clearance of the contact from the pocket's edge")]
SinWallAngle = Annotated[Number, Term("sin α", "1", "sine of the wall angle")]
CosWallAngle = Annotated[Number, Term("cos α", "1", "cosine of the wall angle")]
PocketDepth = Annotated[Number, Term("h_1", "m", "pocket depth to the virtual apex")]
SinHalfPitch = Annotated[Number, Term("sin(π/n)", "1", "sine of half the pitch angle of n balls")]
BallPitch = Annotated[Number, Term("t_ш", "m", "distance between the centres of neighbouring balls")]
PocketWidth = Annotated[Number, Term("b", "m", "width of the pocket's mouth")]
PassedTorque = Annotated[Number, Term("T", "N*m", "torque that passes the balls")]
Balls = Annotated[Number, Term("n", "1", "number of balls")]
NumeratorConstant = Annotated[Number, Term("a", "1", "constant of the numerator")]
NumeratorSlope = Annotated[Number, Term("b", "1", "slope of the numerator")]
DenominatorConstant = Annotated[Number, Term("a'", "1", "constant of the denominator")]
DenominatorSlope = Annotated[Number, Term("b'", "1", "slope of the denominator")]
RadiusRatio = Annotated[Number, Term("q", "1", "r/R")]
BallModulus = Annotated[Number, Term("E_1", "Pa", "elastic modulus of the ball")]
BallPoisson = Annotated[Number, Term("ν_1", "1", "Poisson's ratio of the ball")]
WallModulus = Annotated[Number, Term("E_2", "Pa", "elastic modulus of the pocket wall")]
WallPoisson = Annotated[Number, Term("ν_2", "1", "Poisson's ratio of the pocket wall")]
AllowablePressureOnFlat = Annotated[Number, Term("p_0", "Pa", "allowable maximum contact pressure")]
ContactModulus = Annotated[Number, Term("E_c", "Pa", "contact modulus of ball and wall")]
AllowablePressure = Annotated[Number, Term("p_0,allow", "Pa", "allowable maximum contact pressure")]
ContactForce = Annotated[Number, Term("F_n", "N", "normal force on the ball")]
AllowableForce = Annotated[Number, Term("F_n,allow", "N", "force at which the ball reaches the allowable pressure")]

# What is wanted
WantedAccuracyFactor = Annotated[Number, Term("K_т wanted", "1", "accuracy factor that is wanted")]
WantedTorque = Annotated[Number, Term("T wanted", "N*m", "torque that is wanted")]
ReducedGainLimit = Annotated[Number, Term("largest zC", "1", "largest reduced gain, 5 by S22")]

# The drive
DampingRatio = Annotated[Number, Term("ζ", "1", "damping ratio of the driven half on the shaft")]
ShaftStiffness = Annotated[Number, Term("k", "N*m/rad", "torsional stiffness of the shaft")]
DrivenInertia = Annotated[Number, Term("J_2", "kg*m^2", "inertia of the driven half")]
Twist = Annotated[Number, Term("φ", "rad", "twist of the shaft")]
ShaftDamping = Annotated[Number, Term("d", "N*m*s/rad", "damping of the shaft")]
TwistRate = Annotated[Number, Term("φ'", "rad/s", "speed of the twist, ω_2 − ω_3")]
SpeedBeforeLock = Annotated[Number, Term("ω_0", "rad/s", "speed before the lock")]
Deceleration = Annotated[Number, Term("a", "rad/s^2", "deceleration of the tool, ω_0/t_b")]
LoadBefore = Annotated[Number, Term("T_0", "N*m", "load before the event")]
StaticRatio = Annotated[Number, Term("r_s", "1", "static over sliding friction")]
StribeckDecay = Annotated[Number, Term("e", "1", "1 at rest, 0 at high sliding speed")]
MotorSpeed = Annotated[Number, Term("ω", "rad/s", "speed of the motor side")]
SynchronousSpeed = Annotated[Number, Term("ω_s", "rad/s", "synchronous speed, reduced to the clutch")]
BreakdownTorque = Annotated[Number, Term("M_b", "N*m", "breakdown torque of the motor")]
BreakdownSlip = Annotated[Number, Term("s_b", "1", "slip at breakdown")]
MotorSlip = Annotated[Number, Term("s", "1", "slip of the motor")]
MotorRunTorque = Annotated[Number, Term("M", "N*m", "torque of the motor")]
DriveTorque = Annotated[Number, Term("M", "N*m", "torque on the driving inertia")]
DriveInertia = Annotated[Number, Term("J_1", "kg*m^2", "driving inertia")]
LoadTorque = Annotated[Number, Term("L", "N*m", "torque of the load on the driven inertia")]
LoadInertia = Annotated[Number, Term("J_2", "kg*m^2", "driven inertia")]
TorqueBetween = Annotated[Number, Term("T", "N*m", "torque between the two inertias")]
ControlledTorque = Annotated[Number, Term("T_2", "N*m", "torque through the balls")]
BalancedNormalForce = Annotated[Number, Term("N_eq", "N", "normal force in balance with the load")]
ForceLag = Annotated[Number, Term("τ", "s", "time by which the normal force lags the load")]
TorqueGrowth = Annotated[Number, Term("f T'(f)", "N*m", "growth of the torque with friction")]
StribeckSpeed = Annotated[Number, Term("v_s", "m/s", "sliding speed in which static friction decays")]
MotorTorque = Annotated[Number, Term("M_1", "N*m", "torque of the motor")]

# Heat and wear
MotorInertia = Annotated[Number, Term("J_1", "kg*m^2", "moment of inertia of the motor side")]
MotorSpeedAtSlip = Annotated[Number, Term("ω_0", "rad/s", "speed of the motor side as the slip begins")]
SlipSpeedStart = Annotated[Number, Term("ω_0", "rad/s", "slip speed as the slip begins")]
SlipSpeedEnd = Annotated[Number, Term("ω", "rad/s", "slip speed as it ends")]
SlipDuration = Annotated[Number, Term("t", "s", "duration of the slip")]
TripHeat = Annotated[Number, Term("Q", "J", "heat of a trip")]
PairArea = Annotated[Number, Term("A", "m^2", "area of a pair")]
SlipSpeed = Annotated[Number, Term("ω", "rad/s", "speed of slip")]
SlipPower = Annotated[Number, Term("P", "W", "power of the slip")]
DiscsMass = Annotated[Number, Term("m", "kg", "mass of the discs that take the heat")]
SpecificHeat = Annotated[Number, Term("c", "J/kg/K", "specific heat")]
Conductivity = Annotated[Number, Term("k", "W/m/K", "thermal conductivity")]
Density = Annotated[Number, Term("ρ", "kg/m^3", "density")]
Effusivity = Annotated[Number, Term("b", "W*s^0.5/m^2/K", "√(k ρ c)")]
TransformRoot = Annotated[Number, Term("√p", "1/s^0.5", "root of the variable of the transform")]
HeatThrough = Annotated[Number, Term("tanh(l √(p/a))", "1", "how far the heat comes in 1/p; 1 in a half-space")]
Time = Annotated[Number, Term("t", "s", "time")]
DiscDepth = Annotated[Number, Term("l", "m", "depth to the middle of the disc")]
ReachedTemperature = Annotated[Number, Term("Θ", "K", "temperature that is reached")]
StartTemperature = Annotated[Number, Term("Θ_0", "K", "temperature at the start")]
TemperatureLimit = Annotated[Number, Term("Θ_max", "K", "largest temperature the discs may have")]
TripRise = Annotated[Number, Term("ΔΘ", "K", "rise of temperature by a trip")]
Cooling = Annotated[Number, Term("α A_c", "W/K", "heat given off per kelvin")]
SurroundingTemperature = Annotated[Number, Term("Θ_0", "K", "temperature of the surroundings")]
LiningThickness = Annotated[Number, Term("s_w", "m", "thickness that a pair may lose")]
SpecificWear = Annotated[Number, Term("w", "m^3/J", "volume worn per energy")]
FollowingStiffness = Annotated[Number, Term("c_п", "N/m", "stiffness of the spring that follows the pack")]
PackForce = Annotated[Number, Term("F", "N", "force on the pack at rest")]
CoolingLogarithm = Annotated[Number, Term("λ", "1", "logarithm −ln(1 − ΔΘ/(Θ_max − Θ_0))")]

# What the law neglects
SplineFriction = Annotated[Number, Term("μ_s", "1", "friction of the disc in its spline")]
SplineRadius = Annotated[Number, Term("r_s", "m", "radius of the spline")]
NearerNormalForce = Annotated[Number, Term("N", "N", "normal force on the pair nearer to the spring")]
SplineShare = Annotated[Number, Term("ε", "1", "share of its force that the spline holds, pair nearer to the spring")]
NextSplineShare = Annotated[Number, Term("ε'", "1", "share of its force that the spline holds, next pair")]
WallFriction = Annotated[Number, Term("μ", "1", "friction of the cam on the wall")]
BallMass = Annotated[Number, Term("m_ш", "kg", "mass of a ball")]
RotationSpeed = Annotated[Number, Term("ω", "rad/s", "speed of rotation")]
PairWear = Annotated[Number, Term("δ", "m", "wear of a pair")]
NextNormalForce = Annotated[Number, Term("N'", "N", "normal force on the next pair")]

# Disc springs
DiameterRatio = Annotated[Number, Term("δ", "1", "outer over inner diameter")]
LnDiameterRatio = Annotated[Number, Term("ln δ", "1", "logarithm of the diameter ratio")]
ThicknessWithoutFlats = Annotated[Number, Term("t", "m", "thickness of the disc without flats")]
ReducedThickness = Annotated[Number, Term("t'", "m", "reduced thickness as made")]
FreeHeight = Annotated[Number, Term("l_0", "m", "free height of a disc")]
YoungModulus = Annotated[Number, Term("E", "Pa", "Young's modulus")]
PoissonRatio = Annotated[Number, Term("ν", "1", "Poisson's ratio")]
FactorLoad = Annotated[Number, Term("K_1", "1", "factor of the load")]
FactorFlats = Annotated[Number, Term("K_4", "1", "factor of the flats; 1 without")]
OuterDiameter = Annotated[Number, Term("D_e", "m", "outer diameter of a disc")]
DiscThickness = Annotated[Number, Term("t", "m", "thickness of the disc; with flats t'")]
ConeHeight = Annotated[Number, Term("h_0", "m", "l_0 − t, with flats l_0 − t'")]
DiscDeflection = Annotated[Number, Term("s", "m", "deflection of the disc")]
MembraneFactor = Annotated[
    Number, Term("K_m", "1", "factor of the membrane: of edge I and II K_2, of III and IV (K_2 − 2 K_3)/δ, of OM 0")
]
BendingFactor = Annotated[
    Number, Term("K_b", "1", "factor of bending: of I K_3, of II −K_3, of III −K_3/δ, of IV K_3/δ, of OM 3/π")
]
ParallelDiscs = Annotated[Number, Term("n", "1", "discs laid into each other")]
SeriesPacks = Annotated[Number, Term("i", "1", "such packs against each other")]
StackForce = Annotated[Number, Term("n F", "N", "force of the stack without friction")]
SurfaceFriction = Annotated[Number, Term("w_M", "1", "friction of the cones on each other; on the way back −w_M")]
EdgeFriction = Annotated[Number, Term("w_R", "1", "friction of the edges; on the way back −w_R")]
InnerDiameter = Annotated[Number, Term("D_i", "m", "inner diameter of a disc")]
SpringForce = Annotated[Number, Term("F", "N", "force of the spring")]
FreeLength = Annotated[Number, Term("L_0", "m", "length without load")]
SpringMass = Annotated[Number, Term("m", "kg", "mass of the spring")]

# Coil springs
ShearModulus = Annotated[Number, Term("G", "Pa", "shear modulus")]
WireDiameter = Annotated[Number, Term("d", "m", "wire diameter")]
CoilDiameter = Annotated[Number, Term("D", "m", "mean diameter of the coil")]
CoilTurns = Annotated[Number, Term("n", "1", "active coils")]
CoilCorrection = Annotated[Number, Term("k_τ", "1", "factor of the coil's curvature, 1 under a static load")]
LargestWireDiameter = Annotated[Number, Term("d", "m", "largest wire diameter")]
EnduredAmplitude = Annotated[Number, Term("S_sa", "Pa", "amplitude of a shear stress that is borne for ever")]
EnduredMean = Annotated[Number, Term("S_sm", "Pa", "mean of the shear stress that is borne for ever")]
ShearStrength = Annotated[Number, Term("S_su", "Pa", "shear strength")]
LowerStress = Annotated[Number, Term("τ_U", "Pa", "least shear stress of the stroke, with k_τ")]
EnduredStress = Annotated[Number, Term("S_se", "Pa", "shear stress that alternates about 0 and is borne for ever")]
ModulusRatio = Annotated[Number, Term("G/E", "1", "shear modulus over Young's modulus")]
SeatingFactor = Annotated[Number, Term("ν", "1", "factor of the seating, ½ between parallel plates")]
BucklingRoot = Annotated[Number, Term("q", "1", "what stands under the root in the deflection of buckling")]
