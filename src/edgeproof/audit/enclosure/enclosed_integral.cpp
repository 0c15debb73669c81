// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/enclosure/enclosed_integral.hpp"
#include "edgeproof/audit/enclosure/contact_formulas.hpp"
#include "edgeproof/audit/enclosure/integrand.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>
#include <unordered_map>

namespace edgeproof::audit {
namespace {

using Centre = Integrand::Centre;

struct PieceEnd {
    Expr written;
    Ball at;
    bool of_contacts = false; ///< P1of and bof change their formula there
    Ball angle = {};          ///< on a path
};

const Ball& position(const PieceEnd& end, bool by_angle) { return by_angle ? end.angle : end.at; }

class EnclosedIntegral {
public:
    EnclosedIntegral(const Expr& node, const IntegralSurroundings& around, unsigned digits)
        : f_(node.arg(0)), variable_(node.arg(1).name()), around_(around), digits_(digits),
          lowest_(end_at(resolved(node.arg(2)))), highest_(end_at(resolved(node.arg(3)))),
          downwards_(certainly_less(highest_.at, lowest_.at)) {
        if (downwards_) {
            std::swap(lowest_, highest_);
        }
        if (node.kind() == Expr::Kind::pv) {
            pole_ = node.arg(4);
        }
    }

    [[nodiscard]] Ball value() {
        if (!downwards_ && surely_zero(highest_.written - lowest_.written, around_.law)) {
            return Ball(0, around_.bits);
        }
        if (!certainly_less(lowest_.at, highest_.at)) {
            throw BudgetError("the ends of an integral that are not distinguished");
        }
        const Ball value = real_part(whole());
        return downwards_ ? -value : value;
    }

    [[nodiscard]] bool diverges() {
        if (pole_ || !certainly_less(lowest_.at, highest_.at)) {
            return false;
        }
        const std::vector<PieceEnd> ends = ends_of_pieces();
        return diverges_at(lowest_, ends[1], 1) || diverges_at(highest_, ends[ends.size() - 2], -1);
    }

private:
    [[nodiscard]] bool diverges_at(const PieceEnd& end, const PieceEnd& next, int direction) {
        Integrand f(f_, variable_, meaning((end.at + next.at) / 2, false), around_.bits);
        f.centre(end.written, end.at, direction, {}, Centre::rooted);
        // f = v^k w with v^n = the distance and w continuous: it is integrable if k/n > -1.
        const Integrand::Leading at_end = f.leading(Box(around_.bits));
        return at_end.power <= -f.power() && at_end.factor.is_finite() &&
               !at_end.factor.contains_zero();
    }
    static Ball real_part(const Box& sum) {
        Ball value = sum.real();
        if (!sum.may_be_real()) {
            arb_indeterminate(value.data()); // a root of a value that is negative somewhere
        }
        return value;
    }

    /// Resolves max and min if the balls decide them.
    [[nodiscard]] Expr resolved(const Expr& e) {
        const bool greater = e.builtin() == formula::Builtin::max;
        if ((!greater && e.builtin() != formula::Builtin::min) || e.args().size() != 2) {
            return e;
        }
        const Ball x = number(e.arg(0));
        const Ball y = number(e.arg(1));
        if (overlaps(x, y)) {
            return e;
        }
        return resolved(certainly_less(x, y) == greater ? e.arg(1) : e.arg(0));
    }

    [[nodiscard]] Ball number(const Expr& e) {
        if (const auto it = numbers_.find(e); it != numbers_.end()) {
            return it->second;
        }
        Ball value = around_.value(e);
        numbers_.emplace(e, value);
        return value;
    }

    [[nodiscard]] PieceEnd end_at(const Expr& written) { return {written, number(written)}; }

    [[nodiscard]] const ContactFormulas& contact(const Expr& call) const {
        if (around_.contact == nullptr) {
            throw Error("'" + call.name() + "' has no enclosure inside an integral");
        }
        return *around_.contact;
    }

