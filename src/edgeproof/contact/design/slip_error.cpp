// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/linear_contact.hpp"
#include "edgeproof/contact/law/slip_series.hpp"

namespace edgeproof::contact {
namespace {

/// A contact with its edges and its load, and its stick zones with the tilt that the tension adds.
template <class T> struct SlippingContact {
    LinearContact<T> contact;
    Extent<T> edges;
    T force;
    std::optional<T> tension; ///< sigma_0/Q

    /// A contact without its edges, and without its load if that is not given.
    SlippingContact(const ParametricSlope& slope, const ParametricLoad& load,
                    const std::optional<Expr>& of_tension, const ParameterValues<T>& value)
        : contact(slope, load.contact_modulus, value),
          force(load.P ? value(*load.P) : value.number(Rational(0))), tension(value(of_tension)) {}

    void set_edges(Extent<T> found, const ParametricLoad& load) {
        edges = std::move(found);
        if (!load.P) {
            force = contact.force(edges);
        }
    }
    [[nodiscard]] T load(const T& tau) const { return force * (1 - tau); }
    /// The slope of the corrective contact: tilted by (sigma_0/Q) tau P/(2 E*).
    [[nodiscard]] LinearContact<T> corrective(const T& tau) const {
        LinearContact<T> c = contact;
        if (tension) {
            const T tilt = *tension * tau * force / (contact.modulus * 2);
            for (auto& piece : c.slope.pieces) {
                piece.at_origin += tilt;
            }
        }
        return c;
    }
    /// The coefficients of tau, tau^2, ... (docs/partial-slip.md).
    [[nodiscard]] std::vector<T> terms(ErrorQuestion question) const {
        const T root = sqrt(edges.length());
        const T pi = T(Ball::pi(contact.bits));
        const Edge edge = question.edge;
        const auto pressure = [&](Edge at) {
            question.edge = at;
            std::vector<T> c = LinearError<T>(contact, edges, question).coefficients;
            for (T& x : c) {
                x *= contact.modulus / (pi * 2);
            }
            return c;
        };
        const T one = T(Ball(1, contact.bits));
        const auto both = slip_series<T>(
            pressure(Edge::right), pressure(Edge::left), edges.length(), force * 2 / (pi * root),
            tension ? T(force * *tension / (root * 4)) : one * 0L, question.terms, one);
        return edge == Edge::right ? both.right : both.left;
    }
};

class LinearSlip {
public:
    LinearSlip(SlippingContact<Ball> balls, SlippingContact<Ball> in_middle,
               SlippingContact<Jet> jets, bool symmetric, const ErrorQuestion& question)
        : bits_(balls.contact.bits), balls_(std::move(balls)), in_middle_(std::move(in_middle)),
          jets_(std::move(jets)), symmetric_(symmetric), question_(question),
          right_(question.edge == Edge::right), terms_(balls_.terms(question)) {}

