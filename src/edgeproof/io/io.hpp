// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Files in and out:
///   toml_section.hpp  TomlSection: the one strict TOML reader, numbers exact, errors with the line
///   toml_limits.hpp   what a TOML file may not exceed: its size, how deep it is nested
#include "edgeproof/io/toml_limits.hpp"
#include "edgeproof/io/toml_section.hpp"
