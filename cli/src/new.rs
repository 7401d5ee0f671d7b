//! `viscotack new`: a commented scene to start from.

use super::{Failure, print};
use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;
use viscotack_program::scene::diagnostic::nearest;
use viscotack_program::scene::template::{TEMPLATES, template};
use viscotack_program::terminal_text::name as shown;

pub(super) fn new(problem: Option<&str>, out: Option<&Path>) -> Result<u8, Failure> {
    let list = || TEMPLATES.iter().map(|template| format!("  {:16} {}\n", template.name, template.meaning)).collect::<String>();
    let Some(name) = problem else {
        print(&format!("viscotack new PROBLEM, with one of:\n{}", list()))?;
        return Ok(0);
    };
    let Some(found) = template(name) else {
        let meant =
            nearest(name, TEMPLATES.iter().map(|template| template.name)).map_or_else(String::new, |name| format!(" Did you mean {name}?"));
        return Err(Failure::Wrong(format!("error: there is no problem `{name}`.{meant} The problems are:\n{}", list())));
    };
    let Some(path) = out else {
        print(found.text)?;
        return Ok(0);
    };
    let written = OpenOptions::new().write(true).create_new(true).open(path).and_then(|mut file| file.write_all(found.text.as_bytes()));
    match written {
        Ok(()) => {
            print(&format!("wrote {}; now: viscotack run {}\n", shown(path), shown(path)))?;
            Ok(0)
        }
        Err(error) => {
            let message = format!("error: `{}` cannot be written: {error}\n", shown(path));
            Err(if error.kind() == std::io::ErrorKind::AlreadyExists { Failure::Wrong(message) } else { Failure::Machine(message) })
        }
    }
}
