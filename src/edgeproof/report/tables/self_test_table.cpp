// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/tables/self_test_table.hpp"

#include <fmt/format.h>

namespace edgeproof::report {
namespace {

std::string cell(const comparison::SelfTestCount& count) {
    std::string text = count.cases > 0 ? fmt::format("{}/{}", count.named, count.cases) : "-";
    text += count.beyond > 0 ? fmt::format(" +{}", count.beyond) : "";
    return text + (count.wrong > 0 ? fmt::format(" WRONG {}", count.wrong) : "");
}

} // namespace

std::string self_test_text(const comparison::SelfTest& test) {
    std::string out = "| mistake |";
    std::string rule = "|---|";
    for (const double noise : comparison::noise_levels) {
        out += fmt::format(" {:g} |", noise);
        rule += "---|";
    }
    out += "\n" + rule + "\n";
    for (const comparison::SelfTestRow& row : test.rows) {
        out += "| " + (row.name.empty() ? "none" : "`" + row.name + "`") + " |";
        for (const comparison::SelfTestCount& count : row.at) {
            out += " " + cell(count) + " |";
        }
        out += "\n";
    }
    out += "\n";
    for (const std::string& miss : test.misses) {
        out += miss + "\n";
    }
    const comparison::SelfTestCount sum = test.total();
    return out + fmt::format("{} of {} cases named ({} of them alone), {} hidden by the noise, {} "
                             "wrongly named, in {} contacts\n",
                             sum.named, sum.cases, sum.alone, sum.beyond, sum.wrong,
                             comparison::tested_contacts().size());
}

} // namespace edgeproof::report
