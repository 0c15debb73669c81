// SPDX-License-Identifier: BSD-3-Clause
// node same_bytes.js MODULE-FOLDER PROGRAM [SCENES [SEED]]: runs the scenes of examples/scenes and
// drawn ones, until SCENES of them were computed and not refused, by the page's module and by the
// native program. Exit 1 unless status, standard output, standard error and pictures have the same
// bytes (except for the name of the program).
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const {root, pageNames, pageProgram, nativeProgram, withoutProgram} = require('./program.js');

const [folder, program, count = '300', seed = '1'] = process.argv.slice(2);
const {FORM, defaultState, sceneOf, argumentsOf} = pageNames(
    ['scene.js'], ['FORM', 'defaultState', 'sceneOf', 'argumentsOf']);

let word = Number(seed) >>> 0;
const random = () => { // mulberry32
    word = (word + 0x6D2B79F5) >>> 0;
    let t = word;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
};
const one = (list) => list[Math.floor(random() * list.length)];
/// A decimal of that many digits, between 0.1 and 1 times a power of ten.
const decimal = (digits, exponent = 0) =>
    `${(0.1 + 0.9 * random()).toFixed(digits)}${exponent === 0 ? '' : `e${exponent}`}`;

const drawn = () => {
    const state = defaultState();
    state.kind = one(Object.keys(FORM.profiles));
    state.geometry = random() < 0.25 ? 'axisymmetric' : 'plane';
    state.units = one(['mm', 'none']);
    Object.assign(state, {
        R: decimal(2, one([0, 2, 3])), C: decimal(3), m: one(['1', '0', '2', '1/2', '5/8', '10', decimal(2)]),
        t: one(['1', decimal(2)]), phi: one(['pi/16', '1/50', decimal(3)]),
        alpha: one(['0', '1/1000', `1/${Math.ceil(100 * random())}`]),
        symmetric: one(['1', '1', '0']), knots: one(['1/2', decimal(2)]),
        slopes: one(['x/10\nx/10 + (x - 1/2)^3', 'x/20\nx/5 - 3/40', 'x/10 + x^3\nx/10 + x^3']),
        load: one(['a', 'a', 'P', 'P', 'PM', 'delta']), a: decimal(3, one([0, 1])), P: decimal(2, one([0, 3])),
        M: decimal(2), delta: decimal(3, -2), material: one(['Es', 'E']), Es: decimal(3, one([0, 5])),
        shear: one(['none', 'none', 'stick', 'friction', 'steps']), Q: decimal(2, one([-1, 1])),
        steps: one(['P = 10\nQ = 2', 'P = 100\nQ = 20\nQ = -10, cycles = 2\nP = 50', 'P = 3; Q = 1\nP = 2']),
        bulk_tension: one(['0', '0', decimal(1)]), friction: decimal(1), edges: one(['right', 'left', 'both']),
        u: `1e-${Math.ceil(40 * random())}, ${decimal(4, -2)}, a/2`, terms: one(['1', '1, 2', '1, 2, 3', '4']),
        tolerance: one(['1%', '5%', '1/10']), points: '0 0; 1/2 1/3', x: '0, 3',
        digits: one(['5', '12', '15', '30', '50', '50', '80']),
    });
    // The search for a greatest stress can take minutes after a load history, and for high powers.
    const left_out = state.shear === 'steps' || state.m === '10' ? ['plot', 'mises', 'tau_max'] : ['plot'];
    return {state, quantity: random() < 0.05 ? 'plot'
        : one(Object.keys(FORM.quantities).filter((name) => !left_out.includes(name)))};
};

const main = async () => {
    const page = pageProgram(folder);
    const native = nativeProgram(program);
    const totals = {scenes: 0, errors: 0, different: 0};
    let pageTime = 0;
    let nativeTime = 0;
    const compare = async (name, words, text) => {
        const began = performance.now();
        const here = await page(words, {'scene.toml': text}, ['figure.svg']);
        const middle = performance.now();
        const there = native(words, {'scene.toml': text}, ['figure.svg']);
        pageTime += middle - began;
        nativeTime += performance.now() - middle;
        ++totals.scenes;
        if (totals.scenes % 20 === 0) {
            console.error(`${totals.scenes} runs, ${totals.different} different`);
        }
        totals.errors += there.status === 0 ? 0 : 1;
        const shown = (ran) => [ran.status, withoutProgram(ran.out), withoutProgram(ran.err),
                                withoutProgram(ran.files['figure.svg'])];
        const [a, b] = [shown(here), shown(there)];
        if (a.some((part, i) => part !== b[i])) {
            ++totals.different;
            console.log(`${name}: edgeproof ${words.join(' ')}\n${text}`);
            a.forEach((part, i) => part === b[i] ||
                console.log(`--- page\n${String(part).slice(0, 1500)}\n--- native\n${String(b[i]).slice(0, 1500)}`));
        }
    };
    for (let i = 0; totals.scenes - totals.errors < Number(count); ++i) {
        const {state, quantity} = drawn();
        state.ask = quantity;
        await compare(`scene ${i} of seed ${seed}`, argumentsOf(quantity), sceneOf(state).text);
    }
    const scenes = path.join(root, 'examples', 'scenes');
    for (const file of fs.readdirSync(scenes).filter((name) => name.endsWith('.toml')).sort()) {
        const text = fs.readFileSync(path.join(scenes, file), 'utf8');
        for (const command of ['pressure', 'expand', 'extent']) {
            await compare(file, argumentsOf(command), text);
        }
    }
    console.log(`${totals.scenes} runs, ${totals.errors} of them refused, ${totals.different} different; ` +
        `page ${(pageTime / 1000).toFixed(1)} s, native ${(nativeTime / 1000).toFixed(1)} s (with the start of each program)`);
    process.exitCode = totals.different === 0 ? 0 : 1;
};
main();
