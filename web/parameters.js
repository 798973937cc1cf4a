// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

import { PARAMETERS, PRESETS as TABLE } from './generated/table.js';

export { QUANTITIES } from './generated/quantities.js';
export { PARAMETERS };

/** What a preset looks like. */
const TEXTS = [
  "A broad fire in still air, at every parameter's default.",
  "A large fire that a steady wind leans over, and its sparks with it.",
  "A small heap of logs that catch fire one after another and burn away.",
  "A word of glowing coal that burns along its letters.",
  "A broad, lively fire in the open that throws sparks.",
  "A small flame, steady as in a room without a draught.",
  "Curtains in a draught that a candle sets on fire.",
  "A fire of logs on a grate of iron, in an opening of bricks below its flue.",
  "A campfire on a stone floor before a wall of bricks, which it lights.",
  "Low, wide and white-hot before a wall of bricks, full of sparks.",
  "Small blue flames of gas that was mixed with air before it burns, on five nozzles.",
  "Pale flames that rise slowly, as no fire does.",
  "A house of cards that a small flame sets on fire at a corner, and that falls as it burns.",
  "A small flame that flickers, leans and smokes a little.",
  "A paper boat that the draught of a fire draws in, sets on fire and lifts.",
  "A hoop of iron that burns all around.",
  "A rope that burns upward from its knot, and falls.",
  "A candle in a draught, behind a plate that moves up and down.",
  "Rich fuel and little air: dark red flames under rolling smoke.",
  "A tall, restless flame from a narrow head, on a wall.",
  "A broad front of flames, in slow motion.",
  "A word of wood that a small flame sets on fire at one end, and that burns away.",
  "The student paper's model, with its mistakes put right.",
  "As Paper, plain, with much more buoyancy and shorter lives: the fire is narrower.",
  "The classic model drawn as in the paper: the fire that four other scenes change.",
  "As Paper, plain, with a three times larger smoothing radius: its particles cluster.",
  "As Paper, plain, with a ten times larger gas constant: the fire is wider.",
  "As Paper, plain, with more viscosity, in the force as the paper prints it: the fire spreads to both sides.",
  "The program that Hearth grew from: a narrow column of sparse dots.",
];

/** Named sets of values: the defaults, with these changed. */
export const PRESETS = TABLE.map((preset, at) => ({ ...preset, description: TEXTS[at] }));
