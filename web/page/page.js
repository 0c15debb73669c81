// SPDX-License-Identifier: GPL-3.0-or-later
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
    const labels = new Map(FORM.profiles[state.kind].fields.map(([name, label]) => [name, label]));
    for (const field of document.querySelectorAll('[data-profile]')) {
        field.hidden = !labels.has(field.dataset.profile);
        field.querySelector('label').textContent = labels.get(field.dataset.profile) ?? '';
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
        const ran = await computer.run(argumentsOf(quantity), text, ['figure.svg']);
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
    }
};

// Refuted formulas: for each profile the slider, the lines of the scene, and the values of names.
const sliders = {
    'tilted-wedge': {
        label: 'gamma', range: {min: 0.05, max: 0.95, step: 0.05, value: 0.5},
        scene: (gamma) => ['phi = "pi/16"', `alpha = "1/8*asin((1 - ${gamma})/(1 + ${gamma}))"`,
                           '[load]', 'a = "1"'],
        values: (gamma) => ({gam: gamma, a: 1, b: gamma, phi: Math.PI / 16, calP: Math.PI / 16, x: 0.5}),
    },
    'flat-and-rounded': {
        label: 'a', range: {min: 1.25, max: 4, step: 0.25, value: 2},
        scene: (a) => ['t = "1"', 'R = "10"', '[load]', `a = "${a}"`],
        values: (a) => ({a, t: 1, R: 10, x: a - 0.5}),
    },
};
let asking = 0;
const chosenClaim = () => data.claims.find(({id}) => id === byId('claim').value);
const showSlider = () => {
    const {label, range} = sliders[chosenClaim().over];
    document.querySelector('label[for=slider]').textContent = label;
    for (const [name, value] of Object.entries(range)) {
        byId('slider')[name] = value;
    }
};
const compareClaim = async () => {
    const claim = chosenClaim();
    const slider = sliders[claim.over];
    const at = byId('slider').value;
    byId('slider-value').value = at;
    const mine = ++asking;
    const [, edge, coefficient] = /^(left|right)\.(c\d)$/.exec(claim.of) ?? [];
    byId('claim-formula').textContent = coefficient === undefined ? `p at a - x = 1/2: ${claim.says}`
        : `${coefficient.replace('c', 'c_')} (${edge} edge) = ${claim.says}`;
    const scene = ['[profile]', `kind = "${claim.over}"`, ...slider.scene(at), 'contact_modulus = "1"', '[ask]',
                   `edges = ["${edge ?? 'right'}"]`, 'digits = 12',
                   coefficient === undefined ? 'u = ["1/2"]' : `terms = [${Number(coefficient.slice(1)) + 1}]`, ''];
    const ran = await computer.run([coefficient === undefined ? 'pressure' : 'expand', 'scene.toml', '--format', 'csv'],
                                   scene.join('\n'));
    if (mine !== asking || ran === undefined) {
        return;
    }
    const {columns, rows} = readTable(ran.out);
    const row = coefficient === undefined ? rows[0]
        : rows.find((cells) => cells[1] === coefficient.replace('c', 'c_'));
    const exact = row?.[columns.indexOf(coefficient === undefined ? 'p' : 'value')];
    const bound = row?.[columns.indexOf(coefficient === undefined ? 'p_bound' : 'bound')];
    const printed = printedValue(claim.says, {Pi: Math.PI, Es: 1, ...slider.values(Number(at))});
    byId('claim-exact').textContent = exact === undefined ? ran.err : `${exact} +- ${bound}`;
    byId('claim-printed').textContent = printed.toPrecision(6);
    byId('claim-ratio').textContent = (printed / Number(exact)).toPrecision(4);
};

const begin = () => {
    choices(byId('kind'), Object.fromEntries(Object.entries(FORM.profiles).map(([k, p]) => [k, p.label])));
    choices(byId('load'), FORM.loads);
    choices(byId('material'), FORM.materials);
    const seen = new Set();
    for (const profile of Object.values(FORM.profiles)) {
        for (const [name, label] of profile.fields.filter(([name]) => !seen.has(name))) {
            seen.add(name);
            byId('profile-fields').append(
                element('div', {class: 'field', 'data-profile': name}, element('label', {for: name}, label),
                        element(name === 'slopes' ? 'textarea' : 'input', {id: name})));
        }
    }
    byId('asked').append(...Object.entries(FORM.quantities).map(([value, label]) =>
        element('label', {}, element('input', {type: 'checkbox', value}), label)));
    byId('gallery').append(...data.gallery.map(({title, state}) =>
        element('li', {}, element('a', {href: `#${toFragment({...defaultState(), ...state})}`}, title))));
    choices(byId('claim'), Object.fromEntries(data.claims.map(({id}) => [id, id])));

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
    showSlider();
    byId('claim').addEventListener('change', () => {
        showSlider();
        compareClaim();
    });
    byId('slider').addEventListener('input', compareClaim);
    addEventListener('hashchange', () => {
        writeForm(fromFragment(location.hash));
        compute();
    });
    writeForm(fromFragment(location.hash));
    computer.compiled.then(() => {
        byId('status').textContent = 'Ready.';
        return location.hash.length > 1 ? compute() : undefined;
    }).then(compareClaim, () => {
        byId('status').textContent = 'This browser cannot run the page: it needs WebAssembly with exceptions (2022 or later).';
    });
};
begin();
