// The distance field of a glyph, its cells, and the distance under the pointer.
const $ = (id) => document.getElementById(id);
const POINTS = 240;  // along a side
const LINE_U = 32;  // between two lines of equal distance [1/1024 em]
const IN_EM = 1024;

/** The colour of a distance: warm inside, cool outside, paler with the distance. */
function colourOf(distance, step) {
  const far = Math.min(1, Math.abs(distance) / 160);
  const near = Math.abs(distance) < step;
  const onLine = Math.abs(distance) < 128 &&
    Math.abs(distance - Math.round(distance / LINE_U) * LINE_U) < step / 2;
  const [r, g, b] = distance > 0 ? [255 - 60 * far, 190 - 110 * far, 120 - 90 * far]
                                 : [40 - 20 * far, 70 - 44 * far, 110 - 70 * far];
  return near ? [255, 255, 255] : onLine ? [r * 0.72, g * 0.72, b * 0.72] : [r, g, b];
}

/** @param {import('../../port/web/inkcell.mjs').Core} core */
export function startInside(core) {
  const canvas = $('field');
  canvas.width = canvas.height = 3 * POINTS;
  const context = canvas.getContext('2d');
  const small = new OffscreenCanvas(POINTS, POINTS);
  const probe = {column: POINTS / 2, row: POINTS / 2};
  let field = null;

  const at = (column, row) => {
    const i = 4 * (row * POINTS + column);
    const [distance, x, y, side] = field.points.slice(i, i + 4);
    return {distance: distance / 1024, x, y, side};
  };

  function drawProbe() {
    const {distance, x, y, side} = at(probe.column, probe.row);
    const scale = canvas.width / field.side;
    const left = (x - field.x) * scale;
    const bottom = canvas.height - (y - field.y) * scale;
    context.lineWidth = 3;
    context.strokeStyle = context.fillStyle = '#fff';
    if (side) {
      context.strokeRect(left, bottom - side * scale, side * scale, side * scale);
      for (let i = 0; i < 9; ++i) {
        context.beginPath();
        context.arc(left + i % 3 * side * scale / 2,
          bottom - Math.floor(i / 3) * side * scale / 2, 5, 0, 7);
        context.fill();
      }
    }
    const px = (probe.column + 0.5) * 3;
    const py = (probe.row + 0.5) * 3;
    context.strokeStyle = '#000';
    context.strokeRect(px - 4, py - 4, 8, 8);
    const where = side || Math.abs(distance) < IN_EM
      ? `${Math.abs(distance).toFixed(1)}/1024 em ${distance > 0 ? 'inside' : 'outside'}: ` +
        `${(Math.abs(distance) * 24 / IN_EM).toFixed(2)} px in text of 24 px.`
      : `Far ${distance > 0 ? 'inside' : 'outside'}.`;
    $('probe').textContent = where + (side
      ? ` The cell is ${side}/1024 em wide, and keeps nine distances, at the dots.`
      : ' No edge is near: the cell keeps only whether it is inside or outside.');
  }

  function draw() {
    const image = new ImageData(POINTS, POINTS);
    const step = field.side / POINTS;
    for (let row = 0; row < POINTS; ++row) {
      for (let column = 0; column < POINTS; ++column) {
        const i = row * POINTS + column;
        const p = 4 * i;
        const {points} = field;
        const next = column + 1 < POINTS ? p + 4 : p;
        const below = row + 1 < POINTS ? p + 4 * POINTS : p;
        const border = [next, below].some((q) =>
          points[p + 1] !== points[q + 1] || points[p + 2] !== points[q + 2]);
        const colour = colourOf(points[p] / 1024, step);
        image.data.set(border ? colour.map((c) => c * 0.6 + 50) : colour, p);
        image.data[p + 3] = 255;
      }
    }
    small.getContext('2d').putImageData(image, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(small, 0, 0, canvas.width, canvas.height);
    drawProbe();
  }

  function look() {
    const char = [...$('glyph').value.trim()][0];
    if (!char) return;
    try {
      field = core.field(char, POINTS);
      $('field-size').textContent = `${field.cells} cells, ` +
        `${field.bytes.toLocaleString('en')} bytes, made of an outline in the font.`;
      draw();
    } catch (error) {
      $('field-size').textContent = `'${char}': ${error.message}`;
    }
  }

  const move = (column, row) => {
    const within = (value) => Math.max(0, Math.min(POINTS - 1, Math.round(value)));
    Object.assign(probe, {column: within(column), row: within(row)});
    if (field) draw();
  };
  canvas.onpointermove = canvas.onpointerdown = (event) => {
    const box = canvas.getBoundingClientRect();
    move((event.clientX - box.left) * POINTS / box.width - 0.5,
      (event.clientY - box.top) * POINTS / box.height - 0.5);
  };
  canvas.onkeydown = (event) => {
    const step = event.shiftKey ? 10 : 1;
    const [x, y] = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step],
      ArrowDown: [0, step]}[event.key] || [];
    if (x === undefined) return;
    event.preventDefault();
    move(probe.column + x, probe.row + y);
  };
  $('glyph').oninput = look;
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
