// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/jet.hpp"

// The chain and product rules of Taylor arithmetic to second order (moore-kearfott-cloud2009).
namespace edgeproof::contact {
namespace {

template <class F> void for_pairs(const F& f) {
    for (std::size_t i = 0; i < Jet::variables; ++i) {
        for (std::size_t j = i; j < Jet::variables; ++j) {
            f(i, j, Jet::second(i, j));
        }
    }
}

} // namespace

Jet Jet::variable(const Ball& x, std::size_t which) {
    Jet j(x);
    j.g[which] = Ball(1, x.bits());
    return j;
}

Jet& Jet::operator+=(const Jet& o) {
    return with_each(o, [](Ball& x, const Ball& y) { x += y; });
}
Jet& Jet::operator-=(const Jet& o) {
    return with_each(o, [](Ball& x, const Ball& y) { x -= y; });
}
Jet& Jet::operator*=(const Jet& o) {
    Jet r;
    r.v = v * o.v;
    for (std::size_t i = 0; i < g.size(); ++i) {
        r.g[i] = g[i] * o.v + v * o.g[i];
    }
    for_pairs([&](std::size_t i, std::size_t j, std::size_t k) {
        r.h[k] = h[k] * o.v + g[i] * o.g[j] + g[j] * o.g[i] + v * o.h[k];
    });
    return *this = std::move(r);
}
Jet& Jet::operator/=(const Jet& o) {
    const Ball inverse = 1 / o.v;
    const Ball square = inverse * inverse;
    return *this *= composed(o, inverse, -square, square * inverse * 2);
}
Jet& Jet::operator*=(long k) {
    return with_each(*this, [k](Ball& x, const Ball&) { x *= k; });
}
Jet& Jet::operator/=(long k) {
    return with_each(*this, [k](Ball& x, const Ball&) { x /= k; });
}
Jet& Jet::operator+=(long k) {
    v += k;
    return *this;
}

Jet composed(const Jet& x, const Ball& f0, const Ball& f1, const Ball& f2) {
    Jet r(f0);
    for (std::size_t i = 0; i < Jet::variables; ++i) {
        r.g[i] = f1 * x.g[i];
    }
    for_pairs([&](std::size_t i, std::size_t j, std::size_t k) {
        r.h[k] = f1 * x.h[k] + f2 * x.g[i] * x.g[j];
    });
    return r;
}

Jet sqrt(const Jet& x) {
    const Ball root = sqrt(x.v);
    const Ball rate = 1 / (root * 2);
    return composed(x, root, rate, -(rate / (x.v * 2)));
}
Jet exp(const Jet& x) {
    const Ball e = exp(x.v);
    return composed(x, e, e, e);
}
Jet log(const Jet& x) {
    const Ball rate = 1 / x.v;
    return composed(x, log(x.v), rate, -(rate * rate));
}
Jet log1p(const Jet& x) {
    const Ball rate = 1 / (x.v + 1);
    return composed(x, log1p(x.v), rate, -(rate * rate));
}
Jet sin(const Jet& x) {
    const Ball s = sin(x.v);
    return composed(x, s, cos(x.v), -s);
}
Jet cos(const Jet& x) {
    const Ball c = cos(x.v);
    return composed(x, c, -sin(x.v), -c);
}
Jet atan(const Jet& x) {
    const Ball rate = 1 / (x.v * x.v + 1);
    return composed(x, atan(x.v), rate, -(x.v * 2 * rate * rate));
}

} // namespace edgeproof::contact
