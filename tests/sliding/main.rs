//! Steady sliding with an adhesive edge, or none.
#![allow(missing_docs)]

#[path = "../support/mod.rs"]
mod support;

mod errata_chapter_3;
mod fig_2_4_green;
mod friction_parts;
mod layer_factors;
mod sec_1_4_2_two_forces;
mod sec_3_4_branch_hard_cases;
mod sec_3_4_branches;
mod sec_3_4_every_branch;
mod sec_3_contact_by_fourier_symbol;
mod sec_3_equilibrium_limits;
mod sec_3_error_bounds;
mod sec_3_floors;
mod sec_3_held_loads;
mod sec_3_invariances;
mod sec_3_no_contact;
mod sec_3_parabola;
mod sec_3_process_zone;
mod sec_3_reference_values;
mod sec_3_rivals;
mod sec_3_sensitivities;
mod sec_3_speed_path;
mod sec_3_stiff_cylinder;
mod sec_3_wrong_roots;
mod thin_layers;
mod two_works;
