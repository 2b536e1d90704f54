// The page: what is heard, shown and pressed. The session runs in a worker (worker.js).
'use strict';
(async () => {
    const element = id => document.getElementById(id);
    const texts = JSON.parse(element('texts').textContent);
    let labels = texts[document.documentElement.lang];
    let view = { kind: 'none', items: [] }, stops = 0;

    // ---- the parts of the file ----

    const unpack = async id => {
        const packed = Uint8Array.from(atob(element(id).textContent.trim()), c => c.charCodeAt(0));
        const plain = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
        return new Uint8Array(await new Response(plain).arrayBuffer());
    };
    const script = id => element(id).textContent.replaceAll('<\\/script', '</' + 'script');
    const worker = new Worker(URL.createObjectURL(
        new Blob([script('core'), '\n', script('worker')], { type: 'text/javascript' })));
    const send = message => worker.postMessage(message);

    // ---- what is heard ----

    const own_voice = () => element('voice').value === 'browser';
    function say(line) {
        if (own_voice()) {
            if (line.urgent) speechSynthesis.cancel();
            const spoken = new SpeechSynthesisUtterance(line.text);
            spoken.lang = document.documentElement.lang;
            return speechSynthesis.speak(spoken);
        }
        const region = element(line.urgent ? 'assertive' : 'polite');
        region.append(Object.assign(document.createElement('p'), { textContent: line.text }));
        while (region.childElementCount > 8) region.firstElementChild.remove();
    }
    function hear(message) {
        for (const line of message.said) {
            element('said').append(Object.assign(document.createElement('li'), { textContent: line.text }));
            element('app').textContent = line.text;
            // Lines from before the person pressed the stop key are shown, but not spoken.
            if (message.stops === stops) say(line);
        }
        while (element('said').childElementCount > 200) element('said').firstElementChild.remove();
    }
    // Silences the page at once, without waiting for the worker.
    function silence() {
        if ('speechSynthesis' in window) speechSynthesis.cancel();
        for (const id of ['polite', 'assertive']) element(id).replaceChildren();
    }
    function stop() {
        silence();
        send({ stop: ++stops });
    }

    // ---- lists and questions ----

    function show(next) {
        const was_open = view.kind !== 'none';
        view = next;
        const open = view.kind !== 'none';
        element('list').hidden = !open;
        if (!open) {
            if (was_open) element('app').focus();
            return;
        }
        element('list_title').textContent = view.title;
        element('items').replaceChildren(...view.items.map((item, i) => {
            const row = document.createElement('li'), button = document.createElement('button');
            button.type = 'button';
            button.textContent = item.value ? item.name + ', ' + item.value : item.name;
            button.onclick = () => send({ item: [0, i, item.name] });
            row.append(button);
            return row;
        }));
        if (view.kind === 'text') element('line').focus();
        else element('items').children[view.at].firstElementChild.focus();
    }
    element('items').addEventListener('keydown', event => {
        const buttons = [...element('items').querySelectorAll('button')], at = buttons.indexOf(event.target);
        const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: buttons.length - 1 }[event.key];
        const act = { ArrowLeft: 1, ArrowRight: 2 }[event.key];
        if (to !== undefined) buttons[Math.max(0, Math.min(to, buttons.length - 1))].focus();
        else if (act && view.items[at].adjustable) send({ item: [act, at, view.items[at].name] });
        else return;
        event.preventDefault();
    });
    element('close').onclick = () => send({ key: 'Escape' });

    // ---- keys ----

    const names = { ArrowUp: 'Up', ArrowDown: 'Down', ArrowLeft: 'Left', ArrowRight: 'Right', ' ': 'Space',
        ',': 'Comma', '.': 'Period', '/': 'Slash', '-': 'Minus', '`': 'Grave' };
    // Keys of browsers and screen readers, which the page leaves to them.
    const theirs = /^(Tab|Shift\+Tab|F3|F5|F6|F7|F10|F11|F12|CapsLock|Alt\+(Left|Right|Up|Down|D|F4|F|E)|Control\+.*|Meta\+?.*|Insert.*)$/;
    function key_name(event) {
        if (['Control', 'Shift', 'Alt', 'Meta', 'AltGraph'].includes(event.key)) return '';
        const digit = /^Digit(\d)$/.exec(event.code);
        let name = digit ? digit[1] : names[event.key] || event.key;
        if (name.length === 1) name = name.toUpperCase();
        return (event.ctrlKey ? 'Control+' : '') + (event.altKey ? 'Alt+' : '') + (event.shiftKey ? 'Shift+' : '') +
            (event.metaKey ? 'Meta+' : '') + name;
    }
    element('app').addEventListener('keydown', event => {
        const name = key_name(event);
        if (!name || name === 'Escape' || theirs.test(name)) return;
        event.preventDefault();
        send({ key: name });
    });
    addEventListener('keydown', event => {
        if (event.key === 'Control' && own_voice()) speechSynthesis.cancel();
        if (event.key !== 'Escape') return;
        event.preventDefault();
        if (view.kind === 'none') return stop();
        silence();
        send({ key: 'Escape' });
    });
    element('stop').onclick = stop;
    element('typed').addEventListener('submit', event => {
        event.preventDefault();
        const line = element('line').value.trim();
        element('line').value = '';
        if (line) send({ line });
    });

    // ---- the start ----

    function label(commands) {
        for (const id of ['stop', 'close', 'line_label', 'send', 'said_title', 'commands_title', 'options_title',
            'voice_label', 'language_label', 'keys']) element(id).textContent = labels[id];
        element('app').setAttribute('aria-label', labels.app);
        element('commands').replaceChildren(...commands.map(command => {
            const row = document.createElement('li'), button = document.createElement('button');
            button.type = 'button';
            button.textContent = command.word + ': ' + command.help;
            button.onclick = () => send({ line: command.word });
            row.append(button);
            return row;
        }));
        const voices = [['reader', labels.voice_reader]];
        if ('speechSynthesis' in window) voices.push(['browser', labels.voice_browser]);
        const chosen = element('voice').value || 'reader';
        element('voice').replaceChildren(...voices.map(([value, name]) => new Option(name, value, false, value === chosen)));
    }
    const [wasm, scene, navigation] = await Promise.all(['wasm', 'scene', 'navigation'].map(unpack));
    const begin = () => send({ begin: { wasm, scene, navigation, language: document.documentElement.lang } });
    element('language').replaceChildren(...Object.entries(texts).map(
        ([code, text]) => new Option(text.name, code, false, code === document.documentElement.lang)));
    element('language').onchange = () => {
        document.documentElement.lang = element('language').value;
        labels = texts[element('language').value];
        begin();
    };
    worker.onmessage = event => {
        const message = event.data;
        if (message.ready) {
            label(message.commands);
            element('live').hidden = false;
            element('plain').hidden = true;
            element('app').focus();
        }
        if (message.said) hear(message);
        if (message.view) show(message.view);
        if (message.problem) hear({ said: [{ text: message.problem, urgent: true }], stops });
    };
    worker.onerror = event => hear({ said: [{ text: String(event.message), urgent: true }], stops });
    begin();
})();
