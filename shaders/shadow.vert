// The quad of a solid's shadow on the ground. A solid stands on the ground where its lower edge is seen; one far
// above the front of the ground is over it. `local` is a place on the ground, from below the middle of the solid and
// away from the viewer [m]; `node` is the same, 0–1 over the picture.
#include "solid.glsl"
#include "lean.glsl"

uniform sampler2D irradiance; // of its fourth number, the lean of the light
uniform float horizon; // height at which the ground begins [m]

flat out vec4 stance; // direction of its width; height of its middle and of its top above the ground [m]
flat out vec3 shape;  // half of its size with round corners [m], half of its thickness [m]
flat out float lean;  // of the light

const float FLAT = 0.3;    // height in the picture of what is as deep as wide
const float BEHIND = 0.15; // and of the middle, in half thicknesses: a solid hides what is before it
const float REACH = 3.0;   // of the shadow beyond the solid, in half thicknesses
const float PENUMBRA = 0.5; // and for each way up: across, besides its lean, where the cone is not narrower,
const float SPREAD = 0.4;   // growth of the cone
const float DEPTH = 0.3;    // and away from the viewer
// Shares of the ground's height between which a solid no longer stands but is over the front of the ground.
const float STANDS = 0.25;
const float RAISED = 0.5;

void main() {
    Particle solid = this_solid(false);
    vec2 size = solid.state.xy + max(solid.state.z, 0.0);
    vec2 axis = abs(solid.velocity);
    vec2 extent = vec2(dot(axis, size), dot(axis.yx, size));
    float thick = min(body.x, body.y) + body.z;
    float bottom = max(solid.place.y - extent.y, 0.0);
    float foot = bottom * (1.0 - smoothstep(STANDS, RAISED, bottom / horizon));
    float top = max(solid.place.y + extent.y - foot, 0.0);
    shape = vec3(size, thick);
    stance = vec4(solid.velocity, solid.place.y - foot, top);
    vec2 middle = (vec2(solid.place.x, foot) * clip_scale + clip_offset) * 0.5 + 0.5;
    lean = decode_lean(textureLod(irradiance, middle, 0.0).a);
    // It leans away from the light.
    float aside = min(REACH * thick + PENUMBRA * top, thick + SPREAD * length(vec2(1.0, lean)) * top);
    local = solid.corner * vec2(extent.x + aside + 0.5 * abs(lean) * top, REACH * thick + DEPTH * top);
    local.x -= 0.5 * lean * top;
    gl_Position = clip(solid, vec2(solid.place.x + local.x, foot + BEHIND * thick + FLAT * local.y));
    node = gl_Position.xy * 0.5 + 0.5;
}
