// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/scene/input/load_history.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/readers.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeproof::scene {

namespace {

using Layer = LoadHistory::Layer;

int sign_of_expr(const Expr& e) { return Exact(e).sign(); }
bool same(const Expr& x, const Expr& y) { return sign_of_expr(x - y) == 0; }

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
            entries_.push_back({Exact(P), layers_});
        } else if (grows > 0) {
            slip(P, Q, direction);
            entries_.push_back({Exact(P), {}});
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
    /// Returns the phases of the next step, in which the layers are consumed from outside
    /// (docs/histories.md, "The energy").
    [[nodiscard]] std::vector<LoadHistory::Phase> phases_to(const Expr& P, const Expr& Q) const {
        const int grows = sign_of_expr(P - P_);
        const Expr dP = grows == 0 ? zero_ : P - P_;
        const Expr dQ = Q - Q_;
        const int direction = sign_of_expr(dQ);
        if (grows > 0 && sign_of_expr((direction < 0 ? -dQ : dQ) - f_ * dP) <= 0) {
            return {};
        }
        std::vector<LoadHistory::Phase> phases;
        Expr left = Expr::number(Rational(1)); // the rest of the step
        Expr force = P_;
        Expr inner = P_;
        Expr limit = zero_; // the ratio of what slips
        for (std::size_t j = layers_.size(); j-- > 0;) {
            const Expr& ratio = layers_[j].ratio.expr();
            const Expr bottom = j > 0 ? layers_[j - 1].force.expr() : zero_;
            const bool slips = sign_of_expr(force - inner) > 0;
            if (!slips) {
                const int sign = grows > 0 ? direction : sign_of_expr(dQ - ratio * dP);
                if (sign == 0) { // P and Q decrease along the layer
                    const Expr rest = grows < 0 ? left + (force - bottom) / dP : zero_;
                    if (grows == 0 || sign_of_expr(rest) <= 0) {
                        break;
                    }
                    left = rest;
                    force = inner = bottom;
                    continue;
                }
                limit = sign > 0 ? f_ : -f_;
            }
            if (same(ratio, limit)) {
                inner = bottom; // it has this ratio already
                continue;
            }
            const Expr speed = (dQ - limit * dP) / (ratio - limit); // of `inner`
            enum class End { step, layer, contact };                // P may fall to `inner`
            End end = End::step;
            Expr time = left;
            const auto ends_at = [&](const Expr& t, End which) {
                if (is_less(t, time)) {
                    time = t;
                    end = which;
                }
            };
            ends_at((bottom - inner) / speed, End::layer);
            if (slips && sign_of_expr(speed - dP) > 0) {
                ends_at((force - inner) / (speed - dP), End::contact);
            }
            const Expr change = dQ - limit * dP;
            const Expr next_force = grows == 0 ? force : force + dP * time;
            const Expr next = end == End::layer     ? bottom
                              : end == End::contact ? next_force
                                                    : inner + speed * time;
            phases.push_back(phase(inner, next, force, next_force,
                                   (sign_of_expr(change) < 0 ? -change : change) * time));
            if (end == End::step) {
                break;
            }
            inner = next;
            force = next_force;
            left = left - time;
            j += end == End::layer ? 0 : 1; // the rest of the layer
        }
        return phases;
    }
    /// True if P, Q and the layers are those of the other state.
    [[nodiscard]] bool equals(const History& other) const {
        return same(P_, other.P_) && same(Q_, other.Q_) &&
               std::ranges::equal(layers_, other.layers_, [](const Layer& x, const Layer& y) {
                   return same(x.force.expr(), y.force.expr()) &&
                          same(x.ratio.expr(), y.ratio.expr());
               });
    }
    [[nodiscard]] LoadHistory state() const {
        LoadHistory state{layers_, stick_, {}, {}};
        for (const auto& [force, then] : entries_) {
            state.entries.push_back(
                {force, then ? std::optional(change_since(*then, force.expr())) : std::nullopt});
        }
        return state;
    }

private:
    using Layers = std::vector<Layer>;
    /// The force of an entry, and the layers at its end, unless the edges slipped.
    struct Entry {
        Exact force;
        std::optional<Layers> then;
    };

    [[nodiscard]] static LoadHistory::Phase phase(const Expr& inner_from, const Expr& inner_to,
                                                  const Expr& force_from, const Expr& force_to,
                                                  const Expr& change) {
        std::vector<Expr> cuts{inner_from, inner_to, force_from, force_to};
        std::ranges::sort(cuts, is_less);
        cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
        LoadHistory::Phase phase{Exact(inner_from), Exact(inner_to), Exact(force_from),
                                 Exact(force_to),   Exact(change),   {}};
        for (const Expr& cut : cuts) {
            phase.cuts.emplace_back(cut);
        }
        return phase;
    }
    void add(const Expr& force, const Expr& ratio) {
        if (!layers_.empty() && same(layers_.back().ratio.expr(), ratio)) {
            layers_.back().force = Exact(force);
        } else {
            layers_.push_back({Exact(force), Exact(ratio)});
        }
    }
    template <class List> void remove_above(List& list, const Expr& P) const {
        while (!list.empty() &&
               !is_less(list.size() > 1 ? list[list.size() - 2].force.expr() : zero_, P)) {
            list.pop_back();
        }
        if (!list.empty()) {
            list.back().force = Exact(P);
        }
    }
    /// Returns the ratios of today minus those of `then`, up to the force `end`.
    [[nodiscard]] Layers change_since(const Layers& then, const Expr& end) const {
        Layers change;
        const auto covers = [](const auto& layer, const Expr& L) {
            return is_less(L, layer->force.expr());
        };
        Expr from = zero_;
        for (auto old = then.begin(), now = layers_.begin(); is_less(from, end);) {
            const Exact& inner = covers(old, now->force.expr()) ? now->force : old->force;
            const Expr next = is_less(inner.expr(), end) ? inner.expr() : end;
            change.push_back({Exact(next), Exact(now->ratio.expr() - old->ratio.expr())});
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
            Q = Q + ratio.expr() * (force.expr() - from);
            from = force.expr();
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
        for (const Layer& layer : layers_) {
            const Expr& ratio = layer.ratio.expr();
            const Expr next = missing + (ratio - limit) * (layer.force.expr() - from);
            if (sign_of_expr(next) != sign) {
                stuck = from + missing / (limit - ratio);
                break;
            }
            kept.push_back(layer);
            missing = next;
            from = stuck = layer.force.expr();
        }
        if (is_less(from, stuck)) {
            kept.push_back({Exact(stuck), layers_[kept.size()].ratio});
        }
        layers_ = std::move(kept);
        add(P, limit);
        stick_ = Exact(stuck);
    }

    Expr f_;
    Expr zero_ = Expr::number(Rational(0));
    Expr P_ = Expr::number(Rational(0));
    Expr Q_ = Expr::number(Rational(0));
    Layers layers_;
    std::vector<Entry> entries_;
    std::optional<Exact> stick_;
};

constexpr long most_cycles = 1000;

} // namespace

