// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/formula/exact/enclosure.hpp"
#include "tests/contact/scenes.hpp"

#include <memory>
#include <string>
#include <vector>

/// Contacts with partial slip, for the tests.
namespace edgeproof::scenes {

inline constexpr long slip_bits = 400;

/// A contact with its zones and its slip; f = 3/5.
struct Slipping {
    std::unique_ptr<contact::ProvedContact> of;
    std::unique_ptr<contact::ZoneSolver> zones;
    std::unique_ptr<contact::BallSlip> slip;
    [[nodiscard]] const contact::ProvedContact& contact() const { return *of; }
    [[nodiscard]] Ball force() const { return of->force(); }
};

/// The shear is given by tau = Q/(f P) and r = sigma_0/Q.
inline Slipping slipping(const contact::Profile& profile, const std::string& modulus,
                         const std::string& a, const std::string& tau, const std::string& r,
                         long bits = slip_bits) {
    Slipping s;
    const contact::Load load = contact::Load::right_edge(exact(a));
    const Ball ratio = formula::enclosed_constant(exact(tau), bits);
    const Ball over_Q = formula::enclosed_constant(exact(r), bits);
    const bool by_integrals = !contact::BallContact::has_closed_form(profile) ||
                              (exact(r).sign() != 0 && !profile.piecewise_linear());
    if (by_integrals) {
        auto curved =
            std::make_unique<contact::IntegratedContact>(profile, exact(modulus), load, bits);
        s.zones = integrated_zones(*curved);
        s.of = std::move(curved);
    } else {
        s.of = contact::proved_contact(profile, exact(modulus), load, bits);
        s.zones = closed_form_zones(*s.of->closed_form());
    }
    const Ball f(Rational(3, 5), bits);
    const Ball Q = ratio * f * s.force();
    s.slip = std::make_unique<contact::BallSlip>(s.contact(), *s.zones, s.force(),
                                                 contact::ShearLoad<Ball>{Q, over_Q * Q}, f);
    return s;
}

struct SizeCase {
    std::string name;
    contact::Profile profile;
    const char* modulus;
    const char* a;
    const char* r;
    const char* right;
    const char* left;
};

/// Values by mpmath 1.3 at 60 digits: findroot on consistency and force of g' + sigma_0/(2 f E*)
/// (the integrals of g'/w and s g'/w over s = c + d cos theta by quad, split at the knots) under P
/// - Q/f, tau = 0.3.
inline std::vector<SizeCase> size_cases() {
    const contact::Profile hertz = contact::Profile::power_law(exact("1"), exact("1"));
    const contact::Profile wedge = contact::Profile::power_law(exact("0.3"), exact("0"));
    const contact::Profile flat = contact::Profile::flat_and_rounded(exact("0.4"), exact("3"));
    const contact::Profile tilted = contact::Profile::tilted_wedge(exact("pi/16"), exact("pi/20"));
    const contact::Profile punch =
        contact::Profile::tilted_flat_and_rounded(exact("pi/16"), exact("1"), exact("2"));
    const contact::Profile cubic = contact::Profile::power_law(exact("1/5"), exact("3"));
    return {
        {"Hertz", hertz, "1", "1", "0", "0.163339973465924452021827974214812510607184631",
         "0.163339973465924452021827974214812510607184631"},
        {"Hertz, tension", hertz, "1", "1", "1/4",
         "0.192792404593328763632415255933057850146533094",
         "0.133887542338520140411240692496567171067836168"},
        {"wedge", wedge, "7/3", "3/2", "0", "0.45", "0.45"},
        {"wedge, tension", wedge, "7/3", "3/2", "1/4",
         "0.538905290542816153094295575618105712957956362",
         "0.352870597297658240699043921268416870974969874"},
        {"flat and rounded", flat, "2", "1.5", "0",
         "0.196102763472059745805039524207918347253168463",
         "0.196102763472059745805039524207918347253168463"},
        {"flat and rounded, tension", flat, "2", "1.5", "1/4",
         "0.251351096945929995390415475764967368063960058",
         "0.141447872226648992674959460130462552698208703"},
        {"tilted wedge", tilted, "7/3", "1.5", "0", "0.45",
         "0.0112885339216124692908079666840838243205341061"},
        {"tilted wedge, tension", tilted, "7/3", "1.5", "1/4",
         "0.49554008463483469331647025034722785952233344",
         "0.0100943380901654762074984262632578054286918412"},
        {"tilted flat and rounded", punch, "7/3", "3", "0",
         "0.507658886492987117829650468379947323747261473",
         "0.538173199466273133888874570631782928182410664"},
        {"tilted flat and rounded, tension", punch, "7/3", "3", "1/4",
         "0.881381234402140968097612247312027605262893853",
         "0.148374569592056408323165999567178204556658783"},
        {"cubic", cubic, "7/3", "1.25", "0", "0.106635975964131953606663736720265684320679065",
         "0.106635975964131953606663736720265684320679065"},
        {"cubic, tension", cubic, "7/3", "1.25", "1/4",
         "0.134821433762570334997300742094496347253099855",
         "0.079775209314654840337566967149784598116830375"},
    };
}

} // namespace edgeproof::scenes
