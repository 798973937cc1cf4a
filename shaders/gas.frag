// Sums the kernels of the combustion model's gas.
#include "kernel.glsl"
