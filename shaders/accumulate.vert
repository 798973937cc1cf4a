// A measured quantity, to be summed with the kernel of the gas that fills the volume.
#include "measured.glsl"
