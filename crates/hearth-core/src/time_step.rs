//! The longest stable explicit step:
//!
//! ```text
//! dt = min( C h/(c + u),  0.25 √(h/a),  0.125 h²/ν )
//! ```
//!
//! Neither particles nor sound cross a support radius in one step (Courant number C), forces
//! move particles a short way, and diffusion does not overshoot (Monaghan 1992, Morris et al.
//! 1997). The last steps before a requested time are shorter, so that one ends there.

/// Shortest step before a requested time \[s\]. Rates of a step divide by its length.
pub(crate) const SHORTEST: f64 = 1e-6;

/// The length of the next step \[s\]: `longest`, or what lets a step end when the time `left` has passed. The last
/// two share what is left, so that none is much shorter than the others.
pub(crate) fn fitted(longest: f32, left: f64) -> f32 {
    let left = left as f32;
    if left <= longest {
        left
    } else if left < 2.0 * longest {
        0.5 * left
    } else {
        longest
    }
}

/// The quantities that limit a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stability {
    /// Courant number.
    pub courant: f32,
    /// Smoothing length \[m\].
    pub h: f32,
    /// Speed of sound [m/s].
    pub sound: f32,
    /// Largest speed [m/s].
    pub speed: f32,
    /// Largest acceleration [m/s²].
    pub acceleration: f32,
    /// Largest kinematic viscosity or diffusivity [m²/s], or dynamic viscosity [Pa·s].
    pub viscosity: f32,
    /// Minimum density [kg/m³]; 1 if the viscosity is kinematic.
    pub density: f32,
}

impl Stability {
    /// The longest stable step \[s\].
    pub fn longest_step(&self) -> f32 {
        let courant = self.courant * self.h / (self.sound + self.speed);
        let force = 0.25 * (self.h / self.acceleration.max(1e-6)).sqrt();
        let diffusion = diffusion_limit(self.h, self.density, self.viscosity.max(1e-9));
        courant.min(force).min(diffusion)
    }
}

/// The longest stable step for a viscosity, or the largest stable viscosity for a step.
pub(crate) fn diffusion_limit(h: f32, density: f32, other: f32) -> f32 {
    0.125 * h * h * density / other
}
