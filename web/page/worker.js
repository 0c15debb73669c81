// SPDX-License-Identifier: BSD-3-Clause
// The page's worker: runs the commands that it is sent, one after another. Its text begins with
// edgeproof.js and runner.js. The first message is the compiled module.
let compiled;
self.onmessage = async ({data}) => {
    if (data instanceof WebAssembly.Module) {
        compiled = data;
        return;
    }
    const decoder = new TextDecoder();
    const ran = await runCommand(edgeproofModule, compiled, data.words, data.files, data.wanted);
    const files = Object.fromEntries(
        Object.entries(ran.files).map(([name, bytes]) => [name, decoder.decode(bytes)]));
    self.postMessage({id: data.id, status: ran.status, out: decoder.decode(ran.out),
                      err: decoder.decode(ran.err), files});
};
