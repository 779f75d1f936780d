import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { difference, launch, Viewer, viewerPage } from './browser.js';
import { Glb } from './read_glb.js';
import { allDemos, recording } from './recordings.js';

const options = { timeout: 600_000 };
const single = 1e-6;  // of the length: files and page count in single precision
const isMarker = /: (force|centre of buoyancy)$/;
let browser, folder;

before(async () => {
  browser = await launch();
  folder = mkdtempSync(join(tmpdir(), 'viewer-'));
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

async function inViewer(run, page, settings) {
  const viewer = await Viewer.open(browser, page, settings);
  try {
    await run(viewer);
    assert.deepEqual(viewer.complaints, []);
    assert.deepEqual(viewer.requests.filter((url) => !/^(file|blob|data):/.test(url)), []);
  } finally {
    await viewer.page.context().close();
  }
}

function assertNear(actual, expected, tolerance, what) {
  expected.forEach((value, i) => {
    assert.ok(Math.abs(actual[i] - value) <= tolerance, `${what}: ${actual} in the page, ${expected} in the file`);
  });
}

/** All bodies are where the file has them, in the file's order. */
async function checkBodies(viewer, glb, time) {
  const seen = await viewer.bodies();
  const bodies = [...glb.json.nodes.entries()].filter(([, { name }]) => name !== 'water' && !isMarker.test(name));
  assert.deepEqual(seen.map(([name]) => name), bodies.map(([, { name }]) => name));
  bodies.forEach(([node, { name, translation }], i) => {
    const place = glb.keys(node, 'translation') ? glb.valueAt(node, 'translation', time) : translation;
    assertNear(seen[i][1], place, 8 * single * (1 + Math.hypot(...place)), name);
  });
}

/** The surface is where the file has it, and the walls of the block below reach up to it. */
async function checkWater(viewer, glb, time) {
  const heights = await viewer.film((film) => {
    const place = film.root.position.clone();
    return Array.from({ length: film.water.geometry.attributes.position.count }, (_, i) =>
      film.water.getVertexPosition(i, place).toArray());
  });
  for (let i = 0; i < heights.length; i += Math.ceil(heights.length / 20))
    assertNear([heights[i][1]], [glb.waterHeight(i, time)], 1e-5, `height of vertex ${i}`);
  const tops = await viewer.film((film) => {
    const wall = film.water.children[0], place = film.root.position.clone();
    return Array.from({ length: (wall.geometry.attributes.position.count - 1) / 2 }, (_, i) =>
      wall.getVertexPosition(i, place).toArray());
  });
  const surface = new Set(heights.map((place) => place.map((x) => x.toFixed(4)).join()));
  assert.ok(tops.every((top) => surface.has(top.map((x) => x.toFixed(4)).join())), 'the walls end at the surface');
}

/** A scene of nothing. */
function bareGlb() {
  const json = Buffer.from('{"asset":{"version":"2.0"},"scene":0,"scenes":[{}]}'.padEnd(52)), head = 20;
  const words = new Uint32Array([0x46546c67, 2, head + json.length, json.length, 0x4e4f534a]);
  return Buffer.concat([Buffer.from(words.buffer), json]);
}

async function checkFilm(viewer, demo) {
  const glb = new Glb(recording(demo));
  await viewer.load(recording(demo));
  const duration = await viewer.film((film) => film.duration);
  assertNear([duration], [glb.duration], single * glb.duration, 'duration');
  assert.match(await viewer.page.textContent('#clock'), new RegExp(`/ ${glb.duration.toFixed(2)} s$`));

  const pictures = [], moments = [0.1234, 0.7654].map((share) => share * glb.duration);
  for (const time of moments) {
    await viewer.scrub(time);
    const times = await viewer.film((film) => film.actions.map((action) => action.time));
    assertNear(times, [time], single * glb.duration, 'time');
    await checkBodies(viewer, glb, time);
    if (glb.node('water') >= 0) await checkWater(viewer, glb, time);
    pictures.push(await viewer.pixels());
    await viewer.shoot(`${demo}_${time === moments[0] ? 'early' : 'late'}`);
  }
  assert.ok(new Set(pictures[0]).size > 60, 'the canvas is not blank');
  assert.ok(difference(...pictures) > 0.0005, `what moves is seen to move: ${difference(...pictures)}`);
  await viewer.scrub(moments[0]);
  assert.equal(difference(pictures[0], await viewer.pixels()), 0, 'a time always looks the same');
}

test('plays the films of all demos', options, (t) => inViewer(async (viewer) => {
  for (const demo of allDemos) await t.test(demo, () => checkFilm(viewer, demo));
}));

test('plays, stops, goes in steps and repeats', options, () => inViewer(async (viewer) => {
  const { page } = viewer, time = () => viewer.film((film) => film.time);
  await viewer.load(recording('floating_cube'));
  await viewer.scrub(1);
  await page.locator('#view').focus();
  await page.keyboard.press('ArrowRight');
  assertNear([await time()], [1.1], single, 'an arrow');
  await page.keyboard.press('Shift+ArrowLeft');
  assertNear([await time()], [0.1], single, 'an arrow with Shift');
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.viewer.film().time > 0.2);
  await page.keyboard.press('Space');
  assert.equal(await page.textContent('#play'), 'Play');
  const stopped = await time();
  await page.waitForTimeout(300);
  assert.equal(await time(), stopped);

  await page.uncheck('#repeat');
  await page.selectOption('#speed', '5');
  await page.click('#play');
  await page.waitForFunction(() => document.getElementById('play').textContent === 'Play');
  assert.equal(await time(), await viewer.film((film) => film.duration));
  await page.check('#repeat');
  await page.click('#play');
  await page.waitForFunction(() => window.viewer.film().time < 5);
}));

test('shows the forces where they were filmed', options, () => inViewer(async (viewer) => {
  const shown = () => viewer.film((film) => film.markers.filter((marker) => marker.visible).length);
  await viewer.load(recording('floating_cube'));
  await viewer.scrub(9);
  const without = await viewer.pixels();
  assert.equal(await shown(), 0);
  await viewer.page.check('#forces');
  assert.equal(await shown(), await viewer.film((film) => 2 * film.bodies.length));
  assert.ok(difference(without, await viewer.pixels()) > 0.0003, 'the forces are seen');
  await viewer.shoot('forces');
  await viewer.load(recording('flotsam'));
  assert.equal(await viewer.page.isVisible('#forces'), false);
}));

test('turns by the mouse, and back', options, () => inViewer(async (viewer) => {
  const place = () => viewer.page.evaluate(() => window.viewer.stage().camera.position.toArray());
  await viewer.load(recording('floating_cube'));
  const first = await place();
  await viewer.page.mouse.move(600, 200);
  await viewer.page.mouse.down();
  await viewer.page.mouse.move(800, 260, { steps: 4 });
  await viewer.page.mouse.up();
  assert.ok(Math.hypot(...(await place()).map((x, i) => x - first[i])) > 0.1);
  await viewer.page.click('#reset');
  assertNear(await place(), first, 1e-6 * Math.hypot(...first), 'place of the camera');
}));

test('fills the window, on any screen', options, () => inViewer(async (viewer) => {
  await viewer.load(recording('floating_cube'));
  await viewer.page.setViewportSize({ width: 390, height: 700 });
  await viewer.page.waitForFunction(() => document.getElementById('view').width === 780);
  await viewer.page.click('#reset');
  await viewer.shoot('narrow');
  assert.equal(await viewer.page.evaluate(() => document.getElementById('view').height), 1400);
  assert.ok(new Set(await viewer.pixels()).size > 60);
}, undefined, { deviceScaleFactor: 2 }));

test('says what is wrong with a bad file, and keeps the film', options, () => inViewer(async (viewer) => {
  const bad = (name, bytes) => {
    writeFileSync(join(folder, name), bytes);
    return join(folder, name);
  };
  const whole = readFileSync(recording('floating_cube'));
  await viewer.load(recording('floating_cube'));
  for (const [path, message] of [
    [bad('text.glb', 'not a film'), /text\.glb cannot be played: it is not a glTF/],
    [bad('half.glb', whole.subarray(0, whole.length / 2)), /half\.glb cannot be played: /],
    [bad('empty.glb', ''), /empty\.glb cannot be played: it is not a glTF/],
    [bad('bare.glb', bareGlb()), /bare\.glb cannot be played: there is nothing in it/],
  ]) {
    await viewer.page.setInputFiles('#file', path);
    await viewer.page.getByRole('alert').filter({ hasText: message }).waitFor();
  }
  await viewer.shoot('bad_file');
  assert.equal(await viewer.film((film) => film.bodies.length), 1);
  await viewer.load(recording('floating_cube'));
  assert.equal(await viewer.page.getByRole('alert').isVisible(), false);
}));

test('takes a file that is dropped', options, () => inViewer(async (viewer) => {
  const base64 = readFileSync(recording('floating_cube')).toString('base64');
  await viewer.page.evaluate((text) => {
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([bytes], 'dropped.glb'));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, base64);
  await viewer.waitForFilm();
}));

test('fetches the file that the address names', options, async () => {
  const server = createServer((request, response) => {
    const files = { '/viewer.html': viewerPage, '/floating_cube.glb': recording('floating_cube') };
    const path = files[request.url.split('?')[0]];
    response.writeHead(path ? 200 : 404).end(path && readFileSync(path));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const page = await browser.newPage(), address = `http://127.0.0.1:${server.address().port}/viewer.html`;
  try {
    await page.goto(`${address}?file=floating_cube.glb`);
    await page.waitForFunction(() => window.viewer.film());
    await page.goto(`${address}?file=missing.glb`);
    await page.getByRole('alert').filter({ hasText: /missing\.glb cannot be fetched: the server says 404/ }).waitFor();
    await page.goto(`file://${viewerPage}?file=floating_cube.glb`);
    await page.getByRole('alert').filter({ hasText: /a page from disk may not fetch files; drop it here/ }).waitFor();
  } finally {
    await page.close();
    server.close();
  }
});

test('a packed page plays by itself', options, async () => {
  const packed = join(folder, 'packed.html');
  const pack = fileURLToPath(new URL('../pack.js', import.meta.url));
  execFileSync(process.execPath, [pack, recording('floating_cube'), packed]);
  await inViewer(async (viewer) => {
    await viewer.waitForFilm();
    assert.equal(await viewer.film((film) => film.bodies.length), 1);
    assert.equal(await viewer.page.isVisible('#hint'), false);
  }, packed);
});

test('controls have names', options, () => inViewer(async (viewer) => {
  const { page } = viewer;
  await viewer.load(recording('floating_cube'));
  for (const [role, name] of [['button', 'Play'], ['button', 'Reset view'], ['slider', 'Time'], ['combobox', 'Speed'],
    ['checkbox', 'Repeat'], ['checkbox', 'Forces'], ['img', /film/]])
    assert.equal(await page.getByRole(role, { name }).count(), 1, `${role} ${name}`);
  await viewer.scrub(2.5);
  assert.equal(await page.getByRole('slider').getAttribute('aria-valuetext'), '2.50 s');
}));
