// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/algebra/form.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace edgeproof::algebra {

using Kind = Generator::Kind;

/// Writes a form as a formula.
class Tidy {
public:
    explicit Tidy(const Form& form) : form_(form), g_(form.generators_) {}

    /// Of a sum that is not a product, exactly the sum, and not its negative with a minus.
    [[nodiscard]] Expr radicand() const {
        const auto [constant, powers] = form_.over_.factors();
        const bool one = form_.under_ == Polynomial(g_.size(), 1) && abs(constant) == 1 &&
                         powers.size() == 1 && powers[0].second == 1 && form_.over_.size() > 1;
        return one ? terms_of(form_.over_, true).joined(false) : formula();
    }
    [[nodiscard]] Expr formula() const {
        Product whole;
        multiply(whole, form_.over_, true, 1);
        multiply(whole, form_.under_, false, -1);
        const Expr size = whole.magnitude();
        return whole.number < 0 ? -size : size;
    }

private:
    /// A number and powers of expressions.
    struct Product {
        Rational number{1};
        std::vector<std::pair<Expr, Form>> powers;
        Form exponential; ///< x of exp(x)

        void multiply(const Expr& base, const Form& exponent) {
            const auto at = std::ranges::find(powers, base, &std::pair<Expr, Form>::first);
            if (at != powers.end()) {
                at->second += exponent;
            } else {
                powers.emplace_back(base, exponent);
            }
        }
        [[nodiscard]] bool is_one() const {
            return abs(number) == 1 && powers.empty() && exponential.is_zero();
        }
        /// The product without the sign, as one fraction.
        [[nodiscard]] Expr magnitude() const {
            std::vector<Expr> over;
            std::vector<Expr> under;
            for (const auto& [base, exponent] : powers) {
                const auto q = exponent.rational();
                if (exponent.is_zero()) {
                    continue;
                }
                const bool below =
                    q ? *q < 0 : exponent.sign() < 0 || text_of(exponent).kind() == Expr::Kind::neg;
                (below ? under : over).push_back(raised(base, below ? -exponent : exponent));
            }
            if (!exponential.is_zero()) {
                over.push_back(Expr::call("exp", {exponential.expr()}));
            }
            const Rational size = abs(number);
            sort(over, Integer(numerator(size)), over.empty());
            sort(under, Integer(denominator(size)), false);
            return under.empty() ? product(over) : product(over) / product(under);
        }

    private:
        [[nodiscard]] static Expr raised(const Expr& base, const Form& exponent) {
            const auto q = exponent.rational();
            return q == 1                ? base
                   : q == Rational(1, 2) ? Expr::call("sqrt", {base})
                   : q                   ? pow(base, formula::quotient_of(*q))
                                         : pow(base, text_of(exponent));
        }
        [[nodiscard]] static Expr text_of(const Form& exponent) {
            return Tidy(exponent).radicand();
        }
        static void sort(std::vector<Expr>& factors, const Integer& n, bool even_one) {
            std::ranges::sort(factors, {}, [](const Expr& e) {
                std::string text = to_text(e);
                const std::size_t size = text.size();
                return std::pair(size, std::move(text));
            });
            if (n != 1 || even_one) {
                factors.insert(factors.begin(), Expr::number(Rational(n)));
            }
        }
        [[nodiscard]] static Expr product(const std::vector<Expr>& factors) {
            return std::accumulate(factors.begin() + 1, factors.end(), factors.front(),
                                   [](const Expr& p, const Expr& factor) { return p * factor; });
        }
    };
    /// The terms of a sum: true for those that are subtracted, and their magnitudes.
    struct Terms {
        std::vector<std::pair<bool, Expr>> all;
        bool collected = false;

        /// The sum or its negative. If the terms are not collected, those that are added come
        /// first, so that it begins with a minus only if necessary.
        [[nodiscard]] Expr joined(bool turned) const {
            std::vector<std::pair<bool, Expr>> terms = all;
            for (auto& term : terms) {
                term.first = term.first != turned;
            }
            if (!collected) {
                std::ranges::sort(terms, {}, [](const auto& term) {
                    return std::pair(term.first, to_text(term.second));
                });
            }
            Expr e = terms[0].first ? -terms[0].second : terms[0].second;
            for (std::size_t i = 1; i < terms.size(); ++i) {
                e = terms[i].first ? e - terms[i].second : e + terms[i].second;
            }
            return e;
        }
    };

