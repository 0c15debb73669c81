// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/contact/routes/shear_traction.hpp"

#include "edgeproof/precision/error.hpp"

#include <algorithm>

namespace edgeproof::contact {
namespace {

/// The guard digits of a NormalContact, of twenty, that are left for the cancellation here.
constexpr unsigned spare_digits = 8;
constexpr unsigned most_lost = 400;

/// A sum of two terms, and the size to which its roundoff is relative.
struct Sum {
    Real value;
    Real size;
};

unsigned digits_lost(const Sum& s) {
    if (s.size == 0) {
        return 0;
    }
    const Real ratio = abs(s.value) / s.size;
    if (ratio == 0) {
        return most_lost + 1;
    }
    const Real lost = -log10(ratio);
    return lost > most_lost ? most_lost + 1 : lost > 0 ? static_cast<unsigned>(ceil(lost)) : 0;
}

} // namespace

ShearTraction::ShearTraction(const NormalContact& contact, ShearSpec spec, Work* work)
    : contact_(contact), spec_(std::move(spec)), work_(work) {
    if (spec_.path == LoadingPath::together && spec_.bulk_tension.sign() != 0) {
        throw InputError("P and Q grow together under a bulk tension of " +
                             spec_.bulk_tension.text(),
                         "give bulk_tension = \"0\": only then is q = (Q/P) p");
    }
}

const Real& ShearTraction::force() const {
    if (!force_) {
        force_ = contact_.force();
    }
    return *force_;
}

const NormalContact& ShearTraction::finer(unsigned extra) const {
    if (extra == 0) {
        return contact_;
    }
    auto& slot = finer_[extra];
    if (!slot) {
        slot =
            std::make_unique<NormalContact>(Profile(contact_.profile()), contact_.contact_modulus(),
                                            contact_.load(), contact_.digits() + extra);
    }
    return *slot;
}

/// `at(contact)` returns a Sum at the precision of that contact. Digits are added until they make
/// up for those that cancelled.
template <class At> EstimatedTraction ShearTraction::escalated(const At& at) const {
    unsigned extra = 0;
    for (;;) {
        const NormalContact& contact = finer(extra);
        const unsigned working = contact.a().precision();
        const PrecisionScope scope(working);
        const Sum s = at(contact);
        const unsigned lost = digits_lost(s);
        const Real roundoff =
            s.size * pow(Real(10), -static_cast<int>(contact.digits() + spare_digits + 2));
        if (lost <= spare_digits + extra) {
            return {s.value, roundoff, working};
        }
        if (extra == most_lost) {
            return {Real(0), std::max(roundoff, Real(abs(s.value))), working};
        }
        // In steps of 16 digits, so that neighbouring points share a solved contact.
        extra = std::min(most_lost, (lost + 15) / 16 * 16);
    }
}

EstimatedTraction ShearTraction::similar_to(const Estimated& pressure) const {
    count(work_, &Counts::shear_points);
    const PrecisionScope scope(pressure.working_digits);
    // q = (Q/P) p (docs/shear.md, "P and Q in proportion").
    const Real q = spec_.Q.to<Real>() / force() * pressure.value;
    return {q, Real(abs(q) * pressure.estimate), pressure.working_digits};
}

std::vector<EstimatedTraction> ShearTraction::similar_to(const std::vector<Real>& c) const {
    count(work_, &Counts::shear_expansions);
    const unsigned working = contact_.a().precision();
    const PrecisionScope scope(working);
    const Real factor = spec_.Q.to<Real>() / force();
    const Real relative = pow(Real(10), -static_cast<int>(contact_.digits() + spare_digits));
    std::vector<EstimatedTraction> s;
    s.reserve(c.size());
    for (const Real& x : c) {
        s.push_back({Real(factor * x), Real(abs(Real(factor * x)) * relative), working});
    }
    return s;
}

EstimatedTraction ShearTraction::traction(Edge edge, const Exact& u) const {
    if (spec_.path == LoadingPath::together) {
        return similar_to(contact_.pressure(edge, u));
    }
    count(work_, &Counts::shear_points);
    return escalated([&](const NormalContact& contact) {
        const Extent<Real> e{contact.a(), contact.b()};
        const Point<Real> at = point_at(e, edge, u.to<Real>());
        const Real Q = spec_.Q.to<Real>();
        const Real tension = spec_.bulk_tension.to<Real>();
        // Near the other edge the distance from it has lost digits as well; they count as
        // cancelled.
        const Real other = edge == Edge::right ? at.left : at.right;
        // moore-hills EQ34 with the sizes of both terms.
        const Real size = (abs(Q) / pi<Real>() + abs(tension) * e.length() / 8) /
                          sqrt(Real(at.right * at.left)) *
                          (other < e.length() / 100 ? Real(e.length() / other) : Real(1));
        return Sum{full_stick_traction(at, ShearLoad<Real>{Q, tension}), size};
    });
}

EstimatedTraction ShearTraction::traction(Edge edge, const Real& u) const {
    Rational exact;
    mpfr_get_q(exact.backend().data(), u.backend().data());
    return traction(edge, Exact::of(exact));
}

std::vector<EstimatedTraction> ShearTraction::expansion(Edge edge, std::size_t terms) const {
    if (spec_.path == LoadingPath::together) {
        return similar_to(contact_.expansion(edge, terms));
    }
    count(work_, &Counts::shear_expansions);
    std::vector<EstimatedTraction> s;
    for (std::size_t k = 0; k < terms; ++k) {
        s.push_back(escalated([&](const NormalContact& contact) {
            const Real length = contact.a() + contact.b();
            const Real zero(0);
            // One term for each cause, so that the cancellation between them is known.
            const Real by_force = full_stick_expansion(
                length, ShearLoad<Real>{spec_.Q.to<Real>(), zero}, edge, k + 1)[k];
            const Real by_tension = full_stick_expansion(
                length, ShearLoad<Real>{zero, spec_.bulk_tension.to<Real>()}, edge, k + 1)[k];
            return Sum{Real(by_force + by_tension), Real(abs(by_force) + abs(by_tension))};
        }));
    }
    return s;
}

} // namespace edgeproof::contact