LoadHistory history_after(const std::vector<LoadStep>& steps, std::size_t count, std::size_t pass,
                          const Exact& friction, const std::string& file) {
    History history(friction);
    const bool whole_pass = pass > 0 && count >= pass && (steps.size() - count) % pass == 0;
    const std::size_t recorded = count - (whole_pass ? pass : 1); // the first step with phases
    std::optional<History> begin;                                 // of the last pass
    std::vector<LoadHistory::Phase> step_phases;
    std::vector<LoadHistory::Phase> pass_phases;
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
        if (i == recorded) {
            begin = history;
        }
        if (i >= recorded) {
            step_phases = history.phases_to(step.P.expr(), Q);
            pass_phases.insert(pass_phases.end(), step_phases.begin(), step_phases.end());
        }
        history.step(step.P.expr(), Q);
    }
    LoadHistory state = history.state();
    state.step = std::move(step_phases);
    if (whole_pass) {
        state.pass = std::move(pass_phases);
        state.steady = history.equals(*begin);
    }
    return state;
}

void read_steps(const io::TomlSection& top, Scene& scene) {
    const std::vector<io::TomlSection> sections = top.sections_or_none("step");
    std::size_t first = sections.size(); // the step with `cycles`
    std::size_t cycles = 1;
    LoadStep now;
    const auto read = [&](const io::TomlSection& section) {
        for (const auto& [key, member] :
             {std::pair{"P", &LoadStep::P}, std::pair{"Q", &LoadStep::Q},
              std::pair{"bulk_tension", &LoadStep::bulk_tension}}) {
            if (section.has(key)) {
                now.*member = contact_constant(section, key);
                (void)sign_of(section, key, now.*member);
            }
        }
        now.line = section.line();
        scene.steps.push_back(now);
    };
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const io::TomlSection& section = sections[i];
        section.allow({"P", "Q", "bulk_tension", "cycles"});
        if (section.has("cycles")) {
            section.require(first >= i, "cycles", "cycles is given in two steps", "give it in one");
            first = i;
            cycles = section.count("cycles", 1, most_cycles);
        }
        read(section);
    }
    scene.pass = sections.size() - first;
    for (std::size_t k = 1; k < cycles; ++k) {
        std::for_each(sections.begin() + static_cast<std::ptrdiff_t>(first), sections.end(), read);
    }
}

