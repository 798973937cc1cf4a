/** A fire in a notebook, for anywidget: it follows `preset`, `values` and `height`, and sets `stats`. The element is above it. */

function render({ model, el }) {
  const fire = document.createElement('hearth-fire');
  fire.style.display = 'block';
  const follow = {
    preset: () => fire.setAttribute('preset', model.get('preset')),
    // What is refused is an event `error` of the element, and a warning of the console.
    values: () => fire.set(model.get('values')).catch(() => {}),
    height: () => (fire.style.height = `${model.get('height')}px`),
  };
  for (const [name, act] of Object.entries(follow)) {
    act();
    model.on(`change:${name}`, act);
  }
  fire.addEventListener('stats', ({ detail }) => {
    model.set('stats', { ...detail });
    model.save_changes();
  });
  el.append(fire);
  return () => {
    for (const [name, act] of Object.entries(follow)) model.off(`change:${name}`, act);
    fire.remove();
  };
}

export default { render };
