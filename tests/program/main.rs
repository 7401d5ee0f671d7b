//! The program: commands, files, predictions, pages, the layers of the source.
#![allow(missing_docs)]

#[path = "../bad_input/mod.rs"]
mod bad_input;
#[path = "../command_support/mod.rs"]
mod command_support;

mod architecture;
mod cli_bad_input;
mod cli_commands;
mod cli_kill_and_resume;
mod cli_safety;
mod cli_shards;
mod cli_shells;
mod cli_sweeps;
mod cli_verify;
mod documentation;
mod edges_of_three_problems;
mod explain_predicts_memory;
mod explain_predicts_work;
mod inadmissible_is_never_solved;
mod plot_rendering;
