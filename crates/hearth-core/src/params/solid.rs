//! THE table of a solid's properties, with entries as those of the parameters.

use super::choices::{Choice, Material, Shape, Thermal};
use super::declare::{parameters, properties};
use super::entry::{Description, Domain, Kind, Role, Scale};
use super::property::Property;
use super::slot::Slot;
use super::table::Param;
use super::value::Value;

/// The shapes with two sizes, and those with corners.
const LONG: &[&str] = &["box", "line"];
const CORNERED: &[&str] = &["box"];

/// The thermal boundary condition with a temperature.
const FIXED: &[&str] = &["fixed"];

properties! {
    /// A solid: gas neither passes nor enters it. Every value is in range.
    Solid: SOLID, SOLID_DESCRIPTIONS, SOLID_PROPERTIES, SOLID_NAMES;
    /// A disc, a rectangle or a line. Shape of the solid.
    shape: (choice Shape) "Shape" { (Circle) }
    /// A solid farther to the right, or below 0 to the left. Position of its centre.
    x: number "Place" ["m"] Linear { (0.0, -10.0..=10.0) }
    /// A solid that is higher. Height of its centre above the lower edge of the frame.
    y: number "Height" ["m"] Linear { (0.5, -10.0..=10.0) }
    /// A solid that is turned. Angle of its width from the horizontal, counterclockwise.
    angle: number "Angle" ["°"] Linear { (0.0, -360.0..=360.0) } when { shape: LONG }
    /// A larger solid. Diameter of a circle, width of a box, length of a line.
    width: number "Width" ["m"] Log { (0.2, 0.002..=10.0) }
    /// A thicker solid. Height of a box, thickness of a line.
    height: number "Thickness" ["m"] Log { (0.1, 0.002..=10.0) } when { shape: LONG }
    /// A rounder box. Radius of its corners, at most half of its smaller side.
    corner: number "Corner radius" ["m"] Linear { (0.0, 0.0..=5.0) } when { shape: CORNERED }
    /// Another appearance. Material that is drawn; `none` is invisible.
    [Look] material: (choice Material) "Material" { (Stone) }
    /// A surface that heats or cools the gas. Adiabatic: no heat passes. Fixed: it keeps its
    /// temperature.
    thermal: (choice Thermal) "Heat" { (Adiabatic) }
    /// A hotter surface. Temperature of the surface.
    temperature: number "Temperature" ["K"] Linear { (293.0, 250.0..=2500.0) } when { thermal: FIXED }
}

impl Solid {
    /// The value of a property.
    pub fn get(&self, property: &Param) -> Option<Value> {
        let place = place(property)?;
        self.clone().slots().nth(place).map(Slot::value)
    }

    /// Writes a checked value.
    pub(crate) fn put(&mut self, property: &Param, value: Value) {
        let slot = place(property).and_then(|place| self.slots().nth(place));
        if let Some(slot) = slot {
            slot.put(value);
        }
    }
}

/// The place of a property in the table.
fn place(property: &Param) -> Option<usize> {
    SOLID.iter().position(|one| one.id == property.id)
}
