// The light of the fire on what stands behind it: all of the fire is a lamp, a
// little way in front of a wall.

in vec2 uv;

uniform sampler2D glow; // the widest blurred copy of the light
uniform vec4 view; // size of the picture, and its area, in heights of the domain

out vec4 lamp; // square root of the light / range

void main() {
    // One read for four texels, whatever the shape of the picture: none is left out.
    vec2 reads = ceil(vec2(textureSize(glow, 0)) / 2.0);
    vec3 sum = vec3(0.0);
    for (float y = 0.5; y < reads.y; y += 1.0) {
        for (float x = 0.5; x < reads.x; x += 1.0) {
            vec2 at = vec2(x, y) / reads;
            vec3 root = texture(glow, at).rgb;
            vec2 way = (uv - at) * view.xy;
            float near = 0.06 / (0.06 + dot(way, way));
            sum += root * root * near * near;
        }
    }
    lamp = vec4(sqrt(sum * view.z / (reads.x * reads.y)), 1.0);
}
