// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/checks/parts/enclosed_reach.hpp"

#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/formula/exact/exact_ball.hpp"
#include "edgeproof/precision/error.hpp"

#include <map>
#include <memory>

namespace edgeproof::audit {

EnclosedReach enclosed_reach(const SceneSpec& scene, const ReachQuestion& question,
                             unsigned digits) {
    const contact::Profile profile = scene.make_profile();
    const contact::Load load = contact::Load::right_edge(scene.parameter("a"));
    std::map<long, std::unique_ptr<contact::ProvedPressure>> contacts;
    const auto contact_at = [&](long bits) -> const contact::ProvedPressure& {
        auto& made = contacts[bits];
        if (!made && contact::BallContact::has_closed_form(profile)) {
            made =
                std::make_unique<contact::BallContact>(profile, scene.parameter("Es"), load, bits);
        } else if (!made) {
            made = std::make_unique<contact::IntegratedContact>(profile, scene.parameter("Es"),
                                                                load, bits);
        }
        return *made;
    };
    EnclosedReach reach;
    contact::BallExtentSearch search(contact_at, question.edge, question.terms, question.tolerance,
                                     question.range);
    const long needed = formula::bits_for(digits);
    for (long bits = 2 * needed; bits <= 8 * needed && !reach.extents; bits *= 2) {
        try {
            reach.extents = search.at(bits);
            reach.bits = bits;
        } catch (const InputError&) {
            throw;
        } catch (const BudgetError& error) {
            reach.problem = error.what();
        } catch (const Error& error) {
            reach.problem = error.what();
            break;
        }
    }
    return reach;
}

} // namespace edgeproof::audit
