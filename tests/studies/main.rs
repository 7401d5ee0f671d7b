//! Studies, figures, published numbers.
#![allow(missing_docs)]

#[path = "../support/mod.rs"]
mod support;

mod calibration;
mod effects;
mod figures_of_the_thesis;
mod fit_numbers;
mod hard_cases;
mod held_contacts;
mod orders_and_contests;
mod published_numbers;
mod report;
mod seeded_sweep;
mod whole_grammar;
