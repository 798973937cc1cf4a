// The finished fire, in front of what stands behind it.

in vec2 uv;

uniform sampler2D fire;
uniform vec4 background; // premultiplied

out vec4 pixel;

void main() {
    vec4 shown = texture(fire, uv);
    pixel = shown + background * (1.0 - shown.a);
}
