/* lanes - node lanes.js LANES.wasm: runs tests/web/lanes_run.c, and says what differs
 *
 * SPDX-License-Identifier: MIT */
"use strict";
const fs = require("node:fs");

const program = new WebAssembly.Module(fs.readFileSync(process.argv[2]));
const { exports: call } = new WebAssembly.Instance(program, {});

function name(op) {
  const at = call.lanes_name(op), all = new Uint8Array(call.memory.buffer, at);
  return at && Buffer.from(all.subarray(0, all.indexOf(0))).toString();
}

let agree = 0, cases = 0, count = 0;
for (let text; (text = name(count)); count++) {
  const differ = call.lanes_differ(count), compared = call.lanes_compared();
  if (differ === 0 && compared > 0) {
    agree++;
  } else {
    const words = [...new Uint32Array(call.memory.buffer, call.lanes_first(), 5)];
    const [a, b, c, got, want] = words.map((word) => word.toString(16).padStart(8, "0"));
    console.log(`    ${text}: ${differ} of ${compared} differ, first ${a} ${b} ${c}: ` +
      `${got}, not ${want}`);
  }
  cases += compared;
}
console.log(`${agree} of ${count} operations agree in ${cases} cases`);
process.exit(agree === count && count > 0 ? 0 : 1);
