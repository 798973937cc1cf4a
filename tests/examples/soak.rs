//! Burns every scene for a minute, drives many fires to random corners of all ranges, and back,
//! moves solids through fires at such corners, and burns heaps of free bodies.
//!
//! `soak [--corners N] [--crowds N] [--heaps N] [--seed S] [--hours H]`: N corners, and N crowds of solids,
//! of each model, and of the combustion model in the open, of two simulated seconds, and N heaps of ten.
//! Without corners, it burns no scene either. With hours, it goes on with other seeds until they have passed.
//! Prints how it goes, every corner that fails with all its values, and the corners that lean most on the
//! guards. `cargo measure soak` calls it.

use std::io::{self, Write as _};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, Ordering};
use std::thread;
use std::time::Instant;

use hearth_core::params::Model;
use hearth_core::preset::Preset;
use hearth_core::random::Random;
use hearth_core::{Scene, Simulation};
use hearth_tests::fires::with_first_source;
use hearth_tests::sweep::crowd::Crowd;
use hearth_tests::sweep::heap::Heap;
use hearth_tests::sweep::{self, Outcome};

/// Simulated time of a scene [s].
const MINUTE: f64 = 60.0;
/// Simulated time at a corner, and of a heap [s].
const SECONDS: f64 = 2.0;
const HEAPED: f64 = 10.0;
/// Visits a random corner: its values and what came of it.
type Visit = fn(&mut Random) -> (String, Outcome);
/// The kinds of corners take turns.
const CORNERS: [Visit; 3] = [
    |random| there_and_back(&sweep::corner(Model::Combustion, random)),
    |random| there_and_back(&sweep::corner(Model::Classic, random)),
    |random| there_and_back(&sweep::open_corner(random)),
];
/// So do the kinds of crowds.
const CROWDS: [Visit; 3] = [
    |random| through(Crowd::closed(random)),
    |random| through(Crowd::classic(random)),
    |random| through(Crowd::open(random)),
];
/// Heaps are of one kind.
const HEAPS: [Visit; 1] = [|random| {
    let heap = Heap::random(random);
    (heap.described(), heap.burn(HEAPED))
}];
/// Length of an hour \[s\], and the distance of the seeds of rounds, larger than the number of corners.
const HOUR: f64 = 3600.0;
const BETWEEN: u32 = 1_000_003;
/// Number of corners between two lines of progress.
const LISTED: usize = 20;
/// So many of the corners that lean most on the guards are shown.
const SHOWN: usize = 12;

/// A corner and its outcome.
struct Finished {
    corner: u32,
    values: String,
    outcome: Outcome,
}

