//! How long an explicit step may be:
//!
//! ```text
//! dt = min( C h/(c + u),  0.25 √(h/a),  0.125 h²/ν )
//! ```
//!
//! Nothing crosses a kernel in one step, sound included (Courant's number C); no force
//! moves a particle too far; diffusion damps and does not overshoot (Monaghan 1992,
//! Morris et al. 1997).

/// What limits a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stability {
    /// Courant's number.
    pub courant: f32,
    /// Smoothing length \[m\].
    pub h: f32,
    /// Speed of sound [m/s].
    pub sound: f32,
    /// Largest speed [m/s].
    pub speed: f32,
    /// Largest acceleration [m/s²].
    pub acceleration: f32,
    /// Largest viscosity or diffusivity [m²/s], or with a `density` a dynamic
    /// viscosity [Pa·s].
    pub viscosity: f32,
    /// Least density [kg/m³]; 1 where the viscosity is kinematic.
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

/// The longest step that is stable with a viscosity, or the largest viscosity that is
/// stable in a step.
pub(crate) fn diffusion_limit(h: f32, density: f32, other: f32) -> f32 {
    0.125 * h * h * density / other
}