    [[nodiscard]] Box whole() {
        if (pole_ && (certainly_less(number(*pole_), lowest_.at) ||
                      certainly_less(highest_.at, number(*pole_)))) {
            pole_.reset(); // an ordinary integral
        }
        if (pole_ && !(certainly_less(lowest_.at, number(*pole_)) &&
                       certainly_less(number(*pole_), highest_.at))) {
            throw BudgetError("a pole that is not shown to be inside the interval");
        }
        if (around_.contact != nullptr && holds_pressure(f_, variable_)) {
            if (const auto above = over_the_contact()) {
                return *above;
            }
        }
        const std::vector<PieceEnd> ends = ends_of_pieces();
        Box sum(around_.bits);
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            sum = sum + piece(ends[i], ends[i + 1]);
            if (!sum.is_finite()) {
                break;
            }
        }
        return sum;
    }

    /// Evaluates a linear function of the variable at a place.
    [[nodiscard]] Ball linear_at(const Expr& argument, const Ball& place) {
        const auto line = contact::as_linear(argument, variable_);
        if (!line) {
            throw Error("an argument that is not linear has no enclosure inside an integral");
        }
        return number(line->at_origin) + number(line->rate) * place;
    }

    /// Evaluates a contact's right edge, which must lie to the right of the origin from one end of
    /// the integral to the other.
    [[nodiscard]] Ball right_edge_at(const Expr& argument, const Ball& place) {
        for (const Ball* end : {&lowest_.at, &highest_.at}) {
            const Ball edge = linear_at(argument, *end);
            if (!certainly_positive(edge) && arb_is_zero(edge.data()) == 0) {
                throw Error("a contact's edge that may not be positive inside an integral");
            }
        }
        return linear_at(argument, place);
    }

    /// Returns the ends of the interval and the cuts between them, in ascending order.
    [[nodiscard]] std::vector<PieceEnd> ends_of_pieces() {
        if (around_.contact == nullptr) {
            return {lowest_, highest_};
        }
        std::vector<PieceEnd> inside;
        const auto same = [&](const PieceEnd& x, const Expr& e, const Ball& at) {
            if (!overlaps(x.at, at)) {
                return false;
            }
            if (x.written == e || surely_zero(x.written - e, around_.law)) {
                return true;
            }
            throw BudgetError("places where an integrand changes that are not distinguished");
        };
        for (const IntegrandCut& cut : integrand_cuts(f_, variable_, *around_.contact)) {
            const Ball at = number(cut.at);
            if (same(lowest_, cut.at, at) || same(highest_, cut.at, at)) {
                continue;
            }
            const auto known = std::ranges::find_if(
                inside, [&](const PieceEnd& x) { return same(x, cut.at, at); });
            if (known != inside.end()) {
                known->of_contacts = known->of_contacts || cut.of_contacts;
            } else if (certainly_less(lowest_.at, at) && certainly_less(at, highest_.at)) {
                inside.push_back({cut.at, at, cut.of_contacts});
            }
        }
        std::ranges::sort(inside, [](const PieceEnd& x, const PieceEnd& y) {
            return certainly_less(x.at, y.at);
        });
        inside.insert(inside.begin(), lowest_);
        inside.push_back(highest_);
        return inside;
    }

    /// Returns the functions of the contact near `place`.
    [[nodiscard]] IntegrandMeaning meaning(const Ball& place, bool above) {
        IntegrandMeaning m;
        m.constant = [this](const Expr& e) { return number(e); };
        m.rational = around_.rational;
        m.surely_zero = [this](const Expr& e) { return surely_zero(e, around_.law); };
        m.written_out = [this, place, above](const Expr& e) {
            const bool size = is_size_of_slope(e);
            const Expr& f = size ? e.arg(0) : e;
            const ContactFormulas& formulas = contact(f);
            std::optional<Expr> out;
            if (f.name() == "g1") {
                out = formulas.slope(f.arg(0), linear_at(f.arg(0), place), size);
            } else if (f.name() == "P1of") {
                out = formulas.force_rate(f.arg(0), right_edge_at(f.arg(0), place));
            } else if (f.name() == "bof") {
                out = formulas.left_edge(f.arg(0), right_edge_at(f.arg(0), place));
            } else if (f.name() == "q") {
                out = ContactFormulas::traction(f.arg(0));
            } else if (f.name() == "p" && above) {
                out = formulas.pressure_above(f.arg(0));
            } else if (f.name() == "p") {
                out = formulas.power_law_pressure(f.arg(0), linear_at(f.arg(0), place));
            }
            if (!out) {
                throw Error("'" + f.name() + "' has no enclosure inside an integral");
            }
            return *out;
        };
        return m;
    }

