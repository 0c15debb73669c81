// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/symbolic/symbolic.hpp"
#include "edgeproof/precision/error.hpp"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>

namespace edgeproof::audit {
namespace {

using Kind = Expr::Kind;

struct Product {
    Rational number = 1;
    std::vector<std::string> over;
    std::vector<std::string> under;
};

std::string joined(std::vector<std::string> parts, const char* between) {
    std::ranges::sort(parts);
    return boost::algorithm::join(parts, between);
}

std::string in_sequence(const Expr& e) {
    std::string text = e.name() + "[" + std::to_string(static_cast<int>(e.kind()));
    for (const Expr& part : e.args()) {
        text += "; " + ordered_text(part);
    }
    return text + "]";
}

void collect(const Expr& e, bool over, Product& product) {
    if (const Rational* q = e.rational(); q != nullptr && (over || *q != 0)) {
        product.number = over ? Rational(product.number * *q) : Rational(product.number / *q);
        return;
    }
    switch (e.kind()) {
    case Kind::neg:
        product.number = -product.number;
        collect(e.arg(0), over, product);
        break;
    case Kind::mul:
        collect(e.arg(0), over, product);
        collect(e.arg(1), over, product);
        break;
    case Kind::div:
        collect(e.arg(0), over, product);
        collect(e.arg(1), !over, product);
        break;
    case Kind::symbol:
        (over ? product.over : product.under).push_back(e.name());
        break;
    case Kind::add:
    case Kind::sub:
        (over ? product.over : product.under).push_back("(" + ordered_text(e) + ")");
        break;
    default:
        (over ? product.over : product.under).push_back(in_sequence(e));
    }
}

void collect_terms(const Expr& e, bool plus, std::vector<std::string>& terms) {
    switch (e.kind()) {
    case Kind::add:
    case Kind::sub:
        collect_terms(e.arg(0), plus, terms);
        collect_terms(e.arg(1), (e.kind() == Kind::add) == plus, terms);
        return;
    case Kind::neg:
        collect_terms(e.arg(0), !plus, terms);
        return;
    default:
        break;
    }
    Product product;
    collect(e, true, product);
    if (product.number == 0) {
        return;
    }
    const Rational number = plus ? product.number : Rational(-product.number);
    terms.push_back(number.str() + "*" + joined(std::move(product.over), "*") + "/" +
                    joined(std::move(product.under), "/"));
}

/// True for binders of one kind that differ only in the integrand.
bool differ_inside(const Expr& x, const Expr& y, Kind kind) {
    if (x.kind() != kind || y.kind() != kind) {
        return false;
    }
    for (std::size_t i = 1; i < x.args().size(); ++i) {
        if (!(x.arg(i) == y.arg(i))) {
            return false;
        }
    }
    return true;
}

/// True for principal values whose integrands differ by a constant over w(s)(s - x).
bool differ_by_a_zero_integral(const Expr& x, const Expr& y, const SymbolicCase& under) {
    if (!differ_inside(x, y, Kind::pv)) {
        return false;
    }
    const Expr a = Expr::symbol("a");
    const Expr b = under.symmetric ? a : Expr::symbol("b");
    if (!(x.arg(2) == -b) || !(x.arg(3) == a)) {
        return false;
    }
    const Expr& s = x.arg(1);
    const Expr w = Expr::call("sqrt", {(a - s) * (s + b)});
    const Expr difference = (x.arg(0) - y.arg(0)) * w * (s - x.arg(4));
    return proved_equal(difference, substitute(difference, s.name(), Expr::symbol("s_elsewhere")),
                        under);
}

/// True for integrals whose integrands differ by a function odd about the middle.
bool differ_by_an_odd_part(const Expr& x, const Expr& y, const SymbolicCase& under) {
    if (!differ_inside(x, y, Kind::integral)) {
        return false;
    }
    const Expr difference = x.arg(0) - y.arg(0);
    const Expr mirrored = substitute(difference, x.arg(1).name(), x.arg(2) + x.arg(3) - x.arg(1));
    return proved_equal(difference, -mirrored, under);
}

} // namespace

std::string ordered_text(const Expr& e) {
    std::vector<std::string> terms;
    collect_terms(e, true, terms);
    return joined(std::move(terms), " + ");
}

bool surely_equal(const Expr& x, const Expr& y, const SymbolicCase& under) {
    const auto in_case = [&](const Expr& e) {
        return under.symmetric ? substitute(e, "b", Expr::symbol("a")) : e;
    };
    const Expr one = in_case(x);
    const Expr other = in_case(y);
    if (ordered_text(one) == ordered_text(other)) {
        return true;
    }
    try {
        return differ_by_a_zero_integral(one, other, under) ||
               differ_by_an_odd_part(one, other, under) || proved_equal(one, other, under);
    } catch (const Error&) {
        return false; // not proved by symbols
    }
}

} // namespace edgeproof::audit
