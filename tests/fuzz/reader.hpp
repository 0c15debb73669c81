// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/precision/error.hpp"
#include "tests/support/namespaces.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

/// For the leak sanitizer: CLN does not free a few bytes at the end.
extern "C" inline __attribute__((used)) const char* __lsan_default_suppressions() { // NOLINT
    return "leak:libcln";
}

/// Every reader must read the text, or throw one of our errors in one line. Anything else (another
/// exception, a crash, a sanitizer's finding) ends the program.
template <class Read>
int hold_to_its_word(const Read& read, const std::uint8_t* data, std::size_t size) {
    try {
        read(std::string_view(reinterpret_cast<const char*>(data), size)); // NOLINT: bytes as text
    } catch (const edgeproof::Error& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) {
            std::fputs("an error of more than one line\n", stderr);
            std::abort();
        }
    }
    return 0;
}
