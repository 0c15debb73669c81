// SPDX-License-Identifier: BSD-3-Clause
// Runs one command of the program in a new instance of the module. Used by the page's worker and,
// in Node, by the tests.

/// factory: edgeproofModule of edgeproof.js; module: the compiled WebAssembly. files: {name: text}.
/// Returns {status, out, err, files}: the exit status, the bytes written to the standard streams, and
/// those of the wanted files that exist.
const runCommand = async (factory, module, words, files, wanted = []) => {
    const out = [];
    const err = [];
    let status;
    const instance = await factory({
        noInitialRun: true,
        instantiateWasm: (imports, done) => {
            WebAssembly.instantiate(module, imports).then((created) => done(created, module));
            return {};
        },
        preRun: [(m) => m.FS.init(() => null, (c) => c !== null && out.push(c & 255),
                                  (c) => c !== null && err.push(c & 255))],
        onExit: (code) => {
            status = code;
        },
        quit: (code, thrown) => {
            status = code;
            throw thrown;
        },
    });
    for (const [name, text] of Object.entries(files)) {
        instance.FS.writeFile(name, text);
    }
    try {
        const returned = instance.callMain([...words]); // newer versions of Emscripten change the list
        status ??= returned;
    } catch (error) {
        if (status === undefined) { // a trap: out of memory, or too deep a recursion
            status = 2;
            err.push(...new TextEncoder().encode(`edgeproof: stopped inside (${error.message}); ask for fewer digits\n`));
        }
    }
    const results = {};
    for (const name of wanted) {
        if (instance.FS.analyzePath(name).exists) {
            results[name] = instance.FS.readFile(name);
        }
    }
    return {status, out: Uint8Array.from(out), err: Uint8Array.from(err), files: results};
};
