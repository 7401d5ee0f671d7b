//! What scenes say, and what becomes of it.
#![allow(missing_docs)]

#[path = "../command_support/mod.rs"]
mod command_support;
#[path = "../support/mod.rs"]
mod support;

mod axis_units;
mod bytes_mutated;
mod cautions;
mod cycles_at_a_distance;
mod decks;
mod fit_of_scenes;
mod histories;
mod indentation;
mod indentation_edges;
mod indentation_finite_range;
mod indentation_without_adhesion;
mod inputs_of_users;
mod instants_after_a_long_rest;
mod liquids;
mod material;
mod material_uncertainty;
mod nothing_given_is_ignored;
mod oscillations;
mod protocols;
mod rate_after_another_control;
mod reader_never_panics;
mod record_thinning;
mod records_mutated;
mod sliding_branches;
mod sliding_columns;
mod sliding_full_contact_fields;
mod sliding_on_request;
mod steady_crack_columns;
mod surfaces;
mod tables;
mod two_bodies;
mod units;
mod unknown_keys;
