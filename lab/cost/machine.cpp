// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/cost/machine.hpp"

#include "edgeproof/precision/ball/arb_include.hpp"

#include <boost/version.hpp>

#include <gmp.h>
#include <mpfr.h>
#include <sys/utsname.h>

#include <ctime>
#include <fstream>
#include <thread>

namespace edgeproof::cost {
namespace {

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    utsname name{};
    return ::uname(&name) == 0 ? name.machine : "unknown";
}

std::string compiler() {
#ifdef __clang__
    return "Clang " __clang_version__;
#else
    return "GCC " __VERSION__;
#endif
}

} // namespace

std::vector<std::pair<std::string, std::string>> machine() {
    std::vector<std::pair<std::string, std::string>> facts{
        {"processor", processor()},
        {"cores", std::to_string(std::thread::hardware_concurrency())},
        {"compiler", compiler()},
        {"Boost", std::to_string(BOOST_VERSION / 100000) + "." +
                      std::to_string(BOOST_VERSION / 100 % 1000) + "." +
                      std::to_string(BOOST_VERSION % 100)},
        {"GMP", gmp_version},
        {"MPFR", mpfr_get_version()},
        {"FLINT", FLINT_VERSION},
    };
#ifndef EDGEPROOF_ARB_IN_FLINT
    facts.emplace_back("Arb", arb_version);
#endif
    return facts;
}

} // namespace edgeproof::cost
