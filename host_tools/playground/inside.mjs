// A glyph as it is stored and as a field: points, hints, cells, and the distance
// under the pointer.
import {$} from './dom.mjs';

const POINTS = 240;  // along a side
const ZOOM = 3;  // pixels of the picture to a point
const LINE_U = 32;  // between two lines of equal distance [1/1024 em]
const IN_EM = 1024;
const CELL = 216;  // the side of the picture of a cell [px]
const BAR_KINDS = ['bar', 'serif', 'edge', 'free end'];

/**
 * The colour of a distance: warm inside, cool outside, paler with the distance.
 * @param {number} distance @param {number} step
 */
function colourOf(distance, step) {
  const far = Math.min(1, Math.abs(distance) / 160);
  const near = Math.max(0, Math.min(1, 1.8 - 1.5 * Math.abs(distance) / step));
  const onLine = Math.abs(distance) < 128 &&
    Math.abs(distance - Math.round(distance / LINE_U) * LINE_U) < step / 2;
  const [r, g, b] = distance > 0 ? [255 - 60 * far, 190 - 110 * far, 120 - 90 * far]
                                 : [40 - 20 * far, 70 - 44 * far, 110 - 70 * far];
  const shade = onLine ? 0.72 : 1;
  return [r, g, b].map((c) => c * shade + (255 - c * shade) * near);
}

/** A picture whose pixels are colours. @param {(x: number, y: number) => number[]} colourAt */
function picture(side, colourAt) {
  const image = new ImageData(side, side);
  for (let i = 0; i < side * side; ++i) {
    image.data.set(colourAt(i % side, Math.floor(i / side)), 4 * i);
    image.data[4 * i + 3] = 255;
  }
  return image;
}

