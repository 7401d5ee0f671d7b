//! The command line of viscotack.

fn main() -> std::process::ExitCode {
    viscotack::cli::main()
}
