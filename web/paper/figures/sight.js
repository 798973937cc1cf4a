/** What is in sight: a fire that is not has no picture. */

/**
 * Calls `act` whenever the element comes into sight or leaves it.
 * @param {Element} element
 * @param {(visible: boolean, stop: () => void) => void} act
 */
function watch(element, act) {
  const observer = new IntersectionObserver((entries) => {
    for (const { isIntersecting } of entries) act(isIntersecting, stop);
  });
  const stop = () => observer.disconnect();
  observer.observe(element);
  return stop;
}

/** Resolves when the element is in sight. @param {Element} element @returns {Promise<void>} */
export function seen(element) {
  return new Promise((resolve) => {
    watch(element, (visible, stop) => {
      if (!visible) return;
      stop();
      resolve();
    });
  });
}

/**
 * The result of an act that needs the element in sight. One that fails because a reader scrolls on is repeated when
 * the element is back.
 * @template T
 * @param {Element} element
 * @param {() => Promise<T>} act
 * @returns {Promise<T>}
 */
export async function inSight(element, act) {
  for (;;) {
    await seen(element);
    let left = false;
    const stop = watch(element, (visible) => {
      left ||= !visible;
    });
    try {
      return await act();
    } catch (error) {
      if (!left) throw error;
    } finally {
      stop();
    }
  }
}
