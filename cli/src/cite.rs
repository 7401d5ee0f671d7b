//! `viscotack cite`: the papers behind what a scene uses.

use super::scene_source::SceneSource;
use super::{Failure, SceneArguments, ThreadArguments, print};
use std::path::PathBuf;
use viscotack_program::plan::Plan;
use viscotack_program::plan::citations::{ALL, Citation};

pub(super) fn cite(scene: Option<PathBuf>) -> Result<u8, Failure> {
    let papers: Vec<&Citation> = match scene {
        Some(scene) => {
            Plan::new(&SceneSource::load(&SceneArguments { scene, sets: Vec::new(), threads: ThreadArguments::default() })?.scene)?
                .citations()
        }
        None => ALL.to_vec(),
    };
    for paper in papers {
        print(&format!("% {}\n{}\n\n", paper.role, paper.bibtex))?;
    }
    Ok(0)
}
