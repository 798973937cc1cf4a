// A solid behind the displayed fire: its material, the light of the fire on it, and its own glow.
#include "distance.glsl"
#include "palette.glsl"
#include "tone.glsl"

in vec2 uv;
flat in vec3 turn;
flat in vec3 grid;
in vec2 spot;
in vec2 world;
flat in vec4 frame_a;
flat in vec4 frame_b;
flat in vec3 box_a;
flat in vec3 box_b;

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

out vec4 pixel;

const float NEAR_LIT = 0.7; // brightness of the light nearby
const float FAR_LIT = 300.0 / 16.0; // and of the irradiance
const float AROUND = 0.1;   // distance of the irradiance that gives its direction, in heights of the domain
const float TOUCH = 0.025;  // distance of the light that touches a surface
const vec3 NIGHT = vec3(0.03, 0.033, 0.045); // bluish light without the fire
const float BEVEL = 0.3;    // rounded share of a thickness
const float RAISED = 0.05;  // added to the height of a normal, so that one at a rim is defined
const float DARKEST = 1e-6; // light below which there is no direction
// The direction to the fire: its height over the slope of the irradiance, and the brightness of a
// surface that faces it, of one across it, and of one that light enters.
const float TOWARDS = 0.55;
const float BACKLIT = -0.35; // that height for a solid before the fire: its face is dark, and edges towards the fire are bright
const float FACING = 0.6;
const float ACROSS = 0.2;
const float INSIDE = 0.7;
const float SHARPNESS = 40.0; // exponent of the highlight
const float SKY_FROM_ABOVE = 1.2; // light of the sky on a vertical surface; an upward one gets 1 more
// Light is lost at the rim, and near the floor, which is dark within half of a solid's size.
const float LOST_AT_RIM = 0.4;
const float AT_FLOOR = 0.3;
const float ABOVE_FLOOR = 0.5;
// The solid before another takes this share of its light. The share falls between two distances from a place that
// is a step nearer to the fire, all in half thicknesses.
const float CONTACT = 0.85;
const float CONTACT_FULL = -0.3;
const float CONTACT_END = 1.3;
const float CONTACT_STEP = 0.35;
const float WITHIN = 1.0; // number of the plane within the fire
const float GLINT = 0.9; // maximum coverage by a highlight

// Coordinates of the noise are in sizes of the solid. Factors on them decorrelate reads.
const float WORN_PLACE = 0.17;
const float FINE_PLACE = 0.41;

// Stone: colour, shares of noise in its brightness, and cracks: their darkness, width and raggedness.
const vec3 STONE = vec3(0.33, 0.31, 0.285);
const float STAINS = 0.45;
const float GRAIN = 0.5;
const float CRACK = 0.5;
const float CRACK_WIDTH = 0.07;
const float RAGGED = 0.2;
// Relief: the surface is lit by how much lower it is a step nearer to the fire. The step is in sizes.
const float RELIEF_STEP = 0.05;
const float RELIEF = 0.5;
const float BARK_RELIEF = 1.2;
// Slope of the surface by broad and fine noise.
const float BUMPS = 0.22;
const float FINE_BUMPS = 0.16;

