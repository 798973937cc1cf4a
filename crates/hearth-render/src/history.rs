//! The history of a fire: its gas at moments of its past, from which slices are drawn.
//!
//! The caller that steps a simulation also calls [`History::follow`]. The history depends on no
//! context. Renderers upload its samples, again after a lost context.

use hearth_core::params::{DisplayMode, Model};
use hearth_core::scene::Pose;
use hearth_core::{Instance, Scene, Simulation, SourcePlace};

use crate::advection::{self, Phase};
use crate::bounds::ParticleBounds;
use crate::half;
use crate::rise::Rise;
use crate::slices::{self, Arrangement, Fade, MAX_SLICES, Slice};
use crate::surroundings::Surroundings;

/// Samples in a second of fire. With fewer, slices flicker between them.
const RATE: f64 = 30.0;
/// Maximum time between two samples of continuous motion \[s\].
const MAX_INTERVAL: f64 = 0.1;
/// Path of the scene, in widths of the source, after which an older slice shows another scene.
const MAX_STIRRING: f64 = 0.2;
/// Maximum distance of a source from where it was at a slice's moment, in its widths: the slice follows it.
const MAX_FOLLOWED_WIDTHS: f32 = 1.0;
/// Time over which the motion of a source counts \[s\], and the distance in its widths at which no slice is mirrored.
const DRAG_SECONDS: f64 = 0.3;
const DRAG_WIDTHS: f32 = 0.1;
/// Maximum distance of two particles that a sample holds as one, in smoothing lengths.
const PAIR_LENGTHS: f32 = 1.2;
/// Index of the volume in an instance.
const VOLUME: usize = 5;
/// Bytes of the samples of a fire unless the caller sets another limit.
const DEFAULT_LIMIT: usize = 8 << 20;

/// A moment of a fire, as [`History::record`] keeps it.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// Age of the fire \[s\].
    pub time: f64,
    /// Settings and objects.
    pub scene: &'a Scene,
    /// Where the solids are.
    pub poses: &'a [Pose],
    /// The particles in the layout of the display mode `fire`.
    pub particles: &'a [Instance],
}

/// A kept moment.
#[derive(Clone)]
pub(crate) struct Sample {
    /// Its number since the start of the history.
    pub number: u64,
    /// Age of the fire \[s\].
    pub time: f64,
    /// The particles as parcels of half floats. Volumes are in squared smoothing lengths, because those of small
    /// fires are below the range of half floats.
    pub texels: Vec<u16>,
    /// Number of parcels.
    pub count: usize,
    /// Smoothing length \[m\].
    pub length: f32,
    /// Bounds of the particles.
    pub bounds: ParticleBounds,
    /// Phase of the advected patterns.
    pub phase: Phase,
    /// Period of the patterns \[s\].
    pub period: f32,
    source: SourcePlace,
    /// Path of the scene since the start, in widths of the source.
    stirred: f64,
}

impl Sample {
    /// The phase of the patterns at a later moment.
    pub fn phase_at(&self, moment: f64) -> Phase {
        Phase(self.phase.0 + (moment - self.time) / f64::from(self.period))
    }
}

/// The history of a fire.
#[derive(Clone)]
pub struct History {
    samples: Vec<Sample>,
    /// Number of the next sample.
    next: u64,
    surroundings: Surroundings,
    stirred: f64,
    fades: [Fade; MAX_SLICES],
    pub(crate) rise: Rise,
    /// Maximum size of the samples \[bytes\].
    limit: usize,
    /// Memory for the particles of the next sample.
    particles: Vec<Instance>,
}

hearth_core::state! {
    Sample: number time texels count length bounds phase period source stirred,
    History: samples next surroundings stirred fades rise limit; particles
}

impl Default for History {
    fn default() -> History {
        History {
            samples: Vec::new(),
            next: 0,
            surroundings: Surroundings::default(),
            stirred: 0.0,
            fades: [Fade::default(); MAX_SLICES],
            rise: Rise::default(),
            limit: DEFAULT_LIMIT,
            particles: Vec::new(),
        }
    }
}

impl History {
    /// Limits the size of the samples \[bytes\]. With fewer samples there are fewer slices.
    pub fn set_limit(&mut self, bytes: usize) {
        self.limit = bytes;
    }

