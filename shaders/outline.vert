// The quad of a solid.
#include "solid.glsl"

void main() {
    this_solid(true);
}