// Wood. Bark is stretched along a trunk; across a round one, rows of it crowd towards its sides.
const float ALONG = 0.05;
const float ACROSS_PLANK = 0.3;
const float ACROSS_TRUNK = 0.35;
const float CROWDED = 0.15;
const float FURROWS = 0.5; // share of fine noise in the furrows
const vec3 FURROW = vec3(0.085, 0.053, 0.034);
const vec3 BARK = vec3(0.25, 0.16, 0.1);
const float BARK_STAINS = 0.4;
const float FURROW_WIDTH = 0.55;
// The sawn end of a trunk in view: place and size in half thicknesses; that of a disc is its face.
const float END_PLACE = 0.42;
const vec2 END_SIZE = vec2(0.52, 0.8);
const float DISC_SIZE = 0.88;
const float NO_END = 9.0; // radius of a plank, beyond every face
const float END_EDGE = 0.95;
const float RINGS = 22.0; // [rad] for each radius
const float MEANDER = 4.0; // of a ring [rad]
const float RING_PLACE = 0.08;
// Checks, the radial cracks of dry wood: their darkness, width, and where they end inside.
const float CHECK = 0.3;
const float CHECK_WIDTH = 0.1;
const float CHECK_PLACE = 0.13;
const float CHECK_INNER = 0.15;
const float CHECK_OUTER = 0.6;
const vec3 SAWN = vec3(0.2, 0.125, 0.075);
const float RING_CONTRAST = 0.2;
const float DARKER_OUTSIDE = 0.45;
const float END_SLOPE = 0.45; // of its normal, to the side that is in view
const float GRAZING = 0.5; // loss of the light from before it
const float END_DOME = 0.4; // of the normal of a cross section, at its rim
// Burning bark glows in furrows of this width, where fine noise is above zero.
const float GLOWING_FURROW = 0.2;
const float GLOWING_SPOTS = 0.5;
// Wood chars between these brightnesses of the light nearby, to which the irradiance adds a little.
const float SINGED = 0.05;
const float CHARRED = 0.5;
const float FAR_CHARS = 0.02;
const float CHAR_LOSS = 0.75; // of colour

const vec3 IRON_COLOUR = vec3(0.06, 0.061, 0.065);
const float IRON_GRAIN = 0.3;
const float IRON_BUMPS = 0.15;
const float IRON_SHINE = 1.2;

// Bricks: size [m], and at most these shares of a small solid's size.
const vec2 BRICK_SIZE = vec2(0.21, 0.07);
const vec2 MAX_BRICK = vec2(1.8, 0.667);
// Mortar ends and a brick begins at these distances from its edge, in its heights; noise moves them.
const float JOINT = 0.03;
const float BRICK_FACE = 0.12;
const float BRICK_RAGGED = 0.03;
// Joints are recessed: the step towards the fire whose height shades a place, in heights of a brick, and how much.
const float JOINT_STEP = 0.09;
const float JOINT_RELIEF = 1.1;
const vec3 MORTAR = vec3(0.11, 0.1, 0.09);
const vec3 DARK_CLAY = vec3(0.2, 0.095, 0.065);
const vec3 PALE_CLAY = vec3(0.4, 0.23, 0.155);
const float UNLIKE = 0.45; // share of a brick's own noise in its brightness
const vec2 CELL_PLACE = vec2(0.173, 0.291); // decorrelates the clay of bricks
const float CLAY_GRAIN = 0.3;
const float BRICK_BUMPS = 0.3;

const vec3 COAL_COLOUR = vec3(0.013);
const float COAL_BUMPS = 3.0; // broken faces
// Coal glows in cracks of this width, where broad noise is between these values.
const float COAL_CRACK = 0.35;
const float COAL_DARK = 0.4; // below zero
const float COAL_BRIGHT = 0.3;
const float COAL_SOFT = 0.3;

const vec3 WAX_COLOUR = vec3(0.82, 0.77, 0.66);
const float WAX_SOFT = 0.6; // light spreads in wax
const float WAX_SHINE = 0.15;
// Light enters wax at its top and is lost on the way down: the share that is left far below, what the top gains, and the
// depth over which it is lost [m].
const float WAX_DARK = 0.2;
const float WAX_LIT = 1.9;
const float WAX_DEPTH = 0.032;
const float WAX_ASIDE = 0.4; // share that is lost at its sides, away from the wick
const vec3 PAPER_COLOUR = vec3(0.8, 0.78, 0.72);
const float CRUMPLED = 0.5; // slope of paper by broad noise

// Glass is seen at its rim.
const vec3 GLASS_COLOUR = vec3(0.8, 0.9, 0.9);
const float GLASS_COVER = 0.12;
const float GLASS_RIM = 0.6;

