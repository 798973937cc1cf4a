//! The viewport: the position of the world in a picture.

use crate::camera::{Camera, Fit};

/// The position of the world in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Width and height of the picture \[m\].
    pub metres: [f32; 2],
    /// Position of the middle of the floor, 0–1 over the picture from the lower left.
    pub floor: [f32; 2],
    /// Height of the picture in heights of the domain.
    pub zoom: f32,
    /// Width divided by height of the picture.
    pub aspect: f32,
    /// Height of the picture before it is enlarged in heights of the domain, and the height of
    /// its lower edge above the floor.
    pub whole: [f32; 2],
}

impl Viewport {
    /// The viewport of a picture \[pixels\] on a domain \[m\].
    // `web/element/view/viewport.js` computes the same for pages.
    pub fn new(picture: [u32; 2], domain: [f32; 2], camera: Camera) -> Viewport {
        let aspect = picture[0] as f32 / picture[1].max(1) as f32;
        let [width, height] = domain;
        // The height of a picture that is as wide as the domain.
        let wide = width / aspect.max(f32::MIN_POSITIVE);
        let high = match camera.fit {
            Fit::Height => height,
            Fit::Contain => wide.max(height),
            Fit::Cover => wide.min(height),
            Fit::Width => wide,
        };
        let metres = [high * aspect, high];
        let [left, lower] = camera.align;
        let floor = [
            left + width / metres[0].max(f32::MIN_POSITIVE) * (0.5 - left),
            (1.0 - height / high) * lower,
        ];
        let zoom = camera.zoom.max(1.0);
        let hidden = camera.pan.map(|pan| pan * (1.0 - 1.0 / zoom));
        Viewport {
            metres: metres.map(|side| side / zoom),
            floor: [0, 1].map(|axis| (floor[axis] - hidden[axis]) * zoom),
            zoom: high / height / zoom,
            aspect,
            whole: [high / height, -floor[1] * high / height],
        }
    }

    /// Lower left and upper right corner of the part of the world in the picture \[m\].
    pub fn corners(self) -> [[f32; 2]; 2] {
        let corner = |at: f32| [0, 1].map(|axis| (at - self.floor[axis]) * self.metres[axis]);
        [corner(0.0), corner(1.0)]
    }

    /// The position in an earlier picture of a position in this one, both 0–1: scale and offset.
    pub fn before(self, earlier: Viewport) -> [[f32; 2]; 2] {
        let scale = [0, 1].map(|axis| self.metres[axis] / earlier.metres[axis]);
        let offset = [0, 1].map(|axis| earlier.floor[axis] - self.floor[axis] * scale[axis]);
        [scale, offset]
    }

    /// Metres to clip coordinates: scale and offset.
    pub fn to_clip(self) -> [[f32; 2]; 2] {
        let offset = self.floor.map(|at| 2.0 * at - 1.0);
        [self.metres.map(|side| 2.0 / side), offset]
    }

    /// Width and height of the picture in heights of the domain.
    pub fn heights(self) -> [f32; 2] {
        [self.aspect * self.zoom, self.zoom]
    }

    /// Whether the picture shows the world above the domain, and below it.
    pub fn shows_beyond(self) -> [bool; 2] {
        let lower = self.floor[1];
        [lower + 1.0 / self.zoom < 0.999, lower > 1e-3]
    }

    /// The column of a target of that width at `x` \[m\], within the target.
    pub fn column(&self, x: f32, width: u32) -> f32 {
        within((x / self.metres[0] + self.floor[0]) * width as f32, width)
    }

    /// The row of a target of that height at `y` \[m\], within the target.
    pub fn row(&self, y: f32, height: u32) -> f32 {
        within((y / self.metres[1] + self.floor[1]) * height as f32, height)
    }
}

