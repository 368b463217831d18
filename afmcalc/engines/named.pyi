# ruff: noqa: E501
"""Quantities by name. AFMCALC_UPDATE=1 pytest tests/engines/test_laws.py writes this file from equations/terms.txt."""

from typing import Any

from ..equations.arrays import Values

class Named:
    accuracy_factor: Values  # K_т, 1: accuracy factor
    accuracy_factor_by_ratios: Values  # K_т, 1: accuracy factor
    accuracy_factor_actual: Values  # K_т,act, 1: actual accuracy factor with the published T_ср, S22 (19)
    accuracy_factor_as_set: Values  # K_т, 1: accuracy factor of a control spring set by S21 (14)
    accuracy_factor_equilibrium: Values  # K_т,eq, 1: accuracy factor with the equilibrium torque
    accuracy_factor_expected: Values  # K_т,exp, 1: expected accuracy factor, S22 (18)
    accuracy_factor_hysteresis: Values  # K_т,h, 1: accuracy factor under a load that lasts, T_max/T_ret,min
    accuracy_factor_of_path: Values  # K_т, 1: accuracy factor along the common path of f_1 and f_2
    accuracy_factor_peak: Values  # K_т,p, 1: accuracy factor by breakaway peaks (upper bound)
    accuracy_factor_worst_case: Values  # K_т,w, 1: accuracy factor, f_1 of the bypass and f_2 of the other pairs independent
    actuation_factor: Values  # A, 1: published over expected actuation torque
    actuation_torque_equilibrium: Values  # T_eq, N*m: actuation torque at equilibrium, without misprint M12
    actuation_torque_max: Values  # T_act, N*m: the larger of T_ср and T_муф at f_max
    actuation_torque_published: Values  # T_ср, N*m: actuation torque as published, S22 (14)
    allowable_contact_force: Values  # [F_n], N: allowable normal force on one ball
    allowable_pressure: Values  # p_0,allow, Pa: allowable maximum contact pressure
    allowable_pressure_static: Values  # p_s, Pa: contact pressure at the static limit
    balance: Any  # balance of the forces on the sleeve
    ball_bore: Values  # 2r − d_ш, m: diameter of the circle inside the balls
    ball_circle_radius: Values  # r, m: radius of the ball circle
    ball_diameter: Values  # d_ш, m: ball diameter
    ball_diameter_needed: Values  # 2 r_ш, m: smallest ball diameter
    ball_diameter_standard: Values  # d_ш, m: ball chosen: given, or the next standard one
    ball_modulus: Values  # E_1, Pa: elastic modulus of the ball
    ball_pitch: Values  # t_ш, m: distance between the centres of neighbouring balls
    ball_poisson: Values  # ν_1, 1: Poisson's ratio of the ball
    ball_radius: Values  # r_ш, m: smallest ball radius needed
    ball_radius_chosen: Values  # r_ш, m: radius of the ball chosen
    balls: Values  # n, 1: number of balls
    balls_listed: Values  # , m: diameters of balls to choose from
    base_cycles: Values  # N_0, 1: base cycles of the S-N line
    bend_of_path: Values  # s_cp, 1: share of the common path at which both frictions have their means
    breakaway_torque: Values  # P, N*m: breakaway torque, upper bound
    breakdown_torque: Values  # M_b, N*m: breakdown torque of the motor
    bypass_pairs: Values  # z_1, 1: pairs that bypass the control unit
    can_hold_torque: Any  # whether there is a wall that holds the torque
    circumferential_force: Values  # F_o, N: circumferential force on all the balls
    closing_disc: Any  # disc springs of the closing spring
    closing_force: Values  # F_п, N: closing-spring force as set
    closing_force_by_mean: Values  # F_п,2, N: closing-spring force set at the mean friction, with margin
    closing_force_by_min: Values  # F_п,1, N: closing-spring force set at f_min
    closing_spring: Any  # closing spring as it is set
    closing_stiffness: Values  # c_1, N/m: stiffness of the closing spring
    constant_torque_slope: Values  # C_1*, 1/m: growth of the gain with travel at which pockets hold the torque
    contact_force: Values  # F_n, N: largest normal force on one ball
    contact_force_at_ball: Values  # F_n, N: normal force on one ball
    contact_force_hertz: Values  # [F_n]_H, N: normal force on one ball at the allowable contact pressure
    contact_modulus: Values  # E_c, Pa: contact modulus of ball and wall
    contact_pressure: Values  # p_0, Pa: largest contact pressure of ball and wall (Hertz)
    contact_pressure_at_ball: Values  # p_0, Pa: largest contact pressure where the ball is
    contact_radius_at_ball: Values  # R_e, m: radius of a ball that bears as much on a flat
    control_disc: Any  # disc springs of the control spring
    control_force: Values  # F_п2, N: control-spring force as set
    control_force_back: Values  # F_2(x), N: control-spring force where the sleeve is, friction falling under load
    control_force_made: Values  # F_п2, N: control-spring force as made
    control_force_set: Values  # F_п2, N: control-spring force that just holds the sleeve at its stop at the setting
    control_force_there: Values  # F_2(x), N: control-spring force where the sleeve is
    control_spring: Any  # control spring as it is set
    control_stiffness: Values  # c_2, N/m: stiffness of the control spring
    controlled_pairs: Values  # z_2, 1: pairs whose torque passes the balls
    conventional_accuracy_factor: Values  # K_т,0, 1: accuracy factor of an ordinary clutch in its place
    cos_wall_angle: Values  # cos α, 1: cosine of the wall angle
    counted_damage: Values  # D, 1: damage of a slip as far as it counts
    cycles: Values  # N_ц, 1: cycles to failure of the side that fails first
    cycles_extrapolated: Values  # N_ц, 1: cycles to failure
    cycles_of_band: Values  # N_ц, 1: cycles to failure
    cycles_of_fatigue: Values  # N_ц, 1: cycles to failure
    cycles_of_line: Values  # N_ц, 1: cycles to failure
    cycles_of_mean_damage: Values  # N_ц, 1: cycles to failure
    cycles_of_side: Values  # N_ц, 1: cycles to failure
    damage: Values  # 1/N_ц, 1: damage of one cycle
    damaging_stress: Values  # τ_eq, Pa: damaging stress
    disc_bore: Values  # 2 r_i, m: inner diameter of the friction surface
    discriminant: Values  # D, 1: discriminant of S22 (17)
    distance_to_gain_limit: Values  # δ_1, 1: distance of the loop gain of the bypass pairs from its limit
    drive_efficiency: Values  # η, 1: efficiency between motor and clutch
    drive_ratio: Values  # i, 1: speed of the motor over that of the clutch
    driven_torque: Values  # T_2, N*m: torque of the controlled pairs, which passes the balls
    driven_torque_max: Values  # T_2,max, N*m: largest torque that passes the balls
    driving_torque: Values  # T_1, N*m: torque of the bypass pairs
    dynamic_factor: Values  # k_д, 1: dynamic factor by which the unprotected side is loaded more
    edge_clearance: Values  # y, m: clearance asked for
    edge_clearance_standard: Values  # y_st, m: clearance with the ball chosen
    endless: Values  # ∞, 1: no limit
    endurance_limit: Values  # τ_limb, Pa: endurance limit
    equivalent_gain: Values  # C_eff, 1: gain of the all-driving clutch with the same torque curve
    expected_torque: Values  # T_муф, N*m: expected slip torque; lower bound of the tripping torque
    exponent: Values  # m_τ, 1: exponent of the S-N line
    extreme_points: Any  # torques and frictions among which are the extremes
    face_gap: Values  # s, m: gap between the faces
    force_bypass_first: Values  # N_1, N: normal force under T_н.маш, the bypass pairs carrying first
    force_ratio: Values  # F_п1/F_п2, 1: spring force set at f_min over that set at the mean friction, without margin
    friction: Values  # f, 1: coefficient of friction
    friction_along_wall: Values  # f_w, 1: frictions at which the ball comes along the wall
    friction_at_equal_potential: Values  # f_low, 1: friction at which T_п = T_н.маш
    friction_at_unit_loop_gain: Values  # f_high, 1: friction at which v = 1
    friction_between: Values  # f_turn, 1: friction (f_1) where the torque may turn within the range
    friction_bound: Values  # f_lim, 1: friction below which S22 (10) is positive
    friction_driven: Values  # f_2, 1: friction of the driven pairs
    friction_driven_least: Values  # f_2,0, 1: friction of the controlled pairs that the path begins with
    friction_driven_max: Values  # f_2max, 1: largest friction of the controlled pairs
    friction_driven_mean: Values  # f_2cp, 1: mean friction of the controlled pairs
    friction_driven_min: Values  # f_2min, 1: smallest friction of the controlled pairs
    friction_driven_set: Values  # f_2set, 1: friction of the controlled pairs at the setting
    friction_driven_slips: Values  # f_2, 1: friction of the controlled pairs in each slip
    friction_driving: Values  # f_1, 1: friction of the driving pairs
    friction_driving_least: Values  # f_1,0, 1: friction of the bypass pairs that the path begins with
    friction_driving_max: Values  # f_1max, 1: largest friction of the bypass pairs
    friction_driving_mean: Values  # f_1cp, 1: mean friction of the bypass pairs
    friction_driving_min: Values  # f_1min, 1: smallest friction of the bypass pairs
    friction_driving_set: Values  # f_1set, 1: friction of the bypass pairs at the setting
    friction_driving_slips: Values  # f_1, 1: friction of the bypass pairs in each slip
    friction_leaving: Values  # f_L, 1: friction at which the sleeve leaves its stop
    friction_leaving_made: Values  # f_L, 1: friction at which the sleeve leaves its stop
    friction_leaving_from_mean: Values  # f_L, 1: friction from the mean on at which the sleeve leaves its stop
    friction_leaving_in_range: Values  # f_L, 1: friction within the range at which the sleeve leaves its stop
    friction_max: Values  # f_max, 1: largest coefficient of friction
    friction_mean: Values  # f_cp, 1: mean coefficient of friction
    friction_min: Values  # f_min, 1: smallest coefficient of friction
    friction_of_torque_max: Values  # f(T_max), 1: friction (f_1) where it is largest
    friction_of_torque_min: Values  # f(T_min), 1: friction (f_1) where it is smallest
    friction_ratio_max: Values  # n, 1: f_2max/f_1max
    friction_ratio_min: Values  # p, 1: f_2min/f_1min
    friction_set: Values  # f_set, 1: friction at the setting (f_min or f_cp)
    friction_slips: Values  # f, 1: friction in each slip
    friction_slips_least: Values  # f_0, 1: smallest friction of the slips
    friction_unlocking: Values  # f_u, 1: friction at which the key lets the sleeve go
    gain: Values  # C, 1: feedback gain
    gain_acting: Values  # C(x), 1: gain where the sleeve has travelled to
    gain_limit: Values  # C_max, 1: largest gain at which the law describes the slip
    gain_slope: Values  # C_1, 1/m: how the gain grows with the sleeve's travel
    gain_threshold: Values  # 2R f_1/d, 1: gain at which feedback begins
    hub_diameter: Values  # d, m: hub diameter at the key
    hysteresis_ratio: Values  # κ₊/κ, 1: factor by which friction must fall before the sleeve moves back
    inner_radius: Values  # r_i, m: inner radius of the friction surface
    is_broken: Any  # whether the largest load breaks the part
    is_endless: Any  # whether fatigue sets no limit
    is_held_at_stop: Any  # whether the control spring keeps the sleeve at its stop
    is_locked: Any  # whether the key keeps the sleeve where it was at f_max
    is_made: Any  # whether the control spring has a force of its own
    is_reseated: Any  # whether the sleeve is back at its stop
    is_seated: Any  # whether the sleeve is at its stop
    jumping_slope: Values  # C_1,j, 1/m: growth of the gain with travel above which the sleeve jumps off its stop
    key_friction: Values  # f_1, 1: friction coefficient at the key
    key_friction_force: Values  # F_тр, N: friction force of the key on the sleeve
    largest_driven_torque: Values  # T, N*m: torque that passes the balls
    lining: Values  # s_w, m: thickness of lining that a pair may lose by wear
    load_factor: Values  # k, 1: factor of the load: 1, or the dynamic factor
    load_rise: Values  # ΔT', N*m: load rise until slip
    load_rise_max: Values  # ΔT_max, N*m: load rise until slip at f_min
    load_risen: Values  # T_н.маш + ΔT, N*m: load
    loop_gain: Values  # v, 1: loop gain at f
    machine_torque: Values  # T_н.маш, N*m: nominal torque of the machine
    margin: Values  # β_н, 1: torque margin
    margin_in_spring: Values  # β_п, 1: torque margin as far as it is in the spring
    mean_damage: Values  # D_m, 1: mean damage of a slip over f_min … f_max
    mean_diameter: Values  # 2 R_cp, m: mean friction diameter
    mean_pressure: Values  # p, Pa: surface pressure in the mean
    mean_radius: Values  # R_cp, m: mean friction radius
    mean_stress: Values  # τ_m, Pa: mean stress of the cycle
    mean_stress_sensitivity: Values  # ψ_τ, 1: sensitivity to the mean stress (model amplitude)
    mid_torque: Values  # T_mid, N*m: torque at the middle of the band
    motor_power: Values  # P_н, W: rated power of the motor
    motor_speed: Values  # ω_н, rad/s: rated speed of the motor
    motor_torque: Values  # M_н, N*m: rated torque of the motor, P_н/ω_н
    motor_torque_at_clutch: Values  # T_дв, N*m: rated torque of the motor at the clutch
    net_gain: Values  # κ, 1: C − 2 R f_1/d, gain net of the key's friction
    net_gain_acting: Values  # κ, 1: net gain; κ₊ while the sleeve returns
    net_gain_back: Values  # κ₊(x), 1: net gain where the sleeve is, friction falling under load
    net_gain_returning: Values  # κ₊, 1: C + 2 R f_1/d
    net_gain_there: Values  # κ(x), 1: net gain where the sleeve is
    never: Any  # no
    no_slope: Values  # C_1, 1/m: growth of the gain with travel where no wall holds the torque
    nominal_torque: Values  # T_н, N*m: nominal torque of the clutch
    nominal_torque_wanted: Values  # T_н, N*m: nominal torque of the clutch
    nominal_torque_ratio: Values  # K_п, 1: nominal torque over that of a base clutch whose pairs are all controlled, of equal spring force and gain
    normal_force: Values  # N, N: normal force on the pairs
    normal_force_moving: Values  # N, N: normal force on the pairs
    normal_force_seated: Values  # N, N: normal force on the pairs
    normal_force_let_go: Values  # N, N: normal force once the key has let the sleeve go
    normal_force_moving_back: Values  # N, N: normal force while the sleeve moves back
    normal_force_returning: Values  # N, N: normal force, friction falling under load
    nothing: Values  # 0, 1: nothing
    onset_torque: Values  # T_1(0), N*m: torque that the bypass pairs carry alone, before the balls take a share
    optimal_reduced_gain: Values  # (zC)_opt, 1: reduced gain with the best accuracy by the published T_ср, 1/f_max; T_eq has no optimum
    outer_diameter: Values  # 2 r_o, m: outer diameter of the friction surface
    outer_radius: Values  # r_o, m: outer radius of the friction surface
    pack_force_at_rest: Values  # N(0), N: force on the pack of the clutch at rest
    pairs: Values  # z, 1: friction pairs
    pairs_threshold: Values  # z_lim, 1: number of pairs above which the band set at f_min is the narrower, S19 (12)
    path_around: Values  # Y, m: centre of the ball, around the circle
    path_steepening: Values  # Y'', 1/m: second derivative of the path of the ball's centre
    peak_pressure: Values  # p_i, Pa: surface pressure at the inner edge
    pocket_depth: Values  # h_1, m: pocket depth to the virtual apex, for the ball chosen (the smallest where none is)
    pocket_depth_cut: Values  # h_c, m: pocket depth to cut: the ball's lowest point, where the walls end
    pocket_depth_from_travel: Values  # h_2, m: pocket depth from the travel
    pocket_width: Values  # b, m: width of the pocket's mouth at the face
    polar_section_modulus: Values  # W_p, m^3: polar section modulus
    potential_torque: Values  # T_п, N*m: potential torque of S22 (22): what the clutch could carry under T_н.маш, all pairs sharing it
    potential_torque_bound: Values  # T_п,max, N*m: upper bound of the trip torque, z R f F_п
    potential_torque_bypass_first: Values  # T_п,1, N*m: potential torque, the bypass pairs carrying first
    potential_torque_gain: Values  # T'_п − T_п, N*m: potential torque above that of the all-driving clutch of equal spring, gain and margin
    potential_torque_risen: Values  # T_п(ΔT), N*m: potential torque under it, S22 (6), (9); at slip it is the load
    reduced_gain: Values  # z_2 C, 1: reduced gain
    reduced_gain_of_pairs: Values  # z C, 1: reduced gain of all pairs
    release_force: Values  # F_p, N: release force
    risen_load: Values  # ΔT, N*m: rise of the load above the nominal torque of the machine
    running_torque: Values  # T_0, N*m: load in rated running
    scatter: Values  # ΔT, N*m: torque scatter band
    scatter_of_one_material: Values  # ΔT, N*m: torque scatter band of one material
    scatter_of_side: Values  # ΔT', N*m: torque scatter band on the side in question
    scatter_ratio: Values  # ΔT_2/ΔT_1, 1: band set at the mean friction over that set at f_min
    service_factor: Values  # K_р, 1: service factor of the machine
    shaft_diameter: Values  # d_в, m: diameter of the shaft
    shear_stress: Values  # τ, Pa: shear stress
    shear_yield_strength: Values  # τ_т, Pa: yield strength in shear
    side_torque: Values  # T', N*m: torque of the side in question
    sin_half_pitch: Values  # sin(π/n), 1: sine of half the pitch angle of n balls
    sin_wall_angle: Values  # sin α, 1: sine of the wall angle
    sleeve_depth: Values  # B, m: thickness, along the axis, of the sleeve the pockets are cut into
    sleeve_stiffness: Values  # D, N/m: stiffness against which the sleeve moves
    sleeve_stiffness_curved: Values  # D', N/m: stiffness that takes the place of D
    sleeve_stiffness_there: Values  # D, N/m: stiffness against which the sleeve moves as it leaves its stop
    slope_feedback: Values  # w, 1/m: feedback that a metre of travel adds, z f C_1
    slope_in_ratio_max: Values  # ∂K_т/∂n, 1: slope of K_т in n = f_2max/f_1max, f_2max moving, F11 (18)
    slope_in_ratio_min: Values  # ∂K_т/∂p, 1: slope of K_т in p = f_2min/f_1min, f_2min moving, F11 (22)
    starting_torque: Values  # T_пуск, N*m: largest torque at the clutch at a direct start
    starting_torque_ratio: Values  # m_п, 1: largest torque of the motor at the start over its rated torque
    static_safety: Values  # s_0, 1: static safety factor of the balls
    stays_off: Any  # whether a sleeve that has jumped off its stop has not yet jumped back
    stop_reaction: Values  # S, N: reaction of the stop on the sleeve
    stop_reaction_seated: Values  # S, N: reaction of the stop on the sleeve
    stress_amplitude: Values  # τ_a, Pa: amplitude of the cycle
    stress_high: Values  # τ_max, Pa: largest stress of the cycle
    stress_low: Values  # τ_min, Pa: smallest stress of the cycle
    tan_wall_angle: Values  # tan α, 1: wall angle from the axis
    tan_wall_angle_at_ball: Values  # tan α, 1: tangent of the wall angle where the ball is
    tangent_stiffness: Values  # k_t, N/m: stiffness of the balance where the sleeve is; D of a straight pocket
    tangent_stiffness_squared: Values  # k_t², N^2/m^2: square of the stiffness of the balance where the sleeve is
    torque: Values  # T, N*m: slip torque
    torque_asked_for: Values  # T_маш, N*m: torque that the machine asks for
    torque_between: Values  # T_turn, N*m: slip torque where it may turn within the range
    torque_high: Values  # T_high, N*m: largest torque of the load
    torque_low: Values  # T_low, N*m: smallest torque of the load
    torque_low_of_side: Values  # T_min, N*m: smallest torque of the load on the side in question
    torque_max: Values  # T_max, N*m: largest slip torque
    torque_max_from_mean: Values  # T_max,cp, N*m: largest slip torque from the mean friction on
    torque_max_worst_case: Values  # T_max,w, N*m: largest slip torque, f_1 and f_2 independent
    torque_min: Values  # T_min, N*m: smallest slip torque
    torque_min_from_mean: Values  # T_min,cp, N*m: smallest slip torque from the mean friction on
    torque_min_worst_case: Values  # T_min,w, N*m: smallest slip torque, f_1 and f_2 independent
    torque_per_force: Values  # a, m: slip torque per spring force
    torque_returning: Values  # T_ret, N*m: slip torque, friction falling again from f_max under load
    torque_returning_min: Values  # T_ret,min, N*m: smallest slip torque, friction falling under load
    torque_returning_turn: Values  # T_ret, N*m: smallest torque while the sleeve returns
    travel: Values  # x, m: axial travel of the sleeve
    travel_as_made: Values  # x, m: axial travel of the sleeve
    travel_as_set: Values  # x, m: axial travel of the sleeve
    travel_max: Values  # x_max, m: largest travel of the sleeve
    travel_moving: Values  # x, m: axial travel of the sleeve off its stop
    travel_returning: Values  # x, m: axial travel of the sleeve, friction falling under load
    travel_to_mouth: Values  # ξ_m, m: travel at which the ball would touch the edge of the pocket
    trip_ratio_max: Values  # k_max, 1: largest trip torque over the rated torque
    trip_ratio_min: Values  # k_min, 1: least trip torque over the rated torque
    trip_ratio_ordinary: Values  # k_о, 1: largest trip torque of an ordinary clutch in its place over the rated torque
    turning_points: Any  # points of smallest and largest torque while the sleeve moves
    turning_points_from_mean: Any  # the same from the mean friction on
    ultimate_strength: Values  # τ_u, Pa: ultimate strength in shear
    undercut_radius: Values  # ρ_0, m: radius of a ball that undercuts the curved wall: all smaller ones run on it
    unity: Values  # 1, 1: one
    wall_angle: Values  # α, rad: wall angle of the pockets; of a curved wall at the stop
    wall_angle_at_ball: Values  # α, rad: wall angle where the ball is
    wall_angle_max: Values  # α_max, rad: wall angle at the largest travel
    wall_around: Values  # Y_w, m: wall, around the circle
    wall_axial: Values  # ξ_w, m: wall, along the axis
    wall_modulus: Values  # E_2, Pa: elastic modulus of the pocket wall
    wall_poisson: Values  # ν_2, 1: Poisson's ratio of the pocket wall
    wear_play: Values  # w_z, m: play that the ball needs for the wear of the pack
    web: Values  # e, m: web between neighbouring pockets at the face
    yield_strength: Values  # σ_т, Pa: yield strength of the shaft in tension
