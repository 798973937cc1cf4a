// LiquidFun's particles as a program of the benchmarks: `liquidfun N STEPS`.
//
// Prints one line as benches/README.md describes it. A square of N particles of water at LiquidFun's own
// spacing, without gravity and without walls, on one thread. A step is one iteration.

#include <Box2D/Box2D.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

const float RADIUS = 0.025f;
const float TIME_STEP = 1.0f / 480.0f;
const int WARM_UP = 3;

}  // namespace

int main(int count, char** arguments) {
  const int particles = count > 1 ? std::atoi(arguments[1]) : 5000;
  const int steps = count > 2 ? std::max(1, std::atoi(arguments[2])) : 20;

  b2World world(b2Vec2(0.0f, 0.0f));
  b2ParticleSystemDef definition;
  definition.radius = RADIUS;
  b2ParticleSystem* system = world.CreateParticleSystem(&definition);
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(particles))));
  const float spacing = b2_particleStride * 2.0f * RADIUS;
  for (int i = 0; i < particles; ++i) {
    b2ParticleDef particle;
    particle.flags = b2_waterParticle;
    // Slightly off the lattice, as the blocks of the other programs.
    const float jitter = 0.1f * (std::rand() / static_cast<float>(RAND_MAX) - 0.5f);
    particle.position.Set((i % columns + jitter) * spacing, (i / columns - jitter) * spacing);
    system->CreateParticle(particle);
  }

  std::vector<double> times;
  for (int step = 0; step < WARM_UP + steps; ++step) {
    const auto start = std::chrono::steady_clock::now();
    world.Step(TIME_STEP, 1, 1, 1);
    const auto end = std::chrono::steady_clock::now();
    if (step >= WARM_UP) {
      times.push_back(std::chrono::duration<double, std::milli>(end - start).count());
    }
  }
  std::sort(times.begin(), times.end());
  // A contact is there once, for two neighbours.
  std::printf("LiquidFun,where=native,N=%d,neigh=%.2f,median_ms=%.4f,min_ms=%.4f\n",
              system->GetParticleCount(), 2.0 * system->GetContactCount() / particles,
              times[times.size() / 2], times.front());
  return 0;
}
