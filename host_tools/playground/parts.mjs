// The files beside the page: inside of it, as build.mjs has put them there, or
// fetched from where it lies.
import {$} from './dom.mjs';

const LEAST = 33;  // the first of 92 characters from '!' on, without '<' and '\\'

/**
 * Bytes of base 92: two characters are thirteen bits, the highest first.
 * @param {string} text
 */
function ofBase92(text) {
  const bytes = new Uint8Array(text.length / 2 * 13 >> 3);
  const digit = (/** @type {number} */ at) => {
    const code = text.charCodeAt(at);
    return code - LEAST - Number(code > 60) - Number(code > 92);
  };
  let bits = 0;
  for (let i = 0, count = 0, at = 0; i < text.length; i += 2) {
    bits = bits << 13 | digit(i) * 92 + digit(i + 1);
    for (count += 13; count >= 8; bytes[at++] = bits >> count) count -= 8;
  }
  return bytes;
}

/** @param {string} name @returns {Promise<Uint8Array>} */
export async function part(name) {
  const inside = $(`data:${name}`);
  if (!inside) {
    const answer = await fetch(name);
    if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
    return new Uint8Array(await answer.arrayBuffer());
  }
  const packed = ofBase92(inside.textContent).subarray(0, Number(inside.dataset.bytes));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The address of a script for workers. @param {string} name */
export async function scriptOf(name) {
  if (!$(`data:${name}`)) return name;
  return URL.createObjectURL(new Blob([await part(name)], {type: 'text/javascript'}));
}

/** With files of its own the page works without a network once it was seen. */
export function keepOffline() {
  if (!$('data:core.wasm') && 'serviceWorker' in navigator) {
    navigator.serviceWorker.register('service.js');
  }
}
