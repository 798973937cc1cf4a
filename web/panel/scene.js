/**
 * The scene that a fire started from: its values and its objects, which are the panel's defaults.
 */

import { entriesOf, isSame } from './objects.js';
import { OBJECTS, SOURCE } from '../generated/scene-objects.js';
import { PARAMETERS, PRESETS } from '../generated/table.js';

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('../parameters.js').ModelName} ModelName
 * @typedef {import('../parameters.js').HearthParameters[Id]} Value
 * @typedef {Partial<import('../parameters.js').HearthParameters>} Values
 * @typedef {import('../parameters.js').Parameter['domains']} Domains
 * @typedef {import('./objects.js').Fields} Fields
 * @typedef {Pick<HearthFire, 'preset' | 'params' | 'objects'> & {history?: {settings: object}}} Fire
 */

/** @type {Map<string, Domains>} */
export const DOMAINS = new Map(PARAMETERS.map(({ id, domains }) => [id, domains]));

/** The parameter that decides which others apply. */
export const MODEL = /** @type {import('../parameters.js').Parameter} */ (PARAMETERS.find(({ id }) => id === 'model'));

/** The model of a fire without one. */
const DEFAULT_MODEL = /** @type {ModelName} */ (MODEL.default);

/** The properties that name a solid. */
const LINKS = ['solid', 'hangs_from'];

/** The fields of a domain. */
const FIELDS = /** @type {const} */ (['default', 'min', 'max']);

/** The default of a parameter in a model. @type {(id: Id, model: ModelName) => Value | undefined} */
export function modelDefault(id, model) {
  return DOMAINS.get(id)?.[model]?.default;
}

/** The scene that a fire started from. @param {Fire} fire */
export function presetOf({ preset: name = 'default' }) {
  return PRESETS.find((preset) => preset.name === name);
}

/** The values that the scene sets, with its model. @param {Fire} fire @returns {Values} */
export function valuesOf(fire) {
  return { model: DEFAULT_MODEL, ...presetOf(fire)?.values };
}

/**
 * The value of a parameter in the scene and the current model. If the scene has another model, its values
 * apply to the parameters with the same domain in both.
 * @type {(fire: Fire, id: Id) => Value | undefined}
 */
export function sceneValue(fire, id) {
  const values = valuesOf(fire);
  /** @type {Domains} */
  const domains = DOMAINS.get(id) ?? {};
  const domain = domains[fire.params?.model ?? DEFAULT_MODEL];
  const sceneDomain = domains[values.model ?? DEFAULT_MODEL];
  const shared = sceneDomain && FIELDS.every((field) => sceneDomain[field] === domain?.[field]);
  const value = domain && (domain === sceneDomain || shared ? (values[id] ?? domain.default) : domain.default);
  return id === SOURCE.solid ? idOf(fire, Number(value)) : value;
}

/** The id of the object that has this number in the scene. @type {(fire: Fire, number: number) => number} */
function idOf({ history }, number) {
  const { first = 1 } = /** @type {{first?: number}} */ (history?.settings ?? {});
  return number && number + first - 1;
}

/**
 * The objects of the scene. The properties of its first source are parameters, and missing ones have
 * the defaults.
 * @param {Fire} fire
 * @returns {Fields[]}
 */
export function sceneObjects(fire) {
  const others = OBJECTS[presetOf(fire)?.name ?? ''] ?? [];
  const objects = /** @type {Fields[]} */ ([{ kind: 'source' }, ...others]);
  return objects.map((fields, index) => {
    const links = LINKS.filter((name) => name in fields).map((name) => [name, idOf(fire, fields[name])]);
    return { ...fields, ...Object.fromEntries(links), id: idOf(fire, index + 1) };
  });
}

/**
 * The value of a property in the scene. An object that the scene lacks has the defaults.
 * @type {(fire: Fire, object: Fields, name: string) => Value | undefined}
 */
export function sceneProperty(fire, { id, kind }, name) {
  const [first, ...others] = sceneObjects(fire);
  if (id === first.id && kind === first.kind && name in SOURCE)
    return sceneValue(fire, /** @type {Id} */ (SOURCE[/** @type {keyof typeof SOURCE} */ (name)]));
  const same = others.find((other) => other.id === id && other.kind === kind);
  const entry = entriesOf(kind).find((property) => property.name === name);
  return same?.[name] ?? entry?.domain(fire.params?.model ?? DEFAULT_MODEL)?.default;
}

/** Whether the objects have the values of the scene; those of the first source are parameters. @param {Fire} fire */
export function hasSceneObjects(fire) {
  const scene = sceneObjects(fire);
  const objects = /** @type {Fields[]} */ (fire.objects ?? scene.slice(0, 1));
  return (
    objects.length === scene.length &&
    objects.every((object, index) => {
      const { id, kind } = scene[index];
      if (object.id !== id || object.kind !== kind) return false;
      return index === 0
        ? !object.name
        : Object.keys(object).every(
            (name) => name === 'id' || name === 'kind' || isSame(object[name], sceneProperty(fire, object, name)),
          );
    })
  );
}

/** The label of the scene, with a note if the fire has changed since. @param {Fire} fire */
export function sceneOf(fire) {
  const scene = presetOf(fire);
  if (!scene) return '';
  const same = PARAMETERS.every(({ id }) => [undefined, fire.params?.[id]].includes(sceneValue(fire, id)));
  return same && hasSceneObjects(fire) ? scene.label : `${scene.label}, changed`;
}
