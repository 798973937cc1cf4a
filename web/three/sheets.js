/**
 * The shaders that put the atlas of a fire into a world of three.js: a sheet for each slice, from the back, and embers.
 *
 * Colours of a screen do not add, so a sheet shows what its slice changes: S(k) − (1 − a) S(k + 1), with the displayed
 * colours S of a slice over all behind it, and the coverage a that it adds. Seen from the front, the sheets add up to the
 * picture of the element; a thing between two of them hides those behind it.
 */

/** Places: the sheets face the camera about the vertical. */
const PLACE = /* glsl */ `
uniform vec4 area;    // left, lower, right, upper edge of the picture in the fire [m]
uniform vec3 origin;  // where the middle of its floor is in the world
uniform vec3 right;   // its directions
uniform vec3 up;
uniform float size;   // of a metre of the fire
uniform float depth;  // of the fire [m]

vec4 placed(vec2 at, float behind) {
  vec3 back = cross(up, right);
  return viewMatrix * vec4(origin + size * (right * at.x + up * at.y + back * (behind * depth)), 1.0);
}
`;

/** The atlas, whose cells are empty where no slice is visible. */
const CELL = /* glsl */ `
uniform sampler2D atlas;
uniform vec2 texels; // size of a cell

// The light of a slice from the front, then glow and light on smoke.
vec4 cell(float number, vec2 at) {
  float side = number == 0.0 ? 2.0 : 1.0;
  vec2 corner = number == 0.0 ? vec2(0.0) : vec2(2.0 + floor(0.5 * (number - 1.0)), mod(number - 1.0, 2.0));
  vec2 half_texel = 0.5 / (side * texels);
  vec2 place = (corner + side * clamp(at, half_texel, 1.0 - half_texel)) / vec2(5.0, 2.0);
  return texture2D(atlas, vec2(place.x, 1.0 - place.y));
}
`;

export const VERTEX = /* glsl */ `
attribute float sheet; // its number from the front
varying vec2 at;
flat varying float slice;
varying float away;
${PLACE}
${CELL}
void main() {
  at = position.xy;
  slice = sheet;
  vec4 view = placed(mix(area.xy, area.zw, at), 0.25 * sheet - 0.5);
  away = -view.z;
  gl_Position = cell(sheet, vec2(0.5)).a < 0.25 ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * view;
}
`;

