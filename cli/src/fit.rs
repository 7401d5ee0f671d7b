//! `viscotack fit`: numbers of a scene from measured curves.

use super::scene_source::document;
use super::{Failure, SceneArguments, print, print_json};
use std::path::Path;
use viscotack_program::outcome::folder::{writable, write_whole};
use viscotack_program::outcome::plot;
use viscotack_program::plan::fit::{Found, Setup, carry_out, fitted_scenes, further, models, screen, summary, tables};

/// What the command is asked.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asked<'a> {
    pub(super) out: Option<&'a Path>,
    pub(super) force: bool,
    pub(super) models: bool,
    pub(super) plan: bool,
    pub(super) json: bool,
}

pub(super) fn fit(arguments: &SceneArguments, asked: &Asked<'_>) -> Result<u8, Failure> {
    arguments.threads.start();
    let (mut document, _) = document(arguments)?;
    let setup = Setup::new(&mut document)?;
    if let Some(target) = asked.out {
        // What cannot be written is not computed.
        writable(target, asked.force)?;
    }
    let fit = carry_out(setup.clone())?;
    let found = Found {
        models: if asked.models { models(&setup, &fit) } else { Vec::new() },
        further: if asked.plan { further(&fit) } else { Vec::new() },
        fit,
    };
    let fit = &found.fit;
    let code = if fit.is_sound() { 0 } else { 4 };
    let written = asked.out.map(|target| write(&found, target, asked.force).map(|names| (target, names))).transpose();
    let printed = if asked.json {
        print_json(|out| write!(out, "{:#}", summary(&found)))
    } else {
        print(&screen(&found)).and_then(|()| match &written {
            Ok(Some((target, names))) => {
                print(&format!("\nwrote      {}: {}\n", viscotack_program::terminal_text::name(target), names.join(", ")))
            }
            Ok(None) => {
                print("\n(nothing written; add --out DIR for summary.json, residuals, plots and the scene with the fitted values)\n")
            }
            Err(_) => Ok(()),
        })
    };
    written?;
    printed?;
    Ok(code)
}

/// Writes all files in one step; gives their names.
fn write(found: &Found, target: &Path, force: bool) -> Result<Vec<String>, Failure> {
    let fit = &found.fit;
    let wrong = |what: &str, error: &dyn std::fmt::Display| Failure::Wrong(format!("error: {what} cannot be written: {error}\n"));
    let mut files = vec![("summary.json".to_owned(), format!("{:#}\n", summary(found)).into_bytes())];
    files.extend(fitted_scenes(fit));
    files.extend(tables(fit).map_err(|error| wrong("a table", &error))?);
    for (stem, figure) in fit.figures() {
        match plot::svg(&figure) {
            Ok(svg) => files.push((format!("{stem}.svg"), svg.into_bytes())),
            Err(plot::PlotError::NotBuilt) => {}
            Err(error) => return Err(wrong(&stem, &error)),
        }
    }
    write_whole(target, force, "fit", &files)?;
    Ok(files.into_iter().map(|(name, _)| name).collect())
}
