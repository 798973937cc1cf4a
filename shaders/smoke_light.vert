// Covers the target with one triangle, and sums the light of the fire, which illuminates its smoke.

uniform sampler2D widest_blur; // of the light
uniform vec2 size; // of the picture, in heights of the domain

out vec2 uv; // 0–1 over the target
flat out vec4 fire;  // centroid of the light, and its standard deviation, 0–1 over the picture
flat out vec3 fire_light; // radiance times area, in squared heights of the domain, relative to the range

const float DARKEST = 1e-6; // sum of the light of no fire

void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
    // One filtered read covers four texels.
    vec2 reads = ceil(vec2(textureSize(widest_blur, 0)) / 2.0);
    vec3 sum = vec3(0.0);
    vec4 moments = vec4(0.0);
    float all = DARKEST;
    for (float y = 0.5; y < reads.y; y += 1.0) {
        for (float x = 0.5; x < reads.x; x += 1.0) {
            vec2 at = vec2(x, y) / reads;
            vec3 root = textureLod(widest_blur, at, 0.0).rgb;
            vec3 lit = root * root;
            float weight = dot(lit, vec3(1.0));
            sum += lit;
            all += weight;
            moments += weight * vec4(at, at * at);
        }
    }
    moments /= all;
    fire = vec4(moments.xy, sqrt(max(moments.zw - moments.xy * moments.xy, 0.0)));
    fire_light = sum * (size.x * size.y / (reads.x * reads.y));
}
