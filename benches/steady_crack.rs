//! Speed of steady cracks beside raw quadrature.

fn main() {}
