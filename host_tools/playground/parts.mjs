// The files beside the page: inside of it, as build.mjs has put them there, or
// fetched from where it lies.
import {$} from './dom.mjs';

/**
 * Bytes of characters that are seven bits each, the lowest first.
 * @param {string} text
 */
function ofSevenBits(text) {
  const bytes = new Uint8Array(text.length * 7 >> 3);
  let bits = 0;
  for (let i = 0, count = 0, at = 0; i < text.length; ++i) {
    bits |= (text.charCodeAt(i) & 127) << count;
    for (count += 7; count >= 8; count -= 8, bits >>= 8) bytes[at++] = bits;
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
  const packed = ofSevenBits(inside.textContent).subarray(0, Number(inside.dataset.bytes));
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
