//! Source: Imai and Iri 1986, polylines of fewest corners within a tolerance; `src/continuation/polyline.rs`.
//!
//! Goal: the tolerance holds at every row, there are never more corners than needed by a polyline through rows, reversals larger than twice the tolerance stay, and
//! the noise of a record is found.
//!
//! Oracle: the deviation computed here row by row; a dynamic programme over all polylines whose corners are rows; known numbers of corners.
//!
//! Tolerance: none for the bound and the corners; 5 % for the noise of 20 000 rows.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs)]

use viscotack::continuation::polyline::{noise, thinned};

/// Numbers that look random, always the same ones.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        (-2.0 * (1.0 - self.next()).ln()).sqrt() * (std::f64::consts::TAU * self.next()).cos()
    }
}

fn value(corners: &[(f64, f64)], time: f64) -> f64 {
    let place = corners.partition_point(|corner| corner.0 < time).clamp(1, corners.len() - 1);
    let (a, b) = (corners[place - 1], corners[place]);
    a.1 + (b.1 - a.1) * (time - a.0) / (b.0 - a.0)
}

fn largest(corners: &[(f64, f64)], rows: &[(f64, f64)]) -> f64 {
    rows.iter().map(|row| (value(corners, row.0) - row.1).abs()).fold(0.0, f64::max)
}

/// The fewest corners of a polyline through rows, the first and the last among them.
fn fewest_through_rows(rows: &[(f64, f64)], tolerance: f64) -> usize {
    let mut best = vec![usize::MAX; rows.len()];
    best[0] = 1;
    for end in 1..rows.len() {
        for start in 0..end {
            if best[start] < usize::MAX && largest(&[rows[start], rows[end]], &rows[start..=end]) <= tolerance {
                best[end] = best[end].min(best[start] + 1);
            }
        }
    }
    best[rows.len() - 1]
}

/// A record: ramps and holds of any length, rows at uneven times, noise.
fn record(random: &mut Random, rows: usize, noise: f64) -> Vec<(f64, f64)> {
    let (mut time, mut value, mut slope, mut left) = (0.0, 0.0, 0.0, 0);
    (0..rows)
        .map(|row| {
            if left == 0 {
                left = 1 + (random.next() * 12.0) as usize;
                slope = if random.next() < 0.3 { 0.0 } else { 4.0 * random.next() - 2.0 };
            }
            left -= 1;
            if row > 0 {
                let step = 0.01 + random.next();
                time += step;
                value += slope * step;
            }
            (time, value + noise * random.normal())
        })
        .collect()
}

#[test]
fn the_bound_holds_at_every_row_with_no_more_corners_than_rows_need() {
    let mut random = Random(7);
    let (mut fewer, mut most) = (0, 0.0_f64);
    for case in 0..600 {
        let scale = 10.0_f64.powf(12.0 * random.next() - 9.0);
        let count = 2 + (random.next() * 48.0) as usize;
        let noise = 0.3 * random.next();
        let rows: Vec<(f64, f64)> = record(&mut random, count, noise).into_iter().map(|(time, value)| (time, scale * value)).collect();
        let tolerance = scale * 10.0_f64.powf(2.5 * random.next() - 2.0);
        let found = thinned(&rows, tolerance, f64::NEG_INFINITY).unwrap();
        let corners = &found.corners;
        assert!(corners.windows(2).all(|pair| pair[1].0 > pair[0].0), "{case}");
        assert_eq!((corners[0], corners[corners.len() - 1].0), (rows[0], rows[rows.len() - 1].0), "{case}");
        assert!(largest(corners, &rows) <= tolerance, "{case}: {} above {tolerance}", largest(corners, &rows));
        assert!((found.deviation - largest(corners, &rows)).abs() <= 1e-9 * tolerance, "{case}");
        let reference = fewest_through_rows(&rows, tolerance);
        assert!(corners.len() <= reference, "{case}: {} corners, through rows {reference}", corners.len());
        fewer += usize::from(corners.len() < reference);
        most = most.max(found.deviation / tolerance);
    }
    // Corners between rows save some, and the tolerance is used.
    assert!(fewer > 100 && most > 0.99, "{fewer} {most}");
}

