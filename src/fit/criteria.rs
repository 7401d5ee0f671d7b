//! Akaike's criterion: which of several models of the same data.

/// Σ n_g ln(Σ(m − y)²/n_g) + 2k + 2k(k + 1)/(n − k − 1) of groups (count, sum of squares), k parameters and one variance a group: smaller is better, and
/// exp(−difference/2) is the evidence of the worse model relative to the better one. Infinite where the data are too few.
///
/// Source: Hurvich and Tsai, Biometrika 76 (1989) 297.
#[must_use]
pub fn akaike(groups: &[(usize, f64)], parameters: usize) -> f64 {
    let count: usize = groups.iter().map(|group| group.0).sum();
    let free = (parameters + groups.len()) as f64;
    let rest = count as f64 - free - 1.0;
    if rest <= 0.0 {
        return f64::INFINITY;
    }
    let fit: f64 = groups.iter().map(|&(count, sum)| count as f64 * (sum / count as f64).max(f64::MIN_POSITIVE).ln()).sum();
    fit + 2.0 * free + 2.0 * free * (free + 1.0) / rest
}
