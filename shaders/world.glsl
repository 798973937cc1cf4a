// The position of the world in the picture.

uniform vec2 picture_size; // [m]
uniform vec2 floor_middle; // middle of the world's floor, 0–1 over the picture
uniform vec2 source;       // middle of the source's lower edge [m]
uniform float zoom;        // height of the picture in heights of the domain

vec2 to_metres(vec2 at) {
    return (at - floor_middle) * picture_size;
}

// Height above the floor in heights of the domain.
float domain_height(vec2 at) {
    return (at.y - floor_middle.y) * zoom;
}