#[test]
fn reversals_larger_than_twice_the_tolerance_stay() {
    let rows: Vec<(f64, f64)> = (0..2001).map(|row| (f64::from(row) * 1e-3, 1e-6 * (row / 100 % 2) as f64)).collect();
    let reversals = |corners: &[(f64, f64)]| {
        let steps: Vec<f64> = corners.windows(2).map(|pair| pair[1].1 - pair[0].1).filter(|step| step.abs() > 1e-9).collect();
        steps.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count()
    };
    assert_eq!(reversals(&rows), 19);
    let found = thinned(&rows, 0.49e-6, f64::NEG_INFINITY).unwrap();
    assert_eq!(reversals(&found.corners), 19, "{:?}", found.corners);
    // Larger than the swings: one straight line.
    assert_eq!(thinned(&rows, 1.01e-6, f64::NEG_INFINITY).unwrap().corners.len(), 2);
}

#[test]
fn straight_pieces_are_met_and_a_floor_is_kept() {
    let rows: Vec<(f64, f64)> = (0..=300).map(|row| (f64::from(row), f64::from((row % 200).min(200 - row % 200)))).collect();
    let found = thinned(&rows, 1e-6, f64::NEG_INFINITY).unwrap();
    assert_eq!(found.corners.len(), 4, "{:?}", found.corners);
    let mut random = Random(21);
    let (mut below, mut within) = (0, 0);
    for _ in 0..200 {
        let rows: Vec<(f64, f64)> = record(&mut random, 40, 0.2).into_iter().map(|(time, value)| (time, value.abs())).collect();
        let lowest = |floor: f64| {
            let found = thinned(&rows, 0.3, floor).unwrap();
            assert!(largest(&found.corners, &rows) <= 0.3 && found.corners.len() <= fewest_through_rows(&rows, 0.3));
            found.corners.iter().map(|corner| corner.1).fold(f64::INFINITY, f64::min)
        };
        below += usize::from(lowest(f64::NEG_INFINITY) < 0.0);
        within += usize::from(lowest(0.0) >= 0.0);
    }
    assert!(below > 0 && within == 200, "{below} {within}");
}

#[test]
fn a_tolerance_of_zero_is_the_record_and_wrong_ones_are_refused() {
    let rows = [(0.0, 1.0), (1.0, 2.0), (2.0, 3.0)];
    let found = thinned(&rows, 0.0, f64::NEG_INFINITY).unwrap();
    assert_eq!((found.corners.as_slice(), found.deviation), (rows.as_slice(), 0.0));
    assert!(thinned(&rows, -1.0, 0.0).is_err() && thinned(&rows, f64::NAN, 0.0).is_err());
    assert!(thinned(&rows[..1], 1.0, 0.0).is_err() && thinned(&[(0.0, 1.0), (0.0, 2.0)], 1.0, 0.0).is_err());
    // A tolerance below rounding leaves the record as it is.
    let far: Vec<(f64, f64)> = (0..50).map(|row| (f64::from(row), 1e9 + f64::from(row % 3))).collect();
    let found = thinned(&far, 1e-12, f64::NEG_INFINITY).unwrap();
    assert!(largest(&found.corners, &far) <= 1e-12);
}

#[test]
fn a_long_noisy_record_is_thinned_and_its_noise_found() {
    let mut random = Random(3);
    let rows: Vec<(f64, f64)> = (0..100_000)
        .map(|row| {
            let time = f64::from(row) * 1e-4;
            (time, 2e-6 * (1.0 - (-3.0 * time).exp()) + 1.5e-9 * random.normal())
        })
        .collect();
    assert!((noise(&rows) / 1.5e-9 - 1.0).abs() < 0.05, "{:e}", noise(&rows));
    let found = thinned(&rows, 8e-9, f64::NEG_INFINITY).unwrap();
    assert!(found.corners.len() < 40 && largest(&found.corners, &rows) <= 8e-9, "{}", found.corners.len());
    // Within the noise nothing can be saved by halves: the bound holds there as well.
    let found = thinned(&rows, 1e-9, f64::NEG_INFINITY).unwrap();
    assert!(found.corners.len() > 10_000 && largest(&found.corners, &rows) <= 1e-9, "{}", found.corners.len());
}