/** @param {import('../../port/web/inkcell.mjs').Core} core */
export function startInside(core) {
  const canvas = $('field');
  canvas.width = canvas.height = ZOOM * POINTS;
  /** @type {CanvasRenderingContext2D} */
  const context = canvas.getContext('2d');
  let painted = new ImageData(1, 1);
  const probe = {column: POINTS / 2, row: POINTS / 2};
  /** @type {any} */
  let field = null;
  /** @type {any} */
  let outline = null;

  const at = (column, row) => {
    const i = 4 * (row * POINTS + column);
    const [distance, x, y, side] = field.points.slice(i, i + 4);
    return {distance: distance / 1024, x, y, side};
  };
  const left = (x) => (x - field.x) * canvas.width / field.side;
  const top = (y) => canvas.height - (y - field.y) * canvas.width / field.side;

  function drawLine(x0, y0, x1, y1) {
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
  }

  // Zones dashed; heights and stems of this glyph whole.
  function drawHints() {
    context.lineWidth = 2;
    context.strokeStyle = '#8fd3ff';
    context.setLineDash([4, 6]);
    for (const [y] of outline.zones) drawLine(0, top(y), canvas.width, top(y));
    context.setLineDash([]);
    context.strokeStyle = '#35e07f';
    for (const [, low, high] of outline.heights) {
      for (const y of [low, high]) drawLine(0, top(y), canvas.width, top(y));
    }
    context.strokeStyle = '#ff6ad5';
    for (const [low, high] of outline.stems) {
      for (const x of [low, high]) drawLine(left(x), 0, left(x), canvas.height);
    }
  }

  // Squares are corners, discs smooth points, rings off the curve.
  function drawPoints() {
    context.lineWidth = 2.5;
    context.strokeStyle = '#fff';
    outline.points.forEach(({x, y, kind}, i) => {
      const before = outline.points[i - 1];
      if (kind !== 3 && (kind === 0 || before.kind === 0)) {
        drawLine(left(before.x), top(before.y), left(x), top(y));
      }
    });
    for (const {x, y, kind} of outline.points) {
      context.fillStyle = kind === 0 ? '#10233a' : kind === 1 ? '#5bff8f' : '#ffe14d';
      context.strokeStyle = kind === 0 ? '#fff' : '#000';
      context.beginPath();
      if (kind > 1) context.rect(left(x) - 7, top(y) - 7, 14, 14);
      else context.arc(left(x), top(y), 7, 0, 7);
      context.fill();
      context.stroke();
    }
  }

  // The surface of a cell, and the nine distances that it goes through.
  function drawCell({x, y, side}) {
    const close = $('cell');
    close.hidden = !side;
    if (!side) return;
    close.width = close.height = CELL;
    const paper = close.getContext('2d');
    const place = (i) => 24 + (CELL - 48) * i;
    const step = side / (CELL - 48);
    paper.putImageData(picture(CELL, (column, row) => colourOf(core.distance(
      x + Math.min(side - 0.01, Math.max(0, (column - 24) * step)),
      y + Math.min(side - 0.01, Math.max(0, (CELL - 24 - row) * step))), step)), 0, 0);
    paper.font = '600 13px system-ui, sans-serif';
    paper.textAlign = 'center';
    for (let i = 0; i < 9; ++i) {
      const [column, row] = [i % 3, Math.floor(i / 3)];
      const edge = (n) => n === 2 ? side - 1 / 64 : n * side / 2;
      const distance = core.distance(x + edge(column), y + edge(row));
      const [px, py] = [place(column / 2), place(1 - row / 2)];
      paper.fillStyle = '#fff';
      paper.beginPath();
      paper.arc(px, py, 4, 0, 7);
      paper.fill();
      paper.lineWidth = 3;
      paper.strokeStyle = '#000';
      paper.strokeText(distance.toFixed(1), px, py - 8);
      paper.fillText(distance.toFixed(1), px, py - 8);
    }
  }

  function drawProbe() {
    const cell = at(probe.column, probe.row);
    const {distance, x, y, side} = cell;
    const scale = canvas.width / field.side;
    context.lineWidth = 3;
    context.strokeStyle = context.fillStyle = '#fff';
    if (side && $('cells').checked) {
      context.strokeRect(left(x), top(y) - side * scale, side * scale, side * scale);
      for (let i = 0; i < 9; ++i) {
        context.beginPath();
        context.arc(left(x + i % 3 * side / 2), top(y + Math.floor(i / 3) * side / 2), 5, 0, 7);
        context.fill();
      }
    }
    const px = (probe.column + 0.5) * ZOOM;
    const py = (probe.row + 0.5) * ZOOM;
    context.strokeStyle = '#000';
    context.strokeRect(px - 4, py - 4, 8, 8);
    drawCell(cell);
    const where = side || Math.abs(distance) < IN_EM
      ? `${Math.abs(distance).toFixed(1)}/1024 em ${distance > 0 ? 'inside' : 'outside'}: ` +
        `${(Math.abs(distance) * 24 / IN_EM).toFixed(2)} px in text of 24 px.`
      : `Far ${distance > 0 ? 'inside' : 'outside'}.`;
    $('probe').textContent = where + (side
      ? ` The cell is ${side}/1024 em wide, and keeps the nine distances at the dots.`
      : ' No edge is near: the cell keeps only whether it is inside or outside.');
  }

  /** The distance between points, by those around it. [u] */
  function between(column, row) {
    const within = (/** @type {number} */ i) => Math.max(0, Math.min(POINTS - 1, i));
    const [x, y] = [within((column + 0.5) / ZOOM - 0.5), within((row + 0.5) / ZOOM - 0.5)];
    const [left, top] = [Math.floor(x), Math.floor(y)];
    const right = 4 * (Math.min(left + 1, POINTS - 1) - left);
    const p = 4 * (top * POINTS + left);
    const q = top + 1 < POINTS ? p + 4 * POINTS : p;
    const {points} = field;
    const upper = points[p] + (points[p + right] - points[p]) * (x - left);
    const lower = points[q] + (points[q + right] - points[q]) * (x - left);
    return (upper + (lower - upper) * (y - top)) / 1024;
  }

  function paintField() {
    const step = field.side / POINTS;
    const {points} = field;
    const [showField, showCells] = [$('distances').checked, $('cells').checked];
    // A cell's lower left corner, at the point of a pixel.
    const corner = (column, row) => 4 * (Math.floor(row / ZOOM) * POINTS +
      Math.floor(column / ZOOM));
    painted = picture(ZOOM * POINTS, (column, row) => {
      const distance = between(column, row);
      const inside = Math.max(0, Math.min(1, distance * ZOOM / step + 0.5));
      const colour = showField ? colourOf(distance, step)
        : [28, 44, 70].map((c, i) => c + ([196, 128, 84][i] - c) * inside);
      if (!showCells) return colour;
      const p = corner(column, row);
      const border = [corner(Math.min(column + 1, ZOOM * POINTS - 1), row),
        corner(column, Math.min(row + 1, ZOOM * POINTS - 1))].some((q) =>
        points[p + 1] !== points[q + 1] || points[p + 2] !== points[q + 2]);
      return border ? colour.map((c) => c * 0.6 + 50) : colour;
    });
    draw();
  }

  function draw() {
    context.putImageData(painted, 0, 0);
    if (outline && $('hints-shown').checked) drawHints();
    if (outline && $('points-shown').checked) drawPoints();
    drawProbe();
  }

  function look() {
    const char = [...$('glyph').value.trim()].at(-1);
    if (!char) return;
    if ($('glyph').value !== char) $('glyph').value = char;  // what was typed last
    if (!core.has(char)) {
      $('outline-size').textContent = `The font has no '${char}'.`;
      return;
    }
    try {
      outline = core.points(char);
      const count = outline.points.filter(({kind}) => kind !== 3).length;
      const bars = outline.heights.map(([kind]) => BAR_KINDS[kind]);
      $('outline-size').textContent = `${count} points; hints: ` +
        ([...bars, ...outline.stems.map(() => 'stem')].join(', ') ||
          'none') + '.';
      field = core.field(char, POINTS);
      $('field-size').textContent = `${field.cells} cells, ` +
        `${field.bytes.toLocaleString('en')} bytes of RAM, where a program asks for them.`;
      paintField();
    } catch (error) {
      $('field-size').textContent = `'${char}': ${/** @type {Error} */ (error).message}`;
    }
  }

  const move = (column, row) => {
    const within = (value) => Math.max(0, Math.min(POINTS - 1, Math.round(value)));
    Object.assign(probe, {column: within(column), row: within(row)});
    if (field) draw();
  };
  canvas.onpointermove = canvas.onpointerdown = (/** @type {PointerEvent} */ event) => {
    const box = canvas.getBoundingClientRect();
    move((event.clientX - box.left) * POINTS / box.width - 0.5,
      (event.clientY - box.top) * POINTS / box.height - 0.5);
  };
  canvas.onkeydown = (/** @type {KeyboardEvent} */ event) => {
    const step = event.shiftKey ? 10 : 1;
    /** @type {Record<string, number[]>} */
    const steps = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step],
      ArrowDown: [0, step]};
    if (!(event.key in steps)) return;
    event.preventDefault();
    const [x, y] = steps[event.key];
    move(probe.column + x, probe.row + y);
  };
  $('glyph').oninput = look;
  for (const id of ['distances', 'cells', 'points-shown', 'hints-shown']) {
    $(id).onchange = () => { if (field) paintField(); };
  }
  // Made when it comes into view, and anew for another font.
  let seen = false;
  new IntersectionObserver(([entry]) => {
    if (entry.isIntersecting && !seen) {
      seen = true;
      look();
    }
  }).observe(canvas);
  return () => { if (seen) look(); };
}
