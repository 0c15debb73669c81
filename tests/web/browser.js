// SPDX-License-Identifier: BSD-3-Clause
// A headless Chromium, driven by its DevTools protocol through a pipe.
'use strict';
const {spawn} = require('node:child_process');
const fs = require('node:fs');
const os = require('node:os');
const path = require('node:path');

class Browser {
    constructor() {
        this.profile = fs.mkdtempSync(path.join(os.tmpdir(), 'chromium-'));
        this.process = spawn('chromium', [
            '--headless', '--no-sandbox', '--disable-gpu', '--no-first-run', '--remote-debugging-pipe',
            `--user-data-dir=${this.profile}`, 'about:blank',
        ], {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
        this.next = 1;
        this.waiting = new Map();
        this.listeners = [];
        let rest = '';
        this.process.stdio[4].on('data', (bytes) => {
            const parts = (rest + bytes).split('\0');
            rest = parts.pop();
            parts.forEach((part) => this.take(JSON.parse(part)));
        });
    }
    take(message) {
        if (message.id === undefined) {
            this.listeners.forEach((listener) => listener(message));
            return;
        }
        const {done, fail} = this.waiting.get(message.id);
        this.waiting.delete(message.id);
        if (message.error) {
            fail(new Error(message.error.message));
        } else {
            done(message.result);
        }
    }
    send(method, params = {}, sessionId = undefined) {
        const id = this.next++;
        this.process.stdio[3].write(`${JSON.stringify({id, method, params, sessionId})}\0`);
        return new Promise((done, fail) => this.waiting.set(id, {done, fail}));
    }
    /// Opens a page. Its requests and its errors are kept.
    async open(address, {width = 1280, height = 900, dark = false} = {}) {
        const {targetId} = await this.send('Target.createTarget', {url: 'about:blank'});
        const {sessionId} = await this.send('Target.attachToTarget', {targetId, flatten: true});
        const page = new Page(this, sessionId);
        for (const domain of ['Page', 'Runtime', 'Network', 'Log']) {
            await page.send(`${domain}.enable`);
        }
        await page.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: width < 600});
        await page.send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]});
        await page.go(address);
        return page;
    }
    async close() {
        await this.send('Browser.close').catch(() => undefined);
        await new Promise((done) => this.process.once('exit', done));
        fs.rmSync(this.profile, {recursive: true, force: true});
    }
}

class Page {
    constructor(browser, session) {
        this.browser = browser;
        this.session = session;
        this.requests = [];
        this.errors = [];
        browser.listeners.push((message) => {
            if (message.sessionId !== session) {
                return;
            }
            if (message.method === 'Network.requestWillBeSent') {
                this.requests.push(message.params.request.url);
            } else if (message.method === 'Runtime.exceptionThrown') {
                this.errors.push(message.params.exceptionDetails.exception?.description ?? message.params.exceptionDetails.text);
            } else if (message.method === 'Log.entryAdded' && message.params.entry.level === 'error') {
                this.errors.push(message.params.entry.text);
            }
        });
    }
    send(method, params = {}) {
        return this.browser.send(method, params, this.session);
    }
    async go(address) {
        await this.send('Page.navigate', {url: 'about:blank'});
        await this.send('Page.navigate', {url: address});
        await this.until("document.readyState === 'complete' && document.getElementById('status') !== null");
    }
    async value(expression) {
        const {result, exceptionDetails} = await this.send('Runtime.evaluate',
            {expression, awaitPromise: true, returnByValue: true});
        if (exceptionDetails) {
            throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        }
        return result.value;
    }
    async until(expression, seconds = 120) {
        const last = Date.now() + 1000 * seconds;
        while (!await this.value(expression).catch(() => false)) {
            if (Date.now() > last) {
                throw new Error(`not within ${seconds} s: ${expression}`);
            }
            await new Promise((done) => setTimeout(done, 50));
        }
    }
    async key(key, code = key, windowsVirtualKeyCode = undefined) {
        const text = key === 'Enter' ? '\r' : key === ' ' ? ' ' : undefined;
        for (const type of ['keyDown', 'keyUp']) {
            await this.send('Input.dispatchKeyEvent', {type, key, code, windowsVirtualKeyCode, ...(type === 'keyDown' && text ? {text} : {})});
        }
    }
    async screenshot(file, whole = true) {
        const {data} = await this.send('Page.captureScreenshot', {captureBeyondViewport: whole});
        fs.writeFileSync(file, Buffer.from(data, 'base64'));
    }
    async pdf(file) {
        const {data} = await this.send('Page.printToPDF', {printBackground: true});
        fs.writeFileSync(file, Buffer.from(data, 'base64'));
    }
}

module.exports = {Browser};
