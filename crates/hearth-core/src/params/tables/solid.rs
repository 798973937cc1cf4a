//! THE table of a solid's properties, with entries as those of the parameters.

use crate::params::choices::{Choice, Fuel, Material, Motion, Plane, Shape, Thermal};
use crate::params::declare::{parameters, properties};
use crate::params::entry::{Description, Domain, Kind, Role, Scale};
use crate::params::outline::{Mask, Points};
use crate::params::slot::Slot;
use crate::params::table::Param;
use crate::params::value::{AnyValue, ParamError, Value};

/// The shapes that are turned, those with a width, those with a height, those with corners,
/// those with points and those with a mask.
const TURNED: &[&str] = &["box", "line", "polygon", "stroke", "mask"];
const WIDE: &[&str] = &["circle", "box", "line", "mask"];
const HIGH: &[&str] = &["box", "line", "stroke", "mask"];
const CORNERED: &[&str] = &["box"];
const POINTED: &[&str] = &["polygon", "stroke"];
const MASKED: &[&str] = &["mask"];

/// The thermal boundary conditions with a temperature, and that with a heat capacity.
const TEMPERED: &[&str] = &["fixed", "conducting"];
const CONDUCTING: &[&str] = &["conducting"];

/// The fuels that burn.
const BURNING: &[&str] = &["wood", "paper", "coal", "wax", "cloth"];

/// The motion to and fro, and that around the place.
const SWAYING: &[&str] = &["sway"];
const SPINNING: &[&str] = &["spin"];

/// The motion by forces.
const FREE: &[&str] = &["free"];

