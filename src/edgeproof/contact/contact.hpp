// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// The mechanics of an incomplete contact between half-planes, from the bottom up:
///   profile.hpp          Profile: g'(x), exact
///   normal_contact.hpp   NormalContact: the exact problem, answered to the digits asked
///   work.hpp             Counts and Work: what was done, counted where it is done
///   contact_law.hpp      ContactLaw<T>: b(a), P(a), M(a) and their series, in any arithmetic
///   pressure_routes.hpp  p(x) by routes that share no formula
///   fast_pressure.hpp    many pressures of one contact, each at the least cost of a quadrature
///   ball_contact.hpp     the same contact in balls: enclosures that are proved
///   edge_expansion.hpp   c_0, c_1, ... at both edges, over any field
///   shear_traction.hpp   ShearTraction: q of a contact under full stick (shear.hpp: in any field)
///   integrated_contact.hpp  the same for curved g', by rigorous integration; with
///   rising_slope.hpp     whether g' is proved not to decrease there, which it rests on, and
///   pressure_disk.hpp    its Taylor series with Cauchy's bound of what is left out
///   exact_edges.hpp      edges on a knot, decided by exact algebra
///   ball_extent.hpp      how far n terms stay within a tolerance, proved, for either
///   ball_shear.hpp       the same q in balls
///   forward.hpp          back from a traction to its resultant and its principal value
///   tilt_solver.hpp      the tilt that carries a given force and moment
///   extent.hpp           how far from an edge n terms stay within a tolerance
#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/curved/slope_monotonicity.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_shear.hpp"
#include "edgeproof/contact/enclosure/exact_edges.hpp"
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/forward.hpp"
#include "edgeproof/contact/law/work.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/routes/extent.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/contact/routes/shear_traction.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
