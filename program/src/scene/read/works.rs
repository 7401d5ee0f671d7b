//! The works of adhesion of [adhesion]: one number, one for each edge, and how they follow the speed of the edge.

use super::section::Section;
use crate::scene::diagnostic::SceneError;
use viscotack::closure::work_by_speed::{WorkAtSpeed, WorkBySpeed};

/// Keys of one work, and of one for each edge.
const WHOLE: &str = "work_of_adhesion";
const PER_EDGE: [&str; 2] = ["trailing_work_of_adhesion", "leading_work_of_adhesion"];

/// Works as given, with the table where they were.
pub(super) struct GivenWorks<'a> {
    table: Section<'a>,
    /// At speed zero, or at the first speed of a table: trailing, leading.
    pub(super) given: [f64; 2],
    /// Whether each edge has its own.
    pub(super) per_edge: bool,
    /// What they are multiplied by.
    pub(super) law: Option<WorkBySpeed>,
}

/// Reads the works of an [adhesion] table.
pub(super) fn read<'a>(top: &Section<'a>) -> Result<Option<GivenWorks<'a>>, SceneError> {
    read_by(top, of_edges)
}

/// The same of an indenter, whose one edge opens and closes: one work may be given, and another one for one way.
pub(super) fn of_indenter<'a>(top: &Section<'a>) -> Result<Option<GivenWorks<'a>>, SceneError> {
    let works = read_by(top, of_either_way)?;
    if let Some(GivenWorks { table, given: [trailing, leading], .. }) = &works
        && leading > trailing
    {
        let key = if table.node().get(PER_EDGE[1]).is_some() { PER_EDGE[1] } else { PER_EDGE[0] };
        let message =
            "`adhesion.leading_work_of_adhesion` is above the trailing work at rest: the edge would close and open at once, without end";
        return Err(table.wrong(key, message, "must be at most the trailing work"));
    }
    Ok(works)
}

fn of_either_way(table: &Section<'_>) -> Result<[f64; 2], SceneError> {
    let given = PER_EDGE.map(|key| table.node().get(key).is_some());
    if table.node().get(WHOLE).is_none() || given[0] == given[1] {
        return of_edges(table);
    }
    let whole = table.required_number(WHOLE)?;
    let [trailing, leading] = PER_EDGE.map(|key| table.number(key));
    Ok([trailing?.unwrap_or(whole), leading?.unwrap_or(whole)])
}

fn read_by<'a>(
    top: &Section<'a>,
    of_edges: impl Fn(&Section<'_>) -> Result<[f64; 2], SceneError>,
) -> Result<Option<GivenWorks<'a>>, SceneError> {
    let Some(table) = top.table("adhesion") else { return Ok(None) };
    let Some(by_speed) = table.table("by_speed") else {
        let given = of_edges(&table)?;
        let per_edge = is_per_edge(&table);
        return Ok(Some(GivenWorks { table, given, per_edge, law: None }));
    };
    let way = by_speed.exactly_one(&["speed", "table"])?;
    if way == "speed" {
        let law = WorkBySpeed::power(by_speed.required_number("speed")?, by_speed.required_number("exponent")?);
        let law =
            law.map_err(|refusal| by_speed.wrong("speed", format!("the law of [adhesion.by_speed] cannot be made: {refusal}"), "here"))?;
        let given = of_edges(&table)?;
        let per_edge = is_per_edge(&table);
        return Ok(Some(GivenWorks { table, given, per_edge, law: Some(law) }));
    }
    by_speed.without(&["exponent"], "a law with a reference speed")?;
    if let Some(key) = [WHOLE, PER_EDGE[0], PER_EDGE[1]].into_iter().find(|key| table.node().get(key).is_some()) {
        let message = format!("`{}` is given, and so is a table of it over speed", table.full(key));
        return Err(table.wrong(key, message, "leave it out: the table holds the works themselves"));
    }
    let items = by_speed.items("table");
    let entries = items
        .iter()
        .map(|item| {
            let [trailing, leading] = of_edges(item)?;
            Ok(WorkAtSpeed { speed: item.required_number("speed")?, trailing, leading })
        })
        .collect::<Result<Vec<_>, SceneError>>()?;
    let Some(first) = entries.first().copied() else {
        return Err(by_speed.wrong("table", "`adhesion.by_speed.table` is an empty list", "name two speeds at least"));
    };
    for (item, pair) in items.iter().skip(1).zip(entries.windows(2)) {
        if let [before, after] = pair
            && after.speed <= before.speed
        {
            let message = format!("`{}` ({:e}) is not above the speed before it ({:e})", item.full("speed"), after.speed, before.speed);
            return Err(item.wrong("speed", message, "must grow from entry to entry"));
        }
    }
    let relative: Vec<WorkAtSpeed> = entries
        .iter()
        .map(|entry| WorkAtSpeed { trailing: entry.trailing / first.trailing, leading: entry.leading / first.leading, ..*entry })
        .collect();
    let law = WorkBySpeed::table(&relative)
        .map_err(|refusal| by_speed.wrong("table", format!("`adhesion.by_speed.table` cannot be used: {refusal}"), "from these entries"))?;
    let per_edge = items.iter().any(is_per_edge);
    Ok(Some(GivenWorks { table, given: [first.trailing, first.leading], per_edge, law: Some(law) }))
}

fn is_per_edge(table: &Section<'_>) -> bool {
    PER_EDGE.iter().any(|key| table.node().get(key).is_some())
}

/// One work for both edges, or one for each.
fn of_edges(table: &Section<'_>) -> Result<[f64; 2], SceneError> {
    let per_edge = PER_EDGE.into_iter().find(|key| table.node().get(key).is_some());
    let Some(key) = per_edge else {
        let work = table.required_number(WHOLE)?;
        return Ok([work; 2]);
    };
    table.exactly_one(&[WHOLE, key])?;
    Ok([table.required_number(PER_EDGE[0])?, table.required_number(PER_EDGE[1])?])
}

impl GivenWorks<'_> {
    /// The works of the trailing and of the leading edge at a speed.
    pub(super) fn at(&self, speed: f64) -> Result<[f64; 2], SceneError> {
        let Some(law) = &self.law else { return Ok(self.given) };
        self.covers(speed.abs())?;
        let [trailing, leading] = law.factors(speed.abs());
        Ok([trailing * self.given[0], leading * self.given[1]])
    }

    /// Refuses a speed outside the table: nobody knows the work there.
    pub(super) fn covers(&self, speed: f64) -> Result<(), SceneError> {
        let Some([slowest, fastest]) = self.law.as_ref().and_then(WorkBySpeed::ends) else { return Ok(()) };
        // The ends went through a logarithm.
        if speed >= slowest * (1.0 - 1e-12) && speed <= fastest * (1.0 + 1e-12) {
            return Ok(());
        }
        let message = format!("the speed {speed:e} lies outside the table of works of adhesion, from {slowest:e} to {fastest:e}");
        let place = self.table.table("by_speed").map_or_else(|| self.table.header(), |by_speed| by_speed.key_place("table"));
        Err(SceneError::at(&place, message, "must reach to that speed"))
    }
}
