//! Radiation from hot gas and from the solids that burn to these solids.
//!
//! A coarse model: blocks of hot gas and hot surfaces radiate from the middle of their power, evenly to
//! all sides. In two dimensions, a surface of the length l at the distance r gets the share
//! l cos θ/(2πr) of it. No solid shades another. All solids together get at most half of what a block
//! radiates; gas and surfaces lose the same whether solids are there or not.

use std::f32::consts::PI;

use glam::Vec2;

use super::state::{BLOCKS, Block, Fuels};
use crate::combustion::gas::Gas;
use crate::combustion::reaction::chemistry::HEAT_CAPACITY;
use crate::extremes::{fast_max, fast_min};
use crate::params::Physics;
use crate::solids::Solids;

/// How far the region reaches beyond the solids \[m\]. Gas farther away counts to its border.
const REGION_MARGIN: f32 = 0.3;
/// Smallest side of a block \[m\].
const MIN_BLOCK_SIDE: f32 = 0.05;
/// Gas hotter than this counts \[K\].
const MIN_TEMPERATURE: f32 = 600.0;
/// Largest share of its radiation that a block gives to solids.
pub(in crate::combustion) const MAX_RECEIVED_SHARE: f32 = 0.5;

impl Fuels {
    /// Finds what each cell receives.
    pub(super) fn irradiate(&mut self, gas: &Gas, solids: &Solids, values: &Physics) {
        let (mut low, mut high) = (Vec2::MAX, Vec2::MIN);
        for burning in &mut self.all {
            for cell in &mut burning.cells {
                cell.received = 0.0;
            }
            if let Some(body) = solids.first(burning.id) {
                let frame = &body.surface.frame;
                let half = frame.extent() + REGION_MARGIN;
                let (from, to) = (frame.centre - half, frame.centre + half);
                low = Vec2::new(fast_min(low.x, from.x), fast_min(low.y, from.y));
                high = Vec2::new(fast_max(high.x, to.x), fast_max(high.y, to.y));
            }
        }
        let size = (high - low) / BLOCKS as f32;
        let side = fast_max(fast_max(size.x, size.y), MIN_BLOCK_SIDE);
        self.blocks.fill(Block::default());
        let blocks = &mut self.blocks;
        let mut add = |position: Vec2, power: f32| {
            let last = BLOCKS as f32 - 1.0;
            let at = (position - low) / side;
            let column = fast_min(fast_max(at.x, 0.0), last) as usize;
            let row = fast_min(fast_max(at.y, 0.0), last) as usize;
            let block = &mut blocks[row * BLOCKS + column];
            block.power += power;
            block.moment += position * power;
        };
        let air = values.ambient_temperature;
        let rate = gas.mass * HEAT_CAPACITY * values.radiative_cooling;
        let relative = air * (1.0 / 1500.0);
        let from_air = relative * relative * relative * relative;
        for (state, &position) in gas.state.iter().zip(&gas.position) {
            if state.x > MIN_TEMPERATURE {
                let relative = state.x * (1.0 / 1500.0);
                let square = relative * relative;
                add(position, rate * (square * square - from_air));
            }
        }
        for burning in &self.all {
            let Some(body) = solids.first(burning.id) else {
                continue;
            };
            for (index, cell) in burning.cells.iter().enumerate() {
                if cell.length > 0.0 && cell.temperature > MIN_TEMPERATURE {
                    // Before its surface, so that it is not behind it.
                    let place = burning.place(index) + cell.normal * burning.side;
                    let frame = &body.surface.frame;
                    let turned = frame.axis * place.x + frame.axis.perp() * place.y;
                    add(
                        frame.centre + turned,
                        cell.radiated(air) * (cell.temperature - air),
                    );
                }
            }
        }
        for block in 0..self.blocks.len() {
            let Block { power, moment } = self.blocks[block];
            if power > 0.0 {
                let seen = self.view(solids, moment / power, 0.5 * side);
                self.receive(power * fast_min(MAX_RECEIVED_SHARE / fast_max(seen, 1e-6), 1.0));
            }
        }
    }

    /// Finds the share of a source that each cell sees, from no nearer than that. Returns that of all
    /// cells.
    fn view(&mut self, solids: &Solids, source: Vec2, nearest: f32) -> f32 {
        let mut sum = 0.0;
        for burning in &self.all {
            let Some(body) = solids.first(burning.id) else {
                continue;
            };
            let from = body.surface.frame.local(source);
            let views = &mut self.views[burning.first_beside..];
            let cells = burning.cells.iter().zip(views);
            for (index, (cell, view)) in cells.enumerate() {
                *view = 0.0;
                if cell.length <= 0.0 {
                    continue;
                }
                let path = from - burning.place(index);
                let square = fast_max(path.length_squared(), nearest * nearest);
                let share = cell.length * path.dot(cell.normal) / (2.0 * PI * square);
                if share > 0.0 {
                    sum += share;
                    *view = share;
                }
            }
        }
        sum
    }

    /// Gives each cell its share of that power.
    fn receive(&mut self, power: f32) {
        for burning in &mut self.all {
            let views = &self.views[burning.first_beside..];
            for (cell, view) in burning.cells.iter_mut().zip(views) {
                cell.received += view * power;
            }
        }
    }
}
