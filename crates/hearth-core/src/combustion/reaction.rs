//! Where fuel enters, and how it burns: burners, the reaction with its soot, and embers.

pub(super) mod burner;
pub(super) mod chemistry;
pub(super) mod embers;
