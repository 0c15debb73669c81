// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_extent.hpp"
#include "edgeproof/contact/enclosure/ball_values.hpp"
#include "tests/contact/scenes.hpp"

#include <map>
#include <memory>
#include <string>

/// Extents by enclosures, and their check by the witness.
namespace edgeproof::scenes {

struct AskedExtent {
    Contact contact;
    Edge edge;
    std::size_t n;
    std::string tolerance;
    ExtentRange range = {};
};

template <class C>
[[nodiscard]] EnclosedExtents enclosed(const AskedExtent& asked, long bits = 400) {
    std::map<long, std::unique_ptr<C>> made;
    BallExtentSearch search(
        [&](long b) -> const ProvedContact& {
            auto& slot = made[b];
            if (!slot) {
                slot = std::make_unique<C>(asked.contact.profile, asked.contact.modulus,
                                           asked.contact.load, b);
            }
            return *slot;
        },
        asked.edge, asked.n, exact(asked.tolerance), asked.range);
    return search.at(bits);
}

/// Returns the fault of extents, by pressures of the witness: the error is the tolerance at the
/// crossings, and smaller before the first one. Empty if there is none.
inline std::string fault_by_witness(const AskedExtent& asked, const EnclosedExtents& x) {
    const Witness contact(asked.contact.profile, asked.contact.modulus, asked.contact.load, 25);
    const PrecisionScope scope(50);
    const std::vector<Ball> c =
        proved_contact(asked.contact.profile, asked.contact.modulus, asked.contact.load, 400)
            ->expansion(asked.edge, asked.n);
    const auto error = [&](const Real& u) { // in units of the tolerance
        const Real sum = horner(c, Ball(u, 400)).midpoint();
        const Real p =
            contact.pressure(asked.edge, Exact::parse(u.str(45)), Route::singular_integral).value;
        return Real(abs(Real(sum * sqrt(u) / p - 1)) / exact(asked.tolerance).to<Real>());
    };
    const Real first = x.first_exit.midpoint();
    for (int k = 1; k < 12; ++k) {
        if (!(error(Real(first * k / 12)) < 1)) {
            return "beyond the tolerance before the first exit";
        }
    }
    for (const Ball& crossing : x.crossings) {
        if (!(abs(Real(error(crossing.midpoint()) - 1)) < Real("1e-9"))) {
            return "no crossing at " + crossing.midpoint().str(10);
        }
    }
    if (x.leaves == x.crossings.empty()) {
        return "an exit without a crossing";
    }
    return x.first_exit.relative_accuracy_bits() > 130 && x.measure.relative_accuracy_bits() > 130
               ? ""
               : "wide";
}

} // namespace edgeproof::scenes
