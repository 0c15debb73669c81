// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/ginac_bridge.hpp"
#include "edgeproof/audit/symbolic/ginac_roots.hpp"
#include "edgeproof/precision/ball/ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <ginac/ginac.h>

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace edgeproof::audit::ginac {

using GiNaC::ex;

namespace {

constexpr long screening_bits = 160;

/// Returns a pseudo-random number in (1/2, 3/2) for each name, always the same.
Ball drawn(const std::string& name) {
    std::seed_seq seeds(name.begin(), name.end());
    std::array<std::uint32_t, 1> number{};
    seeds.generate(number.begin(), number.end());
    return Ball(Rational(number[0], 1L << 32), screening_bits) +
           Ball(Rational(1, 2), screening_bits);
}

/// Returns the enclosure of e for the numbers drawn for the symbols; it may be infinite. Returns
/// nullopt if e contains anything except sums, products, powers, rationals with terms that fit a
/// long, and pi.
std::optional<Ball> at_drawn(const ex& e) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) {
        const auto& n = GiNaC::ex_to<GiNaC::numeric>(e);
        const GiNaC::numeric over = n.numer();
        const GiNaC::numeric under = n.denom();
        if (!n.is_rational() || over.int_length() > 60 || under.int_length() > 60) {
            return std::nullopt;
        }
        return Ball(over.to_long(), screening_bits) / under.to_long();
    }
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
        return drawn(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
    }
    if (e.is_equal(GiNaC::Pi)) {
        return Ball::pi(screening_bits);
    }
    if (GiNaC::is_a<GiNaC::power>(e)) {
        const auto base = at_drawn(e.op(0));
        const auto exponent = base ? at_drawn(e.op(1)) : std::nullopt;
        if (!exponent) {
            return std::nullopt;
        }
        const ex& k = e.op(1);
        return GiNaC::is_a<GiNaC::numeric>(k) && GiNaC::ex_to<GiNaC::numeric>(k).is_integer()
                   ? pow_int(*base, GiNaC::ex_to<GiNaC::numeric>(k).to_long())
                   : pow(*base, *exponent);
    }
    const bool sum = GiNaC::is_a<GiNaC::add>(e);
    if (!sum && !GiNaC::is_a<GiNaC::mul>(e)) {
        return std::nullopt;
    }
    Ball all(sum ? 0 : 1, screening_bits);
    for (std::size_t i = 0; i < e.nops(); ++i) {
        const auto part = at_drawn(e.op(i));
        if (!part) {
            return std::nullopt;
        }
        all = sum ? all + *part : all * *part;
    }
    return all;
}

/// True if e is proved not to vanish identically, by its enclosure at one point.
bool is_not_zero_somewhere(const ex& e) {
    const auto value = at_drawn(e);
    return value && value->is_finite() && !contains_zero(*value);
}

} // namespace

bool is_zero(const ex& e) {
    if (e.is_zero()) {
        return true;
    }
    if (is_not_zero_somewhere(e)) {
        return false; // this is the usual case, and it avoids the expensive canonical form
    }
    if (e.expand().is_zero()) {
        return true;
    }
    Roots roots;
    const ex fraction = roots.rational(e).normal();
    return roots.reduced(fraction.numer()).normal().is_zero();
}

std::vector<ex> polynomial_over_root(const ex& e, const ex& s, const ex& hi) {
    Roots roots;
    const ex whole = roots.fraction(e * GiNaC::sqrt(hi - s));
    if (whole.denom().has(s) || roots.involves(whole, s)) {
        throw DomainError("an integrand is not a polynomial over the square root of the distance "
                          "from its upper end");
    }
    const ex under = whole.denom();
    const ex over = whole.numer().expand();
    std::vector<ex> q;
    for (int k = 0; k <= over.degree(s); ++k) {
        q.push_back(roots.restored(over.coeff(s, k) / under));
    }
    return q;
}

} // namespace edgeproof::audit::ginac
