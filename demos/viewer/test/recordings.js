import { existsSync } from 'node:fs';
import { resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

/** Where the demos' tests leave their films. */
const usual = new URL('../../../build/release-double/tests', import.meta.url);
const folder = process.env.RECORDINGS ?? fileURLToPath(usual);

export function recording(name) {
  const path = resolve(folder, `${name}.glb`);
  if (!existsSync(path))
    throw new Error(`${path} is missing: run the demos' tests (ctest -R films), or set RECORDINGS to its folder`);
  return path;
}

export const allDemos = ['boat_in_waves', 'floating_cube', 'flotsam', 'hard_cases', 'rotation_schemes',
  'speed_vs_error', 'step_cost', 'wave_accuracy', 'wave_cost'];
