// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/scene/mistakes/mistake_counts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace edgeproof::scene {
namespace {

std::string cell_of(const MistakeCount& count) {
    std::string text = count.cases > 0 ? fmt::format("{}/{}", count.named, count.cases) : "-";
    text += count.beyond > 0 ? fmt::format(" +{}", count.beyond) : "";
    return text + (count.wrong > 0 ? fmt::format(" WRONG {}", count.wrong) : "");
}

} // namespace

void MistakeCounts::count(const MistakeTrial& trial) {
    auto row = std::ranges::find(rows, trial.mistake, &MistakeRow::name);
    if (row == rows.end()) {
        row = rows.insert(rows.end(), MistakeRow{trial.mistake});
    }
    const bool right = trial.mistake.empty();
    const auto is_it = [&](const std::string& name) { return name == trial.mistake; };
    const bool named = right ? trial.named.empty() : std::ranges::any_of(trial.named, is_it);
    const bool found = named && !trial.hidden;
    const bool wrong = trial.misled || (!named && !trial.named.empty());
    MistakeCount& count = row->at.at(trial.level);
    count.cases += trial.hidden ? 0 : 1;
    count.beyond += trial.hidden ? 1 : 0;
    count.named += found ? 1 : 0;
    count.alone += found && std::ranges::all_of(trial.named, is_it) ? 1 : 0;
    count.wrong += wrong ? 1 : 0;
    if (wrong || (!named && !trial.hidden)) {
        misses.push_back(
            fmt::format("{} in {}, noise {:g}: {} ({})", right ? "right data" : trial.mistake,
                        trial.contact, noise.at(trial.level),
                        trial.named.empty() ? "nothing is named"
                                            : fmt::format("named {}", fmt::join(trial.named, ", ")),
                        trial.measured));
    }
}

MistakeCount MistakeCounts::total() const {
    MistakeCount sum;
    for (const MistakeRow& row : rows) {
        for (const MistakeCount& count : row.at) {
            sum.wrong += count.wrong;
            if (row.name.empty()) {
                continue;
            }
            sum.cases += count.cases;
            sum.named += count.named;
            sum.alone += count.alone;
            sum.beyond += count.beyond;
        }
    }
    return sum;
}

bool MistakeCounts::passes(std::size_t percent) const {
    const MistakeCount sum = total();
    return sum.cases > 0 && sum.wrong == 0 && 100 * sum.named >= percent * sum.cases;
}

std::string MistakeCounts::text() const {
    std::string out = "| mistake |";
    std::string rule = "|---|";
    for (const double level : noise) {
        out += fmt::format(" {:g} |", level);
        rule += "---|";
    }
    out += "\n" + rule + "\n";
    for (const MistakeRow& row : rows) {
        out += "| " + (row.name.empty() ? "none" : "`" + row.name + "`") + " |";
        for (std::size_t level = 0; level < noise.size(); ++level) {
            out += " " + cell_of(row.at.at(level)) + " |";
        }
        out += "\n";
    }
    out += "\n";
    for (const std::string& miss : misses) {
        out += miss + "\n";
    }
    const MistakeCount sum = total();
    return out + fmt::format("{} of {} cases named ({} of them alone), {} hidden by the noise, {} "
                             "wrongly named, in {} contacts\n",
                             sum.named, sum.cases, sum.alone, sum.beyond, sum.wrong, contacts);
}

} // namespace edgeproof::scene
