//! Branches of which there are several: along speeds that of the slow and that of the fast contact; those that a scan of every contact finds isolated from them.
//!
//! | word in the column `branch` | what |
//! |---|---|
//! | slow, fast | along speeds: reaches the smallest or the largest one |
//! | whole | along other parameters: the one that is followed |
//! | isola | closed |
//! | apart | none of these |
//!
//! Further ones of a kind are counted: isola_2 and so on.

use super::SlidingPlan;
use super::branches::{Item, Traced};
use crate::scene::typed::SlidingBranch;
use viscotack::refusal::Refusal;
use viscotack::sliding::branch::{Branch, BranchEnd, BranchPath, BranchProblem, ContactAt, Everywhere, Scan, every_branch, speed_folds};

/// The word of a closed branch.
pub(super) const ISOLA: &str = "isola";

/// Gives each branch a word of its own.
#[derive(Default)]
struct Words(Vec<&'static str>);

impl Words {
    fn of(&mut self, kind: &'static str) -> String {
        self.0.push(kind);
        match self.0.iter().filter(|known| **known == kind).count() {
            1 => kind.to_owned(),
            count => format!("{kind}_{count}"),
        }
    }
}

/// What a branch is, by where it ends.
fn kind(problem: &BranchProblem<'_>, branch: &Branch, followed: bool) -> &'static str {
    let reaches = |rate: f64| [&branch.begins, &branch.ends].contains(&&BranchEnd::Parameter(rate));
    match problem.path {
        _ if branch.ends == BranchEnd::Closed => ISOLA,
        BranchPath::Speeds(_) if reaches(problem.parameters[0]) => "slow",
        BranchPath::Speeds(_) if reaches(problem.parameters[1]) => "fast",
        BranchPath::Speeds(_) => "apart",
        _ if followed => "whole",
        _ => "apart",
    }
}

impl SlidingPlan {
    /// The slow and the fast branch along speeds, and those isolated from them where neither end has a contact.
    pub(super) fn speeds_traced(&self, branch: &SlidingBranch, problem: &BranchProblem<'_>) -> Result<Traced, Refusal> {
        let folds = speed_folds(&self.material, problem)?;
        let gap = folds.no_contact.as_ref().map(|gap| {
            let [slow, fast] = [&gap.lower, &gap.upper].map(|fold| fold.parameter().value * self.scale.length);
            let sure = if gap.closed { "no steady partial contact exists" } else { "no steady partial contact was found" };
            format!("{sure} at speeds between {slow:.6e} and {fast:.6e}")
        });
        let mut traced = Traced { items: Vec::new(), closure_evaluations: folds.scan_evaluations };
        let mut words = Words::default();
        let mut refused = None;
        for (name, end) in [("slow", Some(folds.slow)), ("fast", folds.fast)] {
            match end {
                Some(Ok(found)) => self.collect(&mut traced, branch, problem, found, words.of(name), gap.as_deref()),
                Some(Err(refusal)) => match folds.everywhere {
                    // Isolated branches tell what there is; the limits that the load is beyond are said at the first of them.
                    Some(_) if !folds.isolated.is_empty() => refused = refused.or(Some(refusal)),
                    everywhere => {
                        let found = Err(everywhere.map_or_else(|| refusal.clone(), |everywhere| with_witness(refusal.clone(), everywhere)));
                        traced.items.push(Item { branch: words.of(name).into(), event: "", found, note: None });
                    }
                },
                None => {}
            }
        }
        for found in folds.isolated {
            let word = words.of(kind(problem, &found, false));
            self.collect(&mut traced, branch, problem, found, word, None);
        }
        if let (Some(first), Some(refusal)) = (traced.items.first_mut(), refused) {
            let beyond = format!("neither end of the speeds has a contact, of the slow one: {}", self.sentence(&refusal));
            first.note = Some(first.note.take().map_or_else(|| beyond.clone(), |note| format!("{beyond}; {note}")));
        }
        let left_over: Vec<_> = folds.others.into_iter().map(|(_, contact, refusal)| (contact, refusal)).collect();
        self.leave_over(&mut traced, &left_over);
        Ok(traced)
    }

    /// Every branch that a scan finds, after those that are followed from the ends.
    pub(super) fn every_traced(&self, branch: &SlidingBranch, problem: &BranchProblem<'_>) -> Result<Traced, Refusal> {
        let scan = Scan::of(problem);
        let every = every_branch(&self.material, problem, scan)?;
        let mut traced = Traced { items: Vec::new(), closure_evaluations: every.scan_evaluations };
        if every.branches.is_empty() {
            let reason = match every.left_over.first() {
                Some((_, _, refusal)) => refusal.clone(),
                None => Refusal::NoSuchState {
                    reason: "a scan of every contact finds none".into(),
                    limit_name: "half-widths looked at",
                    limit: scan.half_widths as f64,
                },
            };
            return Err(reason);
        }
        let mut words = Words::default();
        for (index, found) in every.branches.into_iter().enumerate() {
            let word = words.of(kind(problem, &found, index == 0));
            self.collect(&mut traced, branch, problem, found, word, None);
        }
        let left_over: Vec<_> = every.left_over.into_iter().map(|(contact, _, refusal)| (contact, refusal)).collect();
        self.leave_over(&mut traced, &left_over);
        Ok(traced)
    }

    /// One row for the contacts through which no branch was followed.
    fn leave_over(&self, traced: &mut Traced, left_over: &[(ContactAt, Refusal)]) {
        let [(contact, refusal), ..] = left_over else { return };
        let half_width = contact.half_width * self.scale.length;
        let detail = format!(
            "contacts of a scan that lie on no branch that was followed: {}; of the first, of half-width {half_width:.4e}: {refusal}",
            left_over.len()
        );
        let found = Err(Refusal::NotConverged { what: "a branch of its own", detail });
        traced.items.push(Item { branch: "apart".into(), event: "", found, note: None });
    }
}

/// A refusal with what a scan of all speeds has seen besides.
fn with_witness(refusal: Refusal, Everywhere { scan: Scan { half_widths, parameters }, contacts }: Everywhere) -> Refusal {
    let seen = if contacts == 0 {
        format!("a scan finds no steady partial contact at any of {parameters} speeds and {half_widths} half-widths at each")
    } else {
        format!("a scan of {parameters} speeds finds contacts: {contacts}")
    };
    match refusal {
        Refusal::NoSuchState { reason, limit_name, limit } => {
            Refusal::NoSuchState { reason: format!("{reason}; {seen}"), limit_name, limit }
        }
        Refusal::NotConverged { what, detail } => Refusal::NotConverged { what, detail: format!("{detail}; {seen}") },
        other => other,
    }
}
