// SPDX-License-Identifier: BSD-3-Clause
// The program as the page has it (in Node), and the native program, for the tests in this folder.
'use strict';
const {spawnSync} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');
const vm = require('node:vm');

const root = path.resolve(__dirname, '..', '..');

/// The names that scripts of the page define.
const pageNames = (files, names) => {
    const schema = fs.readFileSync(path.join(root, 'share/edgeproof/schemas/scene.schema.json'), 'utf8');
    const text = `const SCHEMA = ${schema};\n` + files.map((file) => fs.readFileSync(path.join(root, 'web', 'page', file), 'utf8')).join('\n');
    return vm.runInThisContext(`(() => {${text}\nreturn {${names.join(', ')}};})()`);
};

/// Returns run(words, files, wanted) for the module in a folder.
const pageProgram = (folder) => {
    const factory = require(path.resolve(folder, 'edgeproof.js'));
    const compiled = new WebAssembly.Module(fs.readFileSync(path.join(folder, 'edgeproof.wasm')));
    const {runCommand} = pageNames(['runner.js'], ['runCommand']);
    return (words, files, wanted) => runCommand(factory, compiled, words, files, wanted);
};

/// Returns the same for the native program.
const nativeProgram = (program) => (words, files, wanted = []) => {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'edgeproof-'));
    try {
        for (const [name, text] of Object.entries(files)) {
            fs.writeFileSync(path.join(folder, name), text);
        }
        const ran = spawnSync(path.resolve(program), words, {cwd: folder, env: {PATH: ''}, maxBuffer: 1 << 28});
        const results = {};
        for (const name of wanted.filter((name) => fs.existsSync(path.join(folder, name)))) {
            results[name] = fs.readFileSync(path.join(folder, name));
        }
        return {status: ran.status, out: ran.stdout, err: ran.stderr, files: results};
    } finally {
        fs.rmSync(folder, {recursive: true});
    }
};

/// The text of an output without the names and versions of the program and its libraries:
/// both may be built from different commits and with different versions.
const withoutProgram = (bytes) => Buffer.from(bytes ?? '').toString('latin1')
    .replace(/edgeproof \d+\.\d+\.\d+ \([^)]*\)/g, 'edgeproof');

module.exports = {root, pageNames, pageProgram, nativeProgram, withoutProgram};