fn main() -> ExitCode {
    let options = match options() {
        Ok(options) => options,
        Err(text) => {
            eprintln!("error: {text}");
            return ExitCode::FAILURE;
        }
    };
    let (start, mut seed, mut failed) = (Instant::now(), options.seed, 0);
    if options.corners > 0 {
        failed += scenes();
    }
    loop {
        if options.corners > 0 {
            failed += visit_all("corners", &CORNERS, options.corners, seed);
        }
        if options.crowds > 0 {
            failed += visit_all("crowds of solids", &CROWDS, options.crowds, seed);
        }
        if options.heaps > 0 {
            failed += visit_all("heaps of burning bodies", &HEAPS, options.heaps, seed);
        }
        if start.elapsed().as_secs_f64() >= HOUR * options.hours {
            break;
        }
        seed = seed.wrapping_add(BETWEEN);
        println!("\nSeed {seed}:");
    }
    if failed == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// Visits so many corners of each kind; returns how many failed.
fn visit_all(name: &str, kinds: &[Visit], each: u32, seed: u32) -> u32 {
    let start = Instant::now();
    println!("\n{name}, {each} of each kind:");
    let mut finished = run(kinds, each, seed);
    let failed = finished.iter().filter(|f| f.outcome.fault().is_some());
    let failed = failed.count() as u32;
    finished.sort_by(|a, b| b.outcome.clamped.total_cmp(&a.outcome.clamped));
    println!("\nMost particles at a guard:");
    for f in finished.iter().take(SHOWN) {
        println!("{:6.2} %  {}", 100.0 * f.outcome.clamped, f.values);
    }
    println!(
        "\n{} {name}, {failed} failed, in {:.0} min",
        finished.len(),
        start.elapsed().as_secs_f64() / 60.0
    );
    failed
}

/// Burns every scene for a minute of fire; returns how many failed.
fn scenes() -> u32 {
    let mut failed = 0;
    println!("Scenes: particles at a guard, steps of particles in a second of the clock, its time");
    for preset in Preset::all() {
        let scene = with_first_source(preset.scene());
        let clock = MINUTE / f64::from(scene.world().time_scale);
        let start = Instant::now();
        let outcome = sweep::burn(&mut Simulation::new(scene), MINUTE);
        let (work, time) = (outcome.work / clock, start.elapsed().as_secs_f64() / clock);
        let (name, clamped) = (preset.name, 100.0 * outcome.clamped);
        println!("{name:20}{clamped:8.3} %{work:12.0}{time:8.3} s");
        if let Some(fault) = outcome.fault() {
            println!("FAILED {name}: {fault}");
            failed += 1;
        }
    }
    failed
}

/// The requested run.
struct Options {
    /// Corners and crowds of each kind, and heaps.
    corners: u32,
    crowds: u32,
    heaps: u32,
    seed: u32,
    /// Least time of all rounds.
    hours: f64,
}

fn options() -> Result<Options, String> {
    let mut options = Options {
        corners: 500,
        crowds: 170,
        heaps: 200,
        seed: 1,
        hours: 0.0,
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let value = arguments.next().unwrap_or_default();
        let whole = || {
            value
                .parse()
                .map_err(|_| format!("{argument} needs a whole number, not \"{value}\""))
        };
        match argument.as_str() {
            "--corners" => options.corners = whole()?,
            "--crowds" => options.crowds = whole()?,
            "--heaps" => options.heaps = whole()?,
            "--seed" => options.seed = whole()?,
            "--hours" => {
                let hours = value.parse().ok();
                let words = || format!("--hours needs a number of hours, not \"{value}\"");
                options.hours = hours
                    .filter(|h| (0.0..1000.0).contains(h))
                    .ok_or_else(words)?;
            }
            other => return Err(format!("there is no option {other}")),
        }
    }
    Ok(options)
}

/// Runs all corners on all cores.
fn run(kinds: &[Visit], each: u32, seed: u32) -> Vec<Finished> {
    let next = AtomicU32::new(0);
    let finished = Mutex::new(Vec::new());
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let all = kinds.len() as u32 * each;
    thread::scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                loop {
                    let corner = next.fetch_add(1, Ordering::Relaxed);
                    if corner >= all {
                        return;
                    }
                    let done = visit(kinds, corner, seed);
                    if let Ok(mut finished) = finished.lock() {
                        finished.push(done);
                        print_news(&finished, all);
                    }
                }
            });
        }
    });
    finished.into_inner().unwrap_or_default()
}

/// Runs a corner. Each has a generator of its own, so
/// that one can be run again without those before it.
fn visit(kinds: &[Visit], corner: u32, seed: u32) -> Finished {
    // Seeds that lie side by side begin alike.
    let mixed = seed.wrapping_add(corner).wrapping_mul(0x9E37_79B9);
    let mut random = Random::new(mixed);
    let mut random = Random::new(random.bits());
    let (values, outcome) = kinds[corner as usize % kinds.len()](&mut random);
    Finished {
        corner,
        values,
        outcome,
    }
}

fn there_and_back(scene: &Scene) -> (String, Outcome) {
    let outcome = sweep::there_and_back(scene, SECONDS);
    (sweep::described(scene), outcome)
}

fn through(crowd: Crowd) -> (String, Outcome) {
    (crowd.described(), crowd.burn(SECONDS))
}

/// Prints a fault of the last corner, and a summary after every few corners.
fn print_news(finished: &[Finished], all: u32) {
    let mut text = String::new();
    if let Some(last) = finished.last()
        && let Some(fault) = last.outcome.fault()
    {
        text = format!("FAILED corner {}: {fault}; {}\n", last.corner, last.values);
    }
    if finished.len().is_multiple_of(LISTED) {
        let worst = finished
            .iter()
            .map(|f| f.outcome.clamped)
            .fold(0.0, f64::max);
        let failed = finished
            .iter()
            .filter(|f| f.outcome.fault().is_some())
            .count();
        text += &format!(
            "{} of {}: {failed} failed, at most {:.2} % at a guard\n",
            finished.len(),
            all,
            100.0 * worst
        );
    }
    // One write, so that lines do not mix.
    let _ = io::stdout().lock().write_all(text.as_bytes());
}
