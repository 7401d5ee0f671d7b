//! Any bytes, given as a scene: an answer, never a panic.
//!
//! ```sh
//! rustup toolchain install nightly && cargo install cargo-fuzz
//! mkdir -p fuzz/corpus/scene && cp scenes/*/*.toml fuzz/corpus/scene/
//! cargo +nightly fuzz run scene -- -max_total_time=600
//! ```
//! The same way as `tests/scene/bytes_mutated.rs`, which runs on stable Rust.
#![no_main]

use libfuzzer_sys::fuzz_target;
use viscotack_verification::studies::scene_bytes::{Answer, answered};

fuzz_target!(|bytes: &[u8]| {
    if let Answer::Refused(sentence) | Answer::Wrong(sentence) = answered(bytes) {
        assert!(!sentence.is_empty());
    }
});