    [[nodiscard]] Box piece(PieceEnd from, PieceEnd to) {
        const Ball place = (from.at + to.at) / 2;
        IntegrandMeaning m = meaning(place, false);
        std::optional<TiltedPath> path;
        const auto argument = contact_argument(f_, variable_);
        if (argument && around_.contact != nullptr) {
            path = around_.contact->path(linear_at(*argument, place));
            if (path) {
                m.path = &*path;
                m.path_argument = argument;
                const bool upwards =
                    certainly_positive(number(contact::as_linear(*argument, variable_)->rate));
                from.angle = angle_of(from, *argument, *path, upwards);
                to.angle = angle_of(to, *argument, *path, !upwards);
            }
        }
        Integrand f(f_, variable_, std::move(m), around_.bits);
        if (f.vanishes()) {
            return Box(around_.bits);
        }
        if (!pole_) {
            return by_ends(f, from, to, path.has_value());
        }
        const Ball pole = number(*pole_);
        if (certainly_less(pole, from.at) || certainly_less(to.at, pole)) {
            return by_ends(f, from, to, path.has_value());
        }
        if (path || !certainly_less(from.at, pole) || !certainly_less(pole, to.at)) {
            throw BudgetError(
                "a pole that is not distinguished from a place where the integrand changes");
        }
        return over_pole(f, {*pole_, pole}, from, to);
    }

    /// Integrates from the centre to v; half the piece, or all of it.
    Box from_centre(Integrand& f, const Ball& near, const Ball& far) const {
        const auto root_of_distance = [&](const Ball& x) {
            Ball v(0, around_.bits);
            if (arb_is_zero(x.data()) != 0) {
                return Box(v); // Arb does not take the root of zero
            }
            arb_root_ui(v.data(), x.data(), static_cast<ulong>(f.power()), around_.bits);
            return Box(v);
        };
        return line_integral(f, root_of_distance(near), root_of_distance(far), digits_);
    }

    /// Returns the end at which to centre: that of the piece, or that of the whole integral if it
    /// is near enough for its singularity to matter.
    std::optional<PieceEnd> singular_end(Integrand& f, const PieceEnd& end,
                                         const PieceEnd& outermost, int direction,
                                         const Ball& length, bool by_angle) const {
        f.centre(end.written, end.at, direction, end.angle, Centre::rooted);
        if (f.power() > 1) {
            return end;
        }
        if (by_angle || !certainly_less(abs(end.at - outermost.at) * 10, length)) {
            return std::nullopt;
        }
        f.centre(outermost.written, outermost.at, direction, outermost.angle, Centre::rooted);
        return f.power() > 1 ? std::optional(outermost) : std::nullopt;
    }

    Box by_ends(Integrand& f, const PieceEnd& from, const PieceEnd& to, bool by_angle) const {
        const Ball start = position(from, by_angle);
        const Ball stop = position(to, by_angle);
        const Ball length = abs(stop - start);
        const auto right = singular_end(f, to, highest_, -1, length, by_angle);
        const auto left = singular_end(f, from, lowest_, 1, length, by_angle);
        const Ball middle = left && right ? (start + stop) / 2 : left ? stop : start;
        Box sum(around_.bits);
        const auto add = [&](const PieceEnd& end, const Ball& near) {
            const Ball& at = position(end, by_angle);
            sum = sum + from_centre(f, distance(at, near), distance(at, middle));
        };
        if (left) {
            add(*left, start);
        }
        if (right) {
            f.centre(right->written, right->at, -1, right->angle, Centre::rooted);
            add(*right, stop);
        }
        if (!left && !right) {
            f.centre(from.written, from.at, 1, from.angle, Centre::regular);
            sum = from_centre(f, Ball(0, around_.bits), length);
        }
        return sum;
    }

    /// Returns zero for the distance of a place from itself, even if the ball is wide.
    Ball distance(const Ball& x, const Ball& y) const {
        return arb_equal(x.data(), y.data()) != 0 ? Ball(0, around_.bits) : abs(y - x);
    }

