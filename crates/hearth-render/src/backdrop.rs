//! The backdrop of a frame: where its wall and its ground are, and the light of its surroundings.

use hearth_core::Parameters;
use hearth_core::params::{Backdrop, DisplayMode, Ground};

use crate::frame_uniforms::{FrameUniforms, background};
use crate::viewport::Viewport;

/// Height of the wall's foot above that of the fire, in heights of the domain: the wall stands
/// behind the fire.
const WALL_OFFSET: f32 = 0.1;
/// Maximum foot of the fire that stands on the floor, in heights of the domain.
const MAX_FOOT: f32 = 0.6;

/// Divides the fire's light on things by 1 + this much of the ambient light.
const PER_AMBIENT_LIGHT: f32 = 8.0;

/// Brightness of ambient light, in which white things are nearly white.
const AMBIENT_BRIGHTNESS: f32 = 1.6;

/// Brightness of the ground under a white background.
const SKY_BRIGHTNESS: f32 = 0.4;

impl FrameUniforms<'_> {
    /// Whether the fire has a backdrop: a wall, a ground or both.
    pub fn has_backdrop(&self) -> bool {
        self.shows(DisplayMode::Fire) && !self.sheets && has_backdrop(self.parameters)
    }

    /// Whether there is a wall behind the fire.
    pub fn has_wall(&self) -> bool {
        self.parameters.backdrop == Backdrop::Bricks
    }

    /// 1 if there is one, or 0.
    pub fn wall(&self) -> f32 {
        f32::from(self.has_wall())
    }

    /// Share of the page that is seen through the ground.
    pub fn page(&self) -> f32 {
        let [.., cover] = background(self.parameters.background);
        (1.0 - self.wall()) * (1.0 - cover)
    }

    /// Light of the surroundings, and of the background, which is a sky where no wall hides it.
    pub fn sky(&self) -> [f32; 3] {
        let share = SKY_BRIGHTNESS * (1.0 - self.wall());
        let [r, g, b, _] = background(self.parameters.background);
        let ambient = AMBIENT_BRIGHTNESS * self.parameters.ambient_light;
        [r, g, b].map(|channel| ambient + share * channel * channel)
    }

    /// Maximum radiance in targets as it lights things: a camera that sees a lit room takes less of the fire's light.
    pub fn light_on_things(&self) -> f32 {
        self.format.light_range() / (1.0 + PER_AMBIENT_LIGHT * self.parameters.ambient_light)
    }

    /// The ground: its number in the table, that of stone under a wall without another.
    pub fn ground(&self) -> f32 {
        f32::from((self.parameters.ground as u8).max(Ground::Stone as u8))
    }

    /// Height at which the ground ends \[m\].
    pub fn horizon(&self) -> f32 {
        self.wall_foot() * self.parameters.domain_height
    }

    /// Whether the lit wall or ground has fewer lines than the picture.
    pub fn enlarges(&self) -> bool {
        self.has_backdrop() && self.layout.plate != self.layout.picture
    }

    /// Height of the foot of the backdrop's wall, in heights of the domain. The
    /// fire stands on the floor in front of the wall.
    pub fn wall_foot(&self) -> f32 {
        self.foot_height() + WALL_OFFSET
    }

    /// Foot of the fire on the floor, 0–1 over the picture.
    pub fn foot(&self) -> [f32; 2] {
        let Viewport {
            floor,
            metres,
            zoom,
            ..
        } = self.viewport;
        [
            floor[0] + self.source.base.x / metres[0],
            floor[1] + self.foot_height() / zoom,
        ]
    }

    /// Its height, in heights of the domain.
    fn foot_height(&self) -> f32 {
        let foot = self.source.base.y / self.parameters.domain_height;
        foot.clamp(0.0, MAX_FOOT)
    }
}

/// Whether a fire with these parameters has a wall behind it or a ground.
pub fn has_backdrop(parameters: &Parameters) -> bool {
    parameters.backdrop != Backdrop::None || parameters.ground != Ground::None
}