// Cloth: a sheet of linen hangs in folds, one across a box, whose edges are between them; a line is a rope. Turns of both for each half
// thickness [rad], their slope and relief, and the light in a turn of a rope and in a fold.
const vec3 ROPE_COLOUR = vec3(0.55, 0.44, 0.31);
const vec3 LINEN_COLOUR = vec3(0.7, 0.66, 0.58);
const float FOLDS = 3.1416;
const float TWIST = 3.59;
const float FOLD_SLOPE = 0.95;
const float TWIST_RELIEF = 0.4;
const float IN_TURN = 0.25;
const float IN_FOLD = 0.3;
const float SHARP_FOLDS = 0.5; // narrowness of the dark side of a turn
const float CREST_DULL = 0.75; // charred cloth glows in its turns
const float FINE_FOLDS = 0.14; // share of three narrow folds in each
const float WEAVE = 0.1;      // share of noise in the brightness of linen
// A fold leans to a side: its crest's distance from the middle of its box in halves of that, and the turns of the lean for
// each half of its width [rad/m], so that unlike folds lean unlike and boxes that hang from each other alike.
const float LEANING = 0.3;
const float LEANS = 400.0;
const float UNEVEN_FOLDS = 0.14; // meander of folds, none at the ends, where another cloth may hang
const float CLOTH_SOFT = 0.3; // light passes through cloth

// A solid with fuel: loss of colour by char, and the char of a full loss, which begins in spots.
const float CHAR_DARK = 0.9;
const float FULL_CHAR = 0.3;
const float CHAR_SPOTS = 0.2;
// Cells glow between these temperatures [kK], unevenly.
const float CELL_DARK = 0.65;
const float CELL_GLOWING = 0.9;
const float CELL_UNEVEN = 0.15;
// A fixed temperature: loss of glow at the rim. Embers of wood and coal: coolest, and range [kK].
const float RIM_DARK = 0.5;
const float EMBER_COOLEST = 0.8;
const float EMBER_RANGE = 0.35;
// Embers breathe by the heat of the flame: they are hotter by so much for its light nearby, up to a most [kK].
const float PER_LIGHT = 0.12;
// Without a fire, as where water has put it out, embers are cooler by the first [kK]; a fire of the second light keeps them hot.
const float COOLED = 0.45;
const float KEPT_HOT = 0.04;
const float MOST_HEAT = 0.25;

vec4 rough(vec2 place) {
    return texture(noise, place + turn.z) * 2.0 - 1.0;
}

vec3 light_at(vec2 side) {
    vec3 root = texture(irradiance, uv + side * AROUND * per_height).rgb;
    return root * root;
}

// A place in the noise of bark, which is stretched along a trunk and crowds towards its sides, or of a plank. Around
// a cross section it runs inwards.
vec2 bark_place(vec2 place) {
    if (max(body.x, body.y) <= 0.0) return ACROSS_TRUNK * place * (0.5 / (length(place) + DARKEST) + 0.5);
    return vec2(ALONG * place.x, body.y > 0.0 ? ACROSS_PLANK * place.y : place.y * (ACROSS_TRUNK + CROWDED * place.y * place.y));
}

// Height of bark; furrows are at zero.
float ridge_of(vec4 worn) {
    return abs(worn.x + FURROWS * worn.w);
}

// Temperature [kK] and char of a cell.
vec2 cell_at(vec2 at) {
    float number = listed(grid.xy, ivec2(clamp(at, vec2(0.0), grid.yz - 1.0)));
    return vec2(floor(number) * 1e-3, fract(number));
}

// Share of the light that the solid before this one leaves at a place [m].
float beside_solid(vec2 place, vec2 towards, vec4 frame, vec3 box) {
    float thick = min(box.x, box.y) + box.z;
    vec2 from = place + CONTACT_STEP * thick * towards - frame.xy;
    vec2 beyond = abs(vec2(dot(from, frame.zw), frame.z * from.y - frame.w * from.x)) - box.xy;
    float away = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - box.z;
    return 1.0 - CONTACT * (1.0 - smoothstep(CONTACT_FULL * thick, CONTACT_END * thick, away)) * step(DARKEST, thick);
}

