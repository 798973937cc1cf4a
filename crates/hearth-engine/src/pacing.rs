//! How much work a fire does: the time of its steps, the number of its particles, the detail of its
//! picture.

#[cfg(target_arch = "wasm32")]
pub mod averages;
pub mod machine_limit;
pub mod picture_limits;
pub mod quality;
pub mod real_time;
pub mod step_requests;
pub mod thread_budget;
