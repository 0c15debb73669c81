// SPDX-License-Identifier: GPL-3.0-or-later
// Values of printed formulas in binary64, from the text of a ledger: + - * / ^, parentheses,
// sqrt, names. Used for the estimate of a ratio only; bounds come from the program.

const printedValue = (text, values) => {
    const tokens = text.match(/\d+(?:\.\d+)?|[A-Za-z]\w*|[-+*/^()]/g) ?? [];
    if (tokens.join('') !== text.replace(/\s/g, '')) {
        throw new Error(`'${text}' is no formula`);
    }
    let at = 0;
    const expect = (token) => {
        if (tokens[at++] !== token) {
            throw new Error(`'${text}' lacks '${token}'`);
        }
    };
    const atom = () => {
        const token = tokens[at++];
        if (token === '(') {
            const inner = sum();
            expect(')');
            return inner;
        }
        if (/^\d/.test(token ?? '')) {
            return Number(token);
        }
        if (token === 'sqrt') {
            expect('(');
            const inner = sum();
            expect(')');
            return Math.sqrt(inner);
        }
        if (!Object.hasOwn(values, token ?? '')) {
            throw new Error(`'${text}' has an unknown name`);
        }
        return values[token];
    };
    const power = () => {
        const base = atom();
        if (tokens[at] === '^') {
            ++at;
            return base ** signed();
        }
        return base;
    };
    const signed = () => {
        if (tokens[at] === '-') {
            ++at;
            return -signed();
        }
        return power();
    };
    const product = () => {
        let value = signed();
        while (tokens[at] === '*' || tokens[at] === '/') {
            value = tokens[at++] === '*' ? value * signed() : value / signed();
        }
        return value;
    };
    const sum = () => {
        let value = product();
        while (tokens[at] === '+' || tokens[at] === '-') {
            value = tokens[at++] === '+' ? value + product() : value - product();
        }
        return value;
    };
    const value = sum();
    if (at !== tokens.length) {
        throw new Error(`'${text}' is no formula`);
    }
    return value;
};
