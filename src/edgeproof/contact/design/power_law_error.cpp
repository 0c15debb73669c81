// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/edge_function.hpp"
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"

namespace edgeproof::contact {
namespace {

/// The length by which distances are divided; 1 if they are fractions of it.
template <class T> Ball whole_length(const T& length, bool fraction) {
    return fraction ? Ball(1, value_in(length).bits()) : value_in(length);
}

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
    [[nodiscard]] Ball whole() const { return whole_length(length, fraction); }
    [[nodiscard]] T error(const T& u) const {
        const T z = fraction ? u : u / length;
        return horner(coefficients, z) * reciprocal_edge_function(z, b) / sqrt(1 - z) - 1;
    }
};

/// With z = u/D, q sqrt(u) = (A - B z)/sqrt(D (1 - z)), A = Q/pi + side sigma_0 D/8, B = side
/// sigma_0 D/4; and s_k u^k = (beta_k A - beta_{k-1} B) z^k/sqrt(D), beta_k of (1 - z)^(-1/2).
template <class T> struct FullStick {
    T A;
    T B;
    T length;
    std::size_t terms;
    bool fraction;

    [[nodiscard]] Ball whole() const { return whole_length(length, fraction); }
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

} // namespace

std::unique_ptr<ErrorFamily> power_law_errors(const Expr& m, const std::optional<Expr>& half_width,
                                              const ErrorQuestion& question) {
    const auto n = static_cast<double>(question.terms);
    return closed_form_errors(
        question, {10 + 1.2 * n * n, 20, 170}, [m, half_width, question](const auto& value) {
            using T = typename std::decay_t<decltype(value)>::Number;
            const T one = value.number(Rational(1));
            return PowerLawError<T>((one - value(m)) / 2,
                                    half_width ? T(value(*half_width) * 2) : one, question);
        });
}

std::unique_ptr<ErrorFamily> full_stick_errors(const Expr& Q, const Expr& bulk_tension,
                                               const Expr& length, const ErrorQuestion& question) {
    return closed_form_errors(question, {7, 4, 8 + 5 * static_cast<double>(question.terms)},
                              [Q, bulk_tension, length, question](const auto& value) {
                                  using T = typename std::decay_t<decltype(value)>::Number;
                                  const T D = value(length);
                                  T tension = value(bulk_tension) * D;
                                  tension *= question.edge == Edge::right ? 1 : -1;
                                  return FullStick<T>{value(Q) / value.pi() + tension / 8,
                                                      tension / 4, D, question.terms,
                                                      question.unit == ReachUnit::fraction};
                              });
}

} // namespace edgeproof::contact
