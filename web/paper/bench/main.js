/**
 * The page that measures the paper's tables on this machine.
 *
 * `?n=300,500&models=classic&sizes=1,30` chooses rows; the boxes on the page do too. A row during which the tab was
 * hidden is measured again, because browsers slow down hidden tabs.
 */

import '../../hearth-fire.js';
import { copyText } from '../../pages/copy.js';
import { pictures } from './fires.js';
import { readMachine } from './machine.js';
import { showPlot } from './plot.js';
import { machineOf, showTable, tablesOf, toCsv, toJson, toMarkdown } from './report.js';
import { ALL, PIXEL, TABLE_1, TABLE_2_COUNT, choiceOf, queryOf } from './rows.js';
import { classicSteps, combustionSteps } from './steps.js';

/** Most particles of the paper's own loop: its time grows with the square of their number. */
const MOST_OF_PAPER = 5000;
/** Most particles of a fire whose memory is counted: as many as the page's thread starts with. */
const MOST_COUNTED = 10_000;

/** @type {(id: string) => any} */
const find = (id) => document.getElementById(id);
const [measure, cancel, progress, status, stage] = ['measure', 'cancel', 'progress', 'status', 'stage'].map(find);

/** @type {import('./report.js').Report} */
const report = { machine: readMachine(), speeds: [], sizes: [] };

/** Whether the tab was hidden since this was last set to false. */
let wasHidden = false;
document.addEventListener('visibilitychange', () => {
  wasHidden ||= document.hidden;
  if (document.hidden && stage.dataset.busy)
    showStatus('The tab is hidden: browsers slow it down. Its row is measured again.');
});

/** @param {string} text */
function showStatus(text) {
  status.textContent = text;
}

/** The chosen rows. @returns {import('./rows.js').Choice} */
function chosen() {
  const of = (/** @type {string} */ id) =>
    [...find(id).querySelectorAll(':checked')].map((box) => /** @type {HTMLInputElement} */ (box).value);
  return {
    counts: of('counts').map(Number),
    models: /** @type {import('./rows.js').Model[]} */ (of('models')),
    sizes: of('sizes').map(Number),
  };
}

/** Adds a box for each row, checked where the link chooses it. */
function showChoices() {
  const choice = choiceOf(location.search);
  for (const id of /** @type {(keyof typeof ALL)[]} */ (Object.keys(ALL))) {
    for (const value of ALL[id]) {
      const label = document.createElement('label');
      const box = document.createElement('input');
      box.type = 'checkbox';
      box.value = String(value);
      box.checked = /** @type {(string | number)[]} */ (choice[id]).includes(value);
      label.append(box, typeof value === 'number' ? value.toLocaleString('en') : value);
      find(id).append(label);
    }
  }
  document.querySelector('details')?.addEventListener('change', () => {
    history.replaceState(history.state, '', `${location.pathname}${queryOf(chosen())}`);
  });
}

/** Shows what has been measured so far. */
function show() {
  const { speeds, sizes } = tablesOf(report);
  showTable(find('speeds'), speeds);
  showTable(find('memory'), sizes);
  /** @type {(model: string) => [number, number][]} */
  const steps = (model) =>
    report.speeds.flatMap((row) => (row.model === model && row.stepMs ? [[row.count, row.stepMs]] : []));
  showPlot(find('plot'), [
    { name: 'classic', className: 'classic', points: steps('classic') },
    { name: 'combustion', className: 'combustion', points: steps('combustion') },
    {
      name: 'the paper’s loop, here',
      className: 'loop',
      points: report.speeds.flatMap(({ count, paperMs }) => (paperMs ? [[count, paperMs]] : [])),
    },
    {
      name: 'the paper’s Table 1',
      className: 'paper',
      points: Object.entries(TABLE_1).map(([count, { ms }]) => [Number(count), ms]),
    },
  ]);
  for (const button of document.querySelectorAll('[data-copies]:not([data-copies="link"])')) {
    /** @type {HTMLButtonElement} */ (button).disabled = report.speeds.length + report.sizes.length === 0;
  }
}

/** @param {AbortSignal} signal */
function pauseUnless(signal) {
  // A message is sooner than a timer, which browsers hold back.
  return () =>
    new Promise((/** @type {(value: void) => void} */ resolve, reject) => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => {
        port1.close();
        if (signal.aborted) reject(signal.reason);
        else resolve();
      };
      port2.postMessage(undefined);
    });
}

/** Resolves when the tab is visible. @param {AbortSignal} signal */
function visible(signal) {
  return new Promise((/** @type {(value: void) => void} */ resolve, reject) => {
    const look = () => {
      if (signal.aborted) reject(signal.reason);
      else if (document.hidden) return;
      else resolve();
      document.removeEventListener('visibilitychange', look);
    };
    document.addEventListener('visibilitychange', look);
    signal.addEventListener('abort', look, { once: true });
    look();
  });
}

/**
 * Counts the memory of a fire in an iframe of its own.
 * @param {import('./rows.js').Model} model
 * @param {number} count
 * @param {(number | undefined)[]} sizes
 * @param {() => Promise<void>} pause
 * @returns {Promise<{wasm: number, gpu: number, pictureMs: number}[]>}
 */
