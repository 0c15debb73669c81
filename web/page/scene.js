// SPDX-License-Identifier: BSD-3-Clause
// The state of the form, as the text of a scene file and as the fragment of a link. No document is
// used here: the tests run this file in Node, too.

/// The kinds of profile and their keys, of the schema of a scene.
const profilesOf = ({properties: {kind}, allOf}) => Object.fromEntries(kind.enum.map((name) => {
    const rule = allOf.find(({if: {properties: {kind: of}}}) => of.const === name || of.enum?.includes(name));
    return [name, Object.keys(rule.then.properties).filter((key) => !['kind', 'geometry', 'symmetric'].includes(key))];
}));

const FORM = {
    profiles: profilesOf(SCHEMA.properties.profile),
    // What the form says for a kind or a key of a profile; others have their own name.
    labels: {
        hertz: 'Cylinders (Hertz)', 'power-law': "Power law: g'(x) = C x^m",
        'flat-and-rounded': 'Flat and rounded punch', 'tilted-wedge': 'Wedge, tilted',
        'tilted-flat-and-rounded': 'Flat and rounded, tilted',
        'cylinder-on-flat': 'Cylinder on a flat', piecewise: "Your own g'(x), in pieces",
        sphere: 'Sphere', wedge: 'Wedge', cone: 'Cone', R: 'radius R', R1: 'radius of body 1, R1',
        R2: 'radius of body 2, R2', m: 'exponent m', C: 'coefficient C', t: 'half of the flat t',
        flat_width: 'or width of the flat', phi: 'angle of the faces phi', alpha: 'tilt alpha',
        slopes: "g'(x) of each piece, one in a line", knots: 'knots between the pieces',
    },
    loads: {
        a: 'half width (radius) a', P: 'force P', delta: 'approach delta',
        PM: 'force P and moment M',
    },
    materials: {Es: 'composite modulus E*', E: 'E and nu of both bodies'},
    // What can be asked: the label and the subcommand.
    quantities: {
        plot: 'Picture', pressure: 'Pressure at places', expand: 'First terms of the expansion',
        extent: 'How far the first terms are good', slip: 'Slip zones', stress: 'Stresses at points',
        mises: 'Greatest von Mises stress', tau_max: 'Greatest shear stress',
        displacement: 'Gap and slip on the surface',
    },
    defaults: {
        kind: 'flat-and-rounded', R: '50', m: '1', C: '1/100', t: '1', phi: 'pi/16', alpha: '1/1000',
        slopes: 'x/10\nx/10 + (x - 1/2)^3', knots: '1/2', geometry: 'plane', symmetric: '1', load: 'P', a: '1', P: '100', M: '0', delta: '1/100',
        material: 'E', Es: '64e3', E1: '115e3', nu1: '0.32', E2: '115e3', nu2: '0.32',
        units: 'mm', shear: 'none', Q: '20', bulk_tension: '0', friction: '0.6', bulk_A: '0',
        steps: 'P = 100\nQ = 20\nQ = -10, cycles = 2\nQ = 15',
        edges: 'right', u: '1e-6, 1e-3, 0.1', terms: '1, 2, 3', tolerance: '5%',
        points: '0 0; 0 1/2; 1 1', x: '0, 2', digits: '15', ask: 'pressure expand extent plot',
    },
};

const labelOf = (name) => FORM.labels[name] ?? name;
const defaultState = () => ({
    ...Object.fromEntries(Object.values(FORM.profiles).flat().map((key) => [key, ''])), ...FORM.defaults,
});

/// A string of TOML. JSON's escapes are TOML's; DEL must be escaped as well.
const tomlString = (text) => JSON.stringify(text).replace(/\x7f/g, '\\u007F');

/// Splits a list at commas, semicolons or line breaks, outside brackets.
const listOf = (text, separators = ',;\n') => {
    const parts = [''];
    let depth = 0;
    for (const c of text) {
        depth += c === '(' ? 1 : c === ')' ? -1 : 0;
        if (depth <= 0 && separators.includes(c)) {
            parts.push('');
        } else {
            parts[parts.length - 1] += c;
        }
    }
    return parts.map((part) => part.trim()).filter((part) => part !== '');
};
const tomlList = (items) => `[${items.map(tomlString).join(', ')}]`;

/// The steps of a load history, one in a line: 'P = 100, Q = 20'. Text without '=' becomes a key that
/// the program refuses.
const stepsOf = (text) => text.split('\n').map((line) => line.trim()).filter((line) => line !== '')
    .map((line) => listOf(line, ',;').map((part) => {
        const [name, ...value] = part.split('=').map((word) => word.trim());
        return `${/^\w+$/.test(name) ? name : tomlString(name)} = ${tomlString(value.join('='))}`;
    }));

