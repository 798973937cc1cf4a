// The shadow of a solid on the ground, behind the displayed fire: the least light that passes it on a
// straight way to the fire, as a cone sees the outline.
#include "distance.glsl"

flat in vec4 stance;
flat in vec3 shape;
flat in float lean;

uniform sampler2D shown;
uniform vec2 picture; // height of the picture [m], and of the lower edge of the frame in it, 0–1
uniform float horizon; // height at which the ground begins [m]
uniform float darkness; // of the middle of a shadow
uniform float edge;    // height of the lower edge of the picture over which the shadow ends, 0–1

out vec4 pixel;

const float CONTACT = 1.0; // radius of the cone on the ground, in half thicknesses
const float SPREAD = 0.4;  // and how it grows, for each way up
const float STEPS = 6.0;
const float LAST = 0.999;  // share of the samples that is read: the last one has no next one to blend with
const float THINNEST = 1e-5; // distance of samples of a solid without any, to divide by [m]
const float FADE = 0.1;    // share of the ground over which the shadow ends at its horizon

void main() {
    float light = 1.0;
    for (float at = 0.0; at < STEPS; at++) {
        float up = max(stance.w, 0.0) * at * at / (STEPS * STEPS);
        vec2 from = vec2(local.x + lean * up, up - stance.z);
        vec2 place = vec2(dot(stance.xy, from), stance.x * from.y - stance.y * from.x);
        // Beyond the samples, the nearest of them counts.
        vec2 nearest = field.y > 0.0 ? clamp(place, -shape.xy, shape.xy) : place;
        float away = surface(nearest, LAST * (nearest + shape.xy) / max(field.zw, THINNEST)).z + length(place - nearest);
        // It is as deep as thick.
        vec2 beyond = vec2(away, abs(local.y) - shape.z);
        away = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0);
        light = min(light, smoothstep(-1.0, 1.0, away / (CONTACT * shape.z + SPREAD * up * length(vec2(1.0, lean)))));
    }
    float shadow = darkness * (1.0 - light) * min(node.y / edge, 1.0);
    shadow *= clamp((horizon - (node.y - picture.y) * picture.x) / (FADE * horizon), 0.0, 1.0);
    vec4 fire = texture(shown, node);
    pixel = vec4(fire.rgb * shadow, shadow);
}
