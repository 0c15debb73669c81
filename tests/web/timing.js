// SPDX-License-Identifier: GPL-3.0-or-later
// node timing.js PAGE MODULE-FOLDER PROGRAM: seconds until the page is ready in headless Chromium, and
// the times of larger tables at 50 digits by the page's module and by the native program, in turn, less
// those of a command that computes nothing: medians of five.
'use strict';
const fs = require('node:fs');
const path = require('node:path');
const {pathToFileURL} = require('node:url');
const {gzipSync} = require('node:zlib');
const {Browser} = require('./browser.js');
const {root, pageProgram, nativeProgram} = require('./program.js');

const [file, folder, program] = process.argv.slice(2);
const median = (times) => times.sort((a, b) => a - b)[Math.floor(times.length / 2)];
const repeated = async (action) => {
    const times = [];
    for (let i = 0; i < 5; ++i) {
        const began = performance.now();
        await action();
        times.push((performance.now() - began) / 1000);
    }
    return median(times);
};

const main = async () => {
    const browser = new Browser();
    const ready = await repeated(async () => {
        const page = await browser.open(pathToFileURL(path.resolve(file)).href);
        await page.until("document.getElementById('status').textContent === 'Ready.'");
    });
    await browser.close();
    console.log(`page: ${(gzipSync(fs.readFileSync(file)).length / 1e6).toFixed(2)} MB compressed, ready after ${ready.toFixed(2)} s`);
    const page = pageProgram(folder);
    const native = nativeProgram(program);
    const start = {page: await repeated(() => page(['--version'], {})), native: await repeated(() => native(['--version'], {}))};
    console.log('scene,command,page/s,native/s,ratio');
    const places = Array.from({length: 3000}, (_, i) => `"a/${i + 2}"`).join(', ');
    const points = Array.from({length: 300}, (_, i) => `["1/${i + 2}", "1/3"]`).join(', ');
    for (const [name, ask, command] of [
        ['fig2b-five-eighths', `u = [${places}]`, 'pressure'],
        ['fig9a-tilted-flat-and-rounded', `u = [${places}]`, 'pressure'],
        ['fig9a-tilted-flat-and-rounded', 'tolerance = "1%"\nterms = [1, 2, 3, 4, 5]', 'extent'],
        ['bevelled', `u = [${places}]`, 'pressure'],
        ['fig4a-flat-and-rounded', `points = [${points}]`, 'stress'],
        ['fig2b-five-eighths', `points = [${points}]`, 'stress'],
        ['history', 'tolerance = "1%"\nterms = [1, 2, 3]', 'slip'],
        ['sphere', `u = [${places}]`, 'pressure']]) {
        const scene = fs.readFileSync(path.join(root, 'examples', 'scenes', `${name}.toml`), 'utf8');
        const text = `${scene.slice(0, scene.indexOf('[ask]'))}[ask]\nedges = ["right"]\n${ask}\n`;
        const words = [command, 'scene.toml', '--digits', '50'];
        const run = (which) => repeated(async () => {
            const {status, err} = await which(words, {'scene.toml': text});
            if (status !== 0) {
                throw new Error(`${name}: ${Buffer.from(err)}`);
            }
        });
        const here = await run(page) - start.page;
        const there = await run(native) - start.native;
        console.log([name, command, here.toFixed(3), there.toFixed(3), (here / there).toFixed(1)].join());
    }
};
main();
