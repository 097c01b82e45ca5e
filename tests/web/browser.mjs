// Headless Chromium for the tests of the page, and what they read of it.
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';

/** Errors of pages, and what they ask of the network, which is nothing. */
export const problems = [];

/**
 * @param {string} npm the folder that has playwright-core
 * @param {string} address of the page
 */
export async function launch(npm, address) {
  const {chromium} = createRequire(`${npm}/`)('playwright-core');
  const browser = await chromium.launch(
    {executablePath: '/usr/bin/chromium', args: ['--no-sandbox']});
  const {origin} = new URL(address);

  /** A page that is ready; `cores` for its workers; frames tell a time `late` ms ago. */
  async function open({hash = '', cores = 0, late = 0, ...options} = {}) {
    const page = await browser.newPage({reducedMotion: 'reduce', ...options});
    page.setDefaultTimeout(600000);  // a machine may have other things to do
    page.on('pageerror', (error) => problems.push(error.message));
    page.on('console', (line) => {
      if (line.type() === 'error') problems.push(line.text());
    });
    page.on('request', (request) => {
      if (!/^(file|blob|data):/.test(request.url()) && !request.url().startsWith(origin)) {
        problems.push(request.url());
      }
    });
    if (cores) {
      await page.addInitScript((count) => Object.defineProperty(navigator,
        'hardwareConcurrency', {get: () => count}), cores);
    }
    if (late) {
      await page.addInitScript((ms) => {
        const frame = window.requestAnimationFrame;
        window.requestAnimationFrame = (step) => frame((now) => step(now - ms));
      }, late);
    }
    const devtools = await page.context().newCDPSession(page);
    await devtools.send('Performance.enable', {timeDomain: 'threadTicks'});
    await page.goto(address + hash);
    await page.waitForSelector('body[data-ready]');
    const {metrics} = await devtools.send('Performance.getMetrics');
    page.milliseconds = 1000 * metrics.find(({name}) => name === 'TaskDuration').value;
    return page;
  }
  return {browser, open};
}

export const text = (page, id) => page.textContent(`#${id}`);
export const number = async (page, id) =>
  Number((await text(page, id)).replace(/[^0-9]/g, ''));

/** The pixels of a display on its canvas: whether each is nearer to white. */
export const shown = (page, id, width, height) => page.evaluate(([name, w, h]) => {
  const canvas = document.getElementById(name);
  const zoom = canvas.width / w;
  const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return Array.from({length: w * h}, (_, i) => {
    const x = i % w * zoom;
    const y = Math.floor(i / w) * zoom;
    return data[4 * (y * canvas.width + x)] > 127 ? 1 : 0;
  });
}, [id, width, height]);

/** Chooses files, and waits for their font. */
export async function convert(page, files, input = 'files') {
  const before = await page.getAttribute('#result', 'data-count') ?? '0';
  // A refusal of the files before is none of these.
  await page.evaluate(() => { document.getElementById('status').textContent = ''; });
  await page.setInputFiles(`#${input}`, files);
  await converted(page, before);
}

/** Waits until a conversion has ended. */
export async function converted(page, before) {
  await page.waitForFunction((count) => {
    const {dataset} = document.getElementById('result');
    return (dataset.count ?? '0') !== count ||
      document.getElementById('status').textContent.includes('refused');
  }, before);
  assert.doesNotMatch(await text(page, 'status'), /refused/, await text(page, 'messages'));
}

/** The bytes of a download. */
export async function download(page, ending) {
  const [file] = await Promise.all([page.waitForEvent('download'),
    page.click(`#downloads button:text-matches("\\.${ending}$")`)]);
  return {path: await file.path(), name: file.suggestedFilename()};
}
