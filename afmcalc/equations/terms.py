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
OuterRadius = Annotated[Number, "r_o", "m", "outer radius of the friction surface"]
InnerRadius = Annotated[Number, "r_i", "m", "inner radius of the friction surface"]
MeanRadius = Annotated[Number, "R_cp", "m", "mean friction radius"]
BallCircleRadius = Annotated[Number, "r", "m", "radius of the ball circle"]
TanWallAngle = Annotated[Number, "tan α", "1", "wall angle from the axis"]
Pairs = Annotated[Number, "z", "1", "friction pairs"]
BypassPairs = Annotated[Number, "z_1", "1", "pairs that bypass the control unit"]
ControlledPairs = Annotated[Number, "z_2", "1", "pairs whose torque passes the balls"]
Gain = Annotated[Number, "C", "1", "feedback gain"]
ClosingForce = Annotated[Number, "F_п", "N", "closing-spring force as set"]
NormalForce = Annotated[Number, "N", "N", "normal force on the pairs"]
SlipTorque = Annotated[Number, "T", "N*m", "slip torque"]

# Friction
Friction = Annotated[Number, "f", "1", "coefficient of friction"]
FrictionMin = Annotated[Number, "f_min", "1", "smallest coefficient of friction"]
FrictionMax = Annotated[Number, "f_max", "1", "largest coefficient of friction"]
FrictionSet = Annotated[Number, "f_set", "1", "friction at the setting (f_min or f_cp)"]
FrictionDriving = Annotated[Number, "f_1", "1", "friction of the bypass pairs"]
FrictionDrivingMin = Annotated[Number, "f_1min", "1", "smallest friction of the bypass pairs"]
FrictionDrivingMax = Annotated[Number, "f_1max", "1", "largest friction of the bypass pairs"]
FrictionDriven = Annotated[Number, "f_2", "1", "friction of the controlled pairs"]
FrictionDrivenMin = Annotated[Number, "f_2min", "1", "smallest friction of the controlled pairs"]
FrictionDrivenMax = Annotated[Number, "f_2max", "1", "largest friction of the controlled pairs"]

# Life
ShearStress = Annotated[Number, "τ", "Pa", "shear stress"]

# Indirect regulation
NetGain = Annotated[Number, "κ", "1", "C − 2 R f_1/d, gain net of the key's friction"]
ClosingStiffness = Annotated[Number, "c_1", "N/m", "stiffness of the closing spring"]
ControlStiffness = Annotated[Number, "c_2", "N/m", "stiffness of the control spring"]
ControlForce = Annotated[Number, "F_п2", "N", "control-spring force at the stop"]
TensedControlForce = Annotated[Number, "F_2", "N", "force of the control spring where the sleeve is"]
ClosingForceAtStop = Annotated[Number, "F_п1", "N", "closing-spring force at the stop"]
Travel = Annotated[Number, "x", "m", "axial travel of the sleeve"]

# Curved pockets
GainSlope = Annotated[Number, "C_1", "1/m", "how the gain grows with travel"]

# The sleeve in motion
Turn = Annotated[Number, "φ", "rad", "turn of the balls"]
GainAtStop = Annotated[Number, "C", "1", "feedback gain at the stop"]
TurnRate = Annotated[Number, "φ'", "rad/s", "speed of the turn of the balls"]
GainAtSleeve = Annotated[Number, "C", "1", "feedback gain where the sleeve is"]
SpringBallTorque = Annotated[Number, "T_b", "N*m", "torque of the springs through the balls, S/κ"]
SleeveMass = Annotated[Number, "m", "kg", "mass of the sleeve"]
NetGainEitherWay = Annotated[Number, "κ", "1", "net gain; κ₊ while the sleeve returns"]
SpringMoment = Annotated[Number, "S", "N*m", "moment of both springs"]
SleeveInertia = Annotated[Number, "μ", "kg*m^2", "inertia of the sleeve's mass, counted in the turn of the balls"]
BallTorque = Annotated[Number, "T_b", "N*m", "torque through the balls"]
PairsTimesFriction = Annotated[Number, "zf", "1", "pairs times friction"]
NetGainOrReturning = Annotated[Number, "κ or κ₊", "1", "net gain while the sleeve leaves its stop or returns"]
TorqueAlone = Annotated[Number, "T_b0", "N*m", "torque that the balls would pass without friction of the pack"]
TorqueShare = Annotated[Number, "j", "1", "share of the pack's torque that the balls pass"]
TravelRate = Annotated[Number, "x'", "m/s", "speed of the sleeve"]