/// A number from 0 to `size`; what is no number becomes 0.
fn within(at: f32, size: u32) -> f32 {
    at.max(0.0).min(size as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOMAIN: [f32; 2] = [1.2, 1.8];

    fn camera(fit: Fit, align: [f32; 2]) -> Camera {
        Camera {
            fit,
            align,
            ..Camera::default()
        }
    }

    /// Left, lower, right and upper edge of the domain in a picture \[pixels\].
    fn seen(picture: [u32; 2], fit: Fit, align: [f32; 2]) -> [f32; 4] {
        let viewport = Viewport::new(picture, DOMAIN, camera(fit, align));
        let [width, height] = picture.map(|side| side as f32);
        let [[sx, sy], [ox, oy]] = viewport.to_clip();
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
    fn by_default_the_domain_has_the_height_of_the_picture_and_is_centred() {
        let viewport = Viewport::new([1280, 720], DOMAIN, Camera::default());
        assert_eq!(viewport.metres, [1.8 * 1280.0 / 720.0, 1.8]);
        assert_eq!((viewport.floor, viewport.zoom), ([0.5, 0.0], 1.0));
        assert_eq!(viewport.to_clip()[1], [0.0, -1.0]);
        assert_eq!(viewport.shows_beyond(), [false; 2]);
    }

    #[test]
    fn fits_and_alignments_match_css() {
        // `object-fit` and `object-position` of a picture of 2:3.
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
    fn a_picture_higher_than_the_domain_shows_the_world_above_or_below() {
        let beyond =
            |fit, y| Viewport::new([300, 900], DOMAIN, camera(fit, [0.5, y])).shows_beyond();
        for fit in [Fit::Contain, Fit::Width] {
            assert_eq!(beyond(fit, 0.0), [true, false]);
            assert_eq!(beyond(fit, 0.5), [true, true]);
            assert_eq!(beyond(fit, 1.0), [false, true]);
        }
        for (_, fit) in Fit::ALL {
            let wide = |y| Viewport::new([900, 300], DOMAIN, camera(fit, [0.5, y])).shows_beyond();
            assert_eq!([wide(0.0), wide(1.0)], [[false; 2]; 2], "{fit:?}");
        }
    }

    #[test]
    fn zoom_and_pan_show_a_part_of_the_picture() {
        for (_, fit) in Fit::ALL {
            let all = camera(fit, [0.5, 0.25]);
            let [low, high] = Viewport::new([900, 300], DOMAIN, all).corners();
            for pan in [[0.0, 0.0], [0.5, 0.5], [1.0, 0.3]] {
                let camera = Camera {
                    zoom: 4.0,
                    pan,
                    ..all
                };
                assert_eq!(camera.zoomed_out().zoom, 1.0);
                let [from, to] = Viewport::new([900, 300], DOMAIN, camera).corners();
                for axis in [0, 1] {
                    let side = high[axis] - low[axis];
                    let part = low[axis] + 0.75 * pan[axis] * side;
                    assert!((from[axis] - part).abs() < 1e-4, "{fit:?} {pan:?}");
                    assert!((to[axis] - part - side / 4.0).abs() < 1e-4);
                }
            }
        }
    }

    #[test]
    fn a_place_keeps_its_metres_in_an_earlier_picture() {
        let camera = |zoom, pan| Camera {
            zoom,
            pan,
            ..Camera::default()
        };
        let first = Viewport::new([900, 300], DOMAIN, camera(1.0, [0.5; 2]));
        let other = Viewport::new([900, 300], DOMAIN, camera(3.0, [0.2, 0.9]));
        let [scale, offset] = other.before(first);
        for at in [0.0, 0.3, 1.0] {
            for axis in [0, 1] {
                let metres = (at - other.floor[axis]) * other.metres[axis];
                let before = at * scale[axis] + offset[axis];
                let then = (before - first.floor[axis]) * first.metres[axis];
                assert!((metres - then).abs() < 1e-4);
            }
        }
        assert_eq!(first.before(first), [[1.0; 2], [0.0; 2]]);
    }

    #[test]
    fn places_of_the_world_are_columns_and_rows_within_a_target() {
        let viewport = Viewport::new([1280, 720], [1.2, 1.5], Camera::default());
        assert_eq!(viewport.column(0.0, 1280), 640.0);
        assert!((viewport.column(0.1, 1280) - 688.0).abs() < 1e-3);
        assert_eq!(
            [0.0, 0.75, 1.5].map(|y| viewport.row(y, 360)),
            [0.0, 180.0, 360.0]
        );
        for (at, edge) in [
            (9.0, 100.0),
            (f32::INFINITY, 100.0),
            (-9.0, 0.0),
            (f32::NAN, 0.0),
        ] {
            assert_eq!(
                (viewport.column(at, 100), viewport.row(at, 100)),
                (edge, edge)
            );
        }
    }
}
