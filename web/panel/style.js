/**
 * The panel's style sheet, as a link. A content security policy that allows styles of the page's own
 * origin allows it; the same policy would forbid an inline style.
 */

/**
 * The sheets that panels brought, and how many use each; a page's own is the page's.
 * @type {WeakMap<HTMLLinkElement, {users: number, styled: Promise<void>}>}
 */
const brought = new WeakMap();

/**
 * The style sheet beside this file, once for each document or shadow root.
 *
 * @param {HTMLElement} host
 * @returns {{styled: Promise<void>, removeStyle: () => void}} when it is there, or
 *   refused; and what takes it away with the last panel that uses it
 */
export function addStyle(host) {
  const root = host.getRootNode();
  const place = root instanceof ShadowRoot ? root : document.head;
  const href = new URL('./panel.css', import.meta.url).href;
  const links = /** @type {HTMLLinkElement[]} */ ([...place.querySelectorAll('link[rel=stylesheet]')]);
  const link = links.find((one) => one.href === href) ?? bring(place, href);
  const sheet = brought.get(link);
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

/** @type {(place: Node, href: string) => HTMLLinkElement} */
function bring(place, href) {
  const link = document.createElement('link');
  link.rel = 'stylesheet';
  link.href = href;
  const styled = /** @type {Promise<void>} */ (new Promise((resolve) => {
    link.onload = link.onerror = () => resolve();
  }));
  brought.set(link, { users: 0, styled });
  place.appendChild(link);
  return link;
}
