import { StrictMode } from 'react';
import { createRoot } from 'react-dom/client';
import 'hearth-fire/react';
import { App, type Observed } from './app.js';

const observed: Observed = { ready: 0, stats: null, changes: [], errors: [] };
const page = { observed, setState: (state: object): void => console.error('too early', state) };
Object.assign(window, { page });

const root = document.getElementById('root');
if (!root) throw new Error('there is no place for the fire');
createRoot(root).render(
  <StrictMode>
    <App observed={observed} onState={(setState) => (page.setState = setState as (state: object) => void)} />
  </StrictMode>,
);