    /// Multiplies by the power k of a generator.
    void multiply(Product& product, const Generator& g, const Rational& k) const {
        switch (g.kind) {
        case Kind::name:
            return product.multiply(Expr::symbol(g.name), Form(k));
        case Kind::pi:
            return product.multiply(Expr::pi(), Form(k));
        case Kind::root:
            if (const Generator* inner = g.parts[0].generator();
                inner != nullptr && inner->kind == Kind::power) {
                return multiply(product, *inner, k / g.index);
            }
            return product.multiply(Tidy(g.parts[0]).radicand(), Form(Rational(k / g.index)));
        case Kind::power:
            if (g.parts.size() == 1) {
                product.exponential += Form(k) * g.parts[0];
                return;
            }
            return product.multiply(g.parts[0].expr(), Form(k) * g.parts[1]);
        case Kind::call: {
            std::vector<Expr> args;
            for (const Form& part : g.parts) {
                args.push_back(part.expr());
            }
            return product.multiply(Expr::call(g.name, std::move(args)), Form(k));
        }
        case Kind::opaque:
            return product.multiply(*g.expr, Form(k));
        }
    }

    /// Multiplies by p^k, with separate factors.
    void multiply(Product& product, const Polynomial& p, bool collect, int k) const {
        const auto [constant, powers] = p.factors();
        product.number *= k > 0 ? Rational(constant) : Rational(1) / Rational(constant);
        for (const auto& [factor, n] : powers) {
            const Rational power(k * static_cast<long>(n));
            if (factor.size() == 1) { // irreducible, and therefore a generator
                for (std::size_t i = 0; i < g_.size(); ++i) {
                    if (factor.holds(i)) {
                        multiply(product, *g_[i], power);
                    }
                }
                continue;
            }
            const auto [base, turned] = sum(factor, collect);
            product.number *= turned && n % 2 != 0 ? -1 : 1;
            product.multiply(base, Form(power));
        }
    }

    /// Returns the formula of a sum or of its negative (then the second value is true): as it is
    /// under a root, else the one with the shorter text.
    [[nodiscard]] std::pair<Expr, bool> sum(const Polynomial& p, bool collect) const {
        const Form form = Form::canonical(g_, p, Polynomial(g_.size(), 1));
        for (const auto& g : g_) {
            if (g->kind == Kind::root && g->parts[0] == form) {
                return {Tidy(form).radicand(), false};
            }
            if (g->kind == Kind::root && g->parts[0] == -form) {
                return {Tidy(-form).radicand(), true};
            }
        }
        const Terms terms = terms_of(p, collect);
        const Expr plain = terms.joined(false);
        const Expr turned = terms.joined(true);
        const std::string s = to_text(plain);
        const std::string t = to_text(turned);
        const bool turn = t.size() != s.size() ? t.size() < s.size() : t < s;
        return {turn ? turned : plain, turn};
    }

    [[nodiscard]] Terms terms_of(Polynomial rest, bool collect) const {
        Terms terms;
        const auto add = [&](const Product& f, const Expr* name) {
            const Expr size = f.magnitude();
            terms.all.emplace_back(f.number < 0, name == nullptr ? size
                                                 : f.is_one()    ? *name
                                                                 : size * *name);
        };
        for (std::size_t i = 0; collect && i < g_.size(); ++i) {
            const std::string& name = g_[i]->name;
            const bool rate = g_[i]->kind == Kind::name && formula::order_behind(name, "P");
            if (!rate || rest.degree(i) != 1) {
                continue;
            }
            Polynomial others(g_.size());
            for (const auto& [k, c] : rest.coefficients(i)) {
                if (k == 0) {
                    others = c;
                    continue;
                }
                Product f;
                multiply(f, c, false, 1);
                const Expr symbol = Expr::symbol(name);
                add(f, &symbol);
            }
            rest = std::move(others);
        }
        terms.collected = !terms.all.empty();
        if (terms.collected && !rest.is_zero()) {
            Product f;
            multiply(f, rest, false, 1);
            add(f, nullptr);
        } else if (!terms.collected) {
            rest.for_each_term([&](const Integer& c, const Exponents& e) {
                Product f;
                f.number = Rational(c);
                for (std::size_t i = 0; i < g_.size(); ++i) {
                    if (e[i] > 0) {
                        multiply(f, *g_[i], Rational(e[i]));
                    }
                }
                add(f, nullptr);
            });
        }
        return terms;
    }

    const Form& form_;
    const Generators& g_;
};

Expr Form::expr() const { return is_zero() ? Expr::number(0) : Tidy(*this).formula(); }

} // namespace edgeproof::algebra
