//! From a scene to its outcome: a scene is read, planned and solved, its outcome collected and drawn. The command line is a package of its own.

pub mod in_order;
pub mod outcome;
pub mod plan;
pub mod regular_file;
pub mod scene;
pub mod terminal_text;
pub mod threads;

/// Version of this program.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");
/// The commit that was built, `unknown` outside of its repository.
pub const COMMIT: &str = env!("VISCOTACK_COMMIT");
/// What compiled it.
pub const COMPILER: &str = env!("VISCOTACK_COMPILER");
/// Version and commit, as `--version` prints them.
pub const VERSION_AND_COMMIT: &str = concat!(env!("CARGO_PKG_VERSION"), " (", env!("VISCOTACK_COMMIT"), ")");
