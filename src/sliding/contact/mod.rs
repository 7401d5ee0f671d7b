//! A steady contact with given edges on a sliding wave, exactly, for any relaxation spectrum, in a form that never loses scale.
//!
//! # Notation
//! Reduced units: lengths in 1/k, displacements in Λ, pressures in E0*kΛ/2, moduli in E0*, times by kv.
//!
//! | symbol | meaning |
//! |---|---|
//! | y | position from the middle of the contact, which is \|y\| < a; the trailing edge is at −a, the leading edge at +a |
//! | e | eccentricity: the middle of the contact ahead of the crest of the wave, x = y + e |
//! | s = sin(a/2), X = √(2\|cos y − cos a\|) | |
//! | j_j, ζ_j = kvτ_j; E_i, ε_i = kvρ_i | creep and relaxation terms over E0; 1/β + Σj_j = 1, β = 1 + ΣE_i |
//! | M_ε f(y) = ∫_y^a e^{−(ξ−y)/ε} f(ξ) dξ/ε | what material that entered at the leading edge remembers |
//! | H₀ = cos(y/2)/X, H₁ = sin(y/2)/X, W = cos(y/2)X, S = −W′ | elastic fields |
//! | D = 2(p̄ − s² cos e) | strength of H₀ |
//!
//! # The form
//! The displacement of a memory material under p is the elastic displacement (modulus E0) under the *effective* pressure
//! q = p/β + Σ j_j v_j, where v_j = M_{ζ_j}p carries on behind the contact: q = Σ j_jV_j e_j there, e_j = exp(−distance behind the trailing
//! edge/ζ_j), and V_j = v_j(−a). So the contact is an ELASTIC mixed problem with n outside loads of unknown strength V_j. Each load
//! presses out of the flat contact
//! ```text
//! K_j(y) = (1/2πX) ∫_out |X(η)| e_j(η)/sin((η − y)/2) dη,       K_j − ζ_jK_j′ = −ζ_j g_j′,
//! g_j = (2/π)(O^c_j H₁ + O^s_j H₀),    O^c_j = ∫_out e_j cos(η/2)/|X| dη,    O^s_j = ∫_out e_j sin(η/2)/|X| dη
//! ```
//! (the translation ∂_y + ∂_η makes the Cauchy kernel separable), and inverting the memory operator term by term gives
//! ```text
//! p = β f₀ − Σ_i E_i M_{ε_i} f_i       f₀ = B − Σ_j j_jV_j g_j,   f_i = B − Σ_j j_jV_j ζ_j/(ζ_j − ε_i) g_j,   B = cos e W − sin e S + D H₀
//! gap = cos e g_W + sin e cos(y/2)|X| − D asinh(|X|/2s) − (2/π) Σ_j j_jV_j ∫_y^{2π−a} e^{−(ξ−y)/ζ_j} (O^c_j sin(ξ/2) + O^s_j cos(ξ/2))/|X| dξ
//! ```
//! p vanishes behind the contact if and only if M_{ε_i}f_i(−a) = 0: n linear equations for the n numbers V_j, whose coefficients
//! ζ_j/(ζ_j − ε_i) have alternating interlaced poles (a Cauchy matrix). For twelve terms over twelve decades, half of them slower than the
//! passage, its condition is below 10, where the partial-fraction form (with Π(1 − iζ_j) as a factor) has lost all digits. The totals are
//! ```text
//! p̄ = s² cos e + D/2                    Δ = 1 − cos e (1 − s² + 2s² ln s) − D ln s − (1/π) Σ j_jV_j ∫_out e_j asinh(|X|/2s) dη
//! ∫p e^{−iy} dy = [e^{ie}(2πs² − πs⁴) + πD(1 − s²) − i Σ j_jV_j ∫_out |X| e_j e^{−iη/2} dη] / (1/β + Σ j_j/(1 − iζ_j))
//! ```
//! Every integral is one-dimensional. Source: our own; the problem is thesis Eqs 3.16–3.24.

mod arcs;
mod edges;
mod fields;
mod indenter;
mod integrals;
mod memory;
mod moments;
mod panel;
mod process_zone;
mod quadrature;
mod resolution;
mod state;
mod system;

pub use edges::ContactEdges;
pub use fields::ArcPoint;
pub use indenter::Indenter;
pub use memory::ContactMemory;
pub use process_zone::{Edge, ProcessZone, ZonePressure, ZoneWork, edge_work};
pub(in crate::sliding) use process_zone::{ZoneFields, ZoneSum};
pub use resolution::Resolution;
pub use state::{ContactState, Prescribed, WaveContact};
pub(super) use system::ContactSystem;
