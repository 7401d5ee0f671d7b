//! Indentation in time.
#![allow(missing_docs)]

#[path = "../support/mod.rs"]
mod support;

mod after_turns;
mod annuli_reference;
mod approach;
mod bounds_without_adhesion;
mod by_panels;
mod by_panels_against_time_steps;
mod by_panels_checkpoints;
mod by_panels_histories;
mod by_panels_shapes;
mod checkpoints;
mod closure_and_states;
mod controls;
mod edge_law;
mod energies;
mod error_bounds;
mod features_converge;
mod fields;
mod measured_scans;
mod never_stalls;
mod oscillations;
mod periodic;
mod prescribed_edge;
mod profile_table;
mod quick_edges;
mod reference_values;
mod retraction;
mod rim;
mod sec_4_3_rival;
mod states_of_events;
mod sudden_loads;
mod wide_spectra;
mod without_adhesion;
mod without_adhesion_controls;
mod without_adhesion_random_scenes;
mod work_counters;
