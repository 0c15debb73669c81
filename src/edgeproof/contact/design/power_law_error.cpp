// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "edgeproof/contact/law/shear.hpp"

namespace edgeproof::contact {
namespace {

/// With z = u/(2a), p is proportional to sqrt(z (1 - z)) F (edge_function.cpp; docs/pressure.md).
template <class T> struct PowerLawError {
    T b;                         ///< (1 - m)/2
    T length;                    ///< in the unit of distances
    std::vector<T> coefficients; ///< c_k D^(k+1/2)/(c_0 D^(1/2))

    PowerLawError(T b_, T length_, std::size_t terms)
        : b(std::move(b_)), length(std::move(length_)) {
        // The sum over j of F's own coefficients, (b)_j/(3/2)_j 4^j z^j (1 - z)^(j+1/2).
        const long bits = value_in(b).bits();
        coefficients.assign(terms, b * Ball(0, bits));
        T t = coefficients[0] + Ball(1, bits);
        for (std::size_t j = 0; j < terms; ++j) {
            const auto n = static_cast<long>(j);
            Rational binomial(1); // the coefficient of (-z)^i
            for (std::size_t i = 0; i + j < terms; ++i) {
                const auto k = static_cast<long>(i);
                coefficients[i + j] = coefficients[i + j] + t * Ball(binomial, bits);
                binomial *= Rational(2 * (k - n) - 1, 2 * k + 2);
            }
            t = t * (b + Ball(n, bits)) * Ball(Rational(8, 2 * n + 3), bits);
        }
    }
    [[nodiscard]] T error(const T& u) const {
        const T z = u / length;
        const Ball one(1, value_in(u).bits());
        return horner(coefficients, z) * reciprocal_edge_function(z, b) / sqrt(-z + one) + -one;
    }
};

/// With z = u/D, q sqrt(u) = (A - B z)/sqrt(D (1 - z)), A = s_0 sqrt(D), B = side sigma_0 D/4, and
/// s_k u^k = c_k z^k/sqrt(D).
template <class T> struct FullStick {
    std::vector<T> c;
    T B;
    T length; ///< in the unit of distances

    [[nodiscard]] T error(const T& u) const {
        const T z = u / length;
        const Ball one(1, value_in(u).bits());
        return horner(c, z) * sqrt(-z + one) / (c[0] - B * z) + -one;
    }
};

template <class Form>
ErrorFamily family_of(const EvaluationCost& cost, const Expr& unit, const Form& form) {
    return {cost, [unit, form](const Ball& at) {
                return closed_form_error(at, form, ParameterValues<Ball>{at}(unit));
            }};
}

/// The length a + b if distances are lengths, else 1.
Expr unit_of(const ErrorQuestion& question, const std::optional<Expr>& length) {
    return question.unit == ReachUnit::distance && length ? *length : Expr::number(Rational(1));
}

} // namespace

ErrorFamily power_law_errors(const Expr& m, const std::optional<Expr>& half_width,
                             const ErrorQuestion& question) {
    const auto n = static_cast<double>(question.terms);
    const Expr two = Expr::number(Rational(2));
    const Expr unit =
        unit_of(question, half_width ? std::optional<Expr>(two * *half_width) : half_width);
    const Expr b = (Expr::number(Rational(1)) - m) / two;
    return family_of({10 + 1.2 * n * n, 20, 60}, unit,
                     [b, unit, terms = question.terms](const auto& value) {
                         using T = typename std::decay_t<decltype(value)>::Number;
                         return PowerLawError<T>(value(b), value(unit), terms);
                     });
}

ErrorFamily full_stick_errors(const Expr& Q, const Expr& bulk_tension, const Expr& length,
                              const ErrorQuestion& question) {
    const Expr unit = unit_of(question, length);
    return family_of({7, 4, 8 + 5 * static_cast<double>(question.terms)}, unit,
                     [=, tension = bulk_tension * length](const auto& value) {
                         using T = typename std::decay_t<decltype(value)>::Number;
                         const T pull = value(tension);
                         const T one = Field<T>::number(1, pull);
                         return FullStick<T>{
                             full_stick_terms(T(value(Q) / Field<T>::pi(pull)), pull, one,
                                              question.edge, question.terms, one),
                             Field<T>::over(question.edge == Edge::right ? pull : T(-pull), 4),
                             value(unit)};
                     });
}

} // namespace edgeproof::contact