properties! {
    /// A solid: gas neither passes nor enters it. Every value is in range.
    Solid: SOLID, SOLID_DESCRIPTIONS, SOLID_NAMES;
    /// A solid that is there. One that is off neither acts nor is drawn, and keeps its values.
    enabled: flag "Enabled" { (true) }
    /// A disc, a rectangle, a line, a polygon, a bent line or a picture. Shape of the solid.
    shape: (choice Shape) "Shape" { (Circle) }
    /// A solid farther to the right, or below 0 to the left. Position of its centre.
    x: number "Place" ["m"] Linear { (0.0, -10.0..=10.0) }
    /// A solid that is higher. Height of its centre above the lower edge of the domain.
    y: number "Height" ["m"] Linear { (0.5, -10.0..=10.0) }
    /// A solid that is turned. Angle of its width from the horizontal, counterclockwise.
    angle: number "Angle" ["°"] Linear { (0.0, -360.0..=360.0) } when { shape: TURNED }
    /// A larger solid. Diameter of a circle, width of a box or a mask, length of a line.
    width: number "Width" ["m"] Log { (0.2, 0.002..=10.0) } when { shape: WIDE }
    /// A thicker solid. Height of a box or a mask, thickness of a line or a stroke. A stroke is at
    /// least as thick as an eightieth of its extent.
    height: number "Thickness" ["m"] Log { (0.1, 0.002..=10.0) } when { shape: HIGH }
    /// A rounder box. Radius of its corners, at most half of its smaller side.
    corner: number "Corner radius" ["m"] Linear { (0.0, 0.0..=5.0) } when { shape: CORNERED }
    /// A solid of any outline. Corners of a polygon or of a stroke, as pairs of numbers in metres from the
    /// centre. A polygon is closed, and what its outline winds around is solid; a stroke is open and
    /// has round ends.
    points: (text Points) "Points" ["m"] { () } when { shape: POINTED }
    /// A solid in the shape of a picture. Opacity of the pixels of a mask, which `hearth-fire/mask` makes from a text,
    /// a path or an image.
    mask: (text Mask) "Mask" { () } when { shape: MASKED }
    /// A surface of stone, wood, iron and so on. Material that is drawn; `none` is invisible.
    [Look] material: (choice Material) "Material" { (Stone) }
    /// A solid behind, within or before the fire. Gas flows around what is within it, and in every plane around a
    /// solid that has fuel, moves freely or carries a source; it passes the others, which are lit. One that is before the
    /// fire hides it. Solids later in the list are before earlier ones.
    plane: (choice Plane) "Plane" { (Within) }
    /// A surface that heats or cools the gas. Adiabatic: no heat passes. Fixed: it keeps its
    /// temperature. Conducting: the gas and radiation heat and cool the solid, which has one
    /// temperature throughout.
    thermal: (choice Thermal) "Heat" { (Adiabatic) }
    /// A hotter surface. Temperature of the surface, at first where it conducts heat.
    temperature: number "Temperature" ["K"] Linear { (293.0, 250.0..=2500.0) } when { thermal: TEMPERED }
    /// A solid that heats and cools more slowly. Heat capacity by volume; that of stone and iron is
    /// 2000 to 3500.
    heat_capacity: number "Heat capacity" ["kJ/(m³·K)"] Log { (100.0, 10.0..=5000.0) } when { thermal: CONDUCTING }
    /// A solid that burns where it is hot enough, until nothing is left. Each part has its own
    /// temperature; `thermal` has no effect. In the classic model it does not burn.
    fuel: (choice Fuel) "Fuel" { (None) }
    /// A fire that lasts longer and spreads more slowly. Dry mass of the fuel by area of the solid.
    load: number "Load" ["kg/m²"] Log { (2.0, 0.05..=200.0) } when { fuel: BURNING }
    /// A fuel that catches fire later. Mass of the water as a share of that of the dry fuel.
    moisture: number "Moisture" ["%"] Linear { (8.0, 0.0..=100.0) } when { fuel: BURNING }
    /// A solid that moves by itself, and pushes the gas. Sway: to and fro along a line. Spin: around
    /// its place. Free: it starts at its place and falls, rests on other solids and is pushed by the
    /// gas. No part of it is faster than 3 m/s, but for a free solid that hits another or hangs. With a fuel
    /// it breaks where it has burnt through, while there are fewer than 64 solids.
    motion: (choice Motion) "Motion" { (Still) }
    /// A solid that moves farther. Distance of its turning points from its place.
    sway: number "Sway" ["m"] Linear { (0.3, 0.0..=5.0) } when { motion: SWAYING }
    /// A motion along another line. Angle from the horizontal at which it starts, counterclockwise.
    heading: number "Heading" ["°"] Linear { (0.0, -360.0..=360.0) } when { motion: SWAYING }
    /// A slower motion. Time of one motion to and fro.
    period: number "Period" ["s"] Log { (4.0, 0.5..=60.0) } when { motion: SWAYING }
    /// A solid that turns faster counterclockwise or, below 0, clockwise.
    spin: number "Spin" ["°/s"] Linear { (45.0, -720.0..=720.0) } when { motion: SPINNING }
    /// A heavier solid. Its mass follows from its area; burnt material has no mass. That of wood is
    /// about 500. None is lighter than the gas beside it.
    density: number "Density" ["kg/m³"] Log { (500.0, 0.1..=10000.0) } when { motion: FREE }
    /// A solid that hangs. Id of the solid from which it hangs, by the highest of the middles of its sides.
    /// Where either burns through, it lets go. If no other solid has the id, it falls.
    hangs_from: integer "Hangs from" [""] Linear { (0, 0.0..=1_000_000.0) } when { motion: FREE }
    /// A rougher solid. Tangent of the angle at which it begins to slide on a fixed solid.
    friction: number "Friction" [""] Linear { (0.5, 0.0..=2.0) } when { motion: FREE }
    /// A solid that bounces higher. Share of the speed of an impact with which it leaves.
    restitution: number "Restitution" [""] Linear { (0.1, 0.0..=1.0) } when { motion: FREE }
}

impl Solid {
    /// The value of a property.
    pub fn get(&self, property: &Param) -> Option<AnyValue<'_>> {
        match (property.kind, property.id) {
            (Kind::Text(_), "mask") => Some(AnyValue::Text(self.mask.text())),
            (Kind::Text(_), _) => Some(AnyValue::Text(self.points.text())),
            _ => self.clone().slot(property).map(Slot::value),
        }
    }

    /// Writes a value that the entry has checked.
    ///
    /// # Errors
    /// An outline in another form.
    pub(crate) fn put(&mut self, property: &Param, value: AnyValue<'_>) -> Result<(), ParamError> {
        property.store(self.slot(property), value)
    }

    /// The field of a property.
    fn slot(&mut self, property: &Param) -> Option<Slot<'_>> {
        let place = SOLID.iter().position(|param| param.id == property.id)?;
        self.slots().nth(place)
    }
}
