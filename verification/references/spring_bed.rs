//! Indentation without adhesion as a bed of viscoelastic springs: the coarse, fast and blunt judge of the solver.
//!
//! Sneddon's transform makes the places s of the line independent of each other: `q = R * dW` at each, in contact `W = D - f(s)`, free `q = 0`, never `q < 0` and
//! never `W < D - f(s)`. Nothing follows an edge here. A grid of springs is stepped in time; W and D go straight within a step, and at its end
//! `W = max(W that makes q = 0, D - f)`: the complementarity of a unilateral spring. Force, contact radius and a frame are increasing functions of D.
//! The contact radius is where D meets the free surface, straight between two springs.
//!
//! Built alone, it can use nothing of the solver: `rustc -O --edition 2024 verification/references/spring_bed.rs -o target/spring_bed`.
//! Reads words from standard input (`spring_bed.py` writes them), prints a row for each wanted instant and each change of contact.

use std::io::{Read, Write};

/// One step's end for a quantity.
#[derive(Clone, Copy, PartialEq)]
enum Quantity {
    Penetration,
    Force,
    ContactRadius,
    Frame,
}

/// Springs: height, weight in the force, radius; the first is the apex and has no weight.
struct Bed {
    height: Vec<f64>,
    weight: Vec<f64>,
    radius: Vec<f64>,
    /// All springs alike, up to a rim.
    flat: bool,
    relaxed: f64,
    moduli: Vec<f64>,
    rates: Vec<f64>,
    frame: f64,
    /// State: displacement of each spring, load of each term on each spring.
    moved: Vec<f64>,
    terms: Vec<f64>,
    /// Of the step: displacement at which a spring is free, penetration at which it is met.
    free: Vec<f64>,
    met: Vec<f64>,
    stiffness: f64,
    decay: Vec<f64>,
    gain: Vec<f64>,
    depth: f64,
    time: f64,
    here: (Quantity, f64),
    last_gap: f64,
    highest: f64,
    rounding: f64,
    imposed: f64,
}

impl Bed {
    /// In contact, or nearer to it than rounding tells: the load of a liquid that is held fades without end. Under a force there is a load or none.
    fn touches(&self, spring: usize) -> bool {
        self.depth + self.rounding * self.depth.abs() > self.met[spring]
    }

    fn touching(&self) -> bool {
        self.touches(0)
    }

    /// Decays and the free surface of a step of this length.
    fn prepare(&mut self, length: f64) {
        self.stiffness = self.relaxed;
        for k in 0..self.rates.len() {
            let lag = self.rates[k] * length;
            self.decay[k] = (-lag).exp();
            self.gain[k] = self.moduli[k] * if lag > 0.0 { -(-lag).exp_m1() / lag } else { 1.0 };
            self.stiffness += self.gain[k];
        }
        self.surface();
    }

    fn surface(&mut self) {
        let terms = self.rates.len();
        let own = self.stiffness - self.relaxed;
        for s in 0..self.height.len() {
            let kept: f64 = self.terms[s * terms..(s + 1) * terms].iter().zip(&self.decay).map(|(load, decay)| load * decay).sum();
            self.free[s] = (own * self.moved[s] - kept) / self.stiffness;
            self.met[s] = self.height[s] + self.free[s];
        }
    }

    fn force(&self, depth: f64) -> (f64, f64) {
        let (mut force, mut slope) = (0.0, 0.0);
        for (met, weight) in self.met.iter().zip(&self.weight) {
            if depth > *met {
                force += weight * (depth - met);
                slope += weight;
            }
        }
        (force * self.stiffness, slope * self.stiffness)
    }

    fn edge(&self) -> f64 {
        if self.flat {
            return if self.touching() { self.radius[0] } else { 0.0 };
        }
        let Some(last) = (0..self.met.len()).rev().find(|&s| self.touches(s)) else { return 0.0 };
        if last + 1 == self.met.len() {
            return self.radius[last];
        }
        let (inner, outer) = ((self.depth - self.met[last]).max(0.0), self.met[last + 1] - self.depth);
        self.radius[last] + (self.radius[last + 1] - self.radius[last]) * inner / (inner + outer)
    }

    /// Where the free surface at a radius is met.
    fn depth_of_radius(&self, radius: f64) -> f64 {
        if radius <= 0.0 {
            return self.met[0];
        }
        let next = self.radius.partition_point(|&r| r < radius).clamp(1, self.radius.len() - 1);
        let share = (radius - self.radius[next - 1]) / (self.radius[next] - self.radius[next - 1]);
        self.met[next - 1] + share * (self.met[next] - self.met[next - 1])
    }

    /// The penetration at which `force + frame depth = load`: convex and increasing, by Newton's steps from above.
    fn depth_of_load(&self, load: f64, frame: f64) -> f64 {
        let lowest = self.met.iter().copied().fold(f64::INFINITY, f64::min);
        if frame * lowest >= load {
            return if frame > 0.0 { load / frame } else { lowest };
        }
        let weights: f64 = self.weight.iter().sum::<f64>() * self.stiffness;
        let mut depth = self.met.iter().copied().fold(f64::NEG_INFINITY, f64::max) + load.abs() / (weights + frame);
        for _ in 0..200 {
            let (force, slope) = self.force(depth);
            let excess = force + frame * depth - load;
            let next = depth - excess / (slope + frame);
            if !(next < depth) || slope + frame <= 0.0 {
                break;
            }
            depth = next;
        }
        depth
    }

