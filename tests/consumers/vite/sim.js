import { createSimulation } from 'hearth-fire/sim';

const simulation = await createSimulation({ seed: 7 });
simulation.step(5);
window.positions = [...simulation.positions()];
simulation.free();
