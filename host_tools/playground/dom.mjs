// What the parts of the page share.

/** @param {string} id @returns {any} the element, of whatever kind it is */
export const $ = (id) => document.getElementById(id);

/** @param {number} number */
export const bytesOf = (number) => `${number.toLocaleString('en')} bytes`;

/**
 * A row of a table; its first cell is its head.
 * @param {(string | number | Node)[]} cells
 */
export function row(cells) {
  const line = document.createElement('tr');
  cells.forEach((content, i) => {
    const cell = document.createElement(i === 0 ? 'th' : 'td');
    if (i === 0) cell.scope = 'row';
    cell.append(typeof content === 'number' ? content.toLocaleString('en') : content);
    line.append(cell);
  });
  return line;
}

/** @param {string} text @param {() => void} press */
export function button(text, press) {
  const made = document.createElement('button');
  made.type = 'button';
  made.textContent = text;
  made.onclick = press;
  return made;
}

// Settings, which links carry: controls that have data-keep.

/** @param {any} control */
export const valueOf = (control) =>
  control.type === 'checkbox' ? (control.checked ? 'on' : 'off') : control.value;

/** @param {any} control */
const usualOf = (control) => control.dataset.usual ??
  (control.type === 'checkbox' ? (control.defaultChecked ? 'on' : 'off')
    : control.matches('select') ? control.options[0]?.value ?? '' : control.defaultValue);

/** @param {any} control @param {string} value */
function setValue(control, value) {
  if (control.type === 'checkbox') control.checked = value === 'on';
  else control.value = value;
}

const link = new URLSearchParams(location.hash.slice(1));

/** Sets controls as the link says. @param {Iterable<any>} controls */
export function restore(controls) {
  for (const control of controls) {
    const value = link.get(control.id);
    if (value !== null) setValue(control, value);
  }
}

/** @param {Iterable<any>} controls */
export function reset(controls) {
  for (const control of controls) setValue(control, usualOf(control));
}

/** Puts the settings into the address, and copies it. @param {HTMLElement} note */
export async function copyLink(note) {
  const values = [...document.querySelectorAll('[data-keep]')]
    .filter((control) => valueOf(control) !== usualOf(control))
    .map((control) => [control.id, valueOf(control)]);
  history.replaceState(null, '', `#${new URLSearchParams(values)}`);
  try {
    await navigator.clipboard.writeText(location.href);
    note.textContent = location.protocol === 'file:'
      ? 'Copied. Others open it with their copy of this page, from # on.' : 'Copied.';
  } catch {
    note.textContent = 'The link is in the address bar.';
  }
}

/**
 * Puts a line above a listing: what it is, and a button that copies it.
 * @param {HTMLElement} listing
 */
export function addCopy(listing) {
  const label = listing.getAttribute('aria-label') ?? '';
  const copy = button('Copy', async () => {
    try {
      await navigator.clipboard.writeText(listing.textContent ?? '');
      copy.textContent = 'Copied';
    } catch {
      getSelection()?.selectAllChildren(listing);
    }
  });
  copy.setAttribute('aria-label', `Copy: ${label}`);
  copy.onblur = () => { copy.textContent = 'Copy'; };
  const line = document.createElement('div');
  line.className = 'copy';
  line.append(label, copy);
  listing.before(line);
}

/** @param {number} least @param {number} most */
export const sizesOf = (least, most) =>
  least === most ? `${least} px` : `any size from ${least} to ${most} px`;
