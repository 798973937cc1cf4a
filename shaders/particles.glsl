uniform sampler2D particles; // TEXELS_PER_PARTICLE texels per particle, PARTICLES_PER_ROW particles per row
