/**
 * The shaders of `sheets.js` as nodes, for `WebGPURenderer` with WebGPU and with WebGL2. That renderer blends light and
 * maps it afterwards, so a material gives light; where nobody maps it, light that shows the colours of the element over
 * black and over white.
 */

import { OneFactor, OneMinusSrcAlphaFactor, SrcColorFactor, ZeroFactor } from 'three';
import {
  attribute,
  cameraFar,
  cameraNear,
  cameraProjectionMatrix,
  cameraViewMatrix,
  clamp,
  cross,
  dot,
  exp,
  float,
  floor,
  fract,
  log,
  max,
  min,
  mix,
  mod,
  orthographicDepthToViewZ,
  perspectiveDepthToViewZ,
  positionGeometry,
  pow,
  select,
  sin,
  smoothstep,
  sqrt,
  step,
  texture,
  uniform,
  varying,
  vec2,
  vec3,
  vec4,
  viewportDepthTexture,
} from 'three/tsl';
import { NodeMaterial } from 'three/webgpu';
import { BLENDED } from './body.js';

/** @typedef {any} Node */

/** How a filter goes into a picture: it multiplies the colours, and covers. */
const FILTERED = {
  blendSrc: ZeroFactor,
  blendDst: SrcColorFactor,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: OneMinusSrcAlphaFactor,
};

/** Depth of the scene before the fires, which share it. */
const DEPTH = viewportDepthTexture();

const brightest = (/** @type {Node} */ light) => max(light.r, max(light.g, light.b));

const toLinear = (/** @type {Node} */ shown) =>
  mix(shown.div(12.92), pow(shown.add(0.055).div(1.055), vec3(2.4)), step(0.04045, shown));

/** @param {Node} given */
function toShown(given) {
  const light = clamp(given, 0, 1);
  return mix(
    light.mul(12.92),
    pow(light, vec3(1 / 2.4))
      .mul(1.055)
      .sub(0.055),
    step(0.0031308, light),
  );
}

/** Light and coverage of a cell. @param {Node} cell */
function lightOf(cell) {
  const alpha = max(cell.a, 0.5);
  const light = toLinear(cell.rgb.div(alpha));
  const peak = min(brightest(light), 0.9965);
  return vec4(light.mul(log(peak.oneMinus()).negate().div(max(peak, 1e-4))), alpha.mul(2).sub(1));
}

const over = (/** @type {Node} */ front, /** @type {Node} */ behind) => front.add(behind.mul(front.a.oneMinus()));

/** Hearth's own tone map. @param {Node} light @param {Node} coverage @param {Node} lit @param {Node} pale */
function toneMapped(light, coverage, lit, pale) {
  const peak = brightest(light);
  const excess = max(peak.sub(0.8), 0);
  const share = excess.mul(excess).div(excess.mul(excess).add(50));
  const yellow = vec3(share, share.mul(share.mul(-0.7).add(1.7)), share.mul(share));
  const colour = mix(light.div(max(peak, 1e-6)), pale.rgb, mix(vec3(share), yellow, pale.w));
  const first = toShown(colour.mul(exp(peak.negate()).oneMinus()));
  const shown = brightest(first);
  const bare = coverage.oneMinus().mul(shown.oneMinus());
  const last = mix(first, sqrt(first.mul(shown)), bare.mul(bare).mul(0.9));
  const alpha = clamp(coverage, shown, 1);
  const dark = alpha.sub(shown);
  return vec4(last.add(lit.mul(dark.mul(dark).div(max(alpha, 1e-4)))), alpha);
}

/** Light that shows premultiplied colours over black, and what they let through of white. @param {Node} shown */
function lightFor(shown) {
  const black = toLinear(clamp(shown.rgb, 0, 1));
  const white = toLinear(clamp(shown.rgb.add(shown.a.oneMinus()), 0, 1));
  return { light: black, clear: white.sub(black) };
}

/**
 * The materials of a fire.
 * @param {{[name: string]: any}} values at first
 * @returns {import('./body.js').Materials}
 */
