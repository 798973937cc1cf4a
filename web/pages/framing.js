/**
 * The fit of scenes whose objects are as wide as the domain: a narrow stage would cut a word to two
 * letters. The other scenes fill the height of the stage, and their fire is large on a phone too.
 */

/** The scenes that a stage shows whole. */
export const WHOLE = [
  'burning-word',
  'curtains',
  'fireplace',
  'house-of-cards',
  'paper-boat',
  'ring-of-fire',
  'rope',
  'sheltered-candle',
  'wooden-word',
];

/**
 * Sets `fit` for the present scene and later ones, unless the page or its URL sets `fit`.
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
export function frameScenes(fire) {
  if (fire.hasAttribute('fit')) return;
  const fit = () => {
    if (WHOLE.includes(fire.preset)) fire.fit = 'contain';
    else fire.removeAttribute('fit');
  };
  // A fire that starts reports no change: a scene that a visitor chose meanwhile is that of `ready`.
  for (const event of ['ready', 'params-change']) fire.addEventListener(event, fit);
  fit();
}
