// Sums the kernels of the classic model's particles.
#include "kernel.glsl"
