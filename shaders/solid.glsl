// One quad per solid, with a margin for its soft edge. The record of a solid holds the centre and the
// direction of its width, then half of its box, a radius, and its surface: material × MATERIAL_FACTOR +
// temperature [K], with the plane × PLANE_FACTOR added to the material. The radius is that of the corners around the box. A negative one is the place of
// a sampled distance in the texture, counted in records: first the number of nodes of a row, the
// largest depth, which is negative if the solid is round, and the distances between nodes; then, in
// the next record, the distance at each node. Both constants come from build/values.rs.
#include "particle.glsl"

uniform float margin; // [m]

const float THIN = 0.02; // half of the box in a round sampled solid, in its depths

out vec2 local;      // from the centre, along its width and its height [m]
out vec2 node;       // from the lower left node of a sampled distance
flat out vec4 body;  // half of the inner box [m], radius [m], surface; a sampled one is as thick as it is deep
flat out vec4 field; // first texel, nodes of a row, distances between nodes [m]; zeros without samples

Particle this_solid() {
    Particle solid = this_particle();
    body = solid.state;
    vec2 size = body.xy + max(body.z, 0.0);
    // A field has a border of its own.
    local = solid.corner * (size + (body.z < 0.0 ? 0.0 : margin));
    gl_Position = clip(solid, solid.place + mat2(solid.velocity, -solid.velocity.y, solid.velocity.x) * local);
    field = vec4(0.0);
    node = local;
    if (body.z < 0.0) {
        int place = int(-body.z);
        vec4 head = texelFetch(particles, ivec2(place % PARTICLES_PER_ROW * TEXELS_PER_PARTICLE, place / PARTICLES_PER_ROW), 0);
        field = vec4(float((place + 1) * TEXELS_PER_PARTICLE), head.x, head.zw);
        node = (local + size) / head.zw;
        // Round, a thin box with a radius.
        body.xyz = head.y < 0.0 ? vec3(-THIN, -THIN, -1.0) * head.y : vec3(head.yy, 0.0);
    }
    return solid;
}
