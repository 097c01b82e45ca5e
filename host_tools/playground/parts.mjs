// The files beside the page: inside of it, as build.mjs has put them there, or
// fetched from where it lies.
import {$} from './dom.mjs';

const LEAST = 35;  // the first of 86 characters from '#' on, without '<' and '\\'

/**
 * Bytes of base 85: five characters are four bytes, the first the highest.
 * @param {string} text
 */
function ofBase85(text) {
  const bytes = new Uint8Array(text.length / 5 * 4);
  const view = new DataView(bytes.buffer);
  for (let i = 0, at = 0; i < text.length; i += 5, at += 4) {
    let value = 0;
    for (let k = i; k < i + 5; ++k) {
      const code = text.charCodeAt(k);
      value = value * 85 + code - LEAST - Number(code > 60) - Number(code > 92);
    }
    view.setUint32(at, value);
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
  const packed = ofBase85(inside.textContent).subarray(0, Number(inside.dataset.bytes));
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
