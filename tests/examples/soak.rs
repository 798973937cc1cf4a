//! Burns every scene for minutes at low quality, drives many fires to random corners of all ranges, and back,
//! moves solids through fires at such corners, and burns heaps of free bodies.
//!
//! `soak [--corners N] [--crowds N] [--heaps N] [--seed S] [--hours H] [--minutes M] [--scenes NAME,…]`: N corners, and
//! N crowds of solids, of each model, and of the combustion model in the open, of two simulated seconds, and N heaps of
//! ten; M minutes of each scene, or of those named. With hours, it goes on with other seeds until they have passed.
//! A scene whose sources alone burn has their power, within a hundredth, with that of the fuel that leaves its air unburnt.
//! `--table FILE` writes the scenes' rows into a table, in which those of other scenes stay; `--of TEXT` is what each states of
//! its program.
//! Prints how it goes, every corner that fails with all its values, and the corners that lean most on the
//! guards. `cargo measure soak` calls it.

use std::collections::HashMap;
use std::fs;
use std::io::{self, Write as _};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;

use hearth_core::params::Model;
use hearth_core::preset::Preset;
use hearth_core::random::Random;
use hearth_core::resolution::{CountInputs, Level, ParticleCount, SizeLimit};
use hearth_core::{Scene, Simulation};
use hearth_settings::Settings;
use hearth_tests::sweep::crowd::Crowd;
use hearth_tests::sweep::heap::Heap;
use hearth_tests::sweep::{self, Outcome};
use hearth_tests::validation;

/// Length of a minute \[s\], and how far the power of a scene may be from that of its sources.
const MINUTE: f64 = 60.0;
const BALANCE: f64 = 0.01;
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
    if options.minutes > 0.0 {
        failed += scenes(&options);
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

/// The head of the table of scenes.
const HEAD: &str = "| scene | simulated | at a guard | power | a second takes | verdict | commit |\n\
                    |---|--:|--:|--:|--:|---|---|\n";

/// Burns every scene, or the named ones, each on the next free core; returns how many failed.
fn scenes(options: &Options) -> u32 {
    println!("Scenes:\n{HEAD}");
    let named = &options.scenes;
    let wanted = |preset: &&Preset| named.is_empty() || named.iter().any(|it| it == preset.name);
    let presets: Vec<_> = Preset::all().iter().filter(wanted).collect();
    let (next, failed) = (AtomicUsize::new(0), AtomicU32::new(0));
    let table = Mutex::new(());
    let cores = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                while let Some(preset) = presets.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let (row, fault) = burnt(preset, options);
                    failed.fetch_add(u32::from(fault.is_some()), Ordering::Relaxed);
                    let _only = table.lock();
                    let written = written(&options.table, preset.name, &row);
                    let fault = fault.or(written.err().map(|error| error.to_string()));
                    let fault = fault.map(|it| format!("FAILED {}: {it}\n", preset.name));
                    let text = format!("{row}\n{}", fault.unwrap_or_default());
                    let _ = io::stdout().lock().write_all(text.as_bytes());
                }
            });
        }
    });
    failed.into_inner()
}

/// Writes a scene's row into the table, in the order of scenes.
fn written(table: &str, name: &str, row: &str) -> io::Result<()> {
    if table.is_empty() {
        return Ok(());
    }
    let old = fs::read_to_string(table).unwrap_or_default();
    let of = |name: &str| {
        old.lines()
            .find(|line| line.starts_with(&format!("| {name} |")))
    };
    let rows = Preset::all().iter().filter_map(|preset| match preset.name {
        own if own == name => Some(row),
        other => of(other),
    });
    let rows: Vec<_> = rows.map(|row| format!("{row}\n")).collect();
    fs::write(table, HEAD.to_owned() + &rows.concat())
}