export function nodeMaterials({ atlas, ...values }) {
  const named = Object.entries(values).map(([name, value]) => [name, uniform(value)]);
  /** @type {{[name: string]: Node}} */
  const uniforms = { ...Object.fromEntries(named), atlas: texture(atlas), mapped: uniform(0) };
  const { texels, area, origin, right, up, size, depth, pale, lens, soft, close, pixels, mapped } = uniforms;
  /** @param {{[name: string]: Node}} nodes */
  const material = (nodes) => Object.assign(new NodeMaterial(), BLENDED, { fog: false, lights: false }, nodes);

  /** A place of the fire, for the camera. @param {Node} at @param {Node} behind */
  const placed = (at, behind) => {
    const beside = right
      .mul(at.x)
      .add(up.mul(at.y))
      .add(cross(up, right).mul(behind.mul(depth)));
    return cameraViewMatrix.mul(vec4(origin.add(beside.mul(size)), 1));
  };
  /** A cell of the atlas. @param {Node} number @param {Node} at */
  const cell = (number, at) => {
    const isBehind = step(0.5, number);
    const side = isBehind.mul(-1).add(2);
    const corner = vec2(floor(number.sub(1).mul(0.5)).add(2), mod(number.sub(1), 2)).mul(isBehind);
    const half = vec2(0.5).div(texels.mul(side));
    const place = corner.add(clamp(at, half, half.oneMinus()).mul(side)).div(vec2(5, 2));
    return uniforms.atlas.sample(vec2(place.x, place.y.oneMinus())).level(0);
  };
  /** Emission, and what is let through of the light behind. @param {Node} light @param {Node} glow @param {Node} lit */
  const shownOf = (light, glow, lit) => {
    const sum = light.rgb.add(glow);
    const dark = max(light.a.sub(exp(brightest(sum).negate()).oneMinus()), 0);
    const shown = lightFor(toneMapped(sum, light.a, lit, pale));
    return {
      light: mix(sum.add(toLinear(lit).mul(dark)), shown.light, mapped),
      clear: mix(vec3(light.a.oneMinus()), shown.clear, mapped),
    };
  };

  const sheet = attribute('sheet', 'float');
  const view = placed(mix(area.xy, area.zw, positionGeometry.xy), sheet.mul(0.25).sub(0.5));
  const isVisible = step(0.25, cell(sheet, vec2(0.5)).a);
  const at = varying(positionGeometry.xy);
  const slice = floor(varying(sheet).add(0.5));
  const away = varying(view.z.negate());

  const here = cell(slice, at);
  let next = vec4(0);
  for (let number = 4; number > 0; number -= 1) {
    const other = cell(float(number), at);
    const counts = step(0.25, other.a).mul(step(slice.add(0.5), number));
    next = mix(next, over(lightOf(other), next), counts);
  }
  const lit = cell(float(6), at).rgb;
  const glow = lightOf(cell(float(5), at)).rgb.mul(step(slice, 0.5));
  const all = shownOf(over(lightOf(here), next), glow, lit);
  const behind = shownOf(next, vec3(0), lit);
  const through = clamp(all.clear.div(max(behind.clear, 1e-4)), 0, 1);
  const own = max(all.light.sub(behind.light.mul(through)), 0);

  const rim = smoothstep(vec2(0), vec2(0.1), min(at, at.oneMinus()));
  const near = smoothstep(0, 1, away.sub(cameraNear).div(close));
  const stored = DEPTH.r;
  const isOrthographic = cameraProjectionMatrix.element(3).element(3).equal(1);
  const thing = select(
    isOrthographic,
    orthographicDepthToViewZ(stored, cameraNear, cameraFar),
    perspectiveDepthToViewZ(stored, cameraNear, cameraFar),
  ).negate();
  const free = clamp(thing.sub(away).div(max(soft.mul(size), 1e-6)), 0, 1);
  const share = rim.x
    .mul(mix(1, rim.y, step(0.5, at.y)))
    .mul(near)
    .mul(free);

  // Each ember flies in a plane of its own.
  const ember = attribute('ember', 'vec4');
  const seed = attribute('seed', 'float');
  const middle = cameraProjectionMatrix.mul(placed(ember.xy, fract(seed.mul(4.7e4)).sub(0.5)));
  const across = pixels.mul(size).mul(seed).div(middle.w);
  const offset = positionGeometry.xy
    .mul(max(across.mul(3), 2.5))
    .mul(lens.zw)
    .mul(middle.w);
  const bright = smoothstep(0, 0.2, ember.w)
    .mul(pow(ember.z.div(1500), 4))
    .mul(2.5);
  const glint = sin(fract(seed.mul(9.1e4)).mul(6.2832).add(ember.w.mul(40)))
    .mul(0.3)
    .add(0.7);
  const colour = vec3(1, ember.z.mul(0.62 / 1500).sub(0.2), 0.12);
  const spark = varying(
    colour.mul(
      bright
        .mul(glint)
        .mul(min(across.div(0.8), 1))
        .mul(step(1e-3, ember.z)),
    ),
  );
  const corner = varying(positionGeometry.xy);
  const inside = max(dot(corner, corner).oneMinus(), 0);
  const light = spark.mul(pow(inside, 3));

  const vertexNode = mix(vec4(2, 2, 2, 1), cameraProjectionMatrix.mul(view), isVisible);
  const passing = mix(vec3(1), through, share);
  return {
    uniforms,
    // A channel of the light behind passes by a share of its own: one material multiplies by them, the next one adds.
    sheets: [
      Object.assign(material({ vertexNode, fragmentNode: vec4(passing, passing.g.oneMinus()) }), FILTERED),
      material({ vertexNode, fragmentNode: vec4(own.mul(share), 0) }),
    ],
    embers: material({
      vertexNode: vec4(middle.xy.add(offset), middle.zw),
      fragmentNode: vec4(mix(light, exp(light.negate()).oneMinus(), mapped), 0),
    }),
  };
}
