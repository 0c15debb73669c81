// SPDX-License-Identifier: BSD-3-Clause
// The only source of the target that owns the precompiled header of the targets built with QUICK.
