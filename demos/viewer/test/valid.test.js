import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { allDemos, recording } from './recordings.js';

for (const demo of allDemos)
  test(`the film of ${demo} is valid glTF`, async (t) => {
    const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(recording(demo))), { maxIssues: 0 });
    for (const code of new Set(issues.messages.map(({ code }) => code))) {
      const messages = issues.messages.filter((message) => message.code === code);
      t.diagnostic(`${demo}: ${messages.length} x ${code}, severity ${messages[0].severity}: ` +
        `${messages[0].pointer} ${messages[0].message}`);
    }
    assert.equal(issues.numErrors, 0);
    assert.equal(issues.numWarnings, 0);
  });