/// Returns {text, fields}: the scene file, and for each of its lines the name of the field of the
/// form that it comes from (or undefined).
const sceneOf = (state) => {
    const lines = [];
    const fields = [];
    const add = (line, field) => {
        lines.push(line);
        fields.push(field);
    };
    const value = (name) => add(`${name} = ${tomlString(state[name].trim())}`, name);
    if (state.units === 'mm') {
        add('[units]');
        add('length = "mm"');
        add('force = "N"');
        add('pressure = "MPa"');
    }
    add('[profile]', 'kind');
    add(`kind = ${tomlString(state.kind)}`, 'kind');
    if (state.geometry === 'axisymmetric') {
        add('geometry = "axisymmetric"', 'geometry');
    }
    if (state.kind === 'piecewise') {
        if (state.symmetric === '1') {
            add('symmetric = true', 'symmetric');
        }
        add(`knots = ${tomlList(listOf(state.knots))}`, 'knots');
        add(`slopes = ${tomlList(listOf(state.slopes, ';\n'))}`, 'slopes');
    } else {
        FORM.profiles[state.kind].filter((name) => state[name].trim() !== '').forEach(value);
    }
    add('[load]', 'load');
    if (state.shear === 'steps') {
        // The steps give the loads.
    } else if (state.load === 'PM') {
        value('P');
        value('M');
    } else {
        value(state.load);
    }
    if (state.material === 'Es') {
        add(`contact_modulus = ${tomlString(state.Es.trim())}`, 'Es');
    } else {
        ['E1', 'nu1', 'E2', 'nu2'].forEach(value);
    }
    if (state.shear !== 'none') {
        add('[shear]', 'shear');
        const sliding = state.shear === 'right' || state.shear === 'left';
        if (sliding) {
            add(`sliding = "${state.shear}"`, 'shear');
        }
        if (state.shear !== 'steps') {
            (sliding ? ['bulk_tension'] : ['Q', 'bulk_tension']).forEach(value);
        }
        if (state.shear !== 'stick') {
            value('friction');
        }
        if (state.bulk_A.trim() !== '0') {
            value('bulk_A');
        }
    }
    for (const step of state.shear === 'steps' ? stepsOf(state.steps) : []) {
        add('[[step]]', 'steps');
        step.forEach((line) => add(line, 'steps'));
    }
    add('[ask]');
    add(`edges = ${tomlList(state.edges === 'both' ? ['right', 'left'] : [state.edges])}`, 'edges');
    add(`terms = ${tomlList(listOf(state.terms))}`, 'terms');
    add(`tolerance = ${tomlString(state.tolerance.trim())}`, 'tolerance');
    add(`digits = ${tomlString(state.digits.trim())}`, 'digits');
    const asked = askedOf(state);
    if (asked.includes('pressure')) {
        add(`u = ${tomlList(listOf(state.u))}`, 'u');
    }
    if (asked.includes('displacement')) {
        add(`x = ${tomlList(listOf(state.x))}`, 'x');
    }
    if (asked.includes('stress')) {
        const points = listOf(state.points, ';\n').map((point) => point.trim().split(/\s+/));
        add(`points = [${points.map(tomlList).join(', ')}]`, 'points');
    }
    return {text: `${lines.join('\n')}\n`, fields};
};

/// The quantities that are asked for, in the order of the form.
const askedOf = (state) => {
    const asked = state.ask.split(' ');
    return Object.keys(FORM.quantities).filter((name) => asked.includes(name));
};

/// The arguments of the program for a quantity. A picture has its panels in one line, or is as wide
/// as asked for (pixels).
const argumentsOf = (quantity, scene = 'scene.toml', width = 0) => {
    switch (quantity) {
    case 'mises':
    case 'tau_max':
        return ['stress', scene, '--greatest', quantity, '--format', 'csv'];
    case 'plot':
        return ['plot', scene, '--out', 'figure.svg', ...width === 0 ? [] : ['--width', `${Math.max(80, Math.floor(width / 4.05))}mm`]];
    default:
        return [quantity, scene, '--format', 'csv'];
    }
};

const toFragment = (state) => {
    const from = defaultState();
    const changed = Object.entries(state).filter(([name, value]) => from[name] !== value);
    return new URLSearchParams(changed).toString();
};
/// Reads a link. Unknown names, and a kind of profile that does not exist, are left out.
const fromFragment = (fragment) => {
    const state = defaultState();
    for (const [name, value] of new URLSearchParams(fragment.replace(/^#/, ''))) {
        if (Object.hasOwn(state, name)) {
            state[name] = value;
        }
    }
    if (!Object.hasOwn(FORM.profiles, state.kind)) {
        state.kind = FORM.defaults.kind;
    }
    return state;
};

/// Reads a table of the program: {columns, rows, notes}.
const readTable = (csv) => {
    const lines = csv.split('\n').filter((line) => line !== '');
    const cells = (line) => [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)]
        .map(([, quoted, plain]) => quoted === undefined ? plain : quoted.replaceAll('""', '"'));
    const data = lines.filter((line) => !line.startsWith('#'));
    return {
        columns: data.length > 0 ? cells(data[0]) : [],
        rows: data.slice(1).map(cells),
        notes: lines.filter((line) => line.startsWith('#')).map((line) => line.replace(/^# ?/, '')),
    };
};

/// Returns {line, message} of an error of the program: "scene.toml:7: message".
const readError = (text) => {
    const found = /^scene\.toml:(?:(\d+):)? ?([^]*)$/.exec(text.trim());
    return found === null ? {message: text.trim().replace(/^edgeproof: /, '')}
        : {line: found[1] === undefined ? undefined : Number(found[1]), message: found[2]};
};
