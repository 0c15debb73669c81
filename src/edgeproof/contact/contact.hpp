// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// The mechanics of an incomplete contact between half-planes. The formulas in law/ are templates
/// over the number type. The contacts are in balls (proved); the witness is in Real (estimates).
///   profile/profile.hpp               Profile: g'(x), exact
///   law/kernels.hpp                   P, M, b(a) and their rates as integrals over dg'
///   law/edge_expansion.hpp            c_0, c_1, ... at both edges
///   law/shear.hpp                     q under full stick
///   tilt/tilt_solver.hpp              the tilt for a given force and moment
///   double_word/double_word_pressure.hpp  pressures to binary64, in double words with bounds
///   enclosure/ball_contact.hpp        BallContact: the contact in balls, proved
///   enclosure/zone_equations.hpp      the edges for a force, an edge or a tilt, by interval Newton
///   enclosure/exact_contact.hpp       exact values; edges on a knot, decided by exact algebra
///   enclosure/taylor_cover.hpp        TaylorCover: series of a function with expensive values
///   enclosure/ball_extent.hpp         how far n terms stay within a tolerance, proved
///   slip/ball_slip.hpp                BallSlip: partial slip, proved; slip zones as series
///   slip/stick_zone.hpp               ZoneSolver: the stick zone under any force and tilt
///   slip/slip_reach.hpp               the load up to which n terms of a zone's size are accurate
///   curved/integrated_contact.hpp     IntegratedContact: curved g', by rigorous integration
///   curved/proved_slip.hpp            ProvedSlip: partial slip of any profile in balls
///   curved/curved_slope.hpp           proves that g' does not decrease
///   curved/pressure_disk.hpp          Taylor series of p; Cauchy's estimate bounds the remainder
///   witness/witness.hpp               Witness: p by two quadratures that share only the slope
///   design/best_reach.hpp             the parameter for which an approximation reaches farthest
#include "edgeproof/contact/curved/curved_slope.hpp"
#include "edgeproof/contact/curved/integrated_contact.hpp"
#include "edgeproof/contact/curved/proved_slip.hpp"
#include "edgeproof/contact/enclosure/ball_contact.hpp"
#include "edgeproof/contact/enclosure/exact_contact.hpp"
#include "edgeproof/contact/law/edge_expansion.hpp"
#include "edgeproof/contact/law/shear.hpp"
#include "edgeproof/contact/profile/profile.hpp"
#include "edgeproof/contact/slip/ball_slip.hpp"
#include "edgeproof/contact/slip/slip_reach.hpp"
#include "edgeproof/contact/tilt/tilt_solver.hpp"
#include "edgeproof/contact/witness/witness.hpp"
