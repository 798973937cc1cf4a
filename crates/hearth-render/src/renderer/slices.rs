//! The frames of the slices of a picture.

use super::Renderer;
use crate::advection::{self, INITIAL_SECONDS, Phase};
use crate::bounds::Bounds;
use crate::frame_uniforms::{Advected, Batch, FrameUniforms};
use crate::gl::Graphics;
use crate::history::{History, Sample};
use crate::kernel::parcel_radius;
use crate::slices::Slice;
use crate::viewport::Viewport;

/// Maximum time over which noise is carried on from a sample \[s\].
const MAX_CARRIED: f64 = 0.1;

/// The flow, which is smooth, needs one of so many parcels, with wider kernels.
const FLOW_STRIDE: usize = 2;
const FLOW_WIDENING: f32 = 1.25;

/// What draws a slice.
pub struct SliceFrame<'a> {
    /// Its light. Its particles are the present ones, or the sample before its moment.
    pub frame: FrameUniforms<'a>,
    /// The same with the sample after its moment.
    pub later: Option<FrameUniforms<'a>>,
    /// The samples to which its noise is advected.
    pub samples: Vec<FrameUniforms<'a>>,
}

/// The advected noise of a slice.
#[derive(Clone, Copy, Default)]
pub struct Noise {
    /// The number of its sample.
    sample: Option<u64>,
    /// Position of the world then, and whether the slice was mirrored.
    seen: Option<(Viewport, bool)>,
    /// Index of the newer of its two targets.
    newest: usize,
}

impl<G: Graphics> Renderer<G> {
    /// The frames of slices that are in the ring, from the front. Widens the reach of `frame` to that of them all.
    pub(super) fn slice_frames<'a>(
        &mut self,
        frame: &mut FrameUniforms<'a>,
        history: &History,
        slices: &[Slice],
    ) -> Vec<SliceFrame<'a>> {
        let mut frames = Vec::with_capacity(slices.len());
        for slice in slices {
            let mut own = frame.clone();
            own.slice = *slice;
            let Some(later) = self.fit_samples(&mut own, history) else {
                continue;
            };
            own.source.base.x += slice.shift;
            let samples = if own.advects_noise() {
                self.advect(&mut own, history)
            } else {
                Vec::new()
            };
            frames.push(SliceFrame {
                later: later.map(|batch| own.with(batch)),
                frame: own,
                samples,
            });
        }
        let mut reaches: Vec<_> = frames.iter().map(|slice| slice.frame.reach).collect();
        if let (Some(front), Some((_, behind))) = (frames.first_mut(), reaches.split_first()) {
            front.frame.behind = (!behind.is_empty()).then(|| Bounds::around(behind, 0.0));
        }
        reaches.push(Bounds::around(&[self.ember_bounds], frame.kernel.margin));
        frame.reach = Bounds::around(&reaches, 0.0);
        frames
    }

    /// Sets the particles of a slice and fits the frame to them. Returns its later sample. `None` if it
    /// is not in the ring.
    fn fit_samples(&self, frame: &mut FrameUniforms, history: &History) -> Option<Option<Batch>> {
        let slice = frame.slice;
        if slice.index == 0 {
            return Some(None);
        }
        let (before, after) = history.around(slice.moment)?;
        let after = after.and_then(|after| Some((after, self.ring.row(after)?)));
        let span = after.map_or(1.0, |(after, _)| after.time - before.time);
        let share = after.map_or(0.0, |_| ((slice.moment - before.time) / span) as f32);
        let moment = slice.moment;
        frame.particles = batch(before, self.ring.row(before)?, moment, 1.0 - share);
        frame.kernel.radius = parcel_radius(before.length);
        let [before_it, after_it] =
            [before, after.map_or(before, |(after, _)| after)].map(|sample| sample.bounds.visible);
        let bounds = Bounds::around(&[before_it, after_it], 0.0);
        frame.fit(&bounds);
        frame.reach = slice.moved(frame.reach);
        Some(after.map(|(after, row)| batch(after, row, moment, share)))
    }

    /// Advects the noise of a slice to its moment. Returns the samples on the way. Older ones than a period have
    /// no effect, because both patterns have restarted since.
    fn advect<'a>(
        &mut self,
        frame: &mut FrameUniforms<'a>,
        history: &History,
    ) -> Vec<FrameUniforms<'a>> {
        let slice = frame.slice;
        let period = advection::period(frame.source.width);
        let oldest = slice.moment - f64::from(period);
        let seen = (frame.viewport, slice.scale[0] < 0.0);
        let noise = &mut self.noise[slice.index];
        let is_known = |sample: &&Sample| {
            noise.sample == Some(sample.number)
                && noise.seen.is_some_and(|(_, side)| side == seen.1)
        };
        let end = slice.moment + MAX_CARRIED;
        let mut last = history.between(oldest, end).find(is_known);
        let mut before = match (last, noise.seen) {
            (Some(_), Some((viewport, _))) => viewport,
            _ => frame.viewport,
        };
        let from = last.map_or(oldest, |sample| sample.time);
        let mut samples = Vec::new();
        for sample in history.between(from, slice.moment) {
            let Some(row) = self.ring.row(sample) else {
                continue;
            };
            noise.newest = 1 - noise.newest;
            let (elapsed, kept) = last.map_or((INITIAL_SECONDS, [0.0; 2]), |last| {
                let elapsed = (sample.time - last.time) as f32;
                (elapsed, sample.phase.kept_since(last.phase))
            });
            let mut own = frame.with(Batch {
                stride: FLOW_STRIDE,
                ..batch(sample, row, sample.time, 1.0)
            });
            own.kernel.radius = FLOW_WIDENING * parcel_radius(sample.length);
            own.before = std::mem::replace(&mut before, frame.viewport);
            own.advected = Advected {
                elapsed,
                kept,
                newest: noise.newest,
            };
            samples.push(own);
            last = Some(sample);
        }
        noise.sample = last.map(|sample| sample.number);
        if !samples.is_empty() {
            noise.seen = Some(seen);
        }
        // The flow is that of the view at the last sample.
        let is_same_view = before == frame.viewport;
        frame.before = before;
        frame.phase = last.map_or(Phase(slice.moment / f64::from(period)), |last| {
            last.phase_at(slice.moment)
        });
        frame.advected = Advected {
            elapsed: match last {
                Some(last) if is_same_view => {
                    (slice.moment - last.time).clamp(0.0, MAX_CARRIED) as f32
                }
                _ => 0.0,
            },
            kept: last.map_or([0.0; 2], |last| frame.phase.kept_since(last.phase)),
            // The pass reads the newest offsets as those before.
            newest: 1 - noise.newest,
        };
        samples
    }
}

/// A sample with a weight, carried on to a moment.
fn batch(sample: &Sample, row: u32, moment: f64, share: f32) -> Batch {
    Batch {
        count: sample.count,
        row: Some(row),
        ahead: (moment - sample.time) as f32,
        share,
        unit: sample.length * sample.length,
        stride: 1,
    }
}
