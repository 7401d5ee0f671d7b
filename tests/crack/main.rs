//! Steady and delayed cracks.
#![allow(missing_docs)]

#[path = "../support/mod.rs"]
mod support;

mod errata_sec_5_4;
mod fig_5_3_persson_brener;
mod fig_5_5_cohesive_zone;
mod sec_5_2_5_3_raw_double_integrals;
mod sec_5_2_limits_and_monotone;
mod sec_5_2_tip_fields;
mod sec_5_4_events_and_accuracy;
mod sec_5_4_load_histories;
mod sec_5_4_never_nan_never_hangs;
mod sec_5_4_one_term_and_delay_times;
mod sec_5_4_order_after_a_start;
mod sec_5_4_slow_loads;
