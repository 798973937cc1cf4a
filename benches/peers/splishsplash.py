"""SPlisHSPlasH's WCSPH in 2D as a program of the benchmarks: `splishsplash.py N STEPS`.

Prints one line as benches/README.md describes it. A square of N particles at
its own spacing, in which each has 12 neighbours, without gravity and without
walls, on one thread. It is timed between the ends of steps, so a step is all of it.
"""

import json
import math
import os
import statistics
import sys
import tempfile
import time

os.environ["OMP_NUM_THREADS"] = "1"
import pysplishsplash as sph  # noqa: E402 (the number of threads is read on import)

RADIUS = 0.025
TIME_STEP = 1e-4
WARM_UP = 3


def scene(count):
    """A square of `count` particles and nothing else."""
    columns = math.ceil(math.sqrt(count))
    rows = math.ceil(count / columns)
    spacing = 2 * RADIUS
    return {
        "Configuration": {
            "particleRadius": RADIUS,
            "sim2D": True,
            "simulationMethod": 0,
            "gravitation": [0, 0, 0],
            "cflMethod": 0,
            "timeStepSize": TIME_STEP,
            "boundaryHandlingMethod": 0,
            "enableZSort": True,
            "density0": 1000,
        },
        "Materials": [
            {"id": "Fluid", "viscosityMethod": 1},
        ],
        "FluidBlocks": [
            {
                "denseMode": 0,
                "start": [0, 0, -1],
                "end": [(columns + 0.5) * spacing, (rows + 0.5) * spacing, 1],
                "translation": [0, 0, 0],
                "scale": [1, 1, 1],
            }
        ],
    }


def tighten(model):
    """Moves all closer together by a little: in its own lattice four of the
    twelve neighbours stand exactly at the edge of the kernel, and rounding
    would decide whether they count."""
    for i in range(model.numActiveParticles()):
        model.setPosition(i, 0.99 * model.getPosition(i))


def neighbours(simulation, model):
    """Neighbours of a particle, on average over at most 2000 of them."""
    count = model.numActiveParticles()
    asked = range(0, count, max(1, count // 2000))
    return statistics.fmean(simulation.numberOfNeighbors(0, 0, i) for i in asked)


def main():
    count, steps = int(sys.argv[1]), int(sys.argv[2])
    ends = []
    found = []

    def after_step():
        ends.append(time.perf_counter())
        simulation = sph.Simulation.getCurrent()
        model = simulation.getFluidModel(0)
        if len(ends) == 1:
            tighten(model)
        if len(ends) == WARM_UP + steps:
            found.append((model.numActiveParticles(), neighbours(simulation, model)))

    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "block.json")
        with open(file, "w", encoding="utf-8") as out:
            json.dump(scene(count), out)
        base = sph.Exec.SimulatorBase()
        base.init(
            sceneFile=file,
            outputDir=folder,
            useCache=False,
            useGui=False,
            initialPause=False,
            stopAt=(WARM_UP + steps + 0.5) * TIME_STEP,
        )
        base.initSimulation()
        base.setTimeStepCB(after_step)
        base.runSimulation()

    ends = ends[WARM_UP - 1 : WARM_UP + steps]
    times = [1e3 * (end - start) for start, end in zip(ends, ends[1:])]
    ((particles, mean),) = found
    print(
        f"SPlisHSPlasH WCSPH,where=native,N={particles},neigh={mean:.2f}"
        f",median_ms={statistics.median(times):.4f},min_ms={min(times):.4f}",
        flush=True,
    )


main()
