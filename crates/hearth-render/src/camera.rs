//! Which part of the world a picture shows: how the domain fits the picture, and where the
//! rest of the picture goes.

/// How the domain fits the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Fit {
    /// The domain is as high as the picture.
    #[default]
    Height,
    /// The picture shows all of the domain.
    Contain,
    /// The picture shows nothing but the domain.
    Cover,
    /// The domain is as wide as the picture.
    Width,
}

impl Fit {
    /// The fits by their names.
    pub const ALL: [(&'static str, Fit); 4] = [
        ("height", Fit::Height),
        ("contain", Fit::Contain),
        ("cover", Fit::Cover),
        ("width", Fit::Width),
    ];
}

/// How a picture shows the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// How the domain fits the picture.
    pub fit: Fit,
    /// Where the domain stands in a picture of another size, or which part of it is seen
    /// in a smaller one, from left and from below: 0 to 1.
    pub align: [f32; 2],
}

impl Default for Camera {
    fn default() -> Camera {
        Camera {
            fit: Fit::default(),
            align: [0.5, 0.0],
        }
    }
}
