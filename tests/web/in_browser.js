// SPDX-License-Identifier: BSD-3-Clause
// node in_browser.js PAGE PROGRAM [PICTURES [PART-OF-A-NAME]]: the page in headless Chromium: every profile and
// quantity, wrong input, Stop, the link, the keyboard, narrow and dark displays, print, and that
// nothing is requested. Results are compared with the native program. PICTURES is a folder for
// screenshots.
'use strict';
const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const {pathToFileURL} = require('node:url');
const {Browser} = require('./browser.js');
const {pageNames, nativeProgram, withoutProgram} = require('./program.js');

const [file, program, pictures, only = ''] = process.argv.slice(2);
const address = pathToFileURL(path.resolve(file)).href;
const {FORM, defaultState, toFragment, fromFragment, sceneOf, argumentsOf, readTable} = pageNames(['scene.js'],
    ['FORM', 'defaultState', 'toFragment', 'fromFragment', 'sceneOf', 'argumentsOf', 'readTable']);
const native = nativeProgram(program);

const idle = "document.getElementById('results').getAttribute('aria-busy') === 'false'";
const opened = `${idle} && document.getElementById('status').textContent.startsWith('Computed')`;
const text = (id) => `document.getElementById('${id}').textContent`;
const set = (id, value) => `(() => {const f = document.getElementById('${id}'); f.value = ${JSON.stringify(value)};
    f.dispatchEvent(new Event('input', {bubbles: true}));})()`;
const click = (id) => `document.getElementById('${id}').click()`;
const picture = (page, name) => pictures === undefined ? undefined : page.screenshot(path.join(pictures, name));

