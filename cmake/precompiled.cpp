// SPDX-License-Identifier: GPL-3.0-or-later
// The only source of the target that owns the precompiled header of the targets built with QUICK.
