//! Manufactured cases: the answer is chosen first, another method computes the question, the solver must give the answer back.

mod crack;
mod sliding;
mod sphere;

use super::section::{Check, Effort, Progress, Section};

pub(super) fn study(effort: Effort, progress: &Progress) -> Section {
    let mut section = Section::new("manufactured", "Manufactured cases");
    progress.expect(3);
    section.say(
        "The answer is chosen, another method computes what would bring it about, and the solver has to find it again. Sliding: edges, eccentricity and penetration are \
         chosen; the extrapolated collocation of the raw integral equation says which work each edge then does, one for each edge; with these the solver must stand at those \
         edges. Crack: the way of the tip x₀(t) is chosen; a Volterra equation solved step by step gives the load K(t); under it the tip must go that way.",
    );
    section.say(
        "Sphere: a work of adhesion that varies in time, as any chosen way of the edge would need, is no input of this program: Δγ is a constant of the interface, and making \
         it one of time for a test alone would test something nobody runs. So the radius a(t) is chosen under a constant Δγ: the integration that is driven by the edge gives \
         the penetration Δ(t), and both the integration that is driven in time and the dense annuli, which share no line with either, must give a(t) back. \
         The work at prescribed edges itself is compared with stored annuli in tests/indentation/annuli_reference.rs.",
    );
    type Part = fn(Effort, &mut Section) -> Result<(), viscotack::Refusal>;
    let parts: [(&str, Part); 3] = [("sliding", sliding::cases), ("crack", crack::cases), ("sphere", sphere::cases)];
    for (name, part) in parts {
        if let Err(refusal) = part(effort, &mut section) {
            section.checks.push(Check::new(format!("manufactured: {name}"), "every case is computed", refusal.to_string(), false));
        }
        progress.advance(1);
    }
    section
}
