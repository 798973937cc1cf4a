//! The calls of the tests.

use std::collections::BTreeMap;

use hearth_core::params::{Kind, PARAMETERS, Param};
use hearth_core::preset::Preset;
use hearth_render::{Chromaticity, NEUTRAL_KELVIN, Renderer, chromaticity};
use serde_json::{Value, json};

use crate::fire::{self, Fire};
use crate::painter::Painter;
use crate::request::Request;
use crate::{Answer, Failure, foreign};

/// Time between two pictures of fires that are drawn in turn \[s\].
const PICTURE: f64 = 1.0 / 30.0;

/// What calls leave for later ones.
pub struct Calls {
    painter: Painter,
    /// Fires that have burnt, by the request: many pictures are of one fire.
    burnt: BTreeMap<String, Fire>,
    film: Option<Film>,
}

/// A fire that is drawn picture by picture.
struct Film {
    fire: Fire,
    renderer: Renderer,
    size: [u32; 2],
}

impl Calls {
    /// None so far.
    pub fn new() -> Result<Calls, Failure> {
        Ok(Calls {
            painter: Painter::new()?,
            burnt: BTreeMap::new(),
            film: None,
        })
    }

    /// The answer to a request.
    pub fn answer(&mut self, request: &Request) -> Answer {
        let json = match request.text("call") {
            "presets" => names(Preset::all().iter().map(|preset| preset.name)),
            "scenes" => json!(fire::scenes()?),
            "modes" => names(modes()),
            "disturbances" => names(foreign::DISTURBANCES.iter().map(|(name, _)| *name)),
            "format" => json!(self.painter.format()),
            "locus" => locus(request),
            "values" => values(request)?,
            "still" => return self.still(request),
            "inTurn" => return self.in_turn(request),
            "film" => self.begin_film(request)?,
            "picture" => return self.picture(request),
            other => return Err(format!("no call `{other}`").into()),
        };
        Ok((json, Vec::new()))
    }

    /// A fire that stands still.
    fn still(&mut self, request: &Request) -> Answer {
        let mut fire = self.burnt(request)?.clone();
        fire.set(request)?;
        let (quality, format) = (request.text("quality"), request.text("format"));
        let mut renderer = self.painter.renderer(quality, format)?;
        let pixels = self.painter.draw(&mut renderer, &mut fire, request.size()?);
        renderer.destroy(self.painter.gl());
        Ok((Value::Null, pixels?))
    }

    /// The fire of a request, burnt, before its values are set.
    fn burnt(&mut self, request: &Request) -> Result<&Fire, Failure> {
        let key = ["lit", "burnt", "particles"].map(|field| request.0[field].to_string());
        let key = key.join(" ");
        if !self.burnt.contains_key(&key) {
            let mut fire = Fire::lit(request)?;
            fire.burn(request.required("burnt")?);
            self.burnt.insert(key.clone(), fire);
        }
        self.burnt.get(&key).ok_or_else(|| "no fire".into())
    }

    /// Fires in one context, drawn in turn, picture by picture: the last picture of each.
    fn in_turn(&mut self, request: &Request) -> Answer {
        let painter = &self.painter;
        let mut fires = Vec::new();
        for request in request.list("fires") {
            let fire = burning(&request, 0.0)?;
            let begin = request.required("burnt")?;
            fires.push((
                fire,
                painter.renderer("medium", "")?,
                request.size()?,
                begin,
                Vec::new(),
            ));
        }
        let disturbance = request.text("disturbance");
        for picture in 1..=request.required("pictures")? as u32 {
            for (fire, renderer, size, begin, pixels) in &mut fires {
                fire.burn(*begin + f64::from(picture) * PICTURE);
                if !disturbance.is_empty() {
                    foreign::disturb(painter.gl(), disturbance)?;
                }
                *pixels = painter.draw(renderer, fire, *size)?;
            }
        }
        let mut last = Vec::new();
        let mut lengths = Vec::new();
        for (_, renderer, _, _, pixels) in fires {
            renderer.destroy(painter.gl());
            lengths.push(pixels.len());
            last.extend(pixels);
        }
        Ok((json!(lengths), last))
    }

    /// Begins a film of a fire that burns; its time \[s\].
    fn begin_film(&mut self, request: &Request) -> Result<Value, Failure> {
        if let Some(film) = self.film.take() {
            film.renderer.destroy(self.painter.gl());
        }
        let film = Film {
            fire: burning(request, request.required("burnt")?)?,
            renderer: self.painter.renderer(request.text("quality"), "")?,
            size: request.size()?,
        };
        let time = film.fire.time();
        self.film = Some(film);
        Ok(json!(time))
    }

    /// The picture of the film at a time \[s\]: pixels, and with `light` its light as floats behind them. It shows
    /// sparks unless `sparks` is false.
    fn picture(&mut self, request: &Request) -> Answer {
        let film = self.film.as_mut().ok_or("there is no film")?;
        film.fire.burn(request.required("time")?);
        film.fire.shows_sparks = request.0["sparks"] != false;
        let (renderer, fire) = (&mut film.renderer, &mut film.fire);
        if request.0["light"] != true {
            return Ok((Value::Null, self.painter.draw(renderer, fire, film.size)?));
        }
        let (mut pixels, light) = self.painter.draw_with_light(renderer, fire, film.size)?;
        pixels.extend(light.iter().flat_map(|number| number.to_le_bytes()));
        Ok((Value::Null, pixels))
    }
}

/// A fire with the values of its request, burnt for so long \[s\].
fn burning(request: &Request, seconds: f64) -> Result<Fire, Failure> {
    let mut fire = Fire::lit(request)?;
    fire.set(request)?;
    fire.burn(seconds);
    Ok(fire)
}

/// All values of the fire of a request, as a person would write them.
fn values(request: &Request) -> Result<Value, Failure> {
    let fire = burning(request, 0.0)?;
    let values = PARAMETERS.iter().map(|param| {
        let value = fire.scene().value(param);
        (param.id.to_owned(), Value::from(value.to_string()))
    });
    Ok(Value::Object(values.collect()))
}

/// The names of the display modes.
fn modes() -> impl Iterator<Item = &'static str> {
    let names = match Param::find("display_mode").map(|param| param.kind) {
        Some(Kind::Choice(names)) => names,
        _ => &[],
    };
    names.iter().copied()
}

/// Where black bodies of these temperatures \[K\] stand in CIE's chart to a camera with this white balance: x, y.
fn locus(request: &Request) -> Value {
    let white = request.0["white"].as_f64().unwrap_or(NEUTRAL_KELVIN);
    let kelvins = request.0["kelvins"].as_array().into_iter().flatten();
    let places = kelvins.filter_map(Value::as_f64).map(|kelvin| {
        let Chromaticity { x, y } = chromaticity(kelvin, white);
        json!([x, y])
    });
    places.collect()
}

fn names<'a>(names: impl Iterator<Item = &'a str>) -> Value {
    names.collect()
}
