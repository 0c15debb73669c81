// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/edge_function.hpp"
#include "edgeproof/contact/design/error_family.hpp"

namespace edgeproof::contact {

/// With z = u/(2a), p is proportional to sqrt(z (1 - z)) F (edge_function.hpp; docs/pressure.md).
template <class T> struct PowerLawError {
    T b; ///< (1 - m)/2
    T length;
    bool fraction;
    std::vector<T> coefficients; ///< c_k D^(k+1/2)/(c_0 D^(1/2))

    PowerLawError(T b_, T length_, const ErrorQuestion& question)
        : b(std::move(b_)), length(std::move(length_)),
          fraction(question.unit == ReachUnit::fraction) {
        // The sum over j of F's own coefficients, (b)_j/(3/2)_j 4^j z^j (1 - z)^(j+1/2).
        const long bits = value_in(b).bits();
        coefficients.assign(question.terms, T(Ball(0, bits)));
        T t = T(Ball(1, bits));
        for (std::size_t j = 0; j < question.terms; ++j) {
            const auto n = static_cast<long>(j);
            Rational binomial(1); // the coefficient of (-z)^i
            for (std::size_t i = 0; i + j < question.terms; ++i) {
                const auto k = static_cast<long>(i);
                coefficients[i + j] += t * T(Ball(binomial, bits));
                binomial *= Rational(2 * (k - n) - 1, 2 * k + 2);
            }
            t *= (b + n) * T(Ball(Rational(8, 2 * n + 3), bits));
        }
    }
    [[nodiscard]] T error(const T& u) const {
        const T z = fraction ? u : u / length;
        T sum = coefficients.back();
        for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
            sum = sum * z + coefficients[k];
        }
        return sum * reciprocal_edge_function(z, b) / sqrt(1 - z) - 1;
    }
};

namespace {

class PowerLawFamily : public ErrorFamily {
public:
    PowerLawFamily(formula::Expr m, std::optional<formula::Expr> half_width, ErrorQuestion question)
        : m_(std::move(m)), half_width_(std::move(half_width)), question_(std::move(question)) {}
    [[nodiscard]] std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const override {
        return std::make_unique<ClosedFormOverBox<PowerLawError>>(law<Ball>(parameters),
                                                                  law<Jet>(parameters));
    }

    [[nodiscard]] EvaluationCost cost() const override {
        const auto n = static_cast<double>(question_.terms);
        return {10 + 1.2 * n * n, 20, 170};
    }

private:
    template <class T> [[nodiscard]] PowerLawError<T> law(const std::vector<Ball>& at) const {
        const ParameterValues<T> value(question_.names, at);
        const T one = value.number(Rational(1));
        return {(one - value(m_)) / 2, half_width_ ? T(value(*half_width_) * 2) : one, question_};
    }
    formula::Expr m_;
    std::optional<formula::Expr> half_width_;
    ErrorQuestion question_;
};

} // namespace

std::unique_ptr<ErrorFamily> power_law_errors(const formula::Expr& m,
                                              const std::optional<formula::Expr>& half_width,
                                              const ErrorQuestion& question) {
    return std::make_unique<PowerLawFamily>(m, half_width, question);
}

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
