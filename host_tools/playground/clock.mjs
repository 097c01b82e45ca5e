// A clock whose digits turn into the next ones by their distances.
const MORPH_MS = 300;

const two = (number) => String(number).padStart(2, '0');
const timeOf = (ms) => {
  const date = new Date(ms);
  return two(date.getHours()) + two(date.getMinutes()) + two(date.getSeconds());
};
const eased = (part) => part * part * (3 - 2 * part);

/** Draws the time of `now` [ms] into the rows from `top` on, `size` px/em. */
export function drawClock(core, screen, now, size, top, still) {
  const time = timeOf(now);
  const before = timeOf(now - 1000);
  const part = still ? 1 : Math.min(1, now % 1000 / MORPH_MS);
  const digit = Math.round(size * 0.66);
  const colon = Math.round(size * 0.3);
  const height = Math.round(size * 0.74) + 4;
  const box = {width: digit, height, baseline: height - 2};
  const look = {size, colour: screen.kind.clockInk};
  let x = Math.round((screen.width - 6 * digit - 2 * colon) / 2);
  for (let i = 0; i < 6; ++i) {
    if (i === 2 || i === 4) {
      const left = (colon - core.advance(look, ':')) / 2;
      core.draw(screen.display, look, ':', x + left, top + box.baseline - size / 11);
      x += colon;
    }
    core.morph(screen.display, look, box, before[i], time[i],
      before[i] === time[i] ? 1 : eased(part), x, top);
    x += digit;
  }
}
