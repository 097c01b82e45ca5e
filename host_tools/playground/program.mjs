// Programs in C++ and in C that draw what the displays show, and their lines of CMake.

/** Names of filters in C++ and in C. @type {Record<string, string[]>} */
const FILTERS = {text: ['kFilterText', 'inkcell_filter_text'],
  motion: ['kFilterMotion', 'inkcell_filter_motion'],
  'paper-display': ['kFilterPaperDisplay', 'inkcell_filter_paper_display'],
  'paper-body': ['kFilterPaperBody', 'inkcell_filter_paper_body'],
  area: ['kFilterArea', 'inkcell_filter_area']};
const WIDTH = 240;
const GLOW = '0xFAE3';  // of the TFT

/**
 * Shows a part of the rows in a terminal, where a character is twice as high as wide:
 * each second row, by the upper bits of green.
 * @param {number} rows @param {boolean} isC
 */
const mainOf = (rows, isC) => `/* On a computer: shows the first 120 px of each second row. */
int main(${isC ? 'void' : ''}) {
  ${isC ? 'inkcell_status_t' : 'const Status'} status = hello();
  for (int y = 0; y < ${rows}; y += 2) {
    for (int x = 0; x < 120; ++x) {
      putchar(" .:-=+*#"[rows[2 * (y * ${WIDTH} + x) + 1] & 7]);
    }
    putchar('\\n');
  }
  return ${isC ? '(int)status' : 'static_cast<int>(status)'};
}`;

/** A string of C and C++. @param {string} text */
const literal = (text) => `"${text.replace(/["\\]|\?(?=\?)/g, '\\$&')}"`;
/** @param {number} px */
const q10 = (px) => Math.round(px * 1024);
/** @param {(string | false)[]} lines */
const joined = (lines) => lines.filter((line) => line !== false).join('\n');

/**
 * What to draw: the text on the screen, as far as the font has it, or an icon, or the
 * first characters of the font; and where, in how many rows.
 * @typedef {import('../../port/web/inkcell.mjs').Look} Look
 * @param {import('../../port/web/inkcell.mjs').Core} core
 * @param {any} report the generator's
 * @param {string} name @param {string} text @param {Look} look
 */
export function sampleOf(core, report, name, text, look) {
  const {bytes_per_glyph: glyphs, min_px: least, max_px: most} = report;
  const px = Math.max(least, Math.min(Math.round(look.size), most));
  const shown = [...text].filter((char) => char in glyphs && !/[\ue000-\uf8ff]/.test(char))
    .join('').trim();
  const icon = shown ? '' : Object.keys(report.icons ?? {})[0];
  const drawn = shown || Object.keys(glyphs).filter((glyph) =>
    [...glyph].length === 1 && glyph !== ' ').slice(0, 8).join('');
  const outlines = report.coding === 'outline';
  const style = outlines ? {...look, size: px} : {size: px, colour: 0, filter: look.filter};
  const turn = (style.angle || 0) * Math.PI / 180;
  const slope = Math.abs(Math.sin(turn));
  const rise = outlines ? Math.round(Math.min(WIDTH, core.advance({...style, angle: 0}, drawn)) *
    slope) : 0;
  return {name, outlines, px, look: style, turn,
    cpp: icon ? `fonts::${name}_icons::k${icon}` : literal(drawn),
    c: icon ? `${name}_icons_${icon}` : literal(drawn),
    x: 4 + Math.ceil(px * slope), y: px + 4 + (turn > 0 ? rise : 0),
    rows: Math.ceil(px * 1.3) + 8 + rise};
}

/** @typedef {ReturnType<typeof sampleOf>} Sample */

/** @param {Sample} sample */
export function cppOf({name, outlines, px, look, turn, cpp, x, y, rows}) {
  const [preset] = FILTERS[look.filter ?? 'text'];
  const {weight = 0, stroke = 0, glow = 0} = /** @type {any} */ (look);
  const filter = weight ? 'filter' : preset;
  const fit = outlines && !turn && look.fit !== 'none';
  const style = (/** @type {string} */ which) => `(${px}_px, ${which}${turn ? ', direction' : ''})`;
  const draw = (/** @type {string} */ which) =>
    `  painter.text(font, ${which}, {${x}, ${y}}, ${cpp});`;
  return joined(['#include <inkcell/inkcell.hpp>',
    !outlines && '#include <inkcell/field/draw.hpp>',
    fit && '#include <inkcell/fit.hpp>',
    glow > 0 && '#include <inkcell/shadow.hpp>',
    stroke > 0 && '#include <inkcell/stroke.hpp>',
    '', '#include <cstdio>', '', `#include "${name}.hpp"`, '', 'using namespace inkcell;', '',
    `uint8_t rows[${WIDTH} * ${rows} * 2];  // ${rows} rows of ${WIDTH} px, RGB565`,
    '', 'Status hello() {', '  Font font;',
    `  INKCELL_TRY(Font::open(fonts::${name}, ${outlines ? '' : 'kFieldCoding, '}font));`,
    '  // For a display behind SPI: ByteOrder::high_first.',
    `  port::Rgb565Canvas canvas({{rows, sizeof rows}, 0, 0, ${WIDTH}, ${rows}, 2 * ${WIDTH},`,
    '                             ByteOrder::low_first});',
    '  Painter painter(canvas);',
    weight !== 0 && `  const Filter filter = with_weight(${preset}, ` +
      `Q6_10::from_raw(${q10(weight)}));  // ${weight} px`,
    turn !== 0 && `  const Direction direction = {  // ${look.angle} degrees\n` +
      `      Fixed<int32_t, 30>::from_raw(${Math.round(Math.cos(turn) * 2 ** 30)}),\n` +
      `      Fixed<int32_t, 30>::from_raw(${Math.round(Math.sin(turn) * 2 ** 30)})};`,
    `  Style style${style(filter)};`,
    fit && `  Fit fit;\n  INKCELL_TRY(Fit::make(font, style, ` +
      `FitOptions{${look.fit === 'across'}}, fit));\n  style.set_fit(fit);`,
    glow > 0 && `  const Filter soft = glow_filter(Q6_10::from_raw(${q10(glow)}));` +
      `  // ${glow} px\n  canvas.set_colour(${GLOW});\n${draw(`Style${style('soft')}`)}`,
    glow > 0 && stroke > 0 && `  canvas.set_colour(0);\n${draw('style')}`,
    glow > 0 && '  canvas.set_colour(0xFFFF);',
    stroke > 0 && `  const Stroke stroke(${filter}, Q6_10::from_raw(${q10(stroke)}));` +
      `  // ${stroke} px\n  style.set_effect(stroke);`,
    `${draw('style')}  // {x, baseline}`,
    '  return canvas.status();  // now send the rows to your display', '}', '',
    mainOf(rows, false)]);
}

