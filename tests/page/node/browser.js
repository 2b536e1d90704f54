// Opens a page of the house in headless Chromium, from the disk, and uses it as a person would:
//   node browser.js CHROMIUM PAGE.html
// Exits with 1 and the reason if something is not as it should be. It speaks Chromium's protocol over a pipe.
'use strict';
const { spawn } = require('child_process'), fs = require('fs'), os = require('os'), path = require('path');
const [chromium, page] = process.argv.slice(2);
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'handrail-page-'));
const browser = spawn(chromium, ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--no-first-run',
    '--disable-extensions', '--remote-debugging-pipe', '--user-data-dir=' + profile, 'about:blank'],
    { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
const waiting = new Map(), requests = [], log = [];
let count = 0, bytes = Buffer.alloc(0), session;

const send = (method, params = {}) => new Promise(resolve => {
    waiting.set(++count, resolve);
    browser.stdio[3].write(JSON.stringify({ id: count, method, params, sessionId: session }) + '\0');
});
function take(message) {
    if (message.id) waiting.get(message.id)(message.result || {});
    if (message.method === 'Network.requestWillBeSent') requests.push(message.params.request.url);
    if (message.method === 'Runtime.consoleAPICalled') log.push(JSON.stringify(message.params.args));
    if (message.method === 'Runtime.exceptionThrown') log.push(JSON.stringify(message.params.exceptionDetails));
    if (message.method === 'Log.entryAdded') log.push(message.params.entry.text);
}
browser.stdio[4].on('data', data => {
    bytes = Buffer.concat([bytes, data]);
    for (let end; (end = bytes.indexOf(0)) >= 0; bytes = bytes.subarray(end + 1)) take(JSON.parse(bytes.subarray(0, end)));
});

const value = async expression =>
    (await send('Runtime.evaluate', { expression, returnByValue: true, awaitPromise: true })).result?.value;
function check(right, what) {
    if (!right) throw new Error(what);
}
async function until(expression, what) {
    for (let tries = 0; tries < 1200; ++tries) {
        if (await value(expression)) return;
        await new Promise(resolve => setTimeout(resolve, 50));
    }
    throw new Error(what + '; said: ' + await value('document.getElementById("said").innerText') + '; console: ' + log.join(' '));
}
async function press(key, code, number) {
    for (const type of ['keyDown', 'keyUp'])
        await send('Input.dispatchKeyEvent', { type, key, code, windowsVirtualKeyCode: number });
}
const said = text => `document.getElementById('said').innerText.includes(${JSON.stringify(text)})`;
const type_line = line => value(`(line.value = ${JSON.stringify(line)}, send.click())`);

async function use_it() {
    const { targetInfos } = await send('Target.getTargets');
    const target = targetInfos.find(one => one.type === 'page').targetId;
    session = (await send('Target.attachToTarget', { targetId: target, flatten: true })).sessionId;
    for (const domain of ['Page', 'Runtime', 'Network', 'Log', 'Accessibility']) await send(domain + '.enable');
    await send('Page.navigate', { url: 'file://' + path.resolve(page) });
    await until(said('House'), 'no first words');
    check(await value('document.activeElement.id') === 'app', 'the building has no focus');
    check(await value('polite.innerText.length > 0'), 'a screen reader hears nothing');

    const before = await value('said.childElementCount');
    await press('ArrowUp', 'ArrowUp', 38);
    await until('said.childElementCount > ' + before, 'the arrow key makes no step');
    await type_line('where am i');
    await until('said.lastElementChild.innerText.match(/hall|base/i)', 'no answer to where am i');

    await type_line('routes');
    await until('!list.hidden && document.activeElement.closest("#items")', 'the list of rooms has no focus');
    const first = await value('document.activeElement.innerText');
    await press('ArrowDown', 'ArrowDown', 40);
    check(await value('document.activeElement.innerText') !== first, 'the arrow key does not move in the list');
    const { nodes } = await send('Accessibility.getFullAXTree');
    const roles = nodes.filter(node => !node.ignored).map(node => node.role?.value);
    for (const role of ['heading', 'button', 'application', 'textbox', 'combobox'])
        check(roles.includes(role), 'no ' + role + ' in the accessibility tree');
    await press('Escape', 'Escape', 27);
    await until('list.hidden && document.activeElement.id === "app"', 'the list does not close');

    check(await value('polite.innerText !== ""'), 'no words to silence');
    check(await value('(document.getElementById("stop").click(), polite.innerText + assertive.innerText === "")'),
        'the stop button leaves words');
    await value('(language.value = "de", language.dispatchEvent(new Event("change")))');
    await until('document.getElementById("stop").innerText === "Ruhe"', 'no German');

    check(requests.every(url => url.startsWith('file://') || url.startsWith('blob:')), 'requests: ' + requests.join(' '));
    check(log.length === 0, 'console: ' + log.join(' '));
}

use_it().then(() => 0, error => {
    console.error(String(error));
    return 1;
}).then(async status => {
    browser.kill();
    await new Promise(resolve => browser.on('exit', resolve));
    fs.rmSync(profile, { recursive: true, force: true });
    process.exit(status);
});
