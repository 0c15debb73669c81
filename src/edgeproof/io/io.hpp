// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Files in and out:
///   toml/toml_section.hpp  TomlSection: the one strict TOML reader, numbers exact, errors with the
///   line text_file.hpp          read_text: a file as text, and why it cannot be read
///   error_place.hpp        an error told with the file and the line
///   toml/toml_limits.hpp   what a TOML file may not exceed: its size, how deep it is nested
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_limits.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