/** @param {Sample} sample */
export function cOf({name, px, look, turn, c, x, y, rows}) {
  const [, preset] = FILTERS[look.filter ?? 'text'];
  const {weight = 0, stroke = 0, glow = 0} = /** @type {any} */ (look);
  const fit = !turn && look.fit !== 'none';
  const unit = `${Math.round(Math.cos(turn) * 2 ** 30)}, ${Math.round(Math.sin(turn) * 2 ** 30)}`;
  const make = (/** @type {string} */ filter, /** @type {string} */ style) => turn
    ? `inkcell_style_make_turned(INKCELL_Q6(${px}), ${filter},\n` +
      `                                       ${unit}, ${style})`
    : `inkcell_style_make(INKCELL_Q6(${px}), ${filter}, ${style})`;
  const tried = (/** @type {string} */ call) =>
    `  if (status == INKCELL_OK) {\n    status = ${call};\n  }`;
  const draw = (/** @type {string} */ style) =>
    `  if (status == INKCELL_OK) {\n    inkcell_draw_text(&painter, &font, ${c}, INKCELL_TERMINATED, ` +
    `&${style},\n                      INKCELL_Q6(${x}), INKCELL_Q6(${y}));\n  }`;
  return joined(['#include <inkcell/inkcell.h>', '#include <stdio.h>', '', `#include "${name}.h"`, '',
    `uint8_t rows[${WIDTH} * ${rows} * 2]; /* ${rows} rows of ${WIDTH} px, RGB565 */`,
    '', 'inkcell_status_t hello(void) {',
    '  inkcell_rgb565_target_t target = {', `      {rows, sizeof rows, 0, 0, ${WIDTH}, ${rows}, ` +
      `INKCELL_STRIDE_BYTES(INKCELL_RGB565, ${WIDTH}),`,
    '       INKCELL_LOW_FIRST}, /* INKCELL_HIGH_FIRST: of a display behind SPI */', '      0xFFFF};',
    '  inkcell_sink_t sink;', '  const inkcell_painter_t painter = {.sink = &sink};', '  inkcell_font_t font;', '  inkcell_style_t style;',
    `  inkcell_filter_t filter = ${preset};`,
    weight !== 0 && '  inkcell_filter_table_t table;',
    fit && '  inkcell_fit_t fit;',
    glow > 0 && '  inkcell_filter_table_t soft_table;\n  inkcell_filter_t soft;\n' +
      '  inkcell_style_t glow;',
    stroke > 0 && '  inkcell_stroke_t stroke;\n  inkcell_filter_t outer;',
    `  inkcell_status_t status = inkcell_font_open(${name}, ${name}_size, &font);`,
    weight !== 0 && `  inkcell_filter_with_weight(&${preset}, ${q10(weight)}, &table, &filter); ` +
      `/* ${weight} px */`,
    tried('inkcell_rgb565_sink(&target, &sink)'),
    tried(make('&filter', '&style')),
    fit && `${tried(`inkcell_fit_make(&font, &style, ${look.fit === 'across'}, 0, 256, &fit)`)}\n` +
      '  if (status == INKCELL_OK) {\n    inkcell_style_set_fit(&style, &fit);\n  }',
    glow > 0 && `  inkcell_filter_glow(${q10(glow)}, &soft_table, &soft); /* ${glow} px */\n` +
      `${tried(make('&soft', '&glow'))}\n  target.colour = ${GLOW};\n${draw('glow')}`,
    glow > 0 && stroke > 0 && `  target.colour = 0;\n${draw('style')}`,
    glow > 0 && '  target.colour = 0xFFFF;',
    stroke > 0 && `  inkcell_stroke_make(&filter, ${q10(stroke)}, INKCELL_STROKE_CENTRED, ` +
      `&stroke, &outer); /* ${stroke} px */\n  inkcell_style_set_stroke(&style, &stroke);`,
    draw('style'),
    '  return status; /* now send the rows to your display */', '}', '', mainOf(rows, true)]);
}

/** @param {Sample} sample @param {boolean} isC */
export const cmakeListsOf = ({name, outlines}, isC) => `cmake_minimum_required(VERSION 3.25)
project(app LANGUAGES C CXX)
add_subdirectory(inkcell)
add_executable(app ${isC ? `main.c ${name}.c` : 'main.cpp'})
target_link_libraries(app PRIVATE ${isC ? 'inkcell::c'
    : `inkcell::core inkcell::port_pixel${outlines ? '' : ' inkcell::field'}`})`;
