// A measured quantity as a disc a particle.
#include "measured.glsl"