# Walls and contact
BallRadius = Annotated[Number, "r_ш", "m", "ball radius"]
Pi = Annotated[Number, "π", "1", "circumference over diameter of a circle"]

# Synthesis of the control unit
Balls = Annotated[Number, "n", "1", "number of balls"]

# What is wanted
NetLoopGain = Annotated[Number, "zκ", "1", "net gain of all pairs together"]
NetLoopLinear = Annotated[Number, "b_κ", "N/m", "coefficient of zκ in its quadratic"]
NetLoopConstant = Annotated[Number, "d_κ", "N/m", "constant of the quadratic of zκ"]
WantedAccuracyFactor = Annotated[Number, "K_т.зад", "1", "accuracy factor that is wanted"]
WantedTorque = Annotated[Number, "T_зад", "N*m", "torque that is wanted"]

# The drive
DampingRatio = Annotated[Number, "ζ", "1", "damping ratio of the driven half on the shaft"]
ShaftStiffness = Annotated[Number, "k", "N*m/rad", "torsional stiffness of the shaft"]
DrivenInertia = Annotated[Number, "J_2", "kg*m^2", "inertia of the driven half"]
Twist = Annotated[Number, "φ", "rad", "twist of the shaft"]
ShaftDamping = Annotated[Number, "d", "N*m*s/rad", "damping of the shaft"]
TwistRate = Annotated[Number, "φ'", "rad/s", "speed of the twist, ω_2 − ω_3"]
SpeedBeforeLock = Annotated[Number, "ω_0", "rad/s", "speed before the lock"]
Deceleration = Annotated[Number, "a", "rad/s^2", "deceleration of the tool, ω_0/t_b"]
LoadBefore = Annotated[Number, "T_0", "N*m", "load before the event"]
StaticRatio = Annotated[Number, "r_s", "1", "static over sliding friction"]
StribeckDecay = Annotated[Number, "e", "1", "1 at rest, 0 at high sliding speed"]
MotorSpeed = Annotated[Number, "ω", "rad/s", "speed of the motor side"]
SynchronousSpeed = Annotated[Number, "ω_s", "rad/s", "synchronous speed, reduced to the clutch"]
BreakdownTorque = Annotated[Number, "M_b", "N*m", "breakdown torque of the motor"]
BreakdownSlip = Annotated[Number, "s_b", "1", "slip at breakdown"]
MotorSlip = Annotated[Number, "s", "1", "slip of the motor"]
MotorRunTorque = Annotated[Number, "M", "N*m", "torque of the motor"]
DriveTorque = Annotated[Number, "M", "N*m", "torque on the driving inertia"]
DriveInertia = Annotated[Number, "J_1", "kg*m^2", "driving inertia"]
LoadTorque = Annotated[Number, "L", "N*m", "torque of the load on the driven inertia"]
LoadInertia = Annotated[Number, "J_2", "kg*m^2", "driven inertia"]
TorqueBetween = Annotated[Number, "T", "N*m", "torque between the two inertias"]
BalancedNormalForce = Annotated[Number, "N_eq", "N", "normal force in balance with the load"]
ForceLag = Annotated[Number, "τ", "s", "time by which the normal force lags the load"]
TorqueGrowth = Annotated[Number, "f T'(f)", "N*m", "growth of the torque with friction"]
StribeckSpeed = Annotated[Number, "v_s", "m/s", "sliding speed over which static friction falls to sliding friction"]
MotorTorque = Annotated[Number, "M_1", "N*m", "torque of the motor"]

