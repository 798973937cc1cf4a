// The distance of this pixel from the surface of a solid.

in vec2 local;
flat in vec4 body;

uniform float pixel_size; // [m]

// Outward normal and distance [m], negative inside.
vec3 surface() {
    vec2 from = abs(local) - body.xy;
    vec2 out_of = max(from, 0.0);
    float away = length(out_of);
    vec2 normal = away > 0.0 ? out_of / away : from.x > from.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    return vec3(normal * vec2(local.x < 0.0 ? -1.0 : 1.0, local.y < 0.0 ? -1.0 : 1.0),
                away + min(max(from.x, from.y), 0.0) - body.z);
}
