// A solid behind the displayed fire: its material, the light of the fire on it, and its own glow.
#include "distance.glsl"
#include "palette.glsl"
#include "tone.glsl"

in vec2 uv;
flat in vec3 turn;
flat in vec3 grid;
in vec2 spot;

uniform sampler2D shown;
uniform sampler2D glow;       // square root of light / range
uniform sampler2D irradiance; // square root of 16 irradiance / range
uniform sampler2D noise;      // a tile; 0.5 is zero
uniform vec2 floor_middle; // middle of the world's floor, 0–1 over the picture
uniform vec2 picture_size; // [m]
uniform vec2 per_height;   // height of the domain as a share of the picture, across and up
uniform float light_range; // maximum radiance in targets
uniform float gain;        // brightness of a surface of 1500 K
uniform vec3 sky;          // light of the background
uniform float breath;      // tiles by which the noise of embers has moved

out vec4 pixel;

const float NEAR_LIT = 0.7; // brightness of the light nearby
const float FAR_LIT = 85.0 / 16.0; // and of the irradiance
const float PALE = 0.15;    // share of the irradiance that loses its hue, so that materials keep theirs
const float AROUND = 0.1;   // distance of the irradiance that gives its direction, in heights of the domain
const float TOUCH = 0.025;  // distance of the light that touches a surface
const vec3 NIGHT = vec3(0.07, 0.075, 0.09); // bluish light without the fire
const float BEVEL = 0.3;    // rounded share of a thickness

vec4 rough(vec2 place) {
    return texture(noise, place + turn.z) * 2.0 - 1.0;
}

vec3 light_at(vec2 side) {
    vec3 root = texture(irradiance, uv + side * AROUND * per_height).rgb;
    vec3 light = root * root;
    return mix(light, vec3(dot(light, vec3(0.333))), PALE);
}

// Temperature [kK] and char of a cell.
vec2 cell_at(vec2 at) {
    float number = listed(grid.xy, ivec2(clamp(at, vec2(0.0), grid.yz - 1.0)));
    return vec2(floor(number) * 1e-3, fract(number));
}

