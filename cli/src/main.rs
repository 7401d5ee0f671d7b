//! The commands, and nothing else: each reads a scene, asks the plan, and prints.
//!
//! Exit codes: 0 solved, 1 a feature of a figure or a check of `verify` failed, 2 the scene or the call is wrong, 3 no such state exists, 4 the wanted accuracy was not
//! reached, 5 the machine refuses: a full disk, no permission.

mod cite;
mod explain;
mod figures;
mod fit;
mod interrupt;
mod material;
mod new;
mod output;
mod run;
mod scene_source;
mod shards;
mod units;
mod verify;

use clap::{CommandFactory, Parser, Subcommand};
use output::{note, print, print_json};
use std::path::PathBuf;
use std::process::ExitCode;
use viscotack_program::outcome::shard::Shard;

/// Adhesive contact and fracture of linear viscoelastic solids, from one energy balance at the edge.
#[derive(Debug, Parser)]
#[command(name = "viscotack", version = viscotack_program::VERSION_AND_COMMIT, about)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// How an error is written to standard error: for people, or as one line of JSON for programs
    #[arg(long, global = true, value_enum, default_value_t, value_name = "FORM", hide_possible_values = true)]
    errors: ErrorForm,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum)]
enum ErrorForm {
    #[default]
    Text,
    Json,
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
        /// Solve only the states whose number is i modulo n, counted from 0, for `viscotack gather`: many machines share a sweep
        #[arg(long, value_name = "i/n", requires = "out", conflicts_with_all = ["json", "no_plots"])]
        shard: Option<Shard>,
    },
    /// Bring the shards of a sweep together: the same files, to the byte, as one run of all states
    Gather {
        /// The folders of all shards, in any order
        #[arg(required = true, value_name = "DIR")]
        shards: Vec<PathBuf>,
        /// Write summary.json, tables and plots to this folder
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// Replace the folder if it exists
        #[arg(long)]
        force: bool,
        /// Print summary.json with all rows instead of the table
        #[arg(long)]
        json: bool,
        /// Draw no plots, whatever the key `plots` of the scene says
        #[arg(long)]
        no_plots: bool,
        #[command(flatten)]
        threads: ThreadArguments,
    },
    /// Find numbers of a scene from measured curves, as its table [fit] says: values with 95 % intervals, residuals, a scene with them
    Fit {
        #[command(flatten)]
        scene: SceneArguments,
        /// Write summary.json, residuals, plots and the scene with the fitted values to this folder
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Replace the folder if it exists
        #[arg(long, requires = "out")]
        force: bool,
        /// Fit the simpler models that the scene contains, too, and compare them
        #[arg(long)]
        models: bool,
        /// Say which further test would shrink the intervals most
        #[arg(long)]
        plan: bool,
        /// Print summary.json instead of the table
        #[arg(long)]
        json: bool,
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
        /// Compute nothing: write the scenes behind the figures to this folder, for `viscotack run`
        #[arg(long, value_name = "DIR", conflicts_with = "out")]
        scenes: Option<PathBuf>,
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
        /// Compute only the pieces whose number is i modulo n, counted from 0, of studies in pieces (finite_spheres, random_lines): many
        /// evenings share a full run
        #[arg(long, value_name = "i/n", requires = "full")]
        shard: Option<Shard>,
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
    Schema {
        /// Print the page of all keys for people instead
        #[arg(long)]
        markdown: bool,
        /// Print the page of all columns of results instead
        #[arg(long, conflicts_with = "markdown")]
        columns: bool,
    },
    /// Print the papers behind what a scene uses, as BibTeX
    Cite {
        /// The scene, - for standard input; without it, all papers
        scene: Option<PathBuf>,
    },
    /// Print completions for a shell
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Print a manual page, for `man -l`
    Man {
        /// A command; without it, the page of the program
        command: Option<String>,
    },
}

#[derive(Debug, clap::Args)]
struct SceneArguments {
    /// The scene, a TOML file; - reads it from standard input
    scene: PathBuf,
    /// Put a value into the scene, as in --set crack.speed='"1 mm/s"' or --set sweep.points=20; may be repeated
    #[arg(long = "set", value_name = "KEY=VALUE")]
    sets: Vec<String>,
    #[command(flatten)]
    threads: ThreadArguments,
}

