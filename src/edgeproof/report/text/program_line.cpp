// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/text/program_line.hpp"

#include "edgeproof/precision/ball/arb_include.hpp"

#include <boost/version.hpp>
#include <fmt/format.h>
#include <ginac/version.h>
#include <mpfr.h>

namespace edgeproof::report {
namespace {

std::string libraries_text() {
    std::string text;
    for (const auto& [name, version] : library_versions()) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, version);
    }
    return text;
}

} // namespace

std::vector<std::pair<std::string, std::string>> library_versions() {
    return {
        {"MPFR", mpfr_get_version()},
        {"FLINT", static_cast<const char*>(flint_version)},
#ifndef EDGEPROOF_ARB_IN_FLINT
        {"Arb", arb_version},
#endif
        {"Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                              BOOST_VERSION % 100)},
        {"GiNaC",
         fmt::format("{}.{}.{}", GiNaC::version_major, GiNaC::version_minor, GiNaC::version_micro)},
    };
}

std::string program_line() {
    const std::string commit =
        program_commit.empty() ? "" : fmt::format("commit {}; ", program_commit);
    return fmt::format("edgeproof {} ({}{})", program_version, commit, libraries_text());
}

std::string program_lines() {
    const std::string commit =
        program_commit.empty() ? "" : fmt::format("commit {}\n", program_commit);
    return fmt::format("edgeproof {}\n{}{}", program_version, commit, libraries_text());
}

} // namespace edgeproof::report
