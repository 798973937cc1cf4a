// The displayed fire in front of the background.

in vec2 uv;

uniform sampler2D shown;
uniform vec4 background; // premultiplied

out vec4 pixel;

void main() {
    vec4 fire = texture(shown, uv);
    pixel = fire + background * (1.0 - fire.a);
}
