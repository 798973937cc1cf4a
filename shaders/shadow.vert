// The quad of a solid's shadow on the ground. The ground below the middle of a solid is at the
// lower edge of the frame and approaches the viewer downwards.
#include "particle.glsl"

uniform sampler2D irradiance; // square root of 16 irradiance / range
uniform vec2 per_height; // height of the domain as a share of the picture, across and up

out vec2 uv;         // 0–1 over the picture
out vec2 local;      // from the ground below the middle, in half thicknesses
flat out vec3 shape; // half of the width without round ends [half thicknesses], softness, darkness
flat out float away; // how far the shadow is drawn out to the right, or below 0 to the left

const float FLAT = 0.3;    // height of what is as deep as wide
const float BEHIND = 0.25; // height of the middle, in half thicknesses: a solid hides what is before it
const float AROUND = 0.1;  // distance of the irradiance that gives its direction, in heights of the domain
const float REACH = 6.0;   // of the drawn shadow beyond the solid, in half thicknesses
const float DARKNESS = 0.8;

void main() {
    Particle solid = this_particle();
    // The shadow of a sampled solid is that of its box.
    vec4 body = max(solid.state, 0.0);
    vec2 axis = abs(solid.velocity);
    vec2 extent = vec2(dot(axis, body.xy), dot(axis.yx, body.xy)) + body.z;
    float thickness = min(min(extent.x, extent.y), 2.0 * (min(body.x, body.y) + body.z));
    float raised = max(solid.place.y - extent.y, 0.0) / thickness;
    shape = vec3(max(extent.x / thickness - 1.0, 0.0), 1.2 + 0.5 * raised, DARKNESS / (1.0 + raised));
    local = solid.corner * vec2(shape.x + REACH + raised, REACH);
    gl_Position = clip(solid, vec2(solid.place.x, BEHIND * thickness) + local * vec2(thickness, FLAT * thickness));
    uv = gl_Position.xy * 0.5 + 0.5;
    vec2 middle = (vec2(solid.place.x, max(solid.place.y, 0.0)) * clip_scale + clip_offset) * 0.5 + 0.5;
    vec2 side = vec2(AROUND * per_height.x, 0.0);
    float left = length(textureLod(irradiance, middle - side, 0.0).rgb);
    float right = length(textureLod(irradiance, middle + side, 0.0).rgb);
    away = (left - right) / (left + right + 4e-4);
}
