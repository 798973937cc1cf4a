//! Which part of the world a picture shows: how the domain fits it, and where what of it
//! is left over goes.

/// How the domain fits the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Fit {
    /// It is as high as the picture.
    #[default]
    Height,
    /// All of it is seen.
    Contain,
    /// Nothing but it is seen.
    Cover,
    /// It is as wide as the picture.
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

/// How the world is seen.
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

/// A rectangle in pixels, from the lower left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rectangle {
    /// Left edge.
    pub x: i32,
    /// Lower edge.
    pub y: i32,
    /// Width; 0: nothing to draw.
    pub width: i32,
    /// Height.
    pub height: i32,
}

/// Where the world stands in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// Width and height of what the picture shows \[m\].
    pub metres: [f32; 2],
    /// Where the middle of the floor is, in pictures from the lower left.
    pub floor: [f32; 2],
    /// Height of the picture in heights of the domain.
    pub zoom: f32,
    /// Width of the picture by its height.
    pub aspect: f32,
}

impl Place {
    /// The place of a domain so wide and high \[m\] in a picture of that size.
    // `web/element/viewport.js` says the same to pages.
    pub fn new(picture: [u32; 2], domain: [f32; 2], camera: Camera) -> Place {
        let aspect = picture[0] as f32 / picture[1].max(1) as f32;
        let [width, height] = domain;
        // A picture as high as this is as wide as the domain.
        let wide = width / aspect.max(f32::MIN_POSITIVE);
        let high = match camera.fit {
            Fit::Height => height,
            Fit::Contain => wide.max(height),
            Fit::Cover => wide.min(height),
            Fit::Width => wide,
        };
        let metres = [high * aspect, high];
        let [left, lower] = camera.align;
        Place {
            metres,
            floor: [
                left + width / metres[0].max(f32::MIN_POSITIVE) * (0.5 - left),
                (1.0 - height / high) * lower,
            ],
            zoom: high / height,
            aspect,
        }
    }

    /// Metres to clip coordinates: scale x, y, offset x, y.
    pub fn to_clip(self) -> [f32; 4] {
        let [x, y] = self.floor.map(|at| 2.0 * at - 1.0);
        [2.0 / self.metres[0], 2.0 / self.metres[1], x, y]
    }

    /// For a shader: where in the picture the middle of the floor is, `x` \[m\], and the
    /// height of the picture in heights of the domain.
    pub fn origin(self, x: f32) -> [f32; 4] {
        [self.floor[0], self.floor[1], x, self.zoom]
    }

    /// Whether what is above the domain is seen, and what is below it.
    pub fn shows_beyond(self) -> [bool; 2] {
        let lower = self.floor[1];
        [lower + 1.0 / self.zoom < 0.999, lower > 1e-3]
    }

