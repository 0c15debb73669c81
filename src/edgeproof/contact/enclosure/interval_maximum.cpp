// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/contact/enclosure/interval_maximum.hpp"

#include "edgeproof/precision/interruption.hpp"

namespace edgeproof::contact {
namespace {

/// The pressure as a function of the distance from the right edge.
class PressureFromEdge {
public:
    explicit PressureFromEdge(const ProvedContact& contact) : contact_(contact) {}
    [[nodiscard]] long bits() const { return contact_.bits(); }
    [[nodiscard]] Ball value(const Ball& u) const { return contact_.pressure(Edge::right, u); }
    [[nodiscard]] Ball bound(const Rational& lo, const Rational& hi) const {
        return value(Ball::hull(Ball(lo, bits()), Ball(hi, bits())));
    }
    [[nodiscard]] static Rational between(const Rational& lo, const Rational& hi) {
        return middle(lo, hi);
    }
    [[nodiscard]] Ball slope(const Ball& u) const {
        return contact_.pressure_series(Edge::right, u, 2)[1];
    }
    [[nodiscard]] Ball bend(const Ball& u) const {
        return contact_.pressure_series(Edge::right, u, 3)[2] * 2;
    }
    [[nodiscard]] bool count() const {
        constexpr std::size_t most_evaluations = 20'000;
        check_interruption();
        spent_ += contact_.cost();
        return spent_ < most_evaluations;
    }

private:
    const ProvedContact& contact_;
    mutable std::size_t spent_ = 0;
};

} // namespace

Ball enclosed_peak(const ProvedContact& contact, bool symmetric) {
    // The second half of a symmetric contact is the mirror image of the first.
    const Ball end = symmetric ? Ball(contact.length() / 2) : contact.length();
    return greatest_on_interval(PressureFromEdge(contact), exact_value(end.upper()), 32,
                                symmetric ? std::optional(contact.length() / 2) : std::nullopt)
        .value;
}

} // namespace edgeproof::contact