# Heat and wear
MotorInertia = Annotated[Number, "J_1", "kg*m^2", "moment of inertia of the motor side"]
MotorSpeedAtSlip = Annotated[Number, "ω_0", "rad/s", "speed of the motor side as the slip begins"]
SlipSpeedStart = Annotated[Number, "ω_0", "rad/s", "slip speed as the slip begins"]
SlipSpeedEnd = Annotated[Number, "ω", "rad/s", "slip speed as it ends"]
SlipDuration = Annotated[Number, "t", "s", "duration of the slip"]
TripHeat = Annotated[Number, "Q", "J", "heat of a trip"]
PairArea = Annotated[Number, "A", "m^2", "area of a pair"]
SlipSpeed = Annotated[Number, "ω", "rad/s", "speed of slip"]
SlipPower = Annotated[Number, "P", "W", "power of the slip"]
DiscsMass = Annotated[Number, "m", "kg", "mass of the discs that take the heat"]
SpecificHeat = Annotated[Number, "c", "J/kg/K", "specific heat"]
Conductivity = Annotated[Number, "k", "W/m/K", "thermal conductivity"]
Density = Annotated[Number, "ρ", "kg/m^3", "density"]
Effusivity = Annotated[Number, "b", "W*s^0.5/m^2/K", "√(k ρ c)"]
TransformRoot = Annotated[Number, "√p", "1/s^0.5", "root of the variable of the transform"]
HeatThrough = Annotated[Number, "tanh(l √(p/a))", "1", "how far the heat comes in 1/p; 1 in a half-space"]
Time = Annotated[Number, "t", "s", "time"]
DiscDepth = Annotated[Number, "l", "m", "depth to the middle of the disc"]
ReachedTemperature = Annotated[Number, "Θ", "K", "temperature that is reached"]
StartTemperature = Annotated[Number, "Θ_0", "K", "temperature at the start"]
TemperatureLimit = Annotated[Number, "Θ_max", "K", "largest temperature the discs may have"]
TripRise = Annotated[Number, "ΔΘ", "K", "rise of temperature by a trip"]
Cooling = Annotated[Number, "α A_c", "W/K", "heat given off per kelvin"]
SurroundingTemperature = Annotated[Number, "Θ_0", "K", "temperature of the surroundings"]
LiningThickness = Annotated[Number, "s_w", "m", "thickness of lining that a pair may lose by wear"]
SpecificWear = Annotated[Number, "w", "m^3/J", "volume worn per energy"]
FollowingStiffness = Annotated[Number, "c_п", "N/m", "stiffness of the spring that follows the pack"]
PackForce = Annotated[Number, "F", "N", "force on the pack at rest"]
CoolingLogarithm = Annotated[Number, "λ", "1", "logarithm −ln(1 − ΔΘ/(Θ_max − Θ_0))"]

# What the law neglects
SplineFriction = Annotated[Number, "μ_s", "1", "friction of the disc in its spline"]
SplineRadius = Annotated[Number, "r_s", "m", "radius of the spline"]
NearerNormalForce = Annotated[Number, "N", "N", "normal force on the pair nearer to the spring"]
SplineShare = Annotated[Number, "ε", "1", "share of its force that the spline holds, pair nearer to the spring"]
NextSplineShare = Annotated[Number, "ε'", "1", "share of its force that the spline holds, next pair"]
BallMass = Annotated[Number, "m_ш", "kg", "mass of a ball"]
RotationSpeed = Annotated[Number, "ω", "rad/s", "speed of rotation"]
RingMass = Annotated[Number, "m", "kg", "mass of the ring"]
RingOuterDiameter = Annotated[Number, "D", "m", "outer diameter of the ring"]
RingInnerDiameter = Annotated[Number, "d", "m", "inner diameter of the ring"]
PairWear = Annotated[Number, "δ", "m", "wear of a pair"]
NextNormalForce = Annotated[Number, "N'", "N", "normal force on the next pair"]

