// One quad per solid, with a margin for its soft edge. A solid is a rounded box: its record holds
// the centre and the direction of its width, then half of the inner box, the radius of its
// corners, and its surface: material × SURFACES + temperature [K]. SURFACES comes from build/values.rs.
#include "particle.glsl"

uniform float margin; // [m]

out vec2 local;     // from the centre, along its width and its height [m]
flat out vec4 body; // half of the inner box [m], radius [m], surface

Particle this_solid() {
    Particle solid = this_particle();
    body = solid.state;
    local = solid.corner * (body.xy + body.z + margin);
    gl_Position = clip(solid, solid.place + mat2(solid.velocity, -solid.velocity.y, solid.velocity.x) * local);
    return solid;
}
