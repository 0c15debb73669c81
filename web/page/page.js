// SPDX-License-Identifier: BSD-3-Clause
// The form, its link, and the buttons.

const byId = (id) => document.getElementById(id);
const computer = new Computer();
const data = JSON.parse(byId('data').textContent);
let results = {scene: '', csv: '', svg: ''};
let running = 0; // the number of the computation that may show results

const choices = (select, values) => {
    select.replaceChildren(...Object.entries(values).map(([value, label]) => element('option', {value}, label)));
};
const askedBoxes = () => [...document.querySelectorAll('#asked input')];

const showFields = () => {
    const state = readForm();
    for (const field of document.querySelectorAll('[data-profile]')) {
        field.hidden = !FORM.profiles[state.kind].includes(field.dataset.profile);
    }
    byId('symmetric-field').hidden = state.kind !== 'piecewise';
    for (const key of ['load', 'material', 'shear']) {
        for (const field of document.querySelectorAll(`[data-${key}]`)) {
            field.hidden = !field.dataset[key].split(' ').includes(state[key]);
        }
    }
    byId('one-load').hidden = state.shear === 'steps';
    const asked = askedOf(state);
    for (const field of document.querySelectorAll('[data-asked]')) {
        field.hidden = !asked.includes(field.dataset.asked);
    }
};

const readForm = () => {
    const state = defaultState();
    for (const name of Object.keys(state)) {
        const field = byId(name);
        if (field !== null) {
            state[name] = field.value;
        }
    }
    state.ask = askedBoxes().filter((box) => box.checked).map((box) => box.value).join(' ');
    return state;
};
const writeForm = (state) => {
    for (const [name, value] of Object.entries(state)) {
        const field = byId(name);
        if (field !== null) {
            field.value = value;
            if (field.value === '' && field.tagName === 'SELECT') { // a link with an unknown choice
                field.value = FORM.defaults[name];
            }
        }
    }
    const asked = askedOf(state);
    for (const box of askedBoxes()) {
        box.checked = asked.includes(box.value);
    }
    showFields();
};

const clearErrors = () => {
    for (const field of document.querySelectorAll('[aria-invalid]')) {
        field.removeAttribute('aria-invalid');
        field.removeAttribute('aria-describedby');
    }
    document.querySelectorAll('.field > .error').forEach((line) => line.remove());
    byId('form-error').textContent = '';
};
/// Shows an error next to the field of its line, or below the form.
const showError = (error, fields) => {
    const field = byId(fields[(error.line ?? 0) - 1] ?? '');
    const place = field?.closest('.field');
    if (!place || place.hidden) {
        byId('form-error').textContent = error.message;
        return;
    }
    const id = `${field.id}-error`;
    field.setAttribute('aria-invalid', 'true');
    field.setAttribute('aria-describedby', id);
    place.append(element('p', {id, class: 'error', role: 'alert'}, error.message));
    field.focus();
};

const setBusy = (busy) => {
    byId('stop').disabled = !busy;
    byId('compute').disabled = busy;
    byId('results').setAttribute('aria-busy', String(busy));
};

const compute = async () => {
    const state = readForm();
    const width = byId('results').clientWidth;
    const mine = ++running;
    history.replaceState(null, '', `#${toFragment(state)}`);
    clearErrors();
    byId('tables').replaceChildren();
    byId('downloads').hidden = byId('command').hidden = true;
    const asked = askedOf(state);
    const {text, fields} = sceneOf(state);
    results = {scene: text, csv: '', svg: ''};
    const began = performance.now();
    setBusy(true);
    let failed = false;
    for (const quantity of asked) {
        byId('status').textContent = `Computing: ${FORM.quantities[quantity]}.`;
        const ran = await computer.run(argumentsOf(quantity, 'scene.toml', width < 620 ? width : 0), text, ['figure.svg']);
        if (mine !== running) {
            return;
        }
        if (ran === undefined) {
            byId('status').textContent = 'Stopped.';
            setBusy(false);
            return;
        }
        if (ran.status !== 0) {
            failed = true;
            showError(readError(ran.err), fields);
            break;
        }
        show(quantity, ran);
    }
    setBusy(false);
    byId('scene').textContent = [...asked.map((q) => `edgeproof ${argumentsOf(q).join(' ')}`), '', '# scene.toml', text].join('\n');
    byId('command').hidden = false;
    byId('downloads').hidden = failed;
    byId('save-svg').disabled = results.svg === '';
    byId('save-csv').disabled = results.csv === '';
    byId('status').textContent = failed ? 'Not computed: see the message in the form.'
        : asked.length === 0 ? 'Nothing is asked for: choose a quantity.'
        : `Computed in ${((performance.now() - began) / 1000).toFixed(2)} s.`;
};

const show = (quantity, ran) => {
    const title = FORM.quantities[quantity];
    if (quantity === 'plot') {
        results.svg = ran.files['figure.svg'];
        byId('tables').append(pictureElement(results.svg));
    } else {
        results.csv += `${results.csv === '' ? '' : '\n'}# ${title}\n${ran.out}`;
        byId('tables').append(tableElement(title, readTable(ran.out)));
        fitTables();
    }
};

const begin = () => {
    choices(byId('kind'), Object.fromEntries(Object.keys(FORM.profiles).map((kind) => [kind, labelOf(kind)])));
    choices(byId('load'), FORM.loads);
    choices(byId('material'), FORM.materials);
    for (const name of new Set(Object.values(FORM.profiles).flat())) {
        byId('profile-fields').append(
            element('div', {class: 'field', 'data-profile': name}, element('label', {for: name}, labelOf(name)),
                    element(name === 'slopes' ? 'textarea' : 'input', {id: name})));
    }
    byId('asked').append(...Object.entries(FORM.quantities).map(([value, label]) =>
        element('label', {}, element('input', {type: 'checkbox', value}), label)));
    byId('gallery').append(...data.gallery.map(({title, state}) =>
        element('li', {}, element('a', {href: `#${toFragment({...defaultState(), ...state})}`}, title))));

    byId('form').addEventListener('submit', (event) => {
        event.preventDefault();
        compute();
    });
    byId('form').addEventListener('input', showFields);
    byId('stop').addEventListener('click', () => computer.stop());
    byId('reset').addEventListener('click', () => {
        clearErrors();
        writeForm(defaultState());
    });
    byId('save-scene').addEventListener('click', () => save('scene.toml', 'application/toml', results.scene));
    byId('save-csv').addEventListener('click', () => save('edgeproof.csv', 'text/csv', results.csv));
    byId('save-svg').addEventListener('click', () => save('edgeproof.svg', 'image/svg+xml', results.svg));
    byId('copy-link').addEventListener('click', async () => {
        await navigator.clipboard.writeText(location.href);
        byId('status').textContent = 'The link is copied.';
    });
    addEventListener('resize', fitTables);
    addEventListener('hashchange', () => {
        writeForm(fromFragment(location.hash));
        compute();
    });
    writeForm(fromFragment(location.hash));
    computer.compiled.then(compute, () => {
        byId('status').textContent = 'This browser cannot run the page: it needs WebAssembly with exceptions (2022 or later).';
    });
};
begin();
