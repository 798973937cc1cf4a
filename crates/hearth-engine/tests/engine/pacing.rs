//! How much work a fire does: its time, its particles, its pictures.

mod machine_limit;
mod particle_count;
mod picture_limits;
mod quality;
mod quality_frames;
mod size_limit;
mod step_requests;
mod thread_budget;
mod warm_up;
