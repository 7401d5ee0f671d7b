//! The commands, and nothing else: each reads a scene, asks the plan, and prints.
//!
//! Exit codes: 0 solved, 1 a feature of a figure or a check of `verify` failed, 2 the scene or the call is wrong, 3 no such state exists, 4 the wanted accuracy was not reached.

mod cite;
mod explain;
mod figures;
mod material;
mod new;
mod run;
mod scene_source;
mod units;
mod verify;

use clap::{CommandFactory, Parser, Subcommand};
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// Adhesive contact and fracture of linear viscoelastic solids, from one energy balance at the edge.
#[derive(Debug, Parser)]
#[command(name = "viscotack", version = concat!(env!("CARGO_PKG_VERSION"), " (", env!("VISCOTACK_COMMIT"), ")"), about)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Print a commented scene to start from
    New {
        /// The problem; without it, the problems are listed
        problem: Option<String>,
        /// Write it to a file instead, which must not exist
        #[arg(long, value_name = "FILE")]
        out: Option<PathBuf>,
    },
    /// Solve a scene
    Run {
        #[command(flatten)]
        scene: SceneArguments,
        /// Write summary.json, tables and plots to this folder
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Replace the folder if it exists
        #[arg(long, requires = "out")]
        force: bool,
        /// Print summary.json with all rows instead of the table
        #[arg(long)]
        json: bool,
        /// Draw no plots, whatever the key `plots` of the scene says
        #[arg(long)]
        no_plots: bool,
    },
    /// Say what a scene simulates and leaves out, why, by which method, at what cost; solves nothing
    Explain {
        #[command(flatten)]
        scene: SceneArguments,
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Compute, draw and check the figures of the thesis
    Figures {
        /// Figures (3.2), panels (3.2a) or chapters (3); without any, all
        ids: Vec<String>,
        /// Write tables, plots and a contact sheet to this folder; what it holds already is not computed again
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Only the figures that take little time
        #[arg(long)]
        reduced: bool,
        /// Another manifest of figures than the thesis's
        #[arg(long, value_name = "FILE")]
        manifest: Option<PathBuf>,
    },
    /// Run the studies of convergence, cost, hard cases and effects, and write one readable report; ends with 1 if a check fails
    Verify {
        /// Studies; without any, all
        studies: Vec<String>,
        /// All of it, within an hour, instead of the three minutes of the continuous tests
        #[arg(long)]
        full: bool,
        /// Write report.html and its tables to this folder
        #[arg(long, value_name = "DIR", default_value = "viscotack-report")]
        out: PathBuf,
        /// Replace the folder if it exists
        #[arg(long)]
        force: bool,
    },
    /// Fit or expand a material: table, curves, plots, and a material file that scenes include
    Material {
        /// A CSV file of measured data, or a TOML file with a [material] table
        file: PathBuf,
        /// Put a value into the material, as in --set material.reference_temperature='"20 °C"'; may be repeated
        #[arg(long = "set", value_name = "KEY=VALUE")]
        sets: Vec<String>,
        /// Wanted relative error: of a fit its root mean square, of a law the largest
        #[arg(long)]
        accuracy: Option<String>,
        /// Write material.toml, tables and plots to this folder
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Replace the folder if it exists
        #[arg(long, requires = "out")]
        force: bool,
        /// Print JSON instead of the table
        #[arg(long)]
        json: bool,
    },
    /// List the units that are read, by what they measure, with their size in SI
    Units {
        /// Print JSON
        #[arg(long)]
        json: bool,
    },
    /// Print the JSON schema of a scene, for editors
    Schema,
    /// Print the papers behind what a scene uses, as BibTeX
    Cite {
        /// The scene; without it, all papers
        scene: Option<PathBuf>,
    },
    /// Print completions for a shell
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
}

#[derive(Debug, clap::Args)]
struct SceneArguments {
    /// The scene, a TOML file
    scene: PathBuf,
    /// Put a value into the scene, as in --set crack.speed='"1 mm/s"' or --set sweep.points=20; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    sets: Vec<String>,
}

/// Ends of a command other than success.
enum Failure {
    /// The scene or the call is wrong: exit 2.
    Wrong(String),
}

impl From<crate::scene::SceneError> for Failure {
    fn from(error: crate::scene::SceneError) -> Self {
        Self::Wrong(error.rendered())
    }
}

impl From<crate::plan::RunError> for Failure {
    fn from(error: crate::plan::RunError) -> Self {
        match error {
            crate::plan::RunError::Scene(error) => error.into(),
            other => Self::Wrong(format!("error: {other}\n")),
        }
    }
}

impl From<crate::outcome::folder::FolderError> for Failure {
    fn from(error: crate::outcome::folder::FolderError) -> Self {
        Self::Wrong(format!("error: {error}\n"))
    }
}

impl From<crate::refusal::Refusal> for Failure {
    fn from(refusal: crate::refusal::Refusal) -> Self {
        Self::Wrong(format!("error: {refusal}\n"))
    }
}

/// Runs the command line.
#[must_use]
pub fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let result = match arguments.command {
        Command::New { problem, out } => new::new(problem.as_deref(), out.as_deref()),
        Command::Run { scene, out, force, json, no_plots } => run::run(&scene, &run::Wanted { out: out.as_deref(), force, json, no_plots }),
        Command::Explain { scene, json } => explain::explain(&scene, json),
        Command::Figures { ids, out, reduced, manifest } => {
            figures::figures(&crate::figures::Options { ids, out, reduced }, manifest.as_deref())
        }
        Command::Verify { studies, full, out, force } => verify::verify(&studies, full, &out, force),
        Command::Material { file, sets, accuracy, out, force, json } => {
            let accuracy = accuracy.as_deref();
            material::material(&material::Asked { file: &file, sets: &sets, accuracy, out: out.as_deref(), force, json })
        }
        Command::Units { json } => units::units(json),
        Command::Schema => print(&format!("{:#}\n", crate::scene::schema::schema())).map(|()| 0),
        Command::Cite { scene } => cite::cite(scene),
        Command::Completions { shell } => {
            let mut bytes = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "viscotack", &mut bytes);
            print(&String::from_utf8_lossy(&bytes)).map(|()| 0)
        }
    };
    match result {
        Ok(code) => ExitCode::from(code),
        Err(Failure::Wrong(message)) => {
            let _ = std::io::stderr().write_all(message.as_bytes());
            ExitCode::from(2)
        }
    }
}

/// Writes to standard output; a reader that has gone away (`| head`) is no error, a full disk is.
fn print(text: &str) -> Result<(), Failure> {
    print_with(|out| out.write_all(text.as_bytes()))
}

/// Prints piece by piece; a reader that closes the pipe early is no error.
fn print_with(write: impl FnOnce(&mut dyn Write) -> std::io::Result<()>) -> Result<(), Failure> {
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    match write(&mut out).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::Wrong(format!("error: standard output cannot be written: {error}\n")))
        }
        _ => Ok(()),
    }
}