#[derive(Debug, Clone, Copy, Default, clap::Args)]
struct ThreadArguments {
    /// Threads that work side by side; without it, one a core. The results do not depend on it, to the byte
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    jobs: Option<u16>,
}

impl ThreadArguments {
    /// Starts the threads; to be called before any work.
    fn start(self) {
        viscotack_program::threads::prepare(self.jobs.map(usize::from));
    }
}

/// Ends of a command other than success.
enum Failure {
    /// The scene is wrong: exit 2.
    Scene(Box<viscotack_program::scene::SceneError>),
    /// The call is wrong: exit 2.
    Wrong(String),
    /// The machine refuses, with the path or the stream that it is about: exit 5.
    Machine(String),
}

impl From<viscotack_program::scene::SceneError> for Failure {
    fn from(error: viscotack_program::scene::SceneError) -> Self {
        Self::Scene(Box::new(error))
    }
}

impl From<viscotack_program::plan::RunError> for Failure {
    fn from(error: viscotack_program::plan::RunError) -> Self {
        match error {
            viscotack_program::plan::RunError::Scene(error) => error.into(),
            viscotack_program::plan::RunError::Refused(refusal) => refusal.into(),
            viscotack_program::plan::RunError::Journal(error) => Self::Machine(format!(
                "error: {error}\nWhat was finished before is kept: once this is mended, the same command goes on from there.\n"
            )),
        }
    }
}

impl From<viscotack_program::outcome::folder::FolderError> for Failure {
    fn from(error: viscotack_program::outcome::folder::FolderError) -> Self {
        let message = format!("error: {error}\n");
        match error {
            viscotack_program::outcome::folder::FolderError::Io { .. } => Self::Machine(message),
            _ => Self::Wrong(message),
        }
    }
}

impl From<viscotack_program::outcome::gather::GatherError> for Failure {
    fn from(error: viscotack_program::outcome::gather::GatherError) -> Self {
        let message = format!("error: {error}\n");
        match error {
            viscotack_program::outcome::gather::GatherError::Io { .. } => Self::Machine(message),
            _ => Self::Wrong(message),
        }
    }
}

impl From<viscotack::refusal::Refusal> for Failure {
    fn from(refusal: viscotack::refusal::Refusal) -> Self {
        Self::Wrong(format!("error: {refusal}\n"))
    }
}

/// Runs the command line.
#[must_use]
pub fn main() -> ExitCode {
    interrupt::limits_are_errors();
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return ended(unparsed(&error), ErrorForm::Text),
    };
    let errors = arguments.errors;
    let result = match arguments.command {
        Command::New { problem, out } => new::new(problem.as_deref(), out.as_deref()),
        Command::Run { scene, out: Some(out), force, shard: Some(shard), .. } => shards::run(&scene, &out, force, shard),
        Command::Run { scene, out, force, json, no_plots, .. } => {
            run::run(&scene, &run::Wanted { out: out.as_deref(), force, json, no_plots })
        }
        Command::Gather { shards, out, force, json, no_plots, threads } => {
            threads.start();
            shards::gather(&shards, &run::Wanted { out: Some(&out), force, json, no_plots })
        }
        Command::Fit { scene, out, force, models, plan, json } => {
            fit::fit(&scene, &fit::Asked { out: out.as_deref(), force, models, plan, json })
        }
        Command::Explain { scene, json } => explain::explain(&scene, json),
        Command::Figures { ids, out, scenes, reduced, manifest } => {
            figures::figures(&viscotack_verification::figures::Options { ids, out, reduced }, scenes.as_deref(), manifest.as_deref())
        }
        Command::Verify { studies, full, shard, out, force } => verify::verify(&studies, full, shard, &out, force),
        Command::Material { file, sets, accuracy, out, force, json } => {
            let accuracy = accuracy.as_deref();
            material::material(&material::Asked { file: &file, sets: &sets, accuracy, out: out.as_deref(), force, json })
        }
        Command::Units { json } => units::units(json),
        Command::Schema { columns: true, .. } => {
            viscotack_program::plan::column_reference::column_reference().map_err(Failure::from).and_then(|page| print(&page)).map(|()| 0)
        }
        Command::Schema { markdown: true, .. } => print(&viscotack_program::scene::key_reference::key_reference()).map(|()| 0),
        Command::Schema { .. } => print(&format!("{:#}\n", viscotack_program::scene::schema::schema())).map(|()| 0),
        Command::Cite { scene } => cite::cite(scene),
        Command::Completions { shell } => {
            let mut bytes = Vec::new();
            clap_complete::generate(shell, &mut Arguments::command(), "viscotack", &mut bytes);
            let values = if shell == clap_complete::Shell::Fish { values_for_fish() } else { String::new() };
            print(&(String::from_utf8_lossy(&bytes).into_owned() + &values)).map(|()| 0)
        }
        Command::Man { command } => man(command.as_deref()),
    };
    ended(result, errors)
}

