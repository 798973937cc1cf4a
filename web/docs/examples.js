/**
 * Examples that burn when the reader asks for it. Their markup stands in a `<template>` of the page, where the build
 * put what its list allows; one example burns at a time.
 */

/** @type {(() => void) | undefined} */
let stop;

/** Shows the button of each example below a node. @param {ParentNode} root */
export function runExamples(root) {
  for (const example of root.querySelectorAll('.example')) {
    const button = /** @type {HTMLButtonElement} */ (example.querySelector('button'));
    const template = /** @type {HTMLTemplateElement} */ (example.querySelector('template'));
    button.hidden = false;
    button.addEventListener('click', () => {
      const burns = button.textContent === 'Stop';
      stop?.();
      stop = burns ? undefined : run(example, button, template);
    });
  }
}

/**
 * @param {Element} example @param {HTMLButtonElement} button @param {HTMLTemplateElement} template
 * @returns {() => void}  Ends it.
 */
function run(example, button, template) {
  const place = document.createElement('div');
  place.className = 'burning';
  place.append(template.content.cloneNode(true));
  for (const element of place.querySelectorAll('[data-style]')) {
    // The page's policy refuses styles in attributes, not those that a script sets.
    const { style, dataset } = /** @type {HTMLElement} */ (element);
    style.cssText = dataset.style ?? '';
    element.removeAttribute('data-style');
  }
  example.append(place);
  button.textContent = 'Stop';
  import('../hearth-fire.js').catch(() => {
    place.textContent = 'The code of the fire did not load. Load the page again.';
  });
  return () => {
    place.remove();
    button.textContent = 'Run';
  };
}
