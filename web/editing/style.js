/**
 * What a panel and a toolbar begin with: checked arguments, and their style sheet, as a link. A content security policy
 * that allows styles of the page's own origin allows it; the same policy would forbid an inline style.
 */

/**
 * The style sheets that panels have added, with the number of panels that use each. A page's own link is
 * not among them.
 * @type {WeakMap<HTMLLinkElement, {users: number, styled: Promise<void>}>}
 */
const added = new WeakMap();

/** The maximum time that a panel waits for its styles [ms]. */
const STYLE_MS = 10_000;

/**
 * Adds a style sheet, once for each document or shadow root.
 *
 * @param {HTMLElement} host
 * @param {string} href
 * @returns {{styled: Promise<void>, removeStyle: () => void}} when it is loaded or refused; and what
 *   removes it with the last panel that uses it
 */
export function addStyle(host, href) {
  const root = host.getRootNode();
  const parent = root instanceof ShadowRoot ? root : document.head;
  const links = /** @type {HTMLLinkElement[]} */ ([...parent.querySelectorAll('link[rel=stylesheet]')]);
  const link = links.find((candidate) => candidate.href === href) ?? add(parent, href);
  const sheet = added.get(link);
  if (!sheet) return { styled: Promise.resolve(), removeStyle() {} };
  sheet.users += 1;
  return {
    styled: sheet.styled,
    removeStyle() {
      sheet.users -= 1;
      if (sheet.users === 0) link.remove();
    },
  };
}

/** @type {(parent: Node, href: string) => HTMLLinkElement} */
function add(parent, href) {
  const link = document.createElement('link');
  link.rel = 'stylesheet';
  link.href = href;
  const styled = /** @type {Promise<void>} */ (
    new Promise((resolve) => {
      link.onload = link.onerror = () => resolve();
      setTimeout(resolve, STYLE_MS);
    })
  );
  added.set(link, { users: 0, styled });
  parent.appendChild(link);
  return link;
}

/**
 * The options of a panel or a toolbar, with a place and a fire.
 * @template {{host: HTMLElement, fire: object}} Options
 * @param {Options} options
 * @returns {Options}
 * @throws {TypeError}
 */
export function optionsOf(options) {
  const { host, fire } = /** @type {any} */ (options ?? {});
  check('host', 'an element', host?.nodeType === 1);
  check('fire', 'a <hearth-fire> or an object with its members', typeof fire?.addEventListener === 'function');
  return options;
}

/**
 * Throws unless an argument is what it must be.
 * @param {string} name
 * @param {string} allowed
 * @param {boolean} isAllowed
 * @throws {TypeError}
 */
export function check(name, allowed, isAllowed) {
  if (!isAllowed) throw new TypeError(`${name} must be ${allowed}`);
}
