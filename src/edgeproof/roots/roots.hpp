// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/roots/bracketed_root.hpp"
#include "edgeproof/roots/power_law_fit.hpp"
