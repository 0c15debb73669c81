// SPDX-License-Identifier: BSD-3-Clause
// The worker that computes, from the page's side.

const bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
const unpacked = async (bytes) =>
    new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();

/// Runs commands of the program in a worker. stop() ends the worker; the commands that it had
/// not finished give undefined.
class Computer {
    constructor() {
        this.waiting = new Map();
        this.next = 0;
        const text = document.getElementById('worker').textContent;
        this.address = URL.createObjectURL(new Blob([text], {type: 'text/javascript'}));
        this.compiled = unpacked(bytesOf(document.getElementById('module').textContent.trim()))
            .then((bytes) => WebAssembly.compile(bytes));
        this.start();
    }
    start() {
        const worker = new Worker(this.address);
        worker.onmessage = ({data}) => {
            this.waiting.get(data.id)?.(data);
            this.waiting.delete(data.id);
        };
        worker.onerror = () => this.stop();
        this.worker = worker;
        this.ready = this.compiled.then((module) => worker.postMessage(module));
    }
    async run(words, scene, wanted = []) {
        const id = this.next++;
        const result = new Promise((done) => this.waiting.set(id, done));
        const worker = this.worker;
        await this.ready;
        worker.postMessage({id, words, files: {'scene.toml': scene}, wanted});
        return result;
    }
    stop() {
        this.worker.terminate();
        for (const done of this.waiting.values()) {
            done(undefined);
        }
        this.waiting.clear();
        this.start();
    }
}
