// The lit wall in the picture.

in vec2 uv;

uniform sampler2D plate;

out vec4 pixel;

void main() {
    pixel = texture(plate, uv);
}
