// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// The mechanics of an incomplete contact between half-planes, from the bottom up:
///   profile.hpp          Profile: g'(x), exact
///   normal_contact.hpp   NormalContact: the exact problem, answered to the digits asked
///   work.hpp             Counts and Work: what was done, counted where it is done
///   kernels.hpp          P, M, b(a) and their rates as integrals over dg', over any field
///   contact_law.hpp      ContactLaw<T>: b(a), P(a), M(a) and their series, in any arithmetic
///   pressure_routes.hpp  p(x) by routes that share no formula
///   power_law_closed_form.hpp  that of a power law by Gauss's 2F1, in Real
///   fast_pressure.hpp    many pressures of one contact, each at the least cost of a quadrature
///   ball_contact.hpp     the same contact in balls: enclosures that are proved
///   edge_expansion.hpp   c_0, c_1, ... at both edges, over any field
///   shear_traction.hpp   ShearTraction: q of a contact under full stick (shear.hpp: over any
///   field) integrated_contact.hpp  the same for curved g', by rigorous integration; with
///   rising_slope.hpp     whether g' is proved not to decrease there, which it rests on, and
///   pressure_disk.hpp    its Taylor series with Cauchy's bound of what is left out
///   exact_edges.hpp      edges on a knot, decided by exact algebra
///   ball_extent.hpp      how far n terms stay within a tolerance, proved, for either
///   ball_slip.hpp        BallSlip: partial slip, proved; with
///   stick_zone.hpp       ZoneSolver: its stick zone, under any force and tilt
///   slip_reach.hpp       the load up to which n terms of a slip zone's size are good, proved
///   slip_series.hpp      the slip zones in powers of the load, over any field
///   partial_slip.hpp     PartialSlip: the same in Real, from the pressures in the slip zones
///   forward.hpp          back from a traction to its resultant and its principal value
///   tilt_solver.hpp      the tilt that carries a given force and moment
///   extent.hpp           how far from an edge n terms stay within a tolerance
#include "edgeproof/contact/batch/batch_pressure.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/curved/integrated_zones.hpp"
#include "edgeproof/contact/curved/slope_monotonicity.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/ball_slip.hpp"
#include "edgeproof/contact/enclosure/exact_edges.hpp"
#include "edgeproof/contact/enclosure/slip_reach.hpp"
#include "edgeproof/contact/law/contact_law.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/forward.hpp"
#include "edgeproof/contact/law/work.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/routes/extent.hpp"
#include "edgeproof/contact/routes/normal_contact.hpp"
#include "edgeproof/contact/routes/partial_slip.hpp"
#include "edgeproof/contact/routes/pressure_routes.hpp"
#include "edgeproof/contact/routes/shear_traction.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
