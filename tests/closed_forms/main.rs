//! Special functions, closed forms of elastic contact, the energy balance of an edge.
#![allow(missing_docs)]

#[path = "../support/mod.rs"]
mod support;

mod closure_against_reduced_forms;
mod elastic_hertz_johnson_1985_sec_4_2;
mod elastic_jkr_thesis_sec_1_3;
mod elastic_johnson_wave_1995;
mod elastic_kendall_1971;
mod elastic_pure_shear_strip_thesis_5_46;
mod elastic_reference_values;
mod elastic_strip_energy_thesis_5_48;
mod elastic_tabor_thesis_sec_1_3_1;
mod elastic_westergaard_johnson_1985_sec_13_2;
mod special_clausen_mpmath;
mod special_dawson_mpmath;
mod special_memory_clausen_mpmath;
