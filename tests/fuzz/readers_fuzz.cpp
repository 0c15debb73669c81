// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/ledger.hpp"
#include "edgeproof/conformance/answers/answers.hpp"
#include "edgeproof/conformance/questions/question.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/scene/input/scene_file.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string_view>

namespace {

const std::map<std::string_view, void (*)(std::string_view)> readers{
    {"scene", [](std::string_view text) { (void)edgeproof::scene::parse_scene(text, "f.toml"); }},
    {"ledger", [](std::string_view text) { (void)edgeproof::audit::parse_ledger(text, "f.toml"); }},
    {"recipe",
     [](std::string_view text) { (void)edgeproof::conformance::parse_recipe(text, "f.toml"); }},
    {"answers",
     [](std::string_view text) {
         (void)edgeproof::conformance::echoed_answers(
             edgeproof::io::parse_csv(text, "f.csv", {.keep_faults = true}));
     }},
};

} // namespace

/// The reader (EDGEPROOF_READER, from CMake) must read the text, or throw one of our errors in one
/// line. Anything else (another exception, a crash, a sanitizer's finding) ends the program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        readers.at(EDGEPROOF_READER)({reinterpret_cast<const char*>(data), size}); // NOLINT
    } catch (const edgeproof::Error& error) {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos) {
            std::fputs("an error of more than one line\n", stderr);
            std::abort();
        }
    }
    return 0;
}