// A brick and the height of its face above the mortar. Every other course is shifted by half a brick.
vec3 brick_at(vec2 place, vec2 brick, float ragged) {
    vec2 cell = place + 0.5;
    cell.x += 0.5 * mod(floor(cell.y), 2.0);
    vec2 edge = (0.5 - abs(fract(cell) - 0.5)) * brick / brick.y;
    return vec3(floor(cell), smoothstep(JOINT, BRICK_FACE, min(edge.x, edge.y) + ragged));
}

void main() {
    vec3 at = surface(local, node);
    float material = floor(body.w / MATERIAL_FACTOR);
    float kilokelvin = (body.w - material * MATERIAL_FACTOR) * 1e-3;
    float plane = floor(material / PLANE_FACTOR);
    material -= plane * PLANE_FACTOR;
    float inner = min(body.x, body.y);
    float size = inner + body.z;
    float rim = clamp(1.0 + at.z / (body.z + BEVEL * inner), 0.0, 1.0);
    vec2 place = local / size;
    vec2 normal = at.xy * rim;
    // A round stone is an ellipsoid.
    if (material < WOOD && field.y == 0.0) normal = mix(normal, local / (body.xy + body.z), body.z / size);
    mat2 turned = mat2(turn.xy, -turn.y, turn.x);
    // The irradiance, and the direction of the fire from its slope.
    vec3 left = light_at(vec2(-1.0, 0.0));
    vec3 right = light_at(vec2(1.0, 0.0));
    vec3 below = light_at(vec2(0.0, -1.0));
    vec3 above = light_at(vec2(0.0, 1.0));
    vec3 fire_light = left + right + below + above;
    vec2 slope = vec2(dot(right - left, vec3(1.0)), dot(above - below, vec3(1.0))) / (0.25 * dot(fire_light, vec3(1.0)) + DARKEST);
    vec3 towards = normalize(vec3(slope, plane > WITHIN ? BACKLIT : TOWARDS));
    vec2 nearer = place + RELIEF_STEP * (towards.xy * turned);
    vec4 worn = rough(material == WOOD ? bark_place(place) : place * WORN_PLACE);
    vec4 fine = rough(place * FINE_PLACE);
    vec4 beside = rough(material == WOOD ? bark_place(nearer) : nearer * FINE_PLACE);
    vec3 colour = STONE * (1.0 + STAINS * worn.x + GRAIN * fine.w) * mix(CRACK, 1.0, smoothstep(0.0, CRACK_WIDTH, abs(worn.y + RAGGED * fine.w)));
    vec3 bump = vec3(BUMPS * worn.yz + FINE_BUMPS * fine.yz, RELIEF * (fine.x - beside.x)); // slope and relief
    float shine = 0.0; // brightness of the highlight
    float cover = 1.0;
    float ember = 0.0; // share of the surface that glows
    float end_on = 0.0; // share of a cross section
    float dull = 0.0;  // loss of glow
    float soft = 0.0;  // share of the light that spreads inside
    if (material == WOOD) {
        // Bark around a trunk, or a plank. One end of a trunk shows its rings.
        float ridge = ridge_of(worn);
        colour = mix(FURROW, BARK * (1.0 + BARK_STAINS * worn.y), smoothstep(0.0, FURROW_WIDTH, ridge));
        float side = turn.y > 0.0 ? -1.0 : 1.0;
        vec2 end = body.x > 0.0 ? vec2(place.x * side - body.x / size - END_PLACE, place.y) / END_SIZE : place / DISC_SIZE;
        float radius = length(end) + (body.y > 0.0 ? NO_END : 0.0);
        float face = 1.0 - smoothstep(END_EDGE, 1.0, radius);
        float ring = sin(RINGS * radius + MEANDER * rough(end * RING_PLACE).x);
        float check = (1.0 - smoothstep(0.0, CHECK_WIDTH, abs(rough(end / (radius + DARKEST) * CHECK_PLACE).x))) * smoothstep(CHECK_INNER, CHECK_OUTER, radius);
        colour = mix(colour, SAWN * (1.0 + RING_CONTRAST * ring - DARKER_OUTSIDE * radius) * mix(1.0, CHECK, check), face);
        bump = vec3(0.0, 0.0, BARK_RELIEF * (1.0 - face) * (min(ridge, FURROW_WIDTH) - min(ridge_of(beside), FURROW_WIDTH)));
        ember = (1.0 - smoothstep(0.0, GLOWING_FURROW, ridge)) * smoothstep(0.0, GLOWING_SPOTS, fine.x) * (1.0 - face);
        end_on = body.x > 0.0 ? 0.0 : face;
        normal = mix(normal, body.x > 0.0 ? vec2(END_SLOPE * side, 0.0) : END_DOME * place, face);
    } else if (material == IRON) {
        colour = IRON_COLOUR * (1.0 + IRON_GRAIN * fine.w);
        bump *= IRON_BUMPS;
        shine = IRON_SHINE;
    } else if (material == BRICK) {
        vec2 brick = min(BRICK_SIZE, size * MAX_BRICK);
        vec3 here = brick_at(local / brick, brick, BRICK_RAGGED * fine.w);
        vec3 there = brick_at(local / brick + JOINT_STEP * (towards.xy * turned) * brick.y / brick, brick, BRICK_RAGGED * fine.w);
        vec4 own = rough(here.xy * CELL_PLACE);
        colour = mix(MORTAR, mix(DARK_CLAY, PALE_CLAY, 0.5 + own.x) * (1.0 + UNLIKE * own.y + CLAY_GRAIN * fine.x + STAINS * worn.x), here.z);
        bump *= BRICK_BUMPS;
        bump.z += JOINT_RELIEF * (here.z - there.z);
        normal *= rim * rim;
    } else if (material == COAL) {
        colour = COAL_COLOUR * (1.0 + fine.w);
        bump *= COAL_BUMPS;
        ember = (1.0 - smoothstep(0.0, COAL_CRACK, abs(worn.x + RAGGED * fine.w))) * smoothstep(-COAL_DARK, COAL_BRIGHT, worn.y);
        soft = COAL_SOFT;
    } else if (material == WAX) {
        // What has fuel is paper: thin, white and crumpled.
        colour = grid.y > 0.0 ? PAPER_COLOUR : WAX_COLOUR;
        bump = vec3(grid.y > 0.0 ? CRUMPLED * worn.yz : vec2(0.0), 0.0);
        float aside = local.x / (body.x + body.z);
        if (grid.y == 0.0) fire_light *= WAX_DARK + WAX_LIT * exp((local.y - body.y - body.z) / WAX_DEPTH) * (1.0 - WAX_ASIDE * aside * aside);
        soft = WAX_SOFT;
        shine = WAX_SHINE;
    } else if (material == CLOTH) {
        float turns = body.z > 0.0 ? TWIST * (place.x + place.y) : FOLDS * (place.x + UNEVEN_FOLDS * worn.x * max(1.0 - pow(local.y / body.y, 2.0), 0.0) + LEANING * sin(LEANS * body.x) * (1.0 - place.x * place.x));
        float crest = 0.5 - 0.5 * cos(turns + SHARP_FOLDS * sin(turns));
        colour = ROPE_COLOUR * mix(IN_TURN, 1.0, crest) * (1.0 + CLAY_GRAIN * fine.w);
        if (body.z <= 0.0) {
            crest = 0.5 + 0.5 * mix(cos(turns), cos(3.0 * turns), FINE_FOLDS);
            rim = 0.0;
            colour = LINEN_COLOUR * mix(IN_FOLD, 1.0, crest * crest) * (1.0 + WEAVE * fine.w);
            normal = vec2(FOLD_SLOPE * mix(sin(turns), sin(3.0 * turns), FINE_FOLDS), 0.0);
        }
        dull = CREST_DULL * crest;
        bump = vec3(0.0, 0.0, TWIST_RELIEF * (crest - 0.5));
        soft = CLOTH_SOFT;
    } else if (material == GLASS) {
        colour = GLASS_COLOUR * rim * rim * rim;
        bump *= 0.0;
        shine = 1.0;
        cover = GLASS_COVER + GLASS_RIM * rim * rim * rim;
    }
    if (grid.y > 0.0) {
        vec2 low = floor(spot);
        vec2 part = spot - low;
        vec2 state = mix(mix(cell_at(low), cell_at(low + vec2(1.0, 0.0)), part.x),
                         mix(cell_at(low + vec2(0.0, 1.0)), cell_at(low + 1.0), part.x), part.y);
        kilokelvin = state.x;
        colour *= 1.0 - CHAR_DARK * smoothstep(0.0, FULL_CHAR, state.y + CHAR_SPOTS * fine.w);
    }
    vec2 tilt = turned * (normal + bump.xy);
    vec3 facing = normalize(vec3(tilt, sqrt(max(1.0 - dot(normal, normal), 0.0)) + RAISED));
    vec3 touch = texture(glow, uv + tilt * TOUCH * per_height).rgb;
    fire_light *= 0.25 * FAR_LIT * light_range;
    vec3 nearby = touch * touch * NEAR_LIT * light_range;
    // The fire is beside a cross section, so its light grazes the face.
    towards.z -= GRAZING * end_on;
    float lit = mix(max(FACING * (dot(facing, towards) + bump.z) + ACROSS * (1.0 - 0.6 * end_on), 0.0), INSIDE, soft);
    float gloss = pow(max(dot(facing, normalize(towards + vec3(0.0, 0.0, 1.0))), 0.0), SHARPNESS) * shine;
    // The floor, and what lies before a rim, take light away.
    float open = (1.0 - LOST_AT_RIM * rim * rim * rim) * mix(AT_FLOOR, 1.0, smoothstep(0.0, ABOVE_FLOOR, (uv.y - floor_middle.y) * picture_size.y / size));
    // Sheets of cloth that hang side by side are one.
    if (material != CLOTH) open *= beside_solid(world, towards.xy, frame_a, box_a) * beside_solid(world, towards.xy, frame_b, box_b);
    if (material == WOOD) {
        // Wood in the flame is black, and its cracks glow.
        float burnt = grid.y > 0.0 ? 0.0 : smoothstep(SINGED, CHARRED, max(nearby.r, FAR_CHARS * fire_light.r));
        colour *= 1.0 - CHAR_LOSS * burnt;
        ember *= burnt;
    }
    vec3 seen = open * (colour * (lit * fire_light + nearby + (NIGHT + sky) * (SKY_FROM_ABOVE + facing.y)) + gloss * fire_light);
    if (grid.y > 0.0) {
        ember = smoothstep(CELL_DARK, CELL_GLOWING, kilokelvin + CELL_UNEVEN * fine.w) * (1.0 - dull);
    } else if (kilokelvin > 0.0) {
        // A solid of a fixed temperature glows everywhere.
        ember = 1.0 - RIM_DARK * rim * rim;
    } else {
        kilokelvin = EMBER_COOLEST + EMBER_RANGE * ember + min(PER_LIGHT * nearby.r, MOST_HEAT) - COOLED * (1.0 - smoothstep(0.0, KEPT_HOT, fire_light.r));
    }
    if (ember > 0.0) seen += radiance(kilokelvin, SOLID_ROW) * (gain * ember);
    cover = max(cover, min(gloss * fire_light.r, GLINT));
    // Nothing of the fire is over a solid before it.
    vec4 fire = plane > WITHIN ? vec4(0.0) : texture(shown, uv);
    vec3 shaded = fire.rgb + displayed(seen) * (1.0 - fire.a);
    pixel = dither(vec4(shaded, 1.0)) * (cover * clamp(0.5 - at.z / pixel_size, 0.0, 1.0));
}
