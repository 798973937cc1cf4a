//! A fire that burns, and what the renderer gets of it.

use std::path::Path;

use hearth_core::params::{DisplayMode, Input, Model};
use hearth_core::preset::Preset;
use hearth_core::resolution::Level;
use hearth_core::{Charred, Instance, Scene, Simulation};
use hearth_render::{History, RenderError, Renderer, ResolutionLimits, View};

use crate::Failure;
use crate::request::Request;

/// What the names of scenes of the community begin with.
const COMMUNITY: &str = "community/";

/// The scenes of the community.
fn community() -> Result<Vec<codegen::Scene>, Failure> {
    let checkout = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    Ok(codegen::community(&checkout)?)
}

/// The names of all scenes, the presets first.
///
/// # Errors
/// A file of the community is wrong.
pub fn scenes() -> Result<Vec<String>, Failure> {
    let presets = Preset::all().iter().map(|preset| preset.name.to_owned());
    let given = community()?;
    let given = given
        .iter()
        .map(|scene| format!("{COMMUNITY}{}", scene.name));
    Ok(presets.chain(given).collect())
}

/// A burning fire.
#[derive(Clone)]
pub struct Fire {
    simulation: Simulation,
    history: History,
    instances: Vec<Instance>,
    embers: Vec<Instance>,
    charred: Charred,
    /// Whether its pictures show sparks.
    pub shows_sparks: bool,
}

impl Fire {
    /// A fire of the preset or the scene of the community `lit`, with no more particles than `particles` fill its domain.
    ///
    /// # Errors
    /// There is no such scene.
    pub fn lit(request: &Request) -> Result<Fire, Failure> {
        let name = request.text("lit");
        let mut scene = match name.strip_prefix(COMMUNITY) {
            Some(name) => {
                let given = community()?;
                let found = given.iter().find(|scene| scene.name == name);
                found.ok_or(format!("no scene {name}"))?.scene()?
            }
            None => Preset::find(name)?.scene(),
        };
        let mut world = scene.world().clone();
        let most = request.number("particles") as u32;
        let limited = most > 0 && world.model() == Model::Combustion;
        if limited && world.domain_particles() > most {
            world.set_domain_particles(most);
            scene.set_world(world);
        }
        Ok(Fire {
            simulation: Simulation::new(scene),
            history: History::default(),
            instances: Vec::new(),
            embers: Vec::new(),
            charred: Charred::default(),
            shows_sparks: true,
        })
    }

    /// Sets the values of a request.
    ///
    /// # Errors
    /// The table refuses a value.
    pub fn set(&mut self, request: &Request) -> Result<(), Failure> {
        for (id, value) in request.values() {
            let set = self.simulation.set(&id, Input::Text(&value));
            set.map_err(|refusal| format!("{id}: {refusal}"))?;
        }
        Ok(())
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        self.simulation.scene()
    }

    /// How long it has burnt \[s\].
    pub fn time(&self) -> f64 {
        self.simulation.time()
    }

    /// Burns until it has burnt for so long \[s\].
    pub fn burn(&mut self, until: f64) {
        self.history.follow(&self.simulation);
        while self.simulation.time() < until {
            self.simulation.step();
            self.history.follow(&self.simulation);
        }
    }

    /// Draws its picture.
    pub fn draw(
        &mut self,
        gl: &glow::Context,
        renderer: &mut Renderer,
        [width, height]: [u32; 2],
        on_pass: &mut dyn FnMut(&'static str),
    ) -> Result<(), RenderError> {
        let fire = &self.simulation;
        // Another display mode has forgotten the past, and a fire before its first step has none.
        self.history.follow(fire);
        let mode = fire.parameters().display_mode;
        fire.write_instances(&mut self.instances);
        fire.write_charred(&mut self.charred);
        self.embers.clear();
        if mode == DisplayMode::Fire && self.shows_sparks {
            fire.write_embers(&mut self.embers);
        }
        let temperatures: Vec<_> = fire.solid_temperatures().collect();
        renderer.upload(gl, mode, &self.instances, &self.embers);
        renderer.upload_solids(
            gl,
            fire.scene(),
            &fire.poses(),
            &temperatures,
            &self.charred,
        );
        let view = View {
            width,
            height,
            time: fire.time(),
            ..View::default()
        };
        renderer.paint_in_passes(gl, &view, fire.scene(), &self.history, on_pass)
    }
}

/// The limits of a quality by its name; medium without one.
pub fn limits(quality: &str) -> Result<ResolutionLimits, Failure> {
    let level = match quality {
        "" => Some(Level::Medium),
        named => Level::of(named),
    };
    let level = level.ok_or_else(|| format!("no quality `{quality}`"))?;
    Ok(ResolutionLimits::of(level))
}