# Disc springs
DiameterRatio = Annotated[Number, "δ", "1", "outer over inner diameter"]
LnDiameterRatio = Annotated[Number, "ln δ", "1", "logarithm of the diameter ratio"]
ThicknessWithoutFlats = Annotated[Number, "t", "m", "thickness of the disc without flats"]
ReducedThickness = Annotated[Number, "t'", "m", "reduced thickness as made"]
FreeHeight = Annotated[Number, "l_0", "m", "free height of a disc"]
YoungModulus = Annotated[Number, "E", "Pa", "Young's modulus"]
PoissonRatio = Annotated[Number, "ν", "1", "Poisson's ratio"]
FactorLoad = Annotated[Number, "K_1", "1", "factor of the load"]
FlatsFirst = Annotated[Number, "c_1", "1", "first coefficient of the flats"]
FlatsSecond = Annotated[Number, "c_2", "1", "second coefficient of the flats"]
FactorFlats = Annotated[Number, "K_4", "1", "factor of the flats; 1 without"]
OuterDiameter = Annotated[Number, "D_e", "m", "outer diameter of a disc"]
DiscThickness = Annotated[Number, "t", "m", "thickness of the disc; with flats t'"]
ConeHeight = Annotated[Number, "h_0", "m", "l_0 − t, with flats l_0 − t'"]
DiscDeflection = Annotated[Number, "s", "m", "deflection of the disc"]
MembraneFactor = Annotated[
    Number, "K_m", "1", "factor of the membrane: of edge I and II K_2, of III and IV (K_2 − 2 K_3)/δ, of OM 0"
]
BendingFactor = Annotated[
    Number, "K_b", "1", "factor of bending: of I K_3, of II −K_3, of III −K_3/δ, of IV K_3/δ, of OM 3/π"
]
ParallelDiscs = Annotated[Number, "n", "1", "discs nested in each other, in parallel"]
SeriesPacks = Annotated[Number, "i", "1", "such packs against each other"]
StackForce = Annotated[Number, "n F", "N", "force of the stack without friction"]
SurfaceFriction = Annotated[Number, "w_M", "1", "friction of the cones on each other; on the way back −w_M"]
EdgeFriction = Annotated[Number, "w_R", "1", "friction of the edges; on the way back −w_R"]
InnerDiameter = Annotated[Number, "D_i", "m", "inner diameter of a disc"]
SpringForce = Annotated[Number, "F", "N", "force of the spring"]
FreeLength = Annotated[Number, "L_0", "m", "length without load"]
SpringMass = Annotated[Number, "m", "kg", "mass of the spring"]

# Coil springs
ShearModulus = Annotated[Number, "G", "Pa", "shear modulus"]
WireDiameter = Annotated[Number, "d", "m", "wire diameter"]
CoilDiameter = Annotated[Number, "D", "m", "mean diameter of the coil"]
CoilTurns = Annotated[Number, "n", "1", "active coils"]
CoilCorrection = Annotated[Number, "k_τ", "1", "factor of the coil's curvature, 1 under a static load"]
LargestWireDiameter = Annotated[Number, "d", "m", "largest wire diameter"]
EnduredAmplitude = Annotated[Number, "S_sa", "Pa", "amplitude of a shear stress that is borne for ever"]
EnduredMean = Annotated[Number, "S_sm", "Pa", "mean of the shear stress that is borne for ever"]
ShearStrength = Annotated[Number, "S_su", "Pa", "shear strength"]
LowerStress = Annotated[Number, "τ_U", "Pa", "least shear stress of the stroke, with k_τ"]
EnduredStress = Annotated[Number, "S_se", "Pa", "shear stress that alternates about 0 and is borne for ever"]
ModulusRatio = Annotated[Number, "G/E", "1", "shear modulus over Young's modulus"]
SeatingFactor = Annotated[Number, "ν", "1", "factor of the seating, ½ between parallel plates"]
BucklingRoot = Annotated[Number, "q", "1", "what stands under the root in the deflection of buckling"]
