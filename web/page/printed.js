// SPDX-License-Identifier: GPL-3.0-or-later
// Values of printed formulas in binary64, from the text of a ledger: + - * / ^, parentheses, names,
// some functions, and integrals. Used for the estimate of a ratio only; bounds come from the program.

/// Functions of evaluated arguments.
const printedFunctions = {
    sqrt: Math.sqrt, log: Math.log, asin: Math.asin, abs: Math.abs, max: Math.max,
};

/// The integral of f from lo to hi by the tanh-sinh rule: at the ends f may be infinite like an
/// inverse square root.
const tanhSinh = (f, lo, hi) => {
    const step = 1 / 32;
    let sum = 0;
    for (let t = -3.5; t <= 3.5; t += step) {
        const y = Math.PI / 2 * Math.sinh(t);
        const fromEnd = (hi - lo) / (1 + Math.exp(2 * Math.abs(y))); // without cancellation
        const value = f(t < 0 ? lo + fromEnd : hi - fromEnd);
        sum += Number.isFinite(value) ? value * Math.cosh(t) / Math.cosh(y) ** 2 : 0;
    }
    return sum * step * Math.PI / 4 * (hi - lo);
};

/// Returns the function of {name: value} that a formula is.
const printedFormula = (text) => {
    const tokens = text.match(/\d+(?:\.\d+)?|[A-Za-z]\w*|[-+*/^(),]/g) ?? [];
    if (tokens.join('') !== text.replace(/\s/g, '')) {
        throw new Error(`'${text}' is no formula`);
    }
    let at = 0;
    const expect = (token) => {
        if (tokens[at++] !== token) {
            throw new Error(`'${text}' lacks '${token}'`);
        }
    };
    const parts = () => {
        const found = [];
        do {
            ++at;
            found.push(sum());
        } while (tokens[at] === ',');
        expect(')');
        return found;
    };
    const atom = () => {
        const token = tokens[at++] ?? '';
        if (token === '(') {
            --at;
            return parts()[0];
        }
        if (/^\d/.test(token)) {
            return () => Number(token);
        }
        if (token === 'integral') { // integral(integrand, variable, lower, upper)
            const variable = tokens.slice(at).join('').match(/,([A-Za-z]\w*),/)?.[1];
            const [integrand, , lower, upper] = parts();
            return (values) => tanhSinh((s) => integrand({...values, [variable]: s}), lower(values), upper(values));
        }
        if (Object.hasOwn(printedFunctions, token)) {
            const given = parts();
            return (values) => printedFunctions[token](...given.map((part) => part(values)));
        }
        return (values) => {
            if (!Object.hasOwn(values, token)) {
                throw new Error(`'${text}' has an unknown name`);
            }
            return values[token];
        };
    };
    const power = () => {
        const base = atom();
        if (tokens[at] !== '^') {
            return base;
        }
        ++at;
        const exponent = signed();
        return (values) => base(values) ** exponent(values);
    };
    const signed = () => {
        if (tokens[at] !== '-') {
            return power();
        }
        ++at;
        const negated = signed();
        return (values) => -negated(values);
    };
    const product = () => {
        let value = signed();
        while (tokens[at] === '*' || tokens[at] === '/') {
            const [left, divides] = [value, tokens[at++] === '/'];
            const right = signed();
            value = (values) => divides ? left(values) / right(values) : left(values) * right(values);
        }
        return value;
    };
    const sum = () => {
        let value = product();
        while (tokens[at] === '+' || tokens[at] === '-') {
            const [left, sign] = [value, tokens[at++] === '+' ? 1 : -1];
            const right = product();
            value = (values) => left(values) + sign * right(values);
        }
        return value;
    };
    const formula = sum();
    if (at !== tokens.length) {
        throw new Error(`'${text}' is no formula`);
    }
    return formula;
};
const printedValue = (text, values) => printedFormula(text)(values);
