// A disc per particle with its measured quantity.
#include "measured.glsl"
