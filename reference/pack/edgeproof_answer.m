% SPDX-License-Identifier: BSD-3-Clause
% Hertz's line contact in double, as an example of a code that answers some of the pack.
function value = edgeproof_answer(c)
    value = [];
    if ~strcmp(c.kind, 'power-law') || c.m ~= 1
        return;
    end
    a = c.a;
    if isnan(a)
        a = sqrt(4 * c.P / (pi * c.E * c.C));
    end
    k = c.E * c.C / 2; % p = k sqrt(a^2 - x^2)
    switch c.quantity
        case 'p'
            value = k * sqrt(c.u * (2 * a - c.u));
        case 'c_0'
            value = k * sqrt(2 * a);
        case 'c_1'
            value = -k * sqrt(2 * a) / (4 * a);
        case 'c_2'
            value = -k * sqrt(2 * a) / (32 * a * a);
        case 'P'
            value = k * pi * a * a / 2;
        case {'a', 'b'}
            value = a;
    end
end
