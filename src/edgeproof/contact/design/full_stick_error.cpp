// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/error_family.hpp"

namespace edgeproof::contact {

/// With z = u/D, q sqrt(u) = (A - B z)/sqrt(D (1 - z)), A = Q/pi + side sigma_0 D/8, B = side
/// sigma_0 D/4; and s_k u^k = (beta_k A - beta_{k-1} B) z^k/sqrt(D), beta_k of (1 - z)^(-1/2).
template <class T> struct FullStick {
    T A;
    T B;
    T length;
    std::size_t terms;
    bool fraction;

    [[nodiscard]] T error(const T& u) const {
        const T z = fraction ? u : u / length;
        T sum = A;
        T power = z;
        Rational beta(1);
        for (std::size_t k = 1; k < terms; ++k) {
            const Rational before = beta;
            beta *= Rational(2 * static_cast<long>(k) - 1, 2 * static_cast<long>(k));
            const long bits = value_in(A).bits();
            sum += (A * T(Ball(beta, bits)) - B * T(Ball(before, bits))) * power;
            power *= z;
        }
        return sum * sqrt(1 - z) / (A - B * z) - 1;
    }
};

namespace {

class FullStickFamily : public ErrorFamily {
public:
    FullStickFamily(formula::Expr Q, formula::Expr tension, formula::Expr length,
                    ErrorQuestion question)
        : Q_(std::move(Q)), tension_(std::move(tension)), length_(std::move(length)),
          question_(std::move(question)) {}
    [[nodiscard]] std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const override {
        return std::make_unique<ClosedFormOverBox<FullStick>>(stick<Ball>(parameters),
                                                              stick<Jet>(parameters));
    }

    [[nodiscard]] EvaluationCost cost() const override {
        return {7, 4, 8 + 5 * static_cast<double>(question_.terms)};
    }

private:
    template <class T> [[nodiscard]] FullStick<T> stick(const std::vector<Ball>& at) const {
        const ParameterValues<T> value(question_.names, at);
        const T length = value(length_);
        T tension = value(tension_) * length;
        tension *= question_.edge == Edge::right ? 1 : -1;
        return {value(Q_) / value.pi() + tension / 8, tension / 4, length, question_.terms,
                question_.unit == ReachUnit::fraction};
    }
    formula::Expr Q_;
    formula::Expr tension_;
    formula::Expr length_;
    ErrorQuestion question_;
};

} // namespace

std::unique_ptr<ErrorFamily> full_stick_errors(const formula::Expr& Q,
                                               const formula::Expr& bulk_tension,
                                               const formula::Expr& length,
                                               const ErrorQuestion& question) {
    return std::make_unique<FullStickFamily>(Q, bulk_tension, length, question);
}

} // namespace edgeproof::contact
