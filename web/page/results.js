// SPDX-License-Identifier: BSD-3-Clause
// What the page shows. Text of a user or of the program is inserted as text, never as HTML.

const element = (name, attributes = {}, ...children) => {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        made.setAttribute(key, value);
    }
    made.append(...children);
    return made;
};

const tableElement = (title, {columns, rows, notes}) => {
    const head = element('tr', {}, ...columns.map((name) => element('th', {scope: 'col'}, name)));
    const body = rows.map((row) => element('tr', {}, ...row.map((cell, i) => element('td', {'data-name': columns[i]}, cell))));
    const table = element('table', {}, element('caption', {}, title), element('thead', {}, head),
                          element('tbody', {}, ...body));
    const list = element('ul', {class: 'notes'},
                         ...notes.filter((note) => !note.startsWith('program:'))
                             .map((note) => element('li', {}, note)));
    return element('div', {}, element('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': title},
                                      table), list);
};

/// Tables that are wider than their place show each row as a list of names and values.
const fitTables = () => {
    for (const table of document.querySelectorAll('#tables table')) {
        table.classList.remove('stacked');
        table.classList.toggle('stacked', table.scrollWidth > table.parentElement.clientWidth);
    }
};

/// The picture that the program drew. It is parsed as XML, and only elements of a picture are taken.
const pictureElement = (svg) => {
    const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml').documentElement;
    const allowed = new Set(['svg', 'g', 'path', 'rect', 'circle', 'polygon', 'text', 'tspan', 'title', 'desc', 'metadata']);
    for (const inner of [parsed, ...parsed.querySelectorAll('*')]) {
        if (!allowed.has(inner.localName)) {
            throw new Error('the picture has an unknown element');
        }
    }
    parsed.setAttribute('role', 'img');
    parsed.setAttribute('aria-label', parsed.querySelector('desc')?.textContent ?? 'picture');
    return element('div', {id: 'picture'}, document.importNode(parsed, true));
};

const save = (name, type, text) => {
    const address = URL.createObjectURL(new Blob([text], {type}));
    element('a', {href: address, download: name}).click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
};
