// Draws docs/img/playground.png: the first screen.
//
// Usage: node draw.mjs PAGE.html NPM_FOLDER OUT.png
//
// NPM_FOLDER has playwright-core; tests/web.sh installs it in build/web/npm.
import {createRequire} from 'node:module';

const [file, npm, out] = process.argv.slice(2);
const {chromium} = createRequire(`${npm}/`)('playwright-core');
const browser = await chromium.launch(
  {executablePath: '/usr/bin/chromium', args: ['--no-sandbox']});
const page = await browser.newPage({viewport: {width: 850, height: 772},
  reducedMotion: 'reduce', timezoneId: 'UTC'});
await page.goto(`file://${file}`);
await page.waitForSelector('body[data-ready]');
await page.clock.setFixedTime('2026-01-01T12:34:56Z');
await page.waitForTimeout(300);
await page.screenshot({path: out});
await browser.close();
