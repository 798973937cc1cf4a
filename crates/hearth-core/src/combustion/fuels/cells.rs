//! The cells of a solid that burns.
//!
//! They are a grid over the box of the solid, in its own frame, so they move with it.

use std::sync::Arc;

use glam::Vec2;

use super::material::Material;
use crate::extremes::{fast_max, fast_min};
use crate::params::{Fuel, Solid};
use crate::scene::{Field, RoundedBox, Surface};

/// Most cells along a side.
const MAX_CELLS_ALONG: f32 = 48.0;
/// Smallest share of a cell that the solid fills.
const MIN_FILLED_SHARE: f32 = 0.35;
/// Depths below the surface at which a cell touches the gas, in halves of a cell.
const DEPTHS: [f32; 8] = [-1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
/// Mass of fuel and char over the area of a cell, half of which does not stand [kg/m²].
const HALF_STANDING_MASS: f32 = 0.5;
/// No cell.
pub(super) const NONE: u16 = u16::MAX;

/// A part of a solid that burns; masses per metre of depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Cell {
    /// Temperature \[K\].
    pub temperature: f32,
    /// Dry mass at first [kg/m]; 0 without any of the solid.
    pub first: f32,
    /// Mass of fuel, of water and of char with its ash [kg/m].
    pub fuel: f32,
    pub water: f32,
    pub char: f32,
    /// Length of the surface in it \[m\], and the normal there, outward in the frame of the solid.
    pub length: f32,
    pub normal: Vec2,
    /// The cell at the surface through which its gas leaves, or [`NONE`].
    pub vent: u16,
    /// Radiation that it receives [kW/m].
    pub received: f32,
    /// For how long a pilot flame still heats it \[s\].
    pub pilot: f32,
    /// Its gas that waits for gas beside the solid, as a mass of fuel of the gas [kg/m].
    pub waiting: f32,
    /// Whether another part of the solid has, or had, what was here.
    pub is_apart: bool,
}

impl Cell {
    /// Heat capacity [kJ/(m·K)].
    pub fn capacity(&self, material: &Material) -> f32 {
        // Enough for a finite temperature.
        fast_max(
            (self.fuel + self.char) * material.capacity
                + self.water * super::material::WATER_CAPACITY,
            1e-9,
        )
    }

    /// Mass [kg/m].
    pub fn mass(&self) -> f32 {
        self.fuel + self.char + self.water
    }

    /// Char that can burn [kg/m].
    pub fn carbon(&self, material: &Material) -> f32 {
        fast_max(self.char - material.ash * self.first, 0.0)
    }

    /// Share of the fuel that it has given off.
    pub fn charred(&self) -> f32 {
        if self.first > 0.0 {
            1.0 - self.fuel / self.first
        } else {
            0.0
        }
    }

    /// How much of it stands: 1 until half of its char has burnt, then less.
    pub fn standing(&self, material: &Material, load: f32) -> f32 {
        let thin = fast_max(0.5 * (material.char - material.ash), 0.05);
        let weak = fast_min(fast_max(thin, HALF_STANDING_MASS / load), 0.5) * self.first;
        let left = self.fuel + self.carbon(material);
        fast_min(left / fast_max(weak, 1e-12), 1.0)
    }
}

/// A solid that burns, or has burnt.
#[derive(Clone, Debug)]
pub(super) struct Burning {
    /// Its id, and that of the object whose part it is: the same until a part breaks off.
    pub id: u32,
    pub object: u32,
    pub material: &'static Material,
    /// What it was made of, and the shape at first, around its centre.
    pub(super) fuel: Fuel,
    pub load: f32,
    pub moisture: f32,
    pub(super) shape: Surface,
    /// The spacing that it was made for \[m\].
    pub(super) spacing: f32,
    /// Dry mass of the whole solid at first [kg/m].
    pub whole: f32,
    /// From the middle of the whole solid to that of the grid \[m\].
    pub origin: Vec2,
    /// Whether a part has broken off, or it is one; and the parts that hold together only because
    /// there are as many solids as there may be.
    pub is_broken: bool,
    pub unbroken: u32,
    pub columns: usize,
    pub rows: usize,
    /// Half of the size of the grid, and the size of a cell \[m\].
    pub half: Vec2,
    pub side: Vec2,
    pub cells: Vec<Cell>,
    /// The place of its first cell among those of all solids.
    pub first_beside: usize,
    /// The surface of what is left; `None` before any of it is lost.
    pub left: Option<Arc<Field>>,
    /// How much stood when the surface was found, over all cells.
    pub stood: f32,
    pub account: Account,
}

