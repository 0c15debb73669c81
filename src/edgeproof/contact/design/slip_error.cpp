// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/design/linear_error.hpp"
#include "edgeproof/contact/law/slip_series.hpp"

namespace edgeproof::contact {
namespace {

template <class T> struct SlipTerms {
    std::vector<T> kappa; ///< coefficients of tau, tau^2, ... (docs/partial-slip.md)

    [[nodiscard]] T over_tau(const T& tau) const {
        T sum = kappa.back();
        for (std::size_t k = kappa.size() - 1; k-- > 0;) {
            sum = sum * tau + kappa[k];
        }
        return sum;
    }
    [[nodiscard]] T error(const T& tau, const T& size) const {
        return over_tau(tau) * tau / size - 1;
    }
};

/// The common part of all slip zones: d increases with tau.
class SlipErrorOverBox : public ErrorOverBox {
public:
    explicit SlipErrorOverBox(long bits) : bits_(bits) {}
    [[nodiscard]] Ball at(const Ball& tau) const override {
        if (!certainly_positive(tau)) { // d/tau is a mean of the derivative
            return terms().over_tau(tau) / rate(tau) - 1;
        }
        return terms().error(tau, size(tau));
    }
    [[nodiscard]] Jet jet(const Ball& tau) const override {
        const Jet t = Jet::variable(tau, 0);
        return jet_terms().error(t, size_jet(t));
    }
    [[nodiscard]] Ball length() const override { return {1, bits_}; }

protected:
    [[nodiscard]] virtual const SlipTerms<Ball>& terms() const = 0;
    [[nodiscard]] virtual const SlipTerms<Jet>& jet_terms() const = 0;
    [[nodiscard]] virtual Ball size(const Ball& tau) const = 0;
    /// Encloses the derivative of d by tau, from 0 to the upper end of the ball.
    [[nodiscard]] virtual Ball rate(const Ball& tau) const = 0;
    [[nodiscard]] virtual Jet size_jet(const Jet& tau) const = 0;
    [[nodiscard]] long bits() const { return bits_; }
    [[nodiscard]] Ball low_end(const Ball& tau) const { return {tau.lower(), bits_}; }
    [[nodiscard]] Ball high_end(const Ball& tau) const { return {tau.upper(), bits_}; }
    /// True if the ball contains full sliding.
    [[nodiscard]] bool to_sliding(const Ball& tau) const {
        return !certainly_less(high_end(tau), Ball(1, bits_));
    }

private:
    long bits_;
};

/// d/a = 1 - (1 - tau)^w, w = 1/(m + 1), since P is proportional to a^(m + 1).
template <class T> SlipTerms<T> power_law_terms(const T& w, std::size_t count) {
    SlipTerms<T> s;
    s.kappa.push_back(w);
    for (long k = 1; s.kappa.size() < count; ++k) {
        s.kappa.push_back(s.kappa.back() * (k - w) / (k + 1));
    }
    return s;
}

class PowerLawSlip : public SlipErrorOverBox {
public:
    PowerLawSlip(Ball w, Jet w_jet, std::size_t count)
        : SlipErrorOverBox(w.bits()), w_(std::move(w)), w_jet_(std::move(w_jet)),
          terms_(power_law_terms(w_, count)), jet_terms_(power_law_terms(w_jet_, count)) {}

protected:
    [[nodiscard]] const SlipTerms<Ball>& terms() const override { return terms_; }
    [[nodiscard]] const SlipTerms<Jet>& jet_terms() const override { return jet_terms_; }
    [[nodiscard]] Ball size(const Ball& tau) const override {
        const Ball most = to_sliding(tau) ? Ball(1, bits()) : size_at(high_end(tau));
        return Ball::hull(size_at(low_end(tau)), most);
    }
    [[nodiscard]] Ball rate(const Ball& tau) const override {
        return w_ * exp((w_ - 1) * log1p(-tau));
    }
    [[nodiscard]] Jet size_jet(const Jet& tau) const override {
        return 1 - exp(w_jet_ * log1p(-tau));
    }

private:
    [[nodiscard]] Ball size_at(const Ball& tau) const { return 1 - exp(w_ * log1p(-tau)); }
    Ball w_;
    Jet w_jet_;
    SlipTerms<Ball> terms_;
    SlipTerms<Jet> jet_terms_;
};

class PowerLawSlipFamily : public ErrorFamily {
public:
    PowerLawSlipFamily(formula::Expr m, ErrorQuestion question)
        : m_(std::move(m)), question_(std::move(question)) {}
    [[nodiscard]] std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const override {
        return std::make_unique<PowerLawSlip>(exponent<Ball>(parameters), exponent<Jet>(parameters),
                                              question_.terms);
    }

