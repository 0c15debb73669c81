// SPDX-License-Identifier: BSD-3-Clause
// node picture.js PAGE FILE.png: the upper part of the page, with a result, for README.md.
'use strict';
const path = require('node:path');
const {pathToFileURL} = require('node:url');
const {Browser} = require('./browser.js');

const [file, output] = process.argv.slice(2);
const main = async () => {
    const browser = new Browser();
    const page = await browser.open(`${pathToFileURL(path.resolve(file)).href}#ask=plot+expand&digits=16`,
                                    {width: 1280, height: 720});
    await page.until("document.getElementById('status').textContent.startsWith('Computed')");
    await page.screenshot(output, false);
    await browser.close();
};
main();
