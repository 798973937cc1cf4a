// The shadow of a solid on the ground, behind the displayed fire.

in vec2 uv;
in vec2 local;
flat in vec3 shape;
flat in float away;

uniform sampler2D shown;
uniform vec2 picture; // height of the picture [m], and of the lower edge of the frame in it, 0–1
uniform float horizon; // height at which the ground begins [m]

out vec4 pixel;

const float LENGTH = 16.0; // of a shadow of light from the side

void main() {
    float beyond = max(abs(local.x) - shape.x, 0.0);
    // A shadow is longer on the far side of the light.
    float drawn_out = 1.0 + LENGTH * max(away * sign(local.x), 0.0);
    float distance = length(vec2(beyond / drawn_out, local.y));
    float shadow = shape.z * (1.0 - smoothstep(0.2, shape.y, distance));
    shadow *= clamp((horizon - (uv.y - picture.y) * picture.x) / (0.1 * horizon), 0.0, 1.0);
    vec4 fire = texture(shown, uv);
    pixel = vec4(fire.rgb * shadow, shadow);
}