/// What a solid that burns has given and taken since it was lit; masses in kg/m, heat in kJ/m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Account {
    /// Mass of gas, of steam, of burnt char, and of what has fallen off.
    pub gas: f64,
    pub steam: f64,
    pub oxidised: f64,
    pub fallen: f64,
    /// Heat that came in, that left, and that the gas beside it lost.
    pub gained: f64,
    pub lost: f64,
    pub exchanged: f64,
    /// Heat of its gas that burnt in the film at its surface.
    pub flames: f64,
    /// Power of the gas given off and of the char that burnt in the last step [kW/m].
    pub power: f32,
    /// Oxygen beside it, relative to air.
    pub oxygen: f32,
    /// Whether it ever burnt, and whether it lacks oxygen.
    pub lit: bool,
    pub starved: bool,
}

crate::state! {
    Cell: temperature first fuel water char length normal vent received pilot waiting is_apart,
    Burning: id object material fuel load moisture shape spacing whole origin is_broken unbroken columns rows
        half side cells first_beside left stood account,
    Account: gas steam oxidised fallen gained lost exchanged flames power oxygen lit starved
}

impl Burning {
    /// The cells of a solid; `None` if it has no fuel.
    pub fn new(
        id: u32,
        solid: &Solid,
        surface: &Surface,
        spacing: f32,
        air: f32,
    ) -> Option<Burning> {
        let material = Material::of(solid.fuel)?;
        let frame = surface.frame;
        let half = frame.half + frame.radius;
        let longest = 2.0 * fast_max(half.x, half.y);
        let side = fast_max(spacing, longest / MAX_CELLS_ALONG);
        let count = |half: f32| ((2.0 * half / side + 0.5) as usize).max(1);
        let (columns, rows) = (count(half.x), count(half.y));
        let shape = Surface {
            frame: RoundedBox {
                centre: Vec2::ZERO,
                axis: Vec2::X,
                ..frame
            },
            field: surface.field.clone(),
        };
        let mut burning = Burning {
            id,
            object: id,
            material,
            fuel: solid.fuel,
            load: solid.load,
            moisture: solid.moisture,
            shape,
            spacing,
            whole: 0.0,
            origin: Vec2::ZERO,
            is_broken: false,
            unbroken: 0,
            columns,
            rows,
            half,
            side: 2.0 * half / Vec2::new(columns as f32, rows as f32),
            cells: vec![Cell::default(); columns * rows],
            first_beside: 0,
            left: None,
            stood: 0.0,
            account: Account::default(),
        };
        burning.fill(air);
        burning.whole = burning.cells.iter().map(|cell| cell.first).sum();
        burning.stood = burning.standing();
        burning.find_surface();
        Some(burning)
    }

    /// Fills the cells inside of the shape, with all of the mass together.
    fn fill(&mut self, air: f32) {
        let smaller = fast_min(self.side.x, self.side.y);
        let (mut filled, mut nearest) = (0.0, (f32::MAX, 0));
        for index in 0..self.cells.len() {
            let (distance, _) = self.shape.distance(self.place(index));
            let share = fast_min(fast_max(0.5 - distance / smaller, 0.0), 1.0);
            if distance < nearest.0 {
                nearest = (distance, index);
            }
            if share >= MIN_FILLED_SHARE {
                filled += share;
                self.cells[index].first = share;
            }
        }
        // A shape that is finer than a cell fills none.
        if filled == 0.0 {
            (self.cells[nearest.1].first, filled) = (1.0, 1.0);
        }
        let (area, _) = self.shape.measures();
        let each = self.load * area / fast_max(filled, 1e-6);
        for cell in &mut self.cells {
            cell.temperature = air;
            cell.first *= each;
            cell.fuel = cell.first;
            cell.water = 0.01 * self.moisture * cell.first;
        }
    }

    /// The middle of a cell.
    pub fn place(&self, index: usize) -> Vec2 {
        let columns = self.columns.max(1);
        let (column, row) = (index % columns, index / columns);
        Vec2::new(column as f32 + 0.5, row as f32 + 0.5) * self.side - self.half
    }

    /// The cell at a place.
    pub fn at(&self, place: Vec2) -> Option<usize> {
        let at = (place + self.half) / self.side;
        let (column, row) = (at.x as usize, at.y as usize);
        let inside = at.x >= 0.0 && at.y >= 0.0 && column < self.columns && row < self.rows;
        inside.then_some(row * self.columns + column)
    }