const tests = {
    'every profile and quantity by its link gives the text of the native program': async (browser) => {
        const page = await browser.open(address);
        await page.until(opened);
        for (const kind of Object.keys(FORM.profiles)) {
            for (const geometry of ['plane', 'axisymmetric']) {
                for (const [ask, shear] of [['pressure', 'none'], ['expand extent', 'none'], ['slip', 'friction'], ['slip', 'steps'],
                                            ['stress', 'none'], ['displacement', 'none'], ['mises', 'none'], ['tau_max', 'none']]) {
                    const state = {...defaultState(), kind, geometry, ask, shear, alpha: '1/1000', digits: '8'};
                    await page.value(`new Promise((done) => {
                        addEventListener('hashchange', () => setTimeout(done), {once: true});
                        location.hash = ${JSON.stringify(toFragment(state))};})`);
                    await page.until(idle);
                    const {text: scene} = sceneOf(fromFragment(toFragment(state)));
                    const runs = ask.split(' ').map((quantity) => native(argumentsOf(quantity), {'scene.toml': scene}));
                    const failed = runs.find(({status}) => status !== 0);
                    if (failed) {
                        const shown = await page.value("document.getElementById('form').textContent");
                        const message = String(failed.err).trim().replace(/^scene\.toml:(\d+:)? ?|^edgeproof: /, '');
                        assert.ok(shown.includes(message), `${kind} ${geometry} ${ask}: '${message}' is not shown`);
                    } else {
                        const cells = await page.value("[...document.querySelectorAll('#tables td')].map((td) => td.textContent)");
                        assert.deepStrictEqual(cells, runs.flatMap(({out}) => readTable(String(out)).rows.flat()), `${kind} ${geometry} ${ask}`);
                    }
                }
            }
        }
        assert.deepStrictEqual(page.errors, []);
    },
    'the controls: quantities, Compute, the picture, the scene': async (browser) => {
        const page = await browser.open(address);
        await page.until(opened);
        await page.value(click('compute'));
        await page.until(idle);
        assert.match(await page.value(text('status')), /^Computed in/);
        assert.strictEqual(await page.value("document.querySelectorAll('#picture > svg').length"), 1);
        const scene = sceneOf(defaultState()).text;
        assert.ok((await page.value(text('scene'))).endsWith(scene));
        const drawn = native(argumentsOf('plot'), {'scene.toml': scene}, ['figure.svg']).files['figure.svg'];
        assert.strictEqual(withoutProgram(await page.value('results.svg')), withoutProgram(drawn));
        await picture(page, 'wide.png');
        if (pictures !== undefined) {
            await page.pdf(path.join(pictures, 'printed.pdf'));
        }
        // Each box shows or hides its fields.
        await page.value("document.querySelector('#asked input[value=stress]').click()");
        assert.strictEqual(await page.value("document.querySelector('[data-asked=stress]').hidden"), false);
        for (const load of Object.keys(FORM.loads)) {
            await page.value(set('load', load));
            assert.strictEqual(await page.value("document.querySelector('[data-load=a]').hidden"), load !== 'a');
        }
        await page.value(set('shear', 'steps'));
        assert.strictEqual(await page.value("document.getElementById('one-load').hidden"), true);
        await page.value(click('reset'));
        assert.strictEqual(await page.value("document.getElementById('load').value"), FORM.defaults.load);
        assert.deepStrictEqual(page.errors, []);
    },
    'an error stands next to its field, in one line, as text': async (browser) => {
        const page = await browser.open(address);
        await page.until(opened);
        for (const [id, wrong, shear = 'none'] of [['steps', 'P = 100\n<b>"]', 'steps'], ['steps', 'P = 100\nQ', 'steps'], ['R', '-1'], ['P', 'abc'], ['P', '<img src=x onerror=alert(1)>'], ['nu1', '0.7'],
                                   ['u', '1e-6, ,"; ['], ['terms', '0'], ['digits', '-3'], ['tolerance', 'none']]) {
            await page.value(click('reset'));
            await page.value(set('shear', shear));
            await page.value(set(id, wrong));
            await page.value(click('compute'));
            await page.until(`${idle} && ${text('status')}.startsWith('Not computed')`);
            const message = await page.value("[...document.querySelectorAll('#form .error')].map((e) => e.textContent).join('')");
            assert.ok(message.length > 0 && !message.includes('\n'), `${id} = ${wrong}: '${message}'`);
            assert.strictEqual(await page.value("document.querySelectorAll('img').length"), 0);
            assert.strictEqual(await page.value(`document.getElementById('${id}').getAttribute('aria-invalid')`), 'true', `${id} = ${wrong}: '${message}'`);
            assert.strictEqual(await page.value(`document.activeElement.id`), id);
        }
        await picture(page, 'error.png');
        assert.deepStrictEqual(page.errors, []);
    },
    'a link adds no lines to the scene, and an unknown choice becomes the usual one': async (browser) => {
        const state = {...defaultState(), ask: 'pressure', digits: '5\n[extra]', units: 'cm', shear: 'glue', load: 'x'};
        assert.strictEqual(sceneOf(state).text.split('\n').filter((line) => line.startsWith('[extra]')).length, 0);
        const page = await browser.open(`${address}#${toFragment(state)}`);
        await page.until(`${idle} && ${text('status')}.startsWith('Not computed')`);
        assert.strictEqual(await page.value("document.getElementById('digits').getAttribute('aria-invalid')"), 'true');
        for (const id of ['units', 'shear', 'load']) {
            assert.strictEqual(await page.value(`document.getElementById('${id}').value`), FORM.defaults[id]);
        }
        assert.deepStrictEqual(page.errors, []);
    },
    'the downloads are the scene, the tables and the picture': async (browser) => {
        const page = await browser.open(address);
        await page.until(opened);
        await page.value(click('compute'));
        await page.until(`${idle} && ${text('status')}.startsWith('Computed')`);
        const saved = (id) => page.value(`(() => {
            const made = URL.createObjectURL;
            let blob;
            URL.createObjectURL = (given) => made.call(URL, blob = given);
            document.getElementById('${id}').click();
            URL.createObjectURL = made;
            return blob.text();})()`);
        const scene = sceneOf(defaultState()).text;
        const run = (quantity, files) => native(argumentsOf(quantity), {'scene.toml': scene}, files);
        assert.strictEqual(await saved('save-scene'), scene);
        const tables = await saved('save-csv');
        for (const quantity of ['pressure', 'expand', 'extent']) {
            assert.ok(withoutProgram(tables).includes(withoutProgram(run(quantity).out)), quantity);
        }
        assert.strictEqual(withoutProgram(await saved('save-svg')), withoutProgram(run('plot', ['figure.svg']).files['figure.svg']));
    },
    'Stop ends a computation, and the next one works': async (browser) => {
        const page = await browser.open(`${address}#${toFragment({...defaultState(), ask: 'pressure', digits: '60000', kind: 'power-law', m: '5/8'})}`);
        await page.until("!document.getElementById('stop').disabled");
        await page.value(click('stop'));
        await page.until(`${text('status')} === 'Stopped.'`, 10);
        await page.value(click('reset'));
        await page.value(click('compute'));
        await page.until(`${idle} && ${text('status')}.startsWith('Computed')`);
        assert.deepStrictEqual(page.errors, []);
    },
    'the keyboard alone: Tab reaches every control, Enter computes': async (browser) => {
        const page = await browser.open(address);
        await page.until(opened);
        const reached = [];
        for (let i = 0; i < 60; ++i) {
            await page.key('Tab', 'Tab', 9);
            reached.push(await page.value('document.activeElement.id'));
        }
        for (const id of ['kind', 'geometry', 'R', 'units', 'P', 'shear', 'edges', 'u', 'terms', 'digits', 'compute']) {
            assert.ok(reached.includes(id), `Tab does not reach ${id}`);
        }
        await page.value("document.getElementById('P').focus()");
        await page.key('Enter', 'Enter', 13);
        await page.until(`${text('status')}.startsWith('Computed')`);
        const unnamed = await page.value("[...document.querySelectorAll('input, select, textarea, button')].filter((e) => e.labels !== null && e.labels.length === 0 && e.textContent.trim() === '').map((e) => e.id)");
        assert.deepStrictEqual(unnamed, []);
    },
    'narrow and dark: nothing is wider than the display': async (browser) => {
        for (const [width, dark] of [[390, false], [390, true], [1280, true]]) {
            const page = await browser.open(`${address}#${toFragment({...defaultState(), digits: '16'})}`, {width, dark});
            await page.until(`${idle} && ${text('status')}.startsWith('Computed')`);
            assert.ok(await page.value('document.documentElement.scrollWidth') <= width, `${width} px`);
            const cut = await page.value(`[...document.querySelectorAll('select, table, .scroll')].filter((e) => {
                const {right} = e.getBoundingClientRect();
                return right > innerWidth || e.scrollWidth > e.clientWidth + 1;
            }).map((e) => e.id || e.textContent.slice(0, 40))`);
            assert.deepStrictEqual(cut, [], `cut off at ${width} px`);
            const short = await page.value(`(() => {
                const pen = document.createElement('canvas').getContext('2d');
                return [...document.querySelectorAll('select')].filter((e) => e.clientWidth > 0).flatMap((e) => {
                    pen.font = getComputedStyle(e).font;
                    return [...e.options].map((o) => o.text).filter((t) => pen.measureText(t).width + 36 > e.clientWidth);
                });})()`);
            assert.deepStrictEqual(short, [], `choices cut off at ${width} px`);
            const first = await page.value("document.getElementById('tables').firstElementChild.id");
            assert.strictEqual(first, 'picture');
            await picture(page, `${width}-${dark ? 'dark' : 'light'}.png`);
        }
    },
    'no request leaves the page': async (browser) => {
        const page = await browser.open(address);
        await page.until(opened);
        await page.value(click('compute'));
        await page.until(`${idle} && ${text('status')}.startsWith('Computed')`);
        const outside = page.requests.filter((url) => !/^(file|about|blob|data):/.test(url));
        assert.deepStrictEqual(outside, []);
        assert.strictEqual(await page.value("fetch('https://example.org/').then(() => 'sent', () => 'refused')"), 'refused');
        assert.strictEqual(await page.value("new Promise((done) => {const i = new Image(); i.onload = () => done('sent'); i.onerror = () => done('refused'); i.src = 'https://example.org/x.png';})"), 'refused');
        assert.ok(page.errors.some((error) => error.includes('Content Security Policy')), page.errors.join());
    },
};

const main = async () => {
    const browser = new Browser();
    let failures = 0;
    for (const [name, test] of Object.entries(tests).filter(([name]) => name.includes(only))) {
        try {
            await test(browser);
            console.log(`passed: ${name}`);
        } catch (error) {
            ++failures;
            console.log(`FAILED: ${name}\n${error.stack}`);
        }
    }
    await browser.close();
    process.exitCode = failures === 0 ? 0 : 1;
};
main();
