//! One scene of the grammar: its text, and its rows at an accuracy.

use super::super::draw::Draw;
use super::text::{Accuracies, Text, quoted};
use super::{crack, delayed, indentation, sliding, surface};
use std::path::Path;
use viscotack_program::outcome::Outcome;
use viscotack_program::plan;
use viscotack_program::scene::diagnostic::SourceText;
use viscotack_program::scene::{Document, read};

/// A problem of the catalogue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Problem {
    /// A crack of a speed or a load.
    SteadyCrack,
    /// A crack under a history.
    DelayedFracture,
    /// A sliding wave or cylinder.
    Sliding,
    /// A sliding surface that acts at a distance.
    Surface,
    /// An indenter.
    Indentation,
}

impl Problem {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::SteadyCrack, Self::DelayedFracture, Self::Sliding, Self::Surface, Self::Indentation];

    /// Its name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::SteadyCrack => "steady crack",
            Self::DelayedFracture => "crack under a history",
            Self::Sliding => "sliding",
            Self::Surface => "sliding surface",
            Self::Indentation => "indentation",
        }
    }

    const fn stream(self) -> u64 {
        match self {
            Self::SteadyCrack => 0x11,
            Self::DelayedFracture => 0x12,
            Self::Sliding => 0x13,
            Self::Indentation => 0x14,
            Self::Surface => 0x15,
        }
    }

    const fn accuracies(self) -> Accuracies {
        match self {
            Self::SteadyCrack => ([1e-3, 1e-6, 1e-9, 1e-12], 1e-15),
            Self::DelayedFracture => ([1e-2, 1e-3, 1e-4, 3e-4], 1e-6),
            Self::Sliding => ([1e-3, 1e-6, 1e-8, 1e-10], 1e-13),
            Self::Indentation => ([1e-2, 1e-3, 1e-4, 1e-5], 1e-8),
            Self::Surface => ([0.1, 5e-2, 4e-2, 3e-2], 1e-5),
        }
    }
}

/// A scene that was drawn, with all but its accuracy.
#[derive(Debug, Clone)]
pub struct Drawn {
    /// Of which problem.
    pub problem: Problem,
    /// Its text.
    pub text: String,
    /// Files that it names.
    pub files: Vec<(String, String)>,
    /// The accuracy that is asked for.
    pub accuracy: f64,
    /// That of the truth.
    pub tight: f64,
}

/// The scene of a number, written in the units of a number.
#[must_use]
pub fn drawn(seed: u64, problem: Problem, scene: u64, units: u64) -> Drawn {
    let seed = seed ^ problem.stream();
    let mut text = Text::new(Draw::of(seed, scene), Draw::of(seed ^ 0x5500, scene ^ (units << 40)));
    if text.chance(0.2) {
        text.put("title", quoted("drawn"));
    }
    match problem {
        Problem::SteadyCrack => crack::write(&mut text),
        Problem::DelayedFracture => delayed::write(&mut text),
        Problem::Sliding => sliding::write(&mut text),
        Problem::Surface => surface::write(&mut text),
        Problem::Indentation => indentation::write(&mut text),
    }
    if text.reduced {
        text.put("units", quoted("reduced"));
    } else if text.chance(0.2) {
        text.put("units", quoted("si"));
    }
    let (accuracies, floor) = text.accuracies.unwrap_or(problem.accuracies());
    let accuracy = accuracies.get(text.draw.below(accuracies.len())).copied().unwrap_or(1e-3);
    if text.chance(0.1) {
        let plots = text.word(&["svg", "png"]);
        text.put("plots", format!("[\"{plots}\"]"));
    }
    let (text, files) = text.written();
    Drawn { problem, text, files, accuracy, tight: (1e-3 * accuracy).max(floor) }
}

impl Drawn {
    /// The scene as a document.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn document(&self, accuracy: f64) -> Result<Document, String> {
        let text = format!("accuracy = {accuracy:e}\n{}", self.text);
        let mut document = Document::parse("scene.toml", text, Path::new("/nowhere")).map_err(|error| error.to_string())?;
        for (name, text) in &self.files {
            document.attach(name, SourceText::new(name, text.clone()));
        }
        read::resolve_includes(&mut document).map_err(|error| error.to_string())?;
        Ok(document)
    }

    /// Its rows at the accuracy of the truth; those of a sliding surface on finer grids, too.
    ///
    /// # Errors
    /// What is wrong with the scene.
    pub fn solved_tightly(&self) -> Result<Outcome, String> {
        let finer = match self.problem {
            Problem::Surface => Self { text: surface::on_finer_grids(&self.text), ..self.clone() },
            _ => self.clone(),
        };
        finer.solved(self.tight)
    }

    /// Its rows at an accuracy.
    ///
    /// # Errors
    /// What is wrong with the scene.
    pub fn solved(&self, accuracy: f64) -> Result<Outcome, String> {
        let document = self.document(accuracy)?;
        let scene = read::read(&document).map_err(|error| error.to_string())?;
        plan::run(&document, &scene, Vec::new(), None, &|_| {}).map_err(|error| error.to_string())
    }
}
