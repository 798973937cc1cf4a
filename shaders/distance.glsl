// The distance of this pixel from the surface of a solid.
#include "listed.glsl"

in vec2 local;
in vec2 node;
flat in vec4 body;
flat in vec4 field;

uniform float pixel_size;    // [m]

float sampled(ivec2 at) {
    return listed(field.xy, at);
}

// Outward normal and distance [m], negative inside, of a place in a solid.
vec3 surface(vec2 place, vec2 at_node) {
    if (field.y > 0.0) {
        vec2 within = max(at_node, 0.0);
        ivec2 at = ivec2(within);
        vec2 part = within - vec2(at);
        vec2 low = vec2(sampled(at), sampled(at + ivec2(1, 0)));
        vec2 high = vec2(sampled(at + ivec2(0, 1)), sampled(at + ivec2(1, 1)));
        vec2 middle = mix(low, high, part.y);
        vec2 slope = vec2(middle.y - middle.x, mix(high.x - low.x, high.y - low.y, part.x)) / field.zw;
        return vec3(slope / max(length(slope), 1e-3), mix(middle.x, middle.y, part.x));
    }
    vec2 from = abs(place) - body.xy;
    vec2 out_of = max(from, 0.0);
    float away = length(out_of);
    vec2 normal = away > 0.0 ? out_of / away : from.x > from.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    return vec3(normal * vec2(place.x < 0.0 ? -1.0 : 1.0, place.y < 0.0 ? -1.0 : 1.0),
                away + min(max(from.x, from.y), 0.0) - body.z);
}