export const FRAGMENT = /* glsl */ `
${CELL}
varying vec2 at;
flat varying float slice;
varying float away;
uniform vec4 pale;     // colour to which overexposed light pales; 1: by way of yellow
uniform float size;
uniform sampler2D sceneDepth;
uniform vec4 lens;     // near and far, 1 / size of the target
uniform float soft;    // distance over which it fades at things [m]; 0: without their depth
uniform float close;   // distance from the camera over which it fades [m]

float brightest(vec3 light) { return max(light.r, max(light.g, light.b)); }

vec3 toLinear(vec3 shown) {
  return mix(shown / 12.92, pow((shown + 0.055) / 1.055, vec3(2.4)), step(0.04045, shown));
}

vec3 toShown(vec3 light) {
  light = clamp(light, 0.0, 1.0);
  return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}

// Light and coverage of a cell.
vec4 lightOf(vec4 cell) {
  float alpha = max(cell.a, 0.5);
  vec3 light = toLinear(cell.rgb / alpha);
  float peak = min(brightest(light), 0.9965);
  return vec4(light * (-log(1.0 - peak) / max(peak, 1e-4)), 2.0 * alpha - 1.0);
}

vec4 over(vec4 front, vec4 behind) { return front + (1.0 - front.a) * behind; }

// Hearth's own tone map, as in its shader of that name.
vec4 toneMapped(vec3 light, float coverage, vec3 lit) {
  float peak = brightest(light);
  float excess = max(peak - 0.8, 0.0);
  float share = excess * excess / (excess * excess + 50.0);
  vec3 shares = mix(vec3(share), vec3(share, share * (1.7 - 0.7 * share), share * share), pale.w);
  vec3 colour = toShown((1.0 - exp(-peak)) * mix(light / max(peak, 1e-6), pale.rgb, shares));
  peak = brightest(colour);
  float bare = (1.0 - coverage) * (1.0 - peak);
  colour = mix(colour, sqrt(colour * peak), 0.9 * bare * bare);
  float alpha = clamp(coverage, peak, 1.0);
  float dark = alpha - peak;
  return vec4(colour + lit * (dark * dark / max(alpha, 1e-4)), alpha);
}

// Premultiplied colours: emission, and the coverage of what is behind.
vec4 shownOf(vec4 light, vec3 glow, vec3 lit) {
  vec3 sum = light.rgb + glow;
#ifndef TONE_MAPPING
  // A target that is not for a screen gets light.
  if (linearToOutputTexel(vec4(0.5)).r > 0.6) return toneMapped(sum, light.a, lit);
#endif
  float dark = max(light.a - (1.0 - exp(-brightest(sum))), 0.0);
  vec4 all = vec4(sum + toLinear(lit) * dark, light.a);
#ifdef TONE_MAPPING
  all.rgb = toneMapping(all.rgb);
#endif
  return linearToOutputTexel(all);
}

void main() {
  vec4 here = cell(slice, at);
  vec4 glowing = slice == 0.0 ? cell(5.0, at) : vec4(vec3(0.0), 0.5);
  // A slice without light and coverage, but for the atlas's dither, changes nothing. In a loop, since a processor that draws
  // computes both sides of a branch, and what follows a discard.
  float passes = here.a < 0.503 && brightest(here.rgb + glowing.rgb) < 0.006 ? 0.0 : 1.0;
  gl_FragColor = vec4(0.0);
  for (float pass = 0.0; pass < passes; pass++) {
    vec4 next = vec4(0.0);
    for (float number = 4.0; number > slice; number--) {
      vec4 other = cell(number, at);
      if (other.a > 0.25) next = over(lightOf(other), next);
    }
    vec3 lit = cell(6.0, at).rgb;
    vec4 all = shownOf(over(lightOf(here), next), lightOf(glowing).rgb, lit);
    vec4 behind = shownOf(next, vec3(0.0), lit);
    float through = clamp((1.0 - all.a) / max(1.0 - behind.a, 1e-4), 0.0, 1.0);
    vec4 own = vec4(max(all.rgb - through * behind.rgb, 0.0), 1.0 - through);
    vec2 rim = smoothstep(vec2(0.0), vec2(0.1), min(at, 1.0 - at));
    float share = rim.x * mix(1.0, rim.y, step(0.5, at.y)) * smoothstep(0.0, 1.0, (away - lens.x) / close);
    if (soft > 0.0) {
      float stored = texture2D(sceneDepth, gl_FragCoord.xy * lens.zw).r;
      float range = lens.y - lens.x;
      float thing = isOrthographic ? lens.x + stored * range : lens.x * lens.y / (lens.y - stored * range);
      share *= clamp((thing - away) / (soft * size), 0.0, 1.0);
    }
    gl_FragColor = own * share;
  }
}
`;

export const EMBER_VERTEX = /* glsl */ `
attribute vec4 ember; // place, temperature [K], remaining share of its life
attribute float seed; // its diameter, which names it [m]
uniform float pixels; // of a metre at a distance of 1
uniform vec4 lens;
varying vec4 spark;
varying vec2 corner;
${PLACE}
void main() {
  corner = position.xy;
  // Each flies in a plane of its own.
  gl_Position = projectionMatrix * placed(ember.xy, fract(seed * 4.7e4) - 0.5);
  float across = pixels * size * seed / gl_Position.w;
  gl_Position.xy += corner * max(3.0 * across, 2.5) * lens.zw * gl_Position.w;
  float bright = 2.5 * smoothstep(0.0, 0.2, ember.w) * pow(ember.z / 1500.0, 4.0);
  float glint = 0.7 + 0.3 * sin(6.2832 * fract(seed * 9.1e4) + 40.0 * ember.w);
  spark = vec4(vec3(1.0, 0.62 * ember.z / 1500.0 - 0.2, 0.12) * bright * glint * min(1.0, across / 0.8), ember.z > 0.0);
}
`;

export const EMBER_FRAGMENT = /* glsl */ `
varying vec4 spark;
varying vec2 corner;
void main() {
  float inside = max(1.0 - dot(corner, corner), 0.0);
  vec3 light = spark.rgb * spark.a * inside * inside * inside;
#ifdef TONE_MAPPING
  light = toneMapping(light);
#else
  if (linearToOutputTexel(vec4(0.5)).r > 0.6) light = 1.0 - exp(-light);
#endif
  gl_FragColor = linearToOutputTexel(vec4(light, 0.0));
}
`;
