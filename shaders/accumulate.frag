// Sums the kernels of a measured quantity.
#include "kernel.glsl"