    [[nodiscard]] Ball error(const Ball& tau) const {
        if (!certainly_positive(tau)) { // d/tau is a mean of the derivative
            return horner(terms_, tau) / rate(tau) - 1;
        }
        return slip_sum(terms_, terms_.size(), tau) / size(tau) - 1;
    }
    [[nodiscard]] Jet jet(const Ball& at) {
        if (!jet_terms_) {
            jet_terms_ = jets_.terms(question_);
        }
        const Jet tau = Jet::variable(at, 0);
        const Extent<Jet> stick =
            differentiated_edges(jets_.corrective(tau), zones(at), symmetric_, {}, jets_.load(tau));
        return slip_sum(*jet_terms_, jet_terms_->size(), tau) / (of(jets_.edges) - of(stick)) - 1;
    }

private:
    template <class T> [[nodiscard]] const T& of(const Extent<T>& e) const {
        return right_ ? e.a : e.b;
    }
    [[nodiscard]] Ball low_end(const Ball& tau) const { return lower_end(tau).with_bits(bits_); }
    [[nodiscard]] Ball high_end(const Ball& tau) const { return upper_end(tau).with_bits(bits_); }
    /// True if the ball contains full sliding.
    [[nodiscard]] bool to_sliding(const Ball& tau) const {
        return !certainly_less(high_end(tau), Ball(1, bits_));
    }
    /// The size of the slip zone, which grows with tau.
    [[nodiscard]] Ball size(const Ball& tau) const {
        const Ball whole = of(balls_.edges);
        if (to_sliding(tau)) { // the zone shrinks to the rest of the contact
            const Extent<Ball> first = zone(low_end(tau));
            const Ball most = balls_.edges.length() -
                              (right_ ? balls_.edges.b - first.b : balls_.edges.a - first.a);
            return Ball::hull(whole - of(first), most);
        }
        return whole - of(zones(tau));
    }
    /// Encloses the derivative of the size by tau, from 0 to the upper end of the ball.
    [[nodiscard]] Ball rate(const Ball& tau) const {
        const Extent<Ball> last = zone(high_end(tau));
        const Extent<Ball> all{Ball::hull(balls_.edges.a, last.a),
                               Ball::hull(balls_.edges.b, last.b)};
        Ball share(1, bits_);
        if (balls_.tension) {
            const Ball turn = Ball::pi(bits_) * *balls_.tension *
                              Ball::hull(balls_.edges.length(), last.length()) / 8;
            share += right_ ? turn : -turn;
        }
        const Ball by_edge = right_ ? balls_.contact.force_rate(all)
                                    : balls_.contact.modulus / 2 * all.length() *
                                          -balls_.contact.imbalance_rate(all);
        return balls_.force * share / by_edge;
    }
    /// Encloses the stick zone of one load ratio.
    [[nodiscard]] Extent<Ball> zone(const Ball& tau) const {
        const auto found = solve_edges(balls_.corrective(tau), in_middle_.corrective(tau),
                                       symmetric_, {}, balls_.load(tau), &in_middle_.edges);
        return found ? *found : Extent<Ball>{unknown_ball(bits_), unknown_ball(bits_)};
    }
    /// Encloses the stick zones of all load ratios of the ball: both edges move inwards as it
    /// grows.
    [[nodiscard]] Extent<Ball> zones(const Ball& tau) const {
        if (to_sliding(tau)) {
            return {unknown_ball(bits_), unknown_ball(bits_)};
        }
        const Extent<Ball> first = zone(low_end(tau));
        if (tau.is_exact()) {
            return first;
        }
        const Extent<Ball> last = zone(high_end(tau));
        return {Ball::hull(first.a, last.a), Ball::hull(first.b, last.b)};
    }

    long bits_;
    SlippingContact<Ball> balls_;
    SlippingContact<Ball> in_middle_;
    SlippingContact<Jet> jets_;
    bool symmetric_; ///< the stick zones are symmetric, too
    const ErrorQuestion& question_;
    bool right_;
    std::vector<Ball> terms_;
    std::optional<std::vector<Jet>> jet_terms_; ///< made on first use
};

} // namespace

std::unique_ptr<ErrorFamily> linear_slip_errors(const ParametricSlope& slope,
                                                const ParametricLoad& load,
                                                const std::optional<Expr>& tension,
                                                const ErrorQuestion& question) {
    const auto n = static_cast<double>(question.terms);
    const double over = (load.P ? 1500 : 500) + 6 * n * n * n * n;
    const EvaluationCost cost = slope.symmetric && !tension ? EvaluationCost{over, 85, 340}
                                                            : EvaluationCost{over, 600, 1700};
    return std::make_unique<ErrorFamily>(ErrorFamily{
        cost, [=](const std::vector<Ball>& at) {
            const std::vector<Ball> middles = middles_of(at);
            const ParameterValues<Ball> value(question.names, at);
            const ParameterValues<Jet> rates(question.names, at);
            SlippingContact<Ball> balls(slope, load, tension, value);
            SlippingContact<Ball> in_middle(slope, load, tension,
                                            ParameterValues<Ball>(question.names, middles));
            const auto edges = solve_edges(balls.contact, in_middle.contact, slope.symmetric,
                                           value(load.a), value(load.P));
            const long bits = value.bits();
            // Both edges slip in the direction of Q from the beginning of loading.
            if (!edges || (tension && !certainly_less(abs(Ball::pi(bits) * *balls.tension *
                                                          edges->length() / 8),
                                                      Ball(1, bits)))) {
                return unknown_errors(bits);
            }
            SlippingContact<Jet> jets(slope, load, tension, rates);
            balls.set_edges(*edges, load);
            in_middle.set_edges({middle(edges->a), middle(edges->b)}, load);
            jets.set_edges(differentiated_edges(jets.contact, *edges, slope.symmetric,
                                                rates(load.a), rates(load.P)),
                           load);
            const auto slip = std::make_shared<LinearSlip>(std::move(balls), std::move(in_middle),
                                                           std::move(jets),
                                                           slope.symmetric && !tension, question);
            return ErrorOverBox{[slip](const Ball& tau) { return slip->error(tau); },
                                [slip](const Ball& tau) { return slip->jet(tau); }, Ball(1, bits)};
        }});
}

} // namespace edgeproof::contact
