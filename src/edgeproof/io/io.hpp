// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
/// Input and output of files:
///   toml/toml_section.hpp  TomlSection: the strict TOML reader, with exact numbers
///   text_file.hpp          read_text: a file as text, or the reason why it cannot be read
///   error_place.hpp        adds the file and the line to an error
///   toml/toml_text.hpp     text of TOML; limits of a TOML file: its size and its nesting
#include "edgeproof/io/error_place.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/io/toml/toml_section.hpp"
#include "edgeproof/io/toml/toml_text.hpp"