void set_step(Scene& scene, std::size_t count) {
    const LoadStep& last = scene.steps.at(count - 1);
    const auto none = [](const LoadStep& step) {
        return step.Q.sign() == 0 && step.bulk_tension.sign() == 0;
    };
    const auto reject = [&](const std::string& problem, const std::string& instead) {
        throw InputError("step " + std::to_string(count) + ": " + problem, instead)
            .at(scene.file, last.line);
    };
    scene.load_line = last.line;
    scene.step = count;
    scene.history.reset();
    if (last.P.sign() <= 0) {
        reject("there is no contact: P = " + last.P.text(), "give P > 0");
    }
    change_given(scene, [&](Scene& s) { s.load = Load::force(last.P); });
    const auto begin = scene.steps.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    if (std::all_of(begin, end, none)) {
        if (scene.shear && scene.shear->bulk_A.sign() != 0) {
            reject("bulk_A is given, but no shear load", "leave bulk_A out, or add Q to a step");
        }
        scene.shear.reset();
        scene.ask.quantities.erase(QuantityGroup::shear);
        scene.ask.quantities.erase(QuantityGroup::slip);
        return;
    }
    if (!scene.shear || !scene.shear->friction) {
        reject("a shear load of a history needs a friction", "add [shear] with friction = \"0.6\"");
    }
    scene.shear->Q = last.Q;
    scene.shear->bulk_tension = last.bulk_tension;
    if (std::any_of(begin, end, [](const LoadStep& s) { return s.bulk_tension.sign() != 0; })) {
        const bool once = count > 1 && std::all_of(begin, end - 1, none) &&
                          Exact(last.P.expr() - (end - 2)->P.expr()).sign() == 0;
        if (!once || last.Q.sign() == 0) {
            reject("a bulk tension is computed only where it is applied once, together with Q, in "
                   "the last step and at constant P: the zones of slip that it changes are no "
                   "superposition",
                   "apply P first, then Q and bulk_tension in one step, and ask for the state "
                   "after it");
        }
        return;
    }
    scene.history =
        history_after(scene.steps, count, scene.pass, *scene.shear->friction, scene.file);
}

void change_steps(Scene& scene, const std::function<void(LoadStep&)>& change) {
    std::ranges::for_each(scene.steps, change);
    set_step(scene, scene.step);
}

} // namespace edgeproof::scene
