import { existsSync, mkdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
const shots = here('../dist/screenshots/');

export const viewerPage = here('../dist/viewer.html');

export async function launch() {
  if (!existsSync(executablePath))
    throw new Error(`no browser at ${executablePath}: install chromium (Debian: chromium), or set CHROMIUM to one`);
  mkdirSync(shots, { recursive: true });
  return chromium.launch({ executablePath, args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });
}

/** The page from disk, without a network, with all that it complains of and asks for. */
export class Viewer {
  static async open(browser, path = viewerPage, options = {}) {
    const context = await browser.newContext({ viewport: { width: 960, height: 540 }, ...options });
    const viewer = new Viewer();
    viewer.complaints = [];
    viewer.requests = [];
    await context.setOffline(true);
    viewer.page = await context.newPage();
    viewer.page.on('console', (message) => message.type() === 'error' && viewer.complaints.push(message.text()));
    viewer.page.on('pageerror', (error) => viewer.complaints.push(error.message));
    viewer.page.on('request', (request) => viewer.requests.push(request.url()));
    await viewer.page.goto(`file://${path}`);
    return viewer;
  }

  /** Loads a film and stops it. */
  async load(path) {
    await this.page.evaluate(() => { document.title = ''; });
    await this.page.setInputFiles('#file', path);
    await this.waitForFilm();
    await this.stop();
  }

  async waitForFilm() {
    await this.page.waitForFunction(() => document.title.includes('.glb') && window.viewer.film());
  }

  async stop() {
    if (await this.page.textContent('#play') === 'Pause') await this.page.click('#play');
  }

  async scrub(time) {
    await this.page.locator('#scrub').evaluate((slider, value) => {
      slider.value = value;
      slider.dispatchEvent(new Event('input'));
    }, time);
  }

  film(what) {
    return this.page.evaluate(`(${what})(window.viewer.film())`);
  }

  /** Names of the bodies in the file, and their world positions. */
  bodies() {
    return this.film((film) =>
      film.bodies.map((body) => [body.userData.name, body.matrixWorld.elements.slice(12, 15)]));
  }

  /** What is on the canvas, as 160 x 90 pixels of red, green and blue. */
  pixels() {
    return this.page.evaluate(() => {
      window.viewer.stage().draw();
      const small = new OffscreenCanvas(160, 90).getContext('2d');
      small.drawImage(document.getElementById('view'), 0, 0, 160, 90);
      return [...small.getImageData(0, 0, 160, 90).data].filter((_, i) => i % 4 !== 3);
    });
  }

  shoot(name) {
    return this.page.screenshot({ path: `${shots}${name}.png` });
  }
}

/** Share of the pixels' values that differ. */
export function difference(a, b) {
  return a.filter((value, i) => Math.abs(value - b[i]) > 2).length / a.length;
}
