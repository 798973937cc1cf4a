// An instance per solid: one quad with a margin for its soft edge, or those parts of a sampled solid that its surface
// touches. The record of a solid holds the centre and the
// direction of its width, then half of its box, a radius, and its surface: material × MATERIAL_FACTOR +
// temperature [K], with the plane × PLANE_FACTOR added to the material. The radius is that of the corners around the box. A negative one is the place of
// a sampled distance in the texture, counted in records: first the number of nodes of a row, the
// largest depth, which is negative if the solid is round, and the distances between nodes; then, in
// the next record, the distance at each node. Both constants come from build/values.rs.
#include "particle.glsl"
#include "listed.glsl"

uniform float first_solid; // number of the first solid that is drawn
uniform float margin; // [m]

const int PARTS = 8;     // of a sampled solid along a side, one for each quad of an instance
const float THIN = 0.02; // half of the box in a round sampled solid, in its depths

out vec2 local;      // from the centre, along its width and its height [m]
out vec2 node;       // from the lower left node of a sampled distance
flat out vec4 body;  // half of the inner box [m], radius [m], surface; a sampled one is as thick as it is deep
flat out vec4 field; // first texel, nodes of a row, distances between nodes [m]; zeros without samples

// `parted`: whether a sampled solid is drawn in parts.
Particle this_solid(bool parted) {
    Particle solid = particle_at(gl_InstanceID + int(first_solid), 0);
    int part = gl_VertexID / 6;
    bool exists = solid.real;
    solid.real = exists && part == 0;
    body = solid.state;
    vec2 size = body.xy + max(body.z, 0.0);
    // A field has a border of its own.
    local = solid.corner * (size + (body.z < 0.0 ? 0.0 : margin));
    field = vec4(0.0);
    node = local;
    if (body.z < 0.0) {
        int place = int(-body.z);
        vec4 head = texelFetch(particles, ivec2(place % PARTICLES_PER_ROW * TEXELS_PER_PARTICLE, place / PARTICLES_PER_ROW), 0);
        field = vec4(float((place + 1) * TEXELS_PER_PARTICLE), head.x, head.zw);
        if (parted) {
            // A part that is as far from the surface as from its own corners is outside.
            vec2 middle = (vec2(part % PARTS, part / PARTS) * 2.0 + 1.0) / float(PARTS) - 1.0;
            float away = listed(field.xy, ivec2((middle + 1.0) * size / head.zw + 0.5));
            solid.real = exists && away < length(size) / float(PARTS) + length(head.zw) + margin;
            local = (middle + solid.corner / float(PARTS)) * size;
        }
        node = (local + size) / head.zw;
        // Round, a thin box with a radius.
        body.xyz = head.y < 0.0 ? vec3(-THIN, -THIN, -1.0) * head.y : vec3(head.yy, 0.0);
    }
    gl_Position = clip(solid, solid.place + mat2(solid.velocity, -solid.velocity.y, solid.velocity.x) * local);
    return solid;
}
