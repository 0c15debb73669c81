// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// The parameter of a scene for which an approximation reaches farthest:
///   error_family.hpp  the relative error as a function of the distance and of parameters
///   reach.hpp         the first exit for one value of the parameters: proved, or sampled
///   best_reach.hpp    the best value, and the proof that nothing else does better
#include "edgeproof/contact/design/best_reach.hpp"
#include "edgeproof/contact/design/error_family.hpp"
#include "edgeproof/contact/design/reach.hpp"
