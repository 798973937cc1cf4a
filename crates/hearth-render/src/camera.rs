//! The camera: which part of the world a picture shows.

/// How the domain fits the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Fit {
    /// The picture is as high as the domain.
    #[default]
    Height,
    /// The picture shows the whole domain.
    Contain,
    /// The domain covers the picture.
    Cover,
    /// The picture is as wide as the domain.
    Width,
}

impl Fit {
    /// All fits with their names.
    pub const ALL: [(&'static str, Fit); 4] = [
        ("height", Fit::Height),
        ("contain", Fit::Contain),
        ("cover", Fit::Cover),
        ("width", Fit::Width),
    ];
}

/// Fit and alignment of the domain in the picture, and the enlarged part of that picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// How the domain fits the picture.
    pub fit: Fit,
    /// Alignment from the left and from below, 0 to 1, of a domain that is smaller or larger
    /// than the picture.
    pub align: [f32; 2],
    /// Magnification of the picture, 1 or more.
    pub zoom: f32,
    /// Which part of the enlarged picture is seen: its position from the left and from below,
    /// 0 to 1.
    pub pan: [f32; 2],
}

impl Camera {
    /// This camera without its magnification: it shows all that zoom and pan can show.
    pub fn zoomed_out(self) -> Camera {
        Camera { zoom: 1.0, ..self }
    }
}

impl Default for Camera {
    fn default() -> Camera {
        Camera {
            fit: Fit::default(),
            align: [0.5, 0.0],
            zoom: 1.0,
            pan: [0.5; 2],
        }
    }
}
