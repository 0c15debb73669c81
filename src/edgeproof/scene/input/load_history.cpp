// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/input/load_history.hpp"

#include "edgeproof/precision/error.hpp"

#include <utility>

namespace edgeproof::scene {
namespace {

using formula::Exact;
using formula::Expr;

int sign_of_expr(const Expr& e) { return Exact(e).sign(); }

class History {
public:
    explicit History(const Exact& friction) : f_(friction.expr()) {}

    void step(const Expr& P, const Expr& Q) {
        const Expr dP = P - P_;
        const Expr dQ = Q - Q_;
        const int grows = sign_of_expr(dP);
        const int direction = sign_of_expr(dQ);
        stick_.reset();
        const Expr excess = (direction < 0 ? -dQ : dQ) - f_ * dP;
        if (grows > 0 && sign_of_expr(excess) <= 0) {
            add(P, dQ / dP); // every new place sticks from its first contact
            entries_.push_back({P, layers_});
        } else if (grows > 0) {
            slip(P, Q, direction);
            entries_.push_back({P, {}});
        } else {
            remove_above(layers_, P);
            remove_above(entries_, P);
            const int sign = sign_of_expr(Q - carried());
            if (sign != 0) {
                slip(P, Q, sign);
            }
        }
        P_ = P;
        Q_ = Q;
    }
    [[nodiscard]] LoadHistory state() const {
        LoadHistory state;
        for (const auto& [force, ratio] : layers_) {
            state.layers.push_back({Exact(force), Exact(ratio)});
        }
        if (stick_) {
            state.stick = Exact(*stick_);
        }
        for (const auto& [force, then] : entries_) {
            state.entries.push_back(
                {Exact(force), then ? std::optional(change_since(*then, force)) : std::nullopt});
        }
        return state;
    }

private:
    using Layers = std::vector<std::pair<Expr, Expr>>; ///< force, ratio
    /// Of each entry: its force, and the layers at its end, unless the edges slipped.
    using Entries = std::vector<std::pair<Expr, std::optional<Layers>>>;

    void add(const Expr& force, const Expr& ratio) {
        if (!layers_.empty() && sign_of_expr(layers_.back().second - ratio) == 0) {
            layers_.back().first = force;
        } else {
            layers_.emplace_back(force, ratio);
        }
    }
    template <class List> void remove_above(List& list, const Expr& P) const {
        while (!list.empty() &&
               sign_of_expr((list.size() > 1 ? list[list.size() - 2].first : zero_) - P) >= 0) {
            list.pop_back();
        }
        if (!list.empty()) {
            list.back().first = P;
        }
    }
    /// Returns the ratios of today minus those of `then`, up to the force `end`.
    [[nodiscard]] std::vector<LoadHistory::Layer> change_since(const Layers& then,
                                                               const Expr& end) const {
        std::vector<LoadHistory::Layer> change;
        const auto covers = [](const auto& layer, const Expr& L) {
            return sign_of_expr(layer->first - L) > 0;
        };
        Expr from = zero_;
        for (auto old = then.begin(), now = layers_.begin(); sign_of_expr(end - from) > 0;) {
            const Expr& inner = covers(old, now->first) ? now->first : old->first;
            const Expr next = sign_of_expr(inner - end) < 0 ? inner : end;
            change.push_back({Exact(next), Exact(now->second - old->second)});
            from = next;
            old += covers(old, from) ? 0 : 1;
            now += covers(now, from) ? 0 : 1;
        }
        return change;
    }
    /// Returns the shear force of the layers.
    [[nodiscard]] Expr carried() const {
        Expr Q = zero_;
        Expr from = zero_;
        for (const auto& [force, ratio] : layers_) {
            Q = Q + ratio * (force - from);
            from = force;
        }
        return Q;
    }
    /// Sets the ratio to sign f between the force L_s and P, such that the whole carries Q: the
    /// missing force decreases from f P - sign Q at L_s = 0 (docs/histories.md, "A step").
    void slip(const Expr& P, const Expr& Q, int sign) {
        const Expr limit = sign > 0 ? f_ : -f_;
        Expr missing = limit * P - Q; // times the sign: positive
        Expr from = zero_;
        Layers kept;
        Expr stuck = zero_;
        for (const auto& [force, ratio] : layers_) {
            const Expr next = missing + (ratio - limit) * (force - from);
            if (sign_of_expr(next) != sign) {
                stuck = from + missing / (limit - ratio);
                break;
            }
            kept.emplace_back(force, ratio);
            missing = next;
            from = stuck = force;
        }
        if (sign_of_expr(stuck - from) > 0) {
            kept.emplace_back(stuck, layers_[kept.size()].second);
        }
        layers_ = std::move(kept);
        add(P, limit);
        stick_ = stuck;
    }

    Expr f_;
    Expr zero_ = Expr::number(Rational(0));
    Expr P_ = Expr::number(Rational(0));
    Expr Q_ = Expr::number(Rational(0));
    Layers layers_;
    Entries entries_;
    std::optional<Expr> stick_;
};

} // namespace

LoadHistory history_after(const std::vector<LoadStep>& steps, std::size_t count,
                          const formula::Exact& friction, const std::string& file) {
    History history(friction);
    for (std::size_t i = 0; i < count; ++i) {
        const LoadStep& step = steps[i];
        const std::string name = "step " + std::to_string(i + 1);
        if (step.P.sign() <= 0) {
            throw InputError(name + " ends without contact: P = " + step.P.text(), "give P > 0")
                .at(file, step.line);
        }
        const Expr& Q = step.Q.expr();
        const Expr size = step.Q.sign() < 0 ? -Q : Q;
        if (sign_of_expr(size - friction.expr() * step.P.expr()) >= 0) {
            throw InputError(name + " lets the contact slide: Q = " + step.Q.text() +
                                 ", P = " + step.P.text() + ", f = " + friction.text(),
                             "give |Q| < f P at the end of each step")
                .at(file, step.line);
        }
        history.step(step.P.expr(), Q);
    }
    return history.state();
}

} // namespace edgeproof::scene
