//! The command line of viscotack.

fn main() {}