    /// The distance of a place from the surface of what is left, and the normal there.
    pub fn distance(&self, place: Vec2) -> (f32, Vec2) {
        match &self.left {
            None => self.shape.distance(place + self.origin),
            Some(field) => field.distance(place),
        }
    }

    /// Half of the box that its material is drawn on, and the radius around it \[m\]. A sampled shape
    /// is as thick as it is deep.
    pub fn drawn(&self) -> [f32; 3] {
        let frame = &self.shape.frame;
        match &self.shape.field {
            None => [frame.half.x, frame.half.y, frame.radius],
            Some(field) if field.round => [0.02 * field.depth, 0.02 * field.depth, field.depth],
            Some(field) => [field.depth, field.depth, 0.0],
        }
    }

    /// Half of the size of the whole solid \[m\].
    pub fn whole_half(&self) -> Vec2 {
        self.shape.frame.half + self.shape.frame.radius
    }

    /// The distance of a place from the surface at first.
    pub fn first_distance(&self, place: Vec2) -> f32 {
        self.shape.distance(place + self.origin).0
    }

    /// The cells that touch the gas at a place of the surface with that normal, and the share of each:
    /// char is porous, so what a cell has given off is the share of those below it.
    pub fn below(&self, surface: Vec2, normal: Vec2, act: &mut dyn FnMut(usize, f32) -> bool) {
        let depth = 0.5 * fast_min(self.side.x, self.side.y);
        let (mut left, mut last, mut outermost) = (1.0, None, None);
        for times in DEPTHS {
            let Some(index) = self.at(surface - normal * (depth * times)) else {
                continue;
            };
            let cell = &self.cells[index];
            if cell.mass() <= 0.0 || last == Some(index) {
                continue;
            }
            last = Some(index);
            outermost = outermost.or(last);
            let share = left * fast_max(1.0 - cell.charred(), 0.0);
            left -= share;
            if share > 0.0 && !act(index, share) {
                return;
            }
        }
        if let Some(index) = outermost {
            act(index, left);
        }
    }

    /// One of these cells, for a number from 0 to 1 that chooses it.
    pub fn one_below(&self, surface: Vec2, normal: Vec2, mut chosen: f32) -> Option<usize> {
        let mut found = None;
        self.below(surface, normal, &mut |index, share| {
            chosen -= share;
            found = Some(index);
            chosen > 0.0
        });
        found
    }

    /// Finds the surface in each cell, and where the gas of each cell leaves.
    pub fn find_surface(&mut self) {
        let smaller = fast_min(self.side.x, self.side.y);
        let mut sum = 0.0;
        for cell in &mut self.cells {
            (cell.length, cell.normal, cell.vent) = (0.0, Vec2::ZERO, NONE);
        }
        for index in 0..self.cells.len() {
            let place = self.place(index);
            let (distance, normal) = self.distance(place);
            let near = fast_max(1.0 - distance.abs() / smaller, 0.0);
            let (mut meets, mut count, mut vent) = ([(0, 0.0); DEPTHS.len() + 1], 0, NONE);
            self.below(place - normal * distance, normal, &mut |index, share| {
                meets[count] = (index, share * near);
                count += 1;
                vent = if vent == NONE { index as u16 } else { vent };
                true
            });
            self.cells[index].vent = vent;
            for &(index, near) in &meets[..count] {
                let cell = &mut self.cells[index];
                cell.length += near;
                cell.normal += normal * near;
                sum += near;
            }
        }
        let (_, circumference) = match &self.left {
            None => self.shape.measures(),
            Some(field) => field.measures(),
        };
        let each = circumference / fast_max(sum, 1e-6);
        for (index, cell) in self.cells.iter_mut().enumerate() {
            cell.length *= each;
            cell.normal = cell.normal.normalize_or_zero();
            if cell.length > 0.0 {
                cell.vent = index as u16;
            }
        }
    }

    /// How much stands, over all cells.
    pub fn standing(&self) -> f32 {
        let cells = self.cells.iter().filter(|cell| cell.first > 0.0);
        cells
            .map(|cell| cell.standing(self.material, self.load))
            .sum()
    }

    /// Heat that it stores, relative to air of that temperature [kJ/m].
    pub fn stored(&self, air: f32) -> f64 {
        let each = |cell: &Cell| {
            f64::from(cell.capacity(self.material)) * f64::from(cell.temperature - air)
        };
        let full = self.cells.iter().filter(|cell| cell.mass() > 0.0);
        full.map(each).sum()
    }
}
