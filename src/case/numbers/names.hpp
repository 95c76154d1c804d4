#pragma once
// Names of numbers that a part of the program asks for by name: to read them back from a result file or a table, or to
// give the column of another table the unit and the meaning of the number. All other names stand only in the records.

namespace ehl::program::id {

// clang-format off
inline constexpr char
    // how a case ended, and the rows of a sweep
    converged[] = "converged", failed_check[] = "failed_check", title[] = "title", status[] = "status",
    exit_status[] = "exit_status", method[] = "method", reason[] = "reason", warnings[] = "warnings",
    seconds[] = "seconds", peak_memory[] = "peak_memory", nx[] = "nx", ny[] = "ny", cycles[] = "cycles",
    work_units[] = "work_units", residual[] = "residual", load_error[] = "load_error",
    // film and pressure
    Hc[] = "Hc", Hm[] = "Hm", error_Hc[] = "error_Hc", error_Hm[] = "error_Hm", mesh_error_Hc[] = "mesh_error_Hc",
    mesh_error_Hm[] = "mesh_error_Hm", Hm_x[] = "Hm_x", Hm_y[] = "Hm_y", Hc_best[] = "Hc_best", error_Hc_best[] = "error_Hc_best", Hm_best[] = "Hm_best",
    error_Hm_best[] = "error_Hm_best", Hm_fitted[] = "Hm_fitted", hc[] = "hc", hm[] = "hm", P_max[] = "P_max",
    error_P_max[] = "error_P_max", p_max[] = "p_max", P_max_converging[] = "P_max_converging",
    domain_error[] = "domain_error", H00[] = "H00", Sq_si[] = "Sq_m", lambda_ratio[] = "lambda_ratio",
    area[] = "area", gap_error[] = "gap_error", deformation[] = "deformation",
    error_map_Hc[] = "error_map_Hc", error_map_Hm[] = "error_map_Hm",
    // scales
    M[] = "M", L[] = "L", p_h[] = "p_h", a[] = "a", h[] = "h", load[] = "load", R[] = "R", u_s[] = "u_s",
    kappa[] = "kappa", angle[] = "angle", radius_ratio[] = "radius_ratio", time[] = "time",
    // effects
    mu[] = "mu", error_mu[] = "error_mu", T_film_max[] = "T_film_max", T1_max[] = "T1_max", T2_max[] = "T2_max",
    heat_1[] = "heat_1", heat_2[] = "heat_2", heat_made[] = "heat_made", heat_carried[] = "heat_carried",
    heat_stored[] = "heat_stored", heat_imbalance[] = "heat_imbalance", supply_ratio[] = "supply_ratio",
    starvation_factor[] = "starvation_factor",
    meniscus_x[] = "meniscus_x", oil_in[] = "oil_in", oil_aside[] = "oil_aside", mass_imbalance[] = "mass_imbalance",
    least_Hc[] = "least_Hc", least_Hm[] = "least_Hm", largest_P_max[] = "largest_P_max", mean_mu[] = "mean_mu",
    least_hc[] = "least_h_c", least_hm[] = "least_h_m",
    completed[] = "completed", ended[] = "ended", speed[] = "speed",
    // friction, also in time
    mu_rolling[] = "mu_rolling", mu_1[] = "mu_1", mu_2[] = "mu_2", mu_cavitated[] = "mu_cavitated",
    mu_beyond[] = "mu_beyond", mu_rolling_beyond[] = "mu_rolling_beyond", mu_side[] = "mu_side",
    largest_shear_stress[] = "largest_shear_stress", limited_share[] = "limited_share",
    slide_roll_ratio[] = "slide_roll_ratio", unlikely_share[] = "unlikely_share", force_1[] = "force_1",
    force_2[] = "force_2", force_side[] = "force_side", friction_power[] = "friction_power",
    // columns of the table of steps, by their paths
    step_time[] = "/transient/time", step_load[] = "/transient/load", step_speed[] = "/transient/speed";
// clang-format on

}  // namespace ehl::program::id
