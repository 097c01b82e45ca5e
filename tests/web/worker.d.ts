// What build.mjs puts before worker.js.
declare const InkcellFontgen: Function;
declare const runFontgen: typeof import('../../fonts_gen/web/fontgen.mjs').runFontgen;
