// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/form.hpp"

#include "edgeproof/formula/evaluation/evaluate.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <algorithm>
#include <flint/ulong_extras.h>
#include <numeric>

namespace edgeproof::algebra {
namespace {

using Kind = Generator::Kind;

bool precedes(const std::shared_ptr<const Generator>& x,
              const std::shared_ptr<const Generator>& y) {
    return x->depth != y->depth ? x->depth < y->depth : x->key < y->key;
}

std::shared_ptr<const Generator> with_index(Generator root, unsigned long index) {
    root.index = index;
    return std::make_shared<const Generator>(std::move(root));
}

/// The generators of both, in order; roots of one radicand become one root.
Generators united(const Generators& x, const Generators& y) {
    Generators all;
    std::merge(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(all), precedes);
    Generators result;
    for (const auto& g : all) {
        if (result.empty() || result.back()->key != g->key) {
            result.push_back(g);
        } else if (const auto index = std::lcm(result.back()->index, g->index);
                   index != result.back()->index) {
            result.back() = with_index(*g, index);
        }
    }
    return result;
}

bool same(const Generators& x, const Generators& y) {
    return std::ranges::equal(x, y, [](const auto& g, const auto& h) {
        return g == h || (g->key == h->key && g->index == h->index);
    });
}

/// A polynomial in the generators `from`, written in `to`, which holds them all.
Polynomial moved(const Polynomial& p, const Generators& from, const Generators& to) {
    std::vector<std::size_t> places;
    for (const auto& g : from) {
        places.push_back(static_cast<std::size_t>(
            std::ranges::find(to, g->key, [](const auto& h) { return h->key; }) - to.begin()));
    }
    return p.with_exponents(to.size(), [&](const Exponents& e) {
        Exponents f(std::max<std::size_t>(to.size(), 1), 0);
        for (std::size_t i = 0; i < from.size(); ++i) {
            f[places[i]] = e[i] * (to[places[i]]->index / from[i]->index);
        }
        return f;
    });
}

int sign_of(const Polynomial& p, const Generators& g) {
    int sign = 0;
    bool known = true;
    p.for_each_term([&](const Integer& c, const Exponents& e) {
        for (std::size_t i = 0; i < g.size(); ++i) {
            known = known && (e[i] % 2 == 0 || g[i]->positive);
        }
        known = known && (sign == 0 || sign == c.sign());
        sign = c.sign();
    });
    return known ? sign : 0;
}

std::string key_of(const Polynomial& p, const Generators& g) {
    std::string text;
    p.for_each_term([&](const Integer& c, const Exponents& e) {
        text += (text.empty() ? "" : " + ") + c.str();
        for (std::size_t i = 0; i < g.size(); ++i) {
            if (e[i] > 0) {
                text += "*" + g[i]->key;
                text += g[i]->index > 1 ? ":" + std::to_string(g[i]->index) : "";
                text += e[i] > 1 ? "^" + std::to_string(e[i]) : "";
            }
        }
    });
    return "(" + text + ")";
}

} // namespace

Form::Form(const Rational& q)
    : over_(0, Integer(numerator(q))), under_(0, Integer(denominator(q))) {}

Form::Form(Generator g) : over_(Polynomial::variable(1, 0)), under_(1, 1) {
    for (const Form& part : g.parts) {
        for (const auto& inner : part.generators_) {
            g.depth = std::max(g.depth, inner->depth + 1);
        }
    }
    generators_.push_back(std::make_shared<const Generator>(std::move(g)));
}

Form Form::pi() { return Form(Generator{Kind::pi, "pi", "", {}, 1, true, 0, {}}); }

Form Form::name(std::string_view name, bool positive) {
    const std::string text(name);
    return Form(Generator{Kind::name, text, text, {}, 1, positive, 0, {}});
}

Form Form::opaque(const Expr& e) {
    return Form(Generator{Kind::opaque, "[" + to_text(e) + "]", "", {}, 1, false, 0, e});
}

std::optional<Rational> Form::rational() const {
    if (!over_.is_constant() || !under_.is_constant()) {
        return {};
    }
    return Rational(over_.leading(), under_.leading());
}

int Form::sign() const { return sign_of(over_, generators_) * sign_of(under_, generators_); }

std::string Form::key() const {
    return key_of(over_, generators_) + "/" + key_of(under_, generators_);
}

const Generator* Form::generator() const {
    return generators_.size() == 1 && over_ == Polynomial::variable(1, 0) &&
                   under_ == Polynomial(1, 1)
               ? generators_[0].get()
               : nullptr;
}

std::optional<Form> Form::argument_of(std::string_view function) const {
    const Generator* g = generator();
    const bool is_call = g != nullptr && g->kind == Kind::call && g->name == function;
    return is_call ? std::optional(g->parts[0]) : std::nullopt;
}

Form Form::reduced(const Polynomial& p, const Generators& g, std::size_t root) {
    const ulong index = g[root]->index;
    const Form w({g[root]}, Polynomial::variable(1, 0), Polynomial(1, 1));
    Form sum;
    for (auto& [k, c] : p.coefficients(root)) {
        sum += canonical(g, c, Polynomial(g.size(), 1)) * pow(w, Rational(k % index)) *
               pow(g[root]->parts[0], Rational(k / index));
    }
    return sum;
}

Form Form::canonical(Generators g, Polynomial over, Polynomial under) {
    if (over.is_zero()) {
        return {};
    }
    check_interruption();
    // Radicands hold generators of less depth, which come first.
    for (std::size_t i = g.size(); i-- > 0;) {
        if (g[i]->kind == Kind::root &&
            (over.degree(i) >= g[i]->index || under.degree(i) >= g[i]->index)) {
            return reduced(over, g, i) / reduced(under, g, i);
        }
    }
    cancel(over, under);
    if (under.leading() < 0) {
        over = -over;
        under = -under;
    }
    // 1/w = w^(n-1)/f, so that 1/sqrt(f) has one form only.
    for (std::size_t i = g.size(); i-- > 0;) {
        if (const ulong k = g[i]->kind == Kind::root ? under.least_exponent(i) : 0; k > 0) {
            const auto times_root = [&](ulong more, ulong less) {
                return [i, more, less](Exponents e) {
                    e[i] = e[i] + more - less;
                    return e;
                };
            };
            over = over.with_exponents(g.size(), times_root(g[i]->index - k, 0));
            under = under.with_exponents(g.size(), times_root(0, k));
            const Form base = g[i]->parts[0];
            return canonical(std::move(g), std::move(over), std::move(under)) / base;
        }
    }
    return pruned(std::move(g), over, under);
}

/// Drops generators that do not occur, and writes the indices of roots in lowest terms.
Form Form::pruned(Generators g, const Polynomial& over, const Polynomial& under) {
    Generators left;
    std::vector<std::pair<std::size_t, ulong>> kept; // place, and divisor of the exponents
    bool changes = false;
    for (std::size_t i = 0; i < g.size(); ++i) {
        if (!over.holds(i) && !under.holds(i)) {
            changes = true;
            continue;
        }
        ulong divisor = 1;
        if (g[i]->index > 2) {
            divisor = g[i]->index;
            for (const Polynomial* p : {&over, &under}) {
                p->for_each_term(
                    [&](const Integer&, const Exponents& e) { divisor = std::gcd(divisor, e[i]); });
            }
        }
        if (divisor > 1) {
            changes = true;
            g[i] = with_index(*g[i], g[i]->index / divisor);
        }
        left.push_back(g[i]);
        kept.emplace_back(i, divisor);
    }
    if (!changes) {
        return {std::move(left), over, under};
    }
    const std::size_t n = left.size();
    const auto fewer = [&](const Exponents& e) {
        Exponents f(std::max<std::size_t>(n, 1), 0);
        for (std::size_t i = 0; i < kept.size(); ++i) {
            f[i] = e[kept[i].first] / kept[i].second;
        }
        return f;
    };
    return {std::move(left), over.with_exponents(n, fewer), under.with_exponents(n, fewer)};
}

/// Two forms in common generators.
struct Form::Pair {
    Generators g;
    Polynomial x;
    Polynomial under_x;
    Polynomial y;
    Polynomial under_y;
    static Pair of(const Form& x, const Form& y) {
        if (same(x.generators_, y.generators_)) {
            return {x.generators_, x.over_, x.under_, y.over_, y.under_};
        }
        Generators all = united(x.generators_, y.generators_);
        return {all, moved(x.over_, x.generators_, all), moved(x.under_, x.generators_, all),
                moved(y.over_, y.generators_, all), moved(y.under_, y.generators_, all)};
    }
};

Form operator-(Form x) {
    x.over_ = -std::move(x.over_);
    return x;
}

Form operator+(const Form& x, const Form& y) {
    if (x.is_zero() || y.is_zero()) {
        return x.is_zero() ? y : x;
    }
    Form::Pair p = Form::Pair::of(x, y);
    const Polynomial under = p.under_x;
    cancel(p.under_x, p.under_y);
    return Form::canonical(std::move(p.g), p.x * p.under_y + p.y * p.under_x, under * p.under_y);
}

Form operator*(const Form& x, const Form& y) {
    Form::Pair p = Form::Pair::of(x, y);
    return Form::canonical(std::move(p.g), p.x * p.y, p.under_x * p.under_y);
}

Form operator/(const Form& x, const Form& y) {
    if (y.is_zero()) {
        throw DomainError("division by zero");
    }
    return x * Form(y.generators_, y.under_, y.over_);
}

bool Form::holds(std::string_view name) const {
    return std::ranges::any_of(generators_, [&](const auto& g) { return g->holds(name); });
}

bool Generator::holds(std::string_view of) const {
    return (kind == Kind::name && name == of) || (expr && holds_symbol(*expr, of)) ||
           std::ranges::any_of(parts, [&](const Form& part) { return part.holds(of); });
}

std::optional<std::vector<Form>> Form::coefficients(std::string_view name) const {
    std::vector<Form> all;
    std::size_t at = generators_.size();
    for (std::size_t i = 0; i < generators_.size(); ++i) {
        const Generator& g = *generators_[i];
        if (g.holds(name)) {
            if (g.kind != Kind::name || under_.holds(i)) {
                return {};
            }
            at = i;
        }
    }
    if (at == generators_.size()) {
        return std::vector{*this};
    }
    all.resize(over_.degree(at) + 1);
    for (auto& [k, c] : over_.coefficients(at)) {
        all[k] = canonical(generators_, c, under_);
    }
    return all;
}

std::optional<ulong> Form::modulo(ulong prime,
                                  const std::function<ulong(const Generator&)>& value) const {
    std::vector<ulong> values;
    for (const auto& g : generators_) {
        values.push_back(value(*g));
    }
    const ulong under = under_.modulo(prime, values);
    if (under == 0) {
        return {};
    }
    return n_mulmod2(over_.modulo(prime, values), n_invmod(under, prime), prime);
}

namespace {

/// The environment of formula::evaluate in which a formula becomes a form.
struct Meanings {
    const std::function<Form(std::string_view)>& meaning;
    [[nodiscard]] static Form number(const Rational& q) { return Form(q); }
    [[nodiscard]] static Form pi() { return Form::pi(); }
    [[nodiscard]] Form symbol(std::string_view name) const { return meaning(name); }
    [[nodiscard]] static Form call(const Expr& e, std::span<const Form> args) {
        return Form::call(e.name(), args);
    }
    [[nodiscard]] Form binder(const Expr& e) const {
        Expr with_meanings = e;
        for (const std::string& name : free_symbols(e)) {
            if (const Expr m = meaning(name).expr(); !(m == Expr::symbol(name))) {
                with_meanings = substitute(with_meanings, name, m);
            }
        }
        return Form::opaque(with_meanings);
    }
};

} // namespace

Form Form::operator()(const Form& x) const {
    return form_of(expr(), [&](std::string_view) { return x; });
}

Form form_of(const Expr& e, const std::function<Form(std::string_view)>& meaning) {
    return formula::evaluate<Form>(e, Meanings{meaning});
}

} // namespace edgeproof::algebra
