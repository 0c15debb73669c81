// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/questions/recipe.hpp"

#include "tests/fuzz/reader.hpp"
#include "tests/support/namespaces.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return hold_to_its_word(
        [](std::string_view text) {
            static_cast<void>(edgeproof::conformance::parse_recipe(text, "recipe.toml"));
        },
        data, size);
}
