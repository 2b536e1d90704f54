// The worker of a page: it runs the session, so that long work never stops the page. Messages from the page: begin,
// line, key, text, item, stop. Messages to the page: ready, said, view, problem.
'use strict';
let core = null, view = '', stops = 0, last = 0;

const call = (name, result, types = [], values = []) => core.ccall(name, result, types, values);

function bytes_in(bytes) {
    const at = core._malloc(bytes.length || 1);
    core.HEAPU8.set(bytes, at);
    return at;
}

function begin(message) {
    const [scene, navigation] = [bytes_in(message.scene), bytes_in(message.navigation)];
    const problem = call('page_begin', 'string', ['number', 'number', 'number', 'number', 'string', 'number'],
        [scene, message.scene.length, navigation, message.navigation.length, message.language, 0]);
    core._free(scene);
    core._free(navigation);
    if (problem) return postMessage({ problem });
    view = '';
    postMessage({ ready: true, commands: JSON.parse(call('page_commands', 'string')) });
    last = performance.now();
}

function report() {
    const said = call('page_said', 'string');
    if (said !== '[]') postMessage({ said: JSON.parse(said), stops });
    const now = call('page_view', 'string');
    if (now !== view) postMessage({ view: JSON.parse(view = now) });
}

// Gives the session the time that has passed. After a pause of the page, the session goes on where it was.
function turn() {
    if (!last) return;
    const now = performance.now(), ms = Math.min(Math.floor(now - last), 100);
    last = ms === 100 ? now : last + ms;
    call('page_advance', 'number', ['number'], [ms]);
    report();
}

async function take(message) {
    if (message.begin) {
        if (!core) core = await handrailCore({ wasmBinary: message.begin.wasm });
        return begin(message.begin);
    }
    if (!last) return;
    if ('line' in message) call('page_line', null, ['string'], [message.line]);
    if ('key' in message) call('page_key', 'number', ['string'], [message.key]);
    if ('text' in message) call('page_text', 'number', ['string'], [message.text]);
    if (message.item) call('page_item', 'number', ['number', 'number', 'string'], message.item);
    if ('stop' in message) {
        stops = message.stop;
        call('page_key', 'number', ['string'], ['F12']);
    }
    turn();
}

onmessage = event => take(event.data).catch(error => postMessage({ problem: String(error) }));
setInterval(turn, 16);
