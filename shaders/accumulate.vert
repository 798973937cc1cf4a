// Accumulates a measured quantity with the kernel of the gas.
#include "measured.glsl"
