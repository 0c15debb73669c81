// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/program_line.hpp"

#include "edgeproof/precision/ball/arb_values.hpp"

#include <boost/version.hpp>
#include <fmt/format.h>
#include <mpfr.h>

#include <vector>

namespace edgeproof::report {

std::string libraries_text() {
    const std::vector<std::string> libraries{
        fmt::format("MPFR {}", mpfr_get_version()),
        fmt::format("FLINT {}", static_cast<const char*>(flint_version)),
#ifndef EDGEPROOF_ARB_IN_FLINT
        fmt::format("Arb {}", arb_version),
#endif
        fmt::format("Boost {}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                    BOOST_VERSION % 100),
    };
    return fmt::format("{}", fmt::join(libraries, ", "));
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