    /// Forgets all samples, because another fire begins.
    pub fn clear(&mut self) {
        *self = History {
            next: self.next,
            limit: self.limit,
            particles: std::mem::take(&mut self.particles),
            ..History::default()
        };
    }

    /// Follows a simulation: keeps a sample if one is due and the display mode is `fire`. Call it after each step.
    #[inline(never)]
    pub fn follow(&mut self, fire: &Simulation) {
        if fire.parameters().display_mode == DisplayMode::Fire && self.is_due(fire.time()) {
            let mut particles = std::mem::take(&mut self.particles);
            fire.write_instances(&mut particles);
            self.record(&Moment {
                time: fire.time(),
                scene: fire.scene(),
                poses: &fire.poses(),
                particles: &particles,
            });
            self.particles = particles;
        }
    }

    /// Whether a moment is the first of its thirtieth of a second, or before the last sample.
    fn is_due(&self, time: f64) -> bool {
        let slot = |time: f64| (time * RATE).floor();
        let last = self.samples.last();
        last.is_none_or(|last| time < last.time || slot(time) != slot(last.time))
    }

    /// Keeps a sample, after the earlier ones unless it is older: then it begins another history.
    pub fn record(&mut self, moment: &Moment<'_>) {
        let &Moment {
            time,
            scene,
            poses,
            particles,
        } = moment;
        let elapsed = self.samples.last().map(|last| time - last.time);
        if elapsed.is_some_and(|elapsed| elapsed < 0.0) {
            self.clear();
        }
        let values = scene.world();
        let source = SourcePlace::first(scene, poses);
        let bounds = ParticleBounds::of(particles);
        self.rise.advance(&bounds, time, values.model());
        let surroundings = Surroundings::of(scene, poses, &source);
        if !self.samples.is_empty() {
            self.stirred += surroundings.path_since(&self.surroundings);
        }
        self.surroundings = surroundings;
        let period = advection::period(source.width);
        let phase = self
            .samples
            .last()
            .map_or(Phase(time / f64::from(period)), |last| last.phase_at(time));
        let length = values.smoothing_length();
        let mut texels = self.trimmed(time, &source);
        if values.model() == Model::Combustion {
            pack(particles, length, &mut texels);
        }
        self.samples.push(Sample {
            number: self.next,
            time,
            count: texels.len() / (size_of::<Instance>() / size_of::<f32>()),
            texels,
            length,
            bounds,
            phase,
            period,
            source,
            stirred: self.stirred,
        });
        self.next += 1;
        self.fade(elapsed.unwrap_or(0.0) as f32);
    }

    /// Drops samples that no slice needs or that exceed the limit. Returns the memory of one, empty.
    fn trimmed(&mut self, time: f64, source: &SourcePlace) -> Vec<u16> {
        let deepest = (0..MAX_SLICES).map(|index| slices::lag(index, source.width));
        let lag = deepest.fold(0.0, f64::max);
        let oldest = time - lag - f64::from(advection::period(source.width)) - 2.0 / RATE;
        let size = |sample: &Sample| size_of_val(&sample.texels[..]);
        let mut sizes: usize = self.samples.iter().map(size).sum();
        let is_dropped = |sample: &&Sample| {
            let is_dropped = sample.time < oldest || sizes > self.limit;
            sizes -= size(sample);
            is_dropped
        };
        let dropped = self.samples.iter().take_while(is_dropped).count();
        let mut free = Vec::new();
        for sample in self.samples.drain(..dropped) {
            free = sample.texels;
        }
        free.clear();
        free
    }

    /// Advances the fades of the slices to the newest sample, `elapsed` seconds after the one before.
    fn fade(&mut self, elapsed: f32) {
        let Some(now) = self.samples.last() else {
            return;
        };
        let (source, time) = (now.source, now.time);
        let far = |moment| {
            let then = self.base_at(moment, &source)[0];
            (then - source.base.x).abs() / source.width
        };
        let arrangement = Arrangement {
            mirrors: self.surroundings.is_symmetric() && far(time - DRAG_SECONDS) < DRAG_WIDTHS,
            spreads: self.surroundings.is_free(),
        };
        let mut fades = self.fades;
        for (index, fade) in fades.iter_mut().enumerate().skip(1) {
            let moment = time - slices::lag(index, source.width);
            let is_same_scene = self.around(moment).is_some_and(|(before, _)| {
                now.stirred - before.stirred < MAX_STIRRING && far(moment) < MAX_FOLLOWED_WIDTHS
            });
            fade.advance(elapsed, is_same_scene.then_some(arrangement));
        }
        self.fades = fades;
    }