/// Values of the arguments of each command without a name, which the generator leaves out for fish.
fn values_for_fish() -> String {
    let mut lines = String::new();
    for command in Arguments::command().get_subcommands() {
        for value in command.get_positionals().flat_map(clap::Arg::get_possible_values).filter(|value| !value.is_hide_set()) {
            let (name, value) = (command.get_name(), value.get_name());
            lines += &format!("complete -c viscotack -n \"__fish_viscotack_using_subcommand {name}\" -f -a \"{value}\"\n");
        }
    }
    lines
}

/// The manual page of the program, or of one command.
fn man(command: Option<&str>) -> Result<u8, Failure> {
    let mut program = Arguments::command();
    program.build();
    let page = match command {
        None => program,
        Some(name) => {
            let found = program.find_subcommand(name).ok_or_else(|| Failure::Wrong(format!("error: there is no command `{name}`\n")))?;
            found.clone()
        }
    };
    let mut bytes = Vec::new();
    clap_mangen::Man::new(page).render(&mut bytes).map_err(|error| Failure::Machine(format!("error: {error}\n")))?;
    print(&String::from_utf8_lossy(&bytes)).map(|()| 0)
}

/// Tables and keys of a scene that are easily taken for options of a command.
const KEYS_NOT_OPTIONS: [&str; 4] = ["sweep", "temperature", "title", "units"];

/// What to type in place of an option.
fn set_instead(key: &str) -> &'static str {
    match key {
        "sweep" => "--set 'sweep.key=sliding.speed' --set 'sweep.values=[\"1 mm/s\", \"1 cm/s\"]'",
        "temperature" => "--set 'material.temperature=\"25 °C\"'",
        "title" => "--set 'title=\"my scene\"'",
        _ => "--set units=reduced",
    }
}

/// What clap says: help and version are asked for, anything else is a wrong call. It may quote arguments.
fn unparsed(error: &clap::Error) -> Result<u8, Failure> {
    let mut text = error.render().to_string();
    if let Some(clap::error::ContextValue::String(argument)) = error.get(clap::error::ContextKind::InvalidArg)
        && let Some(key) = KEYS_NOT_OPTIONS.iter().find(|key| argument.trim_start_matches('-').split(['=', ' ']).next() == Some(*key))
    {
        text = format!("error: `{argument}` is not an option: `{key}` belongs to the scene\n\n  help: {}\n", set_instead(key));
    }
    if error.use_stderr() { Err(Failure::Wrong(text)) } else { print(&text).map(|()| 0) }
}

/// The exit code, after the last words.
fn ended(result: Result<u8, Failure>, errors: ErrorForm) -> ExitCode {
    let failure = match result {
        Ok(code) => return ExitCode::from(code),
        Err(failure) => failure,
    };
    let code = if matches!(failure, Failure::Machine(_)) { 5 } else { 2 };
    note(&match (failure, errors) {
        (Failure::Scene(error), ErrorForm::Text) => error.rendered(),
        (Failure::Wrong(message) | Failure::Machine(message), ErrorForm::Text) => message,
        (Failure::Scene(error), ErrorForm::Json) => format!("{}\n", error.report()),
        (Failure::Wrong(message) | Failure::Machine(message), ErrorForm::Json) => {
            let sentence = message.trim_end().trim_start_matches("error: ");
            format!("{}\n", serde_json::json!({ "message": sentence, "text": message }))
        }
    });
    ExitCode::from(code)
}