    Box over_pole(Integrand& f, const PieceEnd& pole, const PieceEnd& from,
                  const PieceEnd& to) const {
        f.centre(pole.written, pole.at, 1, {}, Centre::pole);
        Ball r(min(pole.at - from.at, to.at - pole.at).midpoint(), around_.bits);
        for (int k = 0; k < 16; ++k) {
            r /= 2;
            const Ball across = r * Ball::from_interval(Real(-1), Real(1), around_.bits);
            const Integrand::Leading without = f.leading(Box(across, across));
            if (without.power != -1 || !without.factor.is_finite()) {
                continue;
            }
            const Ball zero(0, around_.bits);
            const Box top(zero, r);
            Box sum = line_integral(f, Box(-r), top, digits_) +
                      line_integral(f, top, Box(r), digits_) +
                      f.leading(Box(around_.bits)).factor * Box(zero, Ball::pi(around_.bits));
            const Expr unnamed = Expr::symbol("a place inside"); // not a name in any text
            const PieceEnd before{unnamed, pole.at - r};
            const PieceEnd behind{unnamed, pole.at + r};
            sum = sum + by_ends(f, from, before, false);
            return sum + by_ends(f, behind, to, false);
        }
        throw Error("the pole of a principal value is not shown to be a simple one");
    }

    /// `first`: the end with the least angle on the path.
    [[nodiscard]] Ball angle_of(const PieceEnd& end, const Expr& argument, const TiltedPath& path,
                                bool first) {
        if (end.of_contacts) {
            return first ? Ball(0, around_.bits) : path.end_of_flat();
        }
        const Expr s = substitute(argument, variable_, end.written);
        return path.angle_of(number(s), number(Expr::call("bof", {s})));
    }

    /// Integrates above the contact, from its left end to its right end. Returns nothing if the
    /// integrand does not have this form.
    [[nodiscard]] std::optional<Box> over_the_contact() {
        Expr over = f_;
        if (pole_) {
            const Expr behind = Expr::symbol(variable_) - *pole_;
            if (f_.kind() != Expr::Kind::div || !(f_.arg(1) == behind)) {
                return std::nullopt;
            }
            over = f_.arg(0);
        }
        if (degree_in_pressure(over, variable_) != 1 ||
            !around_.contact->pressure_above(Expr::symbol(variable_))) {
            return std::nullopt;
        }
        if (!surely_zero(highest_.written - Expr::symbol("a"), around_.law) ||
            !surely_zero(lowest_.written + Expr::symbol("b"), around_.law)) {
            return std::nullopt;
        }
        const long bits = around_.bits;
        Integrand f(f_, variable_, meaning((lowest_.at + highest_.at) / 2, true), bits);
        const Ball half((highest_.at - lowest_.at).midpoint(), bits);
        const Box top(Ball((lowest_.at + highest_.at).midpoint(), bits) / 2, half / 2);
        Box sum(bits);
        if (pole_) {
            const Ball pole = number(*pole_);
            f.centre(*pole_, pole, 1, {}, Integrand::Centre::pole);
            const Integrand::Leading without = f.leading(Box(bits));
            if (without.power != -1) {
                return std::nullopt;
            }
            sum = without.factor * Box(Ball(0, bits), Ball::pi(bits));
        }
        const auto from_end = [&](const PieceEnd& end, int direction) {
            f.centre(end.written, end.at, direction, {}, Integrand::Centre::rooted);
            if (f.power() % 2 != 0) {
                throw Error("a pressure without a root at the edge");
            }
            Box v = direction > 0 ? top - end.at : end.at - top;
            acb_root_ui(v.get(), v.get(), static_cast<ulong>(f.power()), bits);
            return line_integral(f, Box(bits), v, digits_);
        };
        sum = sum + from_end(lowest_, 1);
        sum = sum + from_end(highest_, -1);
        return Box(sum.real());
    }

    Expr f_;
    std::string variable_;
    const IntegralSurroundings& around_;
    unsigned digits_;
    std::unordered_map<Expr, Ball, formula::ExprHash> numbers_;
    std::optional<Expr> pole_;
    PieceEnd lowest_;
    PieceEnd highest_;
    bool downwards_; ///< the upper limit is less than the lower one
};

} // namespace

Ball enclosed_integral(const Expr& node, const IntegralSurroundings& around, unsigned digits) {
    return EnclosedIntegral(node, around, digits).value();
}

bool certainly_divergent(const Expr& node, const IntegralSurroundings& around) {
    return EnclosedIntegral(node, around, 1).diverges();
}

} // namespace edgeproof::audit
