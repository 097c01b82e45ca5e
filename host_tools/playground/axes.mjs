// The axes of a variable font, by its table fvar.

/** @returns {{tag: string, least: number, usual: number, most: number}[]} */
export function axesOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const tag = (at) => String.fromCharCode(...bytes.subarray(at, at + 4));
  try {
    const font = tag(0) === 'ttcf' ? view.getUint32(12) : 0;
    for (let i = 0; i < view.getUint16(font + 4); ++i) {
      const entry = font + 12 + 16 * i;
      if (tag(entry) !== 'fvar') continue;
      const table = view.getUint32(entry + 8);
      const first = table + view.getUint16(table + 4);
      return Array.from({length: view.getUint16(table + 8)}, (_, n) => {
        const axis = first + n * view.getUint16(table + 10);
        const value = (at) => view.getInt32(axis + at) / 65536;
        return {tag: tag(axis), least: value(4), usual: value(8), most: value(12)};
      });
    }
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
  }
  return [];  // none, or a file that the generator will refuse
}
