// The quad of a solid's shadow on the ground. The ground below a solid is at the lower edge of the
// frame and approaches the viewer downwards. `local` is a place on it, from below the middle of the solid
// and away from the viewer [m]; `node` is the same, 0–1 over the picture.
#include "solid.glsl"

uniform sampler2D irradiance; // square root of 16 irradiance / range
uniform vec2 per_height; // height of the domain as a share of the picture, across and up

flat out vec4 stance; // direction of its width; height of its middle and of its top [m]
flat out vec3 shape;  // half of its size with round corners [m], half of its thickness [m]
flat out float side;  // horizontal way to the light for each way up

const float FLAT = 0.3;    // height in the picture of what is as deep as wide
const float BEHIND = 0.25; // and of the middle, in half thicknesses: a solid hides what is before it
const float AROUND = 0.1;  // distance of the irradiance that gives its direction, in heights of the domain
const float SLANT = 6.0;   // of light from the side
const float LONGEST = 2.0; // horizontal way of light for each way up
const float REACH = 3.0;   // of the shadow beyond the solid, in half thicknesses
const float PENUMBRA = 0.5; // and for each way up: across, besides its slant,
const float DEPTH = 0.3;    // and away from the viewer
const float DARKEST = 4e-4; // light below which there is no side

void main() {
    Particle solid = this_solid();
    vec2 size = solid.state.xy + max(solid.state.z, 0.0);
    vec2 axis = abs(solid.velocity);
    vec2 extent = vec2(dot(axis, size), dot(axis.yx, size));
    float thick = min(body.x, body.y) + body.z;
    float top = solid.place.y + extent.y;
    shape = vec3(size, thick);
    stance = vec4(solid.velocity, solid.place.y, top);
    vec2 middle = (vec2(solid.place.x, max(solid.place.y, 0.0)) * clip_scale + clip_offset) * 0.5 + 0.5;
    vec2 aside = vec2(AROUND * per_height.x, 0.0);
    float left = length(textureLod(irradiance, middle - aside, 0.0).rgb);
    float right = length(textureLod(irradiance, middle + aside, 0.0).rgb);
    side = clamp(SLANT * (right - left) / (left + right + DARKEST), -LONGEST, LONGEST);
    local = solid.corner * (REACH * thick + vec2(extent.x + (PENUMBRA + abs(side)) * max(top, 0.0), DEPTH * max(top, 0.0)));
    gl_Position = clip(solid, vec2(solid.place.x + local.x, BEHIND * thick + FLAT * local.y));
    node = gl_Position.xy * 0.5 + 0.5;
}