async function memory(model, count, sizes, pause) {
  const iframe = document.createElement('iframe');
  iframe.title = 'The fire whose memory is counted';
  iframe.src = new URL('./memory.html', import.meta.url).href;
  const loaded = new Promise((resolve) => iframe.addEventListener('load', resolve, { once: true }));
  stage.append(iframe);
  try {
    await loaded;
    const { measure: ask } = /** @type {any} */ (iframe.contentWindow);
    if (!ask) throw new Error('the iframe that counts memory did not load');
    return await ask(model, count, sizes, pause);
  } finally {
    iframe.remove();
  }
}

/**
 * One row of Table 1.
 * @param {import('./report.js').SpeedRow} row
 * @param {() => Promise<void>} pause
 * @param {AbortSignal} signal
 */
async function measureRow(row, pause, signal) {
  const { model, count } = row;
  Object.assign(
    row,
    model === 'classic'
      ? await classicSteps(count, count <= MOST_OF_PAPER, pause)
      : await combustionSteps(count, pause),
  );
  const { alive: shown, ...others } = await pictures(stage, model, count, pause, signal);
  Object.assign(row, { shown, ...others });
  if (count <= MOST_COUNTED) {
    const [{ wasm, gpu }] = await memory(model, count, [undefined], pause);
    Object.assign(row, { wasm, gpu });
  }
}

/**
 * Measures until the tab was visible all the time.
 * @param {() => Promise<void>} act
 * @param {AbortSignal} signal
 * @param {string} what
 */
async function undisturbed(act, signal, what) {
  for (let again = ''; ; again = ', again: the tab was hidden') {
    await visible(signal);
    wasHidden = false;
    showStatus(`Measuring ${what}${again} …`);
    await act();
    if (!wasHidden) return;
  }
}

/** @param {unknown} error */
const reasonOf = (error) => (error instanceof Error ? error.message : String(error));

/** @param {AbortSignal} signal */
async function measureAll(signal) {
  const { counts, models, sizes } = chosen();
  const pause = pauseUnless(signal);
  const rows = counts.flatMap((count) => models.map((model) => ({ model, count })));
  const all = rows.length + (sizes.length > 0 ? 1 : 0);
  let done = 0;
  const next = () => {
    done += 1;
    progress.value = done / all;
    show();
  };
  for (const { model, count } of rows) {
    /** @type {import('./report.js').SpeedRow} */
    let row = { model, count };
    await undisturbed(
      async () => {
        row = { model, count };
        try {
          await measureRow(row, pause, signal);
        } catch (error) {
          if (signal.aborted) throw error;
          row.failed = reasonOf(error);
        }
      },
      signal,
      `${count.toLocaleString('en')} particles, ${model} (row ${done + 1} of ${all})`,
    );
    report.speeds.push(row);
    next();
  }
  if (sizes.length > 0) {
    await undisturbed(
      async () => {
        const found = await memory(
          'classic',
          TABLE_2_COUNT,
          sizes.map((size) => size * PIXEL),
          pause,
        );
        report.sizes = sizes.map((size, at) => ({ size, ...found[at] }));
      },
      signal,
      `the sizes of a particle (row ${done + 1} of ${all})`,
    );
    next();
  }
}

measure.addEventListener('click', async () => {
  const controller = new AbortController();
  const stop = () => controller.abort(new Error('cancelled'));
  Object.assign(report, { speeds: [], sizes: [] });
  progress.value = 0;
  stage.dataset.busy = 'yes';
  cancel.addEventListener('click', stop);
  for (const [element, hidden] of [
    [measure, true],
    [cancel, false],
    [progress, false],
    [stage, false],
  ])
    element.hidden = hidden;
  cancel.focus();
  try {
    await measureAll(controller.signal);
    const failed = report.speeds.filter((row) => row.failed);
    const why = failed.map(({ count, model, failed: reason }) => `${count}, ${model}: ${reason}.`);
    showStatus(['Done.', ...why].join(' '));
  } catch (error) {
    showStatus(
      controller.signal.aborted ? 'Cancelled. The rows so far are below.' : `Not measured: ${reasonOf(error)}.`,
    );
  } finally {
    cancel.removeEventListener('click', stop);
    delete stage.dataset.busy;
    for (const [element, hidden] of [
      [measure, false],
      [cancel, true],
      [progress, true],
      [stage, true],
    ])
      element.hidden = hidden;
    measure.focus();
    show();
  }
});

const WRITERS = {
  markdown: () => toMarkdown(report),
  csv: () => toCsv(report),
  json: () => toJson(report),
  link: () => `${location.origin}${location.pathname}${queryOf(chosen())}`,
};

for (const button of document.querySelectorAll('[data-copies]')) {
  const what = /** @type {keyof typeof WRITERS} */ (/** @type {HTMLElement} */ (button).dataset.copies);
  button.addEventListener('click', () => copyText(find('copy'), find('copied'), WRITERS[what]()));
}

find('machine').textContent = `This machine: ${machineOf(report.machine)}.`;
showChoices();
show();