    /// Ends a prepared step with the quantity at its value.
    fn finish(&mut self, quantity: Quantity, value: f64) {
        self.rounding = if quantity == Quantity::Force { 0.0 } else { 1e-12 };
        self.depth = match quantity {
            Quantity::Penetration => value,
            Quantity::Force => self.depth_of_load(value, 0.0),
            Quantity::ContactRadius => {
                self.imposed = value;
                self.depth_of_radius(value)
            }
            Quantity::Frame => self.depth_of_load(self.frame * value, self.frame),
        };
        let terms = self.rates.len();
        for s in 0..self.height.len() {
            let moved = self.free[s].max(self.depth - self.height[s]);
            let change = moved - self.moved[s];
            self.moved[s] = moved;
            for (k, load) in self.terms[s * terms..(s + 1) * terms].iter_mut().enumerate() {
                *load = *load * self.decay[k] + self.gain[k] * change;
            }
        }
    }

    fn present(&self, quantity: Quantity) -> f64 {
        if self.here.0 == quantity {
            return self.here.1;
        }
        let force = self.force(self.depth).0;
        match quantity {
            Quantity::Penetration => self.depth,
            Quantity::Force => force,
            Quantity::ContactRadius => self.edge(),
            Quantity::Frame => self.depth + force / self.frame,
        }
    }

    fn step(&mut self, length: f64, quantity: Quantity, value: f64, out: &mut String) {
        let before = self.touching();
        self.prepare(length);
        self.finish(quantity, value);
        self.highest = self.highest.max(self.edge());
        let gap = self.met[0] - self.depth;
        let start = self.time;
        self.time += length;
        if self.touching() != before {
            let part = if self.last_gap != gap { (self.last_gap / (self.last_gap - gap)).clamp(0.0, 1.0) } else { 1.0 };
            let word = if before { "end" } else { "begin" };
            out.push_str(&format!("{word} {:e} {:e}\n", start + part * length, length));
        }
        self.last_gap = gap;
    }

    /// The last two: what the penetration and the force miss between two springs, where the radius is imposed.
    fn show(&self, quantity: Quantity, out: &mut String) {
        let (force, slope) = self.force(self.depth);
        let afloat = u8::from(!self.touching() && quantity == Quantity::Force);
        let (mut edge, mut missed) = (self.edge(), 0.0);
        if quantity == Quantity::ContactRadius && !self.flat {
            // What is imposed: where a liquid has flowed for long, all that it once bore is within rounding of being free.
            edge = self.imposed;
            let next = self.radius.partition_point(|&r| r < edge).clamp(1, self.radius.len() - 1);
            missed = (self.met[next] - self.met[next - 1]).abs();
        }
        out.push_str(&format!("at {:e} {:e} {force:e} {edge:e} {afloat} {missed:e} {:e}\n", self.time, self.depth, slope * missed));
    }
}

struct Words<'a>(std::str::SplitAsciiWhitespace<'a>);

impl<'a> Words<'a> {
    fn word(&mut self) -> &'a str {
        self.0.next().expect("the input ends early")
    }

    fn number(&mut self) -> f64 {
        self.word().parse().expect("a number")
    }

    fn count(&mut self) -> usize {
        self.word().parse().expect("a count")
    }

    fn numbers(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.number()).collect()
    }

    fn quantity(&mut self) -> Quantity {
        match self.word() {
            "penetration" => Quantity::Penetration,
            "force" => Quantity::Force,
            "contact_radius" => Quantity::ContactRadius,
            "frame" => Quantity::Frame,
            other => panic!("no quantity {other}"),
        }
    }
}

fn main() {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).expect("words on standard input");
    let mut words = Words(text.split_ascii_whitespace());
    let flat = words.count() == 1;
    let springs = words.count();
    let (radius, height, weight) = (words.numbers(springs), words.numbers(springs), words.numbers(springs));
    let relaxed = words.number();
    let terms = words.count();
    let (moduli, rates) = (words.numbers(terms), words.numbers(terms));
    let frame = words.number();
    let (quantity, value, at_rest) = (words.quantity(), words.number(), words.count() == 1);
    let mut bed = Bed {
        met: height.clone(),
        height,
        weight,
        radius,
        flat,
        relaxed,
        moduli,
        rates,
        frame,
        moved: vec![0.0; springs],
        terms: vec![0.0; springs * terms],
        free: vec![0.0; springs],
        stiffness: relaxed,
        decay: vec![0.0; terms],
        gain: vec![0.0; terms],
        depth: 0.0,
        time: 0.0,
        here: (quantity, value),
        last_gap: 0.0,
        highest: 0.0,
        rounding: 0.0,
        imposed: 0.0,
    };
    let mut out = String::new();
    if at_rest {
        // Loads of the terms are gone: only the relaxed springs are felt.
        bed.surface();
    } else {
        bed.prepare(0.0);
    }
    bed.finish(quantity, value);
    bed.last_gap = bed.met[0] - bed.depth;
    bed.show(quantity, &mut out);
    for _ in 0..words.count() {
        let (kind, quantity) = (words.word(), words.quantity());
        if kind == "step" {
            let value = words.number();
            bed.step(0.0, quantity, value, &mut out);
            bed.here = (quantity, value);
            bed.show(quantity, &mut out);
            continue;
        }
        // A way: the time in the leg, the share of the straight way, what is added to it, whether wanted.
        let (first, end, count) = (bed.present(quantity), words.number(), words.count());
        let mut before = 0.0;
        for _ in 0..count {
            let (time, share, added, wanted) = (words.number(), words.number(), words.number(), words.count() == 1);
            let value = if share == 1.0 { end + added } else { first + (end - first) * share + added };
            bed.step(time - before, quantity, value, &mut out);
            before = time;
            if wanted {
                bed.show(quantity, &mut out);
            }
        }
        bed.here = (quantity, end);
    }
    out.push_str(&format!("highest {:e}\n", bed.highest));
    std::io::stdout().write_all(out.as_bytes()).expect("standard output");
}
