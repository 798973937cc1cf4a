//! The off-screen targets of one picture size.

use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Graphics;
use crate::layout::{Layout, MOST_BLURS};
use crate::target::Target;

/// Targets of which there is one.
const SINGLE: usize = 7;

/// Everything that is drawn into before the picture itself.
pub struct Targets<G: Graphics> {
    /// The sizes that these are made for.
    pub layout: Layout,
    /// Sums over the particles.
    pub field: Target<G>,
    /// The same, as seen from farther away.
    pub wide: Target<G>,
    /// Velocities of the gas.
    pub flow: Target<G>,
    /// How far the gas has carried the fine structure: before and now, in turn.
    pub drift: [Target<G>; 2],
    /// Light before the tone map.
    pub light: Target<G>,
    /// Colours as displayed.
    pub shown: Target<G>,
    /// Blurred copies of the light, sharpest first.
    pub blurs: Vec<Target<G>>,
    /// The same, joined with all wider ones; the widest stands alone.
    pub joined: Vec<Target<G>>,
}

impl<G: Graphics> Targets<G> {
    /// Makes them all, or none.
    pub fn new(gl: &G, format: TargetFormat, layout: Layout) -> Result<Targets<G>, RenderError> {
        let blurs = layout.blurs();
        let joined = &blurs[..blurs.len() - 1];
        let wanted = [
            ("splat", layout.field),
            ("spread", layout.wide),
            ("flow", layout.flow),
            ("drift", layout.drift),
            ("drift", layout.drift),
            ("shade", layout.light),
            ("develop", layout.light),
        ]
        .into_iter()
        .chain(blurs.iter().map(|&size| ("shrink", size)))
        .chain(joined.iter().map(|&size| ("widen", size)));
        let mut made = Vec::with_capacity(SINGLE + 2 * MOST_BLURS);
        for (pass, size) in wanted {
            let format = if pass == "develop" {
                TargetFormat::Rgba8
            } else {
                format
            };
            match Target::new(gl, pass, format, size) {
                Ok(target) => made.push(target),
                Err(error) => {
                    made.iter()
                        .for_each(|target: &Target<G>| target.destroy(gl));
                    return Err(error);
                }
            }
        }
        let joined = made.split_off(SINGLE + blurs.len());
        let blurs = made.split_off(SINGLE);
        match <[Target<G>; SINGLE]>::try_from(made) {
            Ok([field, wide, flow, before, now, light, shown]) => Ok(Targets {
                layout,
                field,
                wide,
                flow,
                drift: [before, now],
                light,
                shown,
                blurs,
                joined,
            }),
            Err(_) => Err(RenderError::NoTarget),
        }
    }

    /// Frees them all.
    pub fn destroy(&self, gl: &G) {
        let single = [
            &self.field,
            &self.wide,
            &self.flow,
            &self.light,
            &self.shown,
        ];
        let many = self.drift.iter().chain(&self.blurs).chain(&self.joined);
        for target in single.into_iter().chain(many) {
            target.destroy(gl);
        }
    }
}