    [[nodiscard]] EvaluationCost cost() const override {
        const auto n = static_cast<double>(question_.terms);
        return {5 + 3 * n, 4, 10 + 2 * n};
    }

private:
    template <class T> [[nodiscard]] T exponent(const std::vector<Ball>& at) const {
        const ParameterValues<T> value(question_.names, at);
        return value.number(Rational(1)) / (value(m_) + 1);
    }
    formula::Expr m_;
    ErrorQuestion question_;
};

/// A contact with its edges and its load, and its stick zones with the tilt that the tension adds.
template <class T> struct SlippingContact {
    LinearContact<T> contact;
    LinearEdges<T> edges;
    T force;
    std::optional<T> tension; ///< sigma_0/Q

    [[nodiscard]] T length() const { return edges.a + edges.b; }
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
    [[nodiscard]] SlipTerms<T> terms(ErrorQuestion question) const {
        const T root = sqrt(length());
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
        const T one = contact.constant(1);
        auto both = slip_series<T>(
            pressure(Edge::right), pressure(Edge::left), length(), force * 2 / (pi * root),
            tension ? T(force * *tension / (root * 4)) : one * 0L, question.terms, one);
        return {edge == Edge::right ? std::move(both.right) : std::move(both.left)};
    }
};

class LinearSlip : public SlipErrorOverBox {
public:
    LinearSlip(SlippingContact<Ball> balls, SlippingContact<Ball> middle, SlippingContact<Jet> jets,
               bool symmetric, const ErrorQuestion& question)
        : SlipErrorOverBox(balls.contact.bits), balls_(std::move(balls)),
          middle_(std::move(middle)), jets_(std::move(jets)), symmetric_(symmetric),
          question_(question), terms_(balls_.terms(question)) {}

protected:
    [[nodiscard]] const SlipTerms<Ball>& terms() const override { return terms_; }
    [[nodiscard]] const SlipTerms<Jet>& jet_terms() const override {
        if (!jet_terms_) {
            jet_terms_ = jets_.terms(question_);
        }
        return *jet_terms_;
    }
    [[nodiscard]] Ball size(const Ball& tau) const override {
        const LinearEdges<Ball> stick = zones(tau);
        const bool right = question_.edge == Edge::right;
        const Ball whole = right ? balls_.edges.a : balls_.edges.b;
        if (to_sliding(tau)) { // the zone shrinks to the rest of the contact
            const LinearEdges<Ball> first = zone(low_end(tau));
            const Ball most =
                balls_.length() - (right ? balls_.edges.b - first.b : balls_.edges.a - first.a);
            return Ball::hull(whole - (right ? first.a : first.b), most);
        }
        return whole - (right ? stick.a : stick.b);
    }
    [[nodiscard]] Ball rate(const Ball& tau) const override {
        const LinearEdges<Ball> last = zone(high_end(tau));
        const Ball a = Ball::hull(balls_.edges.a, last.a);
        const Ball b = Ball::hull(balls_.edges.b, last.b);
        const bool right = question_.edge == Edge::right;
        Ball share(1, bits());
        if (balls_.tension) {
            const Ball turn = Ball::pi(bits()) * *balls_.tension *
                              Ball::hull(balls_.length(), last.a + last.b) / 8;
            share += right ? turn : -turn;
        }
        const Ball by_edge =
            right ? balls_.contact.force_rate(a, b)
                  : balls_.contact.modulus / 2 * (a + b) * -balls_.contact.imbalance_rate(a, b);
        return balls_.force * share / by_edge;
    }
    [[nodiscard]] Jet size_jet(const Jet& tau) const override {
        const LinearEdges<Jet> stick = differentiated_edges(jets_.corrective(tau), zones(tau.v),
                                                            symmetric_, {}, jets_.load(tau));
        return question_.edge == Edge::right ? jets_.edges.a - stick.a : jets_.edges.b - stick.b;
    }

private:
    /// Encloses the stick zone of one load ratio.
    [[nodiscard]] LinearEdges<Ball> zone(const Ball& tau) const {
        const auto found = solve_edges(balls_.corrective(tau), middle_.corrective(tau), symmetric_,
                                       {}, balls_.load(tau), &middle_.edges);
        return found ? *found : LinearEdges<Ball>{unknown_ball(bits()), unknown_ball(bits())};
    }
    /// Encloses the stick zones of all load ratios of the ball: both edges move inwards as it
    /// grows.
    [[nodiscard]] LinearEdges<Ball> zones(const Ball& tau) const {
        if (to_sliding(tau)) {
            return {unknown_ball(bits()), unknown_ball(bits())};
        }
        const LinearEdges<Ball> first = zone(low_end(tau));
        if (tau.is_exact()) {
            return first;
        }
        const LinearEdges<Ball> last = zone(high_end(tau));
        return {Ball::hull(first.a, last.a), Ball::hull(first.b, last.b)};
    }