    /// The texels of a target of that size that `bounds` (left, lower, right,
    /// upper \[m\]) touches.
    pub fn rectangle(self, bounds: [f32; 4], size: [u32; 2]) -> Rectangle {
        let [left, lower, right, upper] = bounds;
        let [width, height] = size.map(|side| side as f32);
        let column = |x: f32| (x / self.metres[0] + self.floor[0]) * width;
        let row = |y: f32| (y / self.metres[1] + self.floor[1]) * height;
        // A float that is too large, or no number, becomes an edge: `as` saturates.
        let clamp = |at: f32, most: f32| at.max(0.0).min(most) as i32;
        let (x, y) = (
            clamp(column(left).floor(), width),
            clamp(row(lower).floor(), height),
        );
        Rectangle {
            x,
            y,
            width: (clamp(column(right).ceil(), width) - x).max(0),
            height: (clamp(row(upper).ceil(), height) - y).max(0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOMAIN: [f32; 2] = [1.2, 1.8];

    /// Left, lower, right and upper edge of the domain in a picture, in pixels.
    fn seen(picture: [u32; 2], fit: Fit, align: [f32; 2]) -> [f32; 4] {
        let place = Place::new(picture, DOMAIN, Camera { fit, align });
        let [width, height] = picture.map(|side| side as f32);
        let [sx, sy, ox, oy] = place.to_clip();
        let pixel = |x: f32, y: f32| {
            [
                (x * sx + ox + 1.0) / 2.0 * width,
                (y * sy + oy + 1.0) / 2.0 * height,
            ]
        };
        let [left, lower] = pixel(-0.5 * DOMAIN[0], 0.0);
        let [right, upper] = pixel(0.5 * DOMAIN[0], DOMAIN[1]);
        [left, lower, right, upper]
    }

    #[test]
    fn a_domain_is_as_high_as_the_picture_and_in_its_middle_unless_somebody_says_otherwise() {
        let place = Place::new([1280, 720], DOMAIN, Camera::default());
        assert_eq!(place.metres, [1.8 * 1280.0 / 720.0, 1.8]);
        assert_eq!(place.origin(0.3), [0.5, 0.0, 0.3, 1.0]);
        assert_eq!(place.to_clip()[2..], [0.0, -1.0]);
        assert_eq!(place.shows_beyond(), [false; 2]);
    }

    #[test]
    fn each_fit_is_what_css_calls_so_and_each_alignment_too() {
        // As `object-fit` and `object-position` place a picture of 2:3.
        for picture in [[1280, 720], [300, 900], [400, 600]] {
            let [width, height] = picture.map(|side| side as f32);
            let (by_width, by_height) = (width / DOMAIN[0], height / DOMAIN[1]);
            for (fit, scale) in [
                (Fit::Height, by_height),
                (Fit::Width, by_width),
                (Fit::Contain, by_width.min(by_height)),
                (Fit::Cover, by_width.max(by_height)),
            ] {
                for align in [[0.5, 0.0], [0.0, 1.0], [1.0, 0.5], [0.25, 0.75]] {
                    let left = (width - DOMAIN[0] * scale) * align[0];
                    let lower = (height - DOMAIN[1] * scale) * align[1];
                    let [right, upper] = [left + DOMAIN[0] * scale, lower + DOMAIN[1] * scale];
                    let seen = seen(picture, fit, align);
                    for (is, should) in seen.into_iter().zip([left, lower, right, upper]) {
                        assert!(
                            (is - should).abs() < 0.01,
                            "{fit:?} {align:?} in {picture:?}: {seen:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn only_a_domain_lower_than_the_picture_leaves_room_above_or_below() {
        let beyond = |fit, y| {
            let align = [0.5, y];
            Place::new([300, 900], DOMAIN, Camera { fit, align }).shows_beyond()
        };
        for fit in [Fit::Contain, Fit::Width] {
            assert_eq!(beyond(fit, 0.0), [true, false]);
            assert_eq!(beyond(fit, 0.5), [true, true]);
            assert_eq!(beyond(fit, 1.0), [false, true]);
        }
        for (_, fit) in Fit::ALL {
            let wide = |y| {
                let align = [0.5, y];
                Place::new([900, 300], DOMAIN, Camera { fit, align }).shows_beyond()
            };
            assert_eq!([wide(0.0), wide(1.0)], [[false; 2]; 2], "{fit:?}");
        }
    }

    #[test]
    fn the_source_stands_in_the_lower_middle() {
        let place = Place::new([1280, 720], [1.2, 1.5], Camera::default());
        let at = place.rectangle([-0.1, 0.0, 0.1, 0.75], [1280, 720]);
        assert_eq!(at.y, 0);
        assert_eq!(at.height, 360);
        assert_eq!(2 * at.x + at.width, 1280);
        assert!((95..=98).contains(&at.width), "{at:?}");
    }

    #[test]
    fn what_is_outside_or_no_number_touches_nothing() {
        let place = Place::new([100, 100], [1.0, 1.0], Camera::default());
        for bounds in [
            [3.0, 0.0, 4.0, 1.0],
            [0.0, 2.0, 0.1, 3.0],
            [
                f32::INFINITY,
                f32::INFINITY,
                f32::NEG_INFINITY,
                f32::NEG_INFINITY,
            ],
        ] {
            let at = place.rectangle(bounds, [100, 100]);
            assert!(at.width == 0 || at.height == 0, "{bounds:?}: {at:?}");
        }
    }
}