/// Burns a scene at low quality: its row of the table, and its fault.
fn burnt(preset: &'static Preset, options: &Options) -> (String, Option<String>) {
    let seconds = MINUTE * options.minutes;
    let settings = Settings::starting_from(preset);
    let count = ParticleCount::of(&CountInputs {
        settings: settings.resolution(),
        level: Level::Low,
        is_level_requested: true,
        size: SizeLimit::default(),
        machine: u32::MAX,
        is_coarse: false,
    });
    let scene = settings.at(count.number);
    let (fed, start) = (f64::from(scene.power()), Instant::now());
    let mut fire = Simulation::new(scene);
    let mut unburnt = Unburnt::default();
    let outcome = sweep::watched(&mut fire, seconds, &mut |fire| {
        unburnt.watch(fire);
        None
    });
    let left = unburnt.power(seconds);
    let fuels = fire.fuel_total().unwrap_or_default();
    let alone = fire.power().is_some() && fuels.state.is_empty() && fed > 0.0;
    let unbalanced = alone && ((outcome.power + left) / fed - 1.0).abs() > BALANCE;
    let words = || {
        let burns = outcome.power;
        format!("{burns:.2} kW/m burn and {left:.2} leave where {fed:.2} are fed")
    };
    let fault = outcome.fault().or_else(|| unbalanced.then(words));
    let cells = [
        preset.name.to_owned(),
        format!("{} min", options.minutes),
        format!("{:.3} %", 100.0 * outcome.clamped),
        match fire.power() {
            _ if alone => {
                let [burns, leaves] = [outcome.power, left].map(|power| 100.0 * power / fed);
                let beside = (leaves > 0.1).then(|| format!(", {leaves:.2} % leave unburnt"));
                format!("{burns:.2} % of its sources{}", beside.unwrap_or_default())
            }
            Some(_) => format!("{:.1} kW/m", outcome.power),
            // The classic model burns no fuel.
            None => "–".to_owned(),
        },
        format!("{:.0} ms", 1e3 * start.elapsed().as_secs_f64() / seconds),
        fault.clone().unwrap_or_else(|| "holds".to_owned()),
        options.of.clone(),
    ];
    (format!("| {} |", cells.join(" | ")), fault)
}

/// Fuel that leaves open air before it has burnt, because a flame is taller than its air.
#[derive(Default)]
struct Unburnt {
    /// The fuel of each particle in the step before, by their numbers.
    before: HashMap<u64, f32>,
    /// The energy of fuel that has left [kJ/m].
    energy: f64,
}

impl Unburnt {
    /// Adds the fuel of the particles that a step has removed.
    fn watch(&mut self, fire: &Simulation) {
        let fuels = fire.fuels().unwrap_or_default();
        let now: HashMap<_, _> = fire.ids().into_iter().zip(fuels).collect();
        let gone = self.before.iter().filter(|(id, _)| !now.contains_key(*id));
        let fuel: f32 = gone.map(|(_, fuel)| fuel).sum();
        let values = fire.parameters();
        // The heat capacity of the gas is 1 kJ/(kg K).
        let heat = f64::from(values.flame_rise * (1.0 + values.air_demand));
        self.energy += f64::from(fuel) * heat * validation::mass(fire);
        self.before = now;
    }

    /// Its mean power [kW/m].
    fn power(&self, seconds: f64) -> f64 {
        self.energy / seconds
    }
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
    /// Simulated time of each scene, and their names; none: all.
    minutes: f64,
    scenes: Vec<String>,
    /// The file of their table, and what their rows state of this program.
    table: String,
    of: String,
}

fn options() -> Result<Options, String> {
    let mut options = Options {
        corners: 500,
        crowds: 170,
        heaps: 200,
        seed: 1,
        hours: 0.0,
        minutes: 1.0,
        scenes: Vec::new(),
        table: String::new(),
        of: String::new(),
    };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let value = arguments.next().unwrap_or_default();
        let whole = || {
            value
                .parse()
                .map_err(|_| format!("{argument} needs a whole number, not \"{value}\""))
        };
        let time = || {
            let number = value.parse().ok().filter(|it| (0.0..1000.0).contains(it));
            number.ok_or_else(|| format!("{argument} needs a number below 1000, not \"{value}\""))
        };
        match argument.as_str() {
            "--corners" => options.corners = whole()?,
            "--crowds" => options.crowds = whole()?,
            "--heaps" => options.heaps = whole()?,
            "--seed" => options.seed = whole()?,
            "--hours" => options.hours = time()?,
            "--minutes" => options.minutes = time()?,
            "--scenes" => {
                options.scenes = value.split(',').map(str::to_owned).collect();
                for name in &options.scenes {
                    Preset::find(name).map_err(|unknown| unknown.to_string())?;
                }
            }
            "--table" => options.table = value,
            "--of" => options.of = value,
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