    /// The visible slices of a picture at `time` \[s\], from the front, `count` at most. A
    /// fraction of `count` is a part of the last one's weight.
    pub(crate) fn slices(&self, time: f64, count: f32, source: &SourcePlace) -> Vec<Slice> {
        let mut slices = vec![Slice::present(time)];
        let faded = self.samples.last().map_or(0.0, |last| time - last.time) as f32;
        for (index, fade) in self.fades.iter().enumerate().skip(1) {
            let moment = time - slices::lag(index, source.width);
            let weight = fade.after(faded).min((count - index as f32).max(0.0));
            if self.around(moment).is_some() {
                let base = self.base_at(moment, source);
                let slice = Slice::behind(index, moment, fade, weight, source, base);
                slices.extend(slice);
            }
        }
        slices::share(&mut slices);
        slices
    }

    /// The samples before and after a moment; `None` where the history has a gap.
    pub(crate) fn around(&self, moment: f64) -> Option<(&Sample, Option<&Sample>)> {
        let after = self.samples.partition_point(|sample| sample.time <= moment);
        let before = self.samples.get(after.checked_sub(1)?)?;
        let after = self.samples.get(after);
        let end = after.map_or(moment, |after| after.time);
        (end - before.time <= MAX_INTERVAL).then_some((before, after))
    }

    /// The samples after the time `from` up to a moment, oldest first.
    pub(crate) fn between(&self, from: f64, moment: f64) -> impl Iterator<Item = &Sample> {
        let all = self.samples.iter();
        all.filter(move |sample| sample.time > from && sample.time <= moment)
    }

    /// All samples, oldest first.
    pub(crate) fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// The base of the source at a moment \[m\]. A slice follows a single source. Several move by themselves.
    #[inline(never)]
    fn base_at(&self, moment: f64, now: &SourcePlace) -> [f32; 2] {
        let base = |source: &SourcePlace| source.base.to_array();
        match self.around(moment) {
            Some((before, after)) if self.surroundings.is_single() => {
                let (from, to) = (
                    base(&before.source),
                    after.map_or(*now, |after| after.source),
                );
                let share = after.map_or(0.0, |after| {
                    (moment - before.time) / (after.time - before.time).max(1e-9)
                });
                [0, 1].map(|axis| from[axis] + share as f32 * (base(&to)[axis] - from[axis]))
            }
            _ => base(now),
        }
    }
}

/// Appends particles as half floats, neighbours in pairs: slices behind the fire need half of its detail.
/// Consecutive particles are neighbours, because the simulation sorts them by cells.
fn pack(particles: &[Instance], length: f32, texels: &mut Vec<u16>) {
    let per_area = 1.0 / (length * length);
    let reach = PAIR_LENGTHS * length;
    texels.reserve(particles.len() * 8);
    let mut rest = particles.iter().copied().peekable();
    while let Some(mut parcel) = rest.next() {
        let near = |other: &Instance| {
            let (x, y) = (other[0] - parcel[0], other[1] - parcel[1]);
            x * x + y * y < reach * reach
        };
        if let Some(other) = rest.next_if(near) {
            parcel = joined(&parcel, &other);
        }
        parcel[VOLUME] *= per_area;
        for number in parcel {
            texels.push(half::bits(number));
        }
    }
}

/// Two particles as one of their volume and mean state.
fn joined(a: &Instance, b: &Instance) -> Instance {
    let volume = a[VOLUME] + b[VOLUME];
    let share = b[VOLUME] / volume;
    let mut both = *a;
    for (number, other) in both.iter_mut().zip(b) {
        *number += share * (other - *number);
    }
    both[VOLUME] = volume;
    both
}

#[cfg(test)]
mod tests;
