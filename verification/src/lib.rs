//! What viscotack is checked by: the figures of the thesis, studies of accuracy and cost, and the schemes that the solvers are measured against.

mod date;
pub mod figures;
pub mod rivals;
pub mod studies;
