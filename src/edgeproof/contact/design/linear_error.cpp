// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/contact/design/linear_edges.hpp"
#include "edgeproof/contact/enclosure/ball_marks.hpp"
#include "edgeproof/contact/enclosure/fields.hpp"

namespace edgeproof::contact {
namespace {

/// artanh(sqrt(x))/sqrt(x), whose power series has positive terms: it grows. 0 <= x < 1.
Ball arc_over_root(const Ball& x) {
    const auto at = [&](const Real& end) {
        const Ball e(end, x.bits());
        if (!certainly_positive(e)) {
            return Ball(1, x.bits());
        }
        const Ball root = sqrt(e);
        return atanh(root) / root;
    };
    return Ball::hull(at(x.lower()), at(x.upper()));
}

/// p/sqrt(u) at an edge, times 2 pi/E*: the sum of arc sqrt(D - u) and of (jump + drop (v - x))
/// G/sqrt(u) over the knots inside, where G = ln((1 + s)/|1 - s|), s^2 = u (D - u_v)/((D - u) u_v),
/// u_v the distance of a knot from the edge (docs/pressure.md).
template <class T> struct LinearError {
    struct Knot {
        T distance; ///< u_v
        T jump;
        T drop; ///< of g'' across it, times the sign of v - x beyond it
        bool corner;
    };
    T length;
    T arc;
    std::vector<Knot> knots;
    std::vector<T> coefficients; ///< c_k times 2 pi/E*
    bool fraction = true;
    long bits = 64;

    LinearError(const LinearContact<T>& contact, const LinearEdges<T>& edges,
                const ErrorQuestion& question)
        : length(edges.a + edges.b), arc(contact.arc(edges.a, edges.b)),
          fraction(question.unit == ReachUnit::fraction), bits(contact.bits) {
        const bool right = question.edge == Edge::right;
        for (std::size_t i = 0; i < contact.knots.size(); ++i) {
            const T from_right = edges.a - contact.knots[i];
            const T from_left = edges.b + contact.knots[i];
            if (certainly_negative(value_in(from_right)) ||
                certainly_negative(value_in(from_left))) {
                continue;
            }
            T drop = contact.pieces[i].rate - contact.pieces[i + 1].rate;
            drop *= right ? 1 : -1;
            knots.push_back({right ? from_right : from_left, contact.jumps[i], drop,
                             static_cast<bool>(contact.corner[i])});
        }
        for (std::size_t k = 0; k < question.terms; ++k) {
            coefficients.push_back(coefficient(k));
        }
    }

    /// Of w^i in (1 - w)^(-s), s = j + half.
    [[nodiscard]] static Rational rising(const Rational& s, std::size_t i) {
        Rational q(1);
        for (std::size_t k = 0; k < i; ++k) {
            q *= (s + static_cast<long>(k)) / Rational(static_cast<long>(k) + 1);
        }
        return q;
    }
    [[nodiscard]] T number(const Rational& q) const { return T(Ball(q, bits)); }
    [[nodiscard]] T power(const T& x, std::size_t n) const {
        T y = number(Rational(1));
        for (std::size_t i = 0; i < n; ++i) {
            y *= x;
        }
        return y;
    }
    /// Of u^k in G/sqrt(u): 2 sqrt(kappa) times the sum of kappa^j (1 - u/D)^(-j-1/2) u^j/(2j + 1),
    /// kappa = (D - u_v)/(D u_v).
    [[nodiscard]] T green_coefficient(const Knot& knot, std::size_t k) const {
        const T kappa = (length - knot.distance) / (length * knot.distance);
        T sum = number(Rational(0));
        for (std::size_t j = 0; j <= k; ++j) {
            const Rational s(2 * static_cast<long>(j) + 1, 2);
            sum += power(kappa, j) * number(rising(s, k - j) / (2 * s)) / power(length, k - j);
        }
        return sum * sqrt(kappa) * 2;
    }
    [[nodiscard]] T coefficient(std::size_t k) const {
        // sqrt(D - u) = sqrt(D) (1 - u/D)^(1/2)
        T sum = arc * sqrt(length) * number(rising(Rational(-1, 2), k)) / power(length, k);
        for (const Knot& knot : knots) {
            sum += (knot.jump - knot.drop * knot.distance) * green_coefficient(knot, k);
            if (k > 0) {
                sum += knot.drop * green_coefficient(knot, k - 1);
            }
        }
        return sum;
    }

    [[nodiscard]] T error(const T& given) const {
        const T u = fraction ? given * length : given;
        T sum = arc * sqrt(length - u);
        for (const Knot& knot : knots) {
            sum += part_of(knot, u);
        }
        T local = coefficients.back();
        for (std::size_t k = coefficients.size() - 1; k-- > 0;) {
            local = local * u + coefficients[k];
        }
        return local / sum - 1;
    }

private:
    [[nodiscard]] T part_of(const Knot& knot, const T& u) const {
        const T offset = u - knot.distance;
        const T weight = knot.jump + knot.drop * offset;
        const T ratio = (length - knot.distance) / ((length - u) * knot.distance);
        const T z = ratio * u;
        if constexpr (std::is_same_v<T, Ball>) {
            if (certainly_less(z, Ball(Rational(1, 4), bits))) {
                return weight * sqrt(ratio) * arc_over_root(clamped(z)) * 2;
            }
            if (contains_zero(offset) && !knot.corner) {
                return across(knot, u, offset);
            }
        }
        const T s = sqrt(z);
        if (certainly_positive(value_in(offset))) {
            return weight * log1p(number(Rational(2)) / (s - 1)) / sqrt(u);
        }
        return weight * log1p(s * 2 / (1 - s)) / sqrt(u);
    }
    /// By |t ln(C/t)|, which grows with t up to C/e (ball_marks.cpp).
    [[nodiscard]] Ball across(const Knot& knot, const Ball& u, const Ball& offset) const {
        const Ball sum = Field<Ball>::root(knot.distance * (length - u)) +
                         Field<Ball>::root(u * (length - knot.distance));
        const Ball C(Ball(sum * sum / length).upper(), bits);
        const Ball t(abs(offset).upper(), bits);
        const Ball largest = t * log(C / t);
        if (!certainly_less(t * 3, C) || !largest.is_finite()) {
            return unknown_ball(bits);
        }
        return knot.drop * Ball::around(Real(0), largest.upper(), bits) / sqrt(u);
    }
};

class LinearOverBox : public ErrorOverBox {
public:
    LinearOverBox(LinearContact<Jet> contact, std::optional<Jet> a, std::optional<Jet> P,
                  const LinearEdges<Ball>& edges, LinearError<Ball> balls, bool symmetric,
                  const ErrorQuestion& question)
        : contact_(std::move(contact)), a_(std::move(a)), P_(std::move(P)), edges_(edges),
          balls_(std::move(balls)), symmetric_(symmetric), question_(question) {}
    [[nodiscard]] Ball at(const Ball& u) const override { return balls_.error(u); }
    [[nodiscard]] Jet jet(const Ball& u) const override {
        if (!jets_) {
            jets_.emplace(contact_, differentiated_edges(contact_, edges_, symmetric_, a_, P_),
                          question_);
        }
        return jets_->error(Jet::variable(u, 0));
    }
    [[nodiscard]] Ball length() const override {
        return balls_.fraction ? Ball(1, balls_.bits) : balls_.length;
    }

private:
    LinearContact<Jet> contact_;
    std::optional<Jet> a_;
    std::optional<Jet> P_;
    LinearEdges<Ball> edges_;
    LinearError<Ball> balls_;
    mutable std::optional<LinearError<Jet>> jets_; ///< made when it is first asked for
    bool symmetric_;
    const ErrorQuestion& question_;
};

/// Nothing is known.
class UnknownOverBox : public ErrorOverBox {
public:
    explicit UnknownOverBox(long bits) : bits_(bits) {}
    [[nodiscard]] Ball at(const Ball&) const override { return unknown_ball(bits_); }
    [[nodiscard]] Jet jet(const Ball&) const override {
        Jet j(unknown_ball(bits_));
        j.g.fill(j.v);
        j.h.fill(j.v);
        return j;
    }
    [[nodiscard]] Ball length() const override { return unknown_ball(bits_); }

private:
    long bits_;
};

class LinearSlopeFamily : public ErrorFamily {
public:
    LinearSlopeFamily(ParametricSlope slope, ParametricLoad load, ErrorQuestion question)
        : slope_(std::move(slope)), load_(std::move(load)), question_(std::move(question)) {}
    [[nodiscard]] std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const override {
        std::vector<Ball> middles;
        for (const Ball& x : parameters) {
            middles.emplace_back(x.midpoint(), x.bits());
        }
        const ParameterValues<Ball> value(question_.names, parameters);
        const ParameterValues<Ball> in_middle(question_.names, middles);
        const ParameterValues<Jet> jets(question_.names, parameters);
        const LinearContact<Ball> contact = linear_contact(slope_, load_.contact_modulus, value);
        const auto given = [](const std::optional<formula::Expr>& e, const auto& at) {
            return e ? std::optional(at(*e)) : std::nullopt;
        };
        const auto edges =
            solve_edges(contact, linear_contact(slope_, load_.contact_modulus, in_middle),
                        slope_.symmetric, given(load_.a, value), given(load_.P, value));
        if (!edges) {
            return std::make_unique<UnknownOverBox>(value.bits());
        }
        return std::make_unique<LinearOverBox>(linear_contact(slope_, load_.contact_modulus, jets),
                                               given(load_.a, jets), given(load_.P, jets), *edges,
                                               LinearError<Ball>(contact, *edges, question_),
                                               slope_.symmetric, question_);
    }

private:
    ParametricSlope slope_;
    ParametricLoad load_;
    ErrorQuestion question_;
};

} // namespace

std::unique_ptr<ErrorFamily> linear_slope_errors(const ParametricSlope& slope,
                                                 const ParametricLoad& load,
                                                 const ErrorQuestion& question) {
    return std::make_unique<LinearSlopeFamily>(slope, load, question);
}

} // namespace edgeproof::contact