void main() {
    vec3 at = surface(local, node);
    float material = floor(body.w / SURFACES);
    float kilokelvin = (body.w - material * SURFACES) * 1e-3;
    bool front = material >= FRONT;
    if (front) material -= FRONT;
    float inner = min(body.x, body.y);
    float size = inner + body.z;
    float rim = clamp(1.0 + at.z / (body.z + BEVEL * inner), 0.0, 1.0);
    vec2 place = local / size;
    vec2 normal = at.xy * rim;
    mat2 turned = mat2(turn.xy, -turn.y, turn.x);
    vec4 worn = rough(place * 0.17);
    vec4 fine = rough(place * 0.41);
    // Stone.
    vec3 colour = vec3(0.33, 0.31, 0.285) * (1.0 + 0.45 * worn.x + 0.5 * fine.w) * mix(0.5, 1.0, smoothstep(0.0, 0.07, abs(worn.y + 0.2 * fine.w)));
    vec2 bump = 0.22 * worn.yz + 0.16 * fine.yz;
    float shine = 0.0; // brightness of the highlight
    float cover = 1.0;
    float ember = 0.0; // share of the surface that glows
    float soft = 0.0;  // share of the light that spreads inside
    if (material == 1.0) {
        // Bark around a trunk, or a plank. One end of a trunk shows its rings.
        worn = rough(vec2(0.05 * place.x, body.y > 0.0 ? 0.3 * place.y : place.y * (0.35 + 0.15 * place.y * place.y)));
        float ridge = abs(worn.x + 0.5 * worn.w);
        colour = mix(vec3(0.05, 0.03, 0.018), vec3(0.3, 0.18, 0.1) * (1.0 + 0.4 * worn.y), smoothstep(0.0, 0.4, ridge));
        bump = vec2(0.1, 0.5) * worn.zw;
        float side = turn.y > 0.0 ? -1.0 : 1.0;
        vec2 end = body.x > 0.0 ? vec2(place.x * side - body.x / size - 0.42, place.y) / vec2(0.52, 0.8) : place / 0.92;
        float radius = length(end) + (body.y > 0.0 ? 9.0 : 0.0);
        float face = 1.0 - smoothstep(0.95, 1.0, radius);
        float ring = sin(22.0 * radius + 4.0 * rough(end * 0.08).x);
        colour = mix(colour, vec3(0.46, 0.3, 0.165) * (1.0 + 0.2 * ring - 0.3 * radius), face);
        ember = (1.0 - smoothstep(0.0, 0.2, ridge)) * smoothstep(0.0, 0.5, fine.x) * (1.0 - face);
        normal = mix(normal, vec2(body.x > 0.0 ? 0.45 * side : 0.0, 0.0), face);
        bump *= 1.0 - face;
    } else if (material == 2.0) {
        colour = vec3(0.06, 0.061, 0.065) * (1.0 + 0.3 * fine.w);
        bump *= 0.15;
        shine = 1.2;
    } else if (material == 3.0) {
        // Courses, every other one shifted by half a brick.
        vec2 brick = min(vec2(0.21, 0.07), size * vec2(1.8, 0.667));
        vec2 cell = local / brick + 0.5;
        cell.x += 0.5 * mod(floor(cell.y), 2.0);
        vec2 edge = (0.5 - abs(fract(cell) - 0.5)) * brick / brick.y;
        float joint = smoothstep(0.03, 0.12, min(edge.x, edge.y) + 0.03 * fine.w);
        colour = mix(vec3(0.17, 0.16, 0.145), mix(vec3(0.33, 0.13, 0.08), vec3(0.48, 0.23, 0.145),
            0.5 + rough(floor(cell) * vec2(0.173, 0.291)).x) * (1.0 + 0.3 * fine.x), joint);
        bump *= 0.6;
    } else if (material == 4.0) {
        colour = vec3(0.035) * (1.0 + fine.w);
        bump *= 3.0;
        ember = (1.0 - smoothstep(0.0, 0.35, abs(worn.x + 0.2 * fine.w))) * smoothstep(-0.4, 0.3, worn.y);
        soft = 0.3;
    } else if (material == 5.0) {
        colour = vec3(0.8, 0.72, 0.55);
        bump *= 0.0;
        soft = 0.6;
        shine = 0.15;
    } else if (material == 6.0) {
        colour = vec3(0.8, 0.9, 0.9) * rim * rim * rim;
        bump *= 0.0;
        shine = 1.0;
        cover = 0.12 + 0.6 * rim * rim * rim;
    }
    if (grid.y > 0.0) {
        vec2 low = floor(spot);
        vec2 part = spot - low;
        vec2 state = mix(mix(cell_at(low), cell_at(low + vec2(1.0, 0.0)), part.x),
                         mix(cell_at(low + vec2(0.0, 1.0)), cell_at(low + 1.0), part.x), part.y);
        kilokelvin = state.x;
        // Char begins in spots.
        colour *= 1.0 - 0.9 * smoothstep(0.0, 0.3, state.y + 0.2 * fine.w);
    }
    vec2 tilt = turned * (normal + bump);
    vec3 facing = normalize(vec3(tilt, sqrt(max(1.0 - dot(normal, normal), 0.0)) + 0.05));
    // The irradiance, and the direction of the fire from its slope.
    vec3 left = light_at(vec2(-1.0, 0.0));
    vec3 right = light_at(vec2(1.0, 0.0));
    vec3 below = light_at(vec2(0.0, -1.0));
    vec3 above = light_at(vec2(0.0, 1.0));
    vec3 fire_light = left + right + below + above;
    vec2 slope = vec2(dot(right - left, vec3(1.0)), dot(above - below, vec3(1.0))) / (0.25 * dot(fire_light, vec3(1.0)) + 1e-6);
    vec3 towards = normalize(vec3(slope, 0.45));
    vec3 touch = texture(glow, uv + tilt * TOUCH * per_height).rgb;
    fire_light *= 0.25 * FAR_LIT * light_range;
    vec3 nearby = touch * touch * NEAR_LIT * light_range;
    float lit = mix(max(0.8 * dot(facing, towards) + 0.2, 0.0), 0.7, soft);
    float gloss = pow(max(dot(facing, normalize(towards + vec3(0.0, 0.0, 1.0))), 0.0), 40.0) * shine;
    // The floor, and what lies before a rim, take light away.
    float open = (1.0 - 0.4 * rim * rim * rim) * mix(0.3, 1.0, smoothstep(0.0, 0.5, (uv.y - floor_middle.y) * picture_size.y / size));
    if (material == 1.0) {
        // Wood in the flame is black, and its cracks glow.
        float burnt = grid.y > 0.0 ? 0.0 : smoothstep(0.05, 0.5, max(nearby.r, 0.02 * fire_light.r));
        colour *= 1.0 - 0.75 * burnt;
        ember *= burnt;
    }
    vec3 seen = open * (colour * (lit * fire_light + nearby + (NIGHT + sky) * (1.2 + facing.y)) + gloss * fire_light);
    if (grid.y > 0.0) {
        ember = smoothstep(0.65, 0.9, kilokelvin + 0.15 * fine.w);
    } else if (kilokelvin > 0.0) {
        // A solid of a fixed temperature glows everywhere.
        ember = 1.0 - 0.5 * rim * rim;
    } else {
        kilokelvin = 0.8 + 0.35 * ember;
    }
    if (ember > 0.0) seen += radiance(kilokelvin + 0.07 * rough(place * 0.07 + breath).x) * (gain * ember);
    cover = max(cover, min(gloss * fire_light.r, 0.9));
    // Nothing of the fire is over a solid before it.
    vec4 fire = front ? vec4(0.0) : texture(shown, uv);
    vec3 shaded = fire.rgb + displayed(seen) * (1.0 - fire.a);
    pixel = dither(vec4(shaded, 1.0)) * (cover * clamp(0.5 - at.z / pixel_size, 0.0, 1.0));
}