    SlippingContact<Ball> balls_;
    SlippingContact<Ball> middle_;
    SlippingContact<Jet> jets_;
    bool symmetric_; ///< the stick zones are symmetric, too
    const ErrorQuestion& question_;
    SlipTerms<Ball> terms_;
    mutable std::optional<SlipTerms<Jet>> jet_terms_; ///< made on first use
};

class LinearSlipFamily : public ErrorFamily {
public:
    LinearSlipFamily(ParametricSlope slope, ParametricLoad load,
                     std::optional<formula::Expr> tension, ErrorQuestion question)
        : slope_(std::move(slope)), load_(std::move(load)), tension_(std::move(tension)),
          question_(std::move(question)) {}
    [[nodiscard]] std::unique_ptr<ErrorOverBox>
    over(const std::vector<Ball>& parameters) const override {
        std::vector<Ball> middles;
        for (const Ball& x : parameters) {
            middles.emplace_back(x.midpoint(), x.bits());
        }
        auto balls = contact_of<Ball>(parameters);
        auto middle = contact_of<Ball>(middles);
        auto jets = contact_of<Jet>(parameters);
        const auto edges =
            solve_edges(balls.contact, middle.contact, slope_.symmetric,
                        given<Ball>(load_.a, parameters), given<Ball>(load_.P, parameters));
        const long bits = parameters.front().bits();
        if (!edges) {
            return std::make_unique<UnknownOverBox>(bits);
        }
        balls.edges = *edges;
        middle.edges = {Ball(edges->a.midpoint(), bits), Ball(edges->b.midpoint(), bits)};
        const auto a = given<Jet>(load_.a, parameters);
        const auto P = given<Jet>(load_.P, parameters);
        jets.edges = differentiated_edges(jets.contact, *edges, slope_.symmetric, a, P);
        if (!load_.P) {
            balls.force = balls.contact.force(balls.edges.a, balls.edges.b);
            middle.force = middle.contact.force(middle.edges.a, middle.edges.b);
            jets.force = jets.contact.force(jets.edges.a, jets.edges.b);
        }
        if (tension_) {
            // Both edges slip in the direction of Q from the beginning of loading.
            const Ball turn = Ball::pi(bits) * *balls.tension * balls.length() / 8;
            if (!certainly_less(abs(turn), Ball(1, bits))) {
                return std::make_unique<UnknownOverBox>(bits);
            }
        }
        return std::make_unique<LinearSlip>(std::move(balls), std::move(middle), std::move(jets),
                                            slope_.symmetric && !tension_, question_);
    }

    [[nodiscard]] EvaluationCost cost() const override {
        const auto n = static_cast<double>(question_.terms);
        const double over = (load_.P ? 1500 : 500) + 6 * n * n * n * n;
        return slope_.symmetric && !tension_ ? EvaluationCost{over, 85, 340}
                                             : EvaluationCost{over, 600, 1700};
    }

private:
    template <class T>
    [[nodiscard]] std::optional<T> given(const std::optional<formula::Expr>& e,
                                         const std::vector<Ball>& at) const {
        return e ? std::optional<T>(ParameterValues<T>(question_.names, at)(*e)) : std::nullopt;
    }
    /// Makes the contact with its load, if that is given, and without its edges.
    template <class T>
    [[nodiscard]] SlippingContact<T> contact_of(const std::vector<Ball>& at) const {
        const ParameterValues<T> value(question_.names, at);
        SlippingContact<T> c;
        c.contact = linear_contact(slope_, load_.contact_modulus, value);
        c.force = load_.P ? value(*load_.P) : c.contact.constant(0);
        c.tension = given<T>(tension_, at);
        return c;
    }
    ParametricSlope slope_;
    ParametricLoad load_;
    std::optional<formula::Expr> tension_;
    ErrorQuestion question_;
};

} // namespace

std::unique_ptr<ErrorFamily> power_law_slip_errors(const formula::Expr& m,
                                                   const ErrorQuestion& question) {
    return std::make_unique<PowerLawSlipFamily>(m, question);
}

std::unique_ptr<ErrorFamily> linear_slip_errors(const ParametricSlope& slope,
                                                const ParametricLoad& load,
                                                const std::optional<formula::Expr>& tension,
                                                const ErrorQuestion& question) {
    return std::make_unique<LinearSlipFamily>(slope, load, tension, question);
}

} // namespace edgeproof::contact
