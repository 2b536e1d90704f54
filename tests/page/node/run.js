// Runs the core of a page in node and prints what it says:
//   node run.js PAGE_NODE.js lines SCENE NAVIGATION LANGUAGE SCRIPT     the lines of the file SCRIPT, one after the other
//   node run.js PAGE_NODE.js scenario FILE MAPS PACKED
'use strict';
const fs = require('fs');
const [core, what, ...rest] = process.argv.slice(2);

require(core)({ wasmBinary: fs.readFileSync(core.replace(/js$/, 'wasm')) }).then(module => {
    const call = (name, result, types = [], values = []) => module.ccall(name, result, types, values);
    if (what === 'scenario') {
        process.stdout.write(call('page_scenario', 'string', ['string', 'string', 'string'], rest));
        return;
    }
    const [scene, navigation] = rest.slice(0, 2).map(name => {
        const bytes = fs.readFileSync(name), at = module._malloc(bytes.length || 1);
        module.HEAPU8.set(bytes, at);
        return [at, bytes.length];
    });
    const problem = call('page_begin', 'string', ['number', 'number', 'number', 'number', 'string', 'number'],
        [...scene, ...navigation, rest[2], 1]);
    if (problem) throw new Error(problem);
    for (const line of fs.readFileSync(rest[3], 'utf8').split('\n').filter(line => line))
        call('page_line', null, ['string'], [line]);
    for (let quiet = 0, ms = 0; quiet < 1000 && ms < 900000; ms += 10) {
        quiet = call('page_advance', 'number', ['number'], [10]) ? 0 : quiet + 10;
        for (const line of JSON.parse(call('page_said', 'string'))) process.stdout.write(line.text + '\n');
    }
}).catch(error => {
    console.error(String(error));
    process.exitCode = 1;
});
