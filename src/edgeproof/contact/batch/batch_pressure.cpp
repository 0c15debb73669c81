// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/batch/batch_pressure.hpp"

#include "edgeproof/contact/batch/batch_integral.hpp"
#include "edgeproof/contact/batch/batch_power_law.hpp"
#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::contact {
namespace {

constexpr unsigned batch_guard_digits = 10;

/// Returns the number of digits that the 64-bit words needed for `digits` digits hold: these cost
/// no more.
unsigned whole_words(unsigned digits) {
    const unsigned long bits = boost::multiprecision::detail::digits10_2_2(digits);
    const unsigned long filled = (bits + 63) / 64 * 64;
    unsigned more = digits;
    while (boost::multiprecision::detail::digits10_2_2(more + 1) <= filled) {
        ++more;
    }
    return more;
}

Real modulus_of(const NormalContact& contact, unsigned digits) {
    const PrecisionScope scope(digits + 2 * batch_guard_digits);
    return contact.contact_modulus().to<Real>();
}

} // namespace

/// The integrals are those of docs/pressure.md; batch_integral.hpp and batch_power_law.hpp have
/// them.
struct BatchPressure::Contact {
    Contact(const Profile& profile, const Real& modulus, const Extent<Real>& given, unsigned digits,
            Rule rule)
        : extent(given), symmetric(profile.symmetric()) {
        const bool power =
            profile.kind() == Profile::Kind::power_law && !profile.piecewise_linear();
        working =
            whole_words(digits + batch_guard_digits +
                        (power ? BatchPowerLaw::lost_digits(profile.parameters().at("m")) : 0));
        const PrecisionScope scope(working);
        if (power) {
            const ContactLaw<Real> law(profile, at_working_precision(modulus));
            const Real a = at_working_precision(given.a);
            power_law.emplace(profile.parameters().at("m"), law.force_rate({a, a}), a, digits,
                              rule);
        } else {
            integral.emplace(profile, at_working_precision(modulus), given, digits, rule);
        }
    }

    unsigned working = 0;
    Extent<Real> extent;
    bool symmetric;
    std::optional<BatchPowerLaw> power_law;
    std::optional<BatchIntegral> integral;
};

BatchPressure::BatchPressure(const NormalContact& contact, unsigned digits, Rule rule)
    : BatchPressure(contact.profile(), modulus_of(contact, digits),
                    Extent<Real>{contact.a(), contact.b()}, digits, rule) {}

BatchPressure::BatchPressure(const Profile& profile, const Real& contact_modulus,
                             const Extent<Real>& e, unsigned digits, Rule rule)
    : contact_(std::make_unique<Contact>(profile, contact_modulus, e, digits, rule)) {}

BatchPressure::~BatchPressure() = default;
BatchPressure::BatchPressure(BatchPressure&&) noexcept = default;
BatchPressure& BatchPressure::operator=(BatchPressure&&) noexcept = default;

RoutedPressure<Real> BatchPressure::operator()(const Point<Real>& at) const {
    const PrecisionScope scope(contact_->working);
    if (!(at.right > 0) || !(at.left > 0)) {
        throw DomainError("a point lies outside the contact");
    }
    if (contact_->power_law) {
        return (*contact_->power_law)(at);
    }
    return (*contact_->integral)(at);
}

RoutedPressure<Real> BatchPressure::operator()(Edge edge, const Real& u) const {
    const PrecisionScope scope(std::max(u.precision(), contact_->extent.a.precision()));
    return (*this)(point_at(contact_->extent, edge, u));
}

} // namespace edgeproof::contact
