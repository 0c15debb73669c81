// SPDX-License-Identifier: BSD-3-Clause
// Holds a contact code against the conformance pack (C++17).
//
//     c++ -std=c++17 -O2 -o driver driver.cpp example.cpp      (your file in place of example.cpp)
//     ./driver A level-a.csv
//     ./driver B cases.csv hard-cases.csv
//
// Levels A, B and C; README.md says what they ask. Exit status 0: every answer is within the level;
// 1: one is not; 2: there was nothing to hold.
#include "edgeproof_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {

const std::string header =
    "id,kind,m,C,phi,alpha,t,R,a,P,M,E,Q,S,edge,u,quantity,scale,value,bound,binary64,hex,"
    "condition,ulps";
constexpr std::size_t columns = 24;
constexpr long most_shown = 10;
constexpr double same_ratio = 0.01; // ratios that agree to this are one factor

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t comma = std::min(line.find(',', at), line.size());
        cells.push_back(line.substr(at, comma - at));
        at = comma + 1;
    }
    return cells;
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

// Whether an answer is within the level: a NaN is not.
bool within(char level, double value, double exact, double scale, double ulps) {
    const double error = std::abs(value - exact);
    if (level == 'A') {
        return error <= 0.01 * scale;
    }
    if (level == 'B') {
        const double size = std::abs(exact);
        return error <=
               ulps * (std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
    }
    return value == exact;
}

// Names the factor where all wrong answers of a quantity, three or more, have the same one.
// `ratios`: answer/exact.
void print_causes(const std::map<std::string, std::vector<double>>& ratios) {
    for (const auto& [quantity, found] : ratios) {
        const auto ends = std::minmax_element(found.begin(), found.end());
        const double middle = (*ends.first + *ends.second) / 2;
        const bool same = *ends.second - *ends.first <= same_ratio * std::abs(middle);
        if (found.size() < 3 || !same || std::abs(middle - 1) <= same_ratio) {
            continue;
        }
        std::string names;
        std::ifstream factors("factors.txt");
        for (std::string line; std::getline(factors, line);) {
            const std::size_t blank = std::min(line.find(' '), line.size());
            if (line[0] != '#' && std::abs(middle / number(line.substr(blank)) - 1) <= same_ratio) {
                names += (names.empty() ? "" : " or ") + line.substr(0, blank);
            }
        }
        std::printf(
            "likely cause: the %zu wrong answers for %s are %.6g times the exact ones: %s\n",
            found.size(), quantity.c_str(), middle, names.empty() ? "factor" : names.c_str());
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::string asked = argc > 1 ? argv[1] : "";
    if (argc < 3 || (asked != "A" && asked != "B" && asked != "C")) {
        std::cerr << "usage: driver A|B|C FILE...\n";
        return 2;
    }
    const char level = asked[0];
    long answered = 0;
    long wrong = 0;
    long not_there = 0;
    std::map<std::string, std::vector<double>> ratios;
    for (int i = 2; i < argc; ++i) {
        std::ifstream file(argv[i]);
        if (!file) {
            std::cerr << argv[i] << ": cannot be read\n";
            return 2;
        }
        bool in_rows = false;
        long rows = 0;
        long stated = -1;
        for (std::string line; std::getline(file, line);) {
            if (!line.empty() && line.back() == '\r') {
                line.pop_back();
            }
            if (line.rfind('#', 0) == 0) {
                std::sscanf(line.c_str(), "# rows: %ld", &stated);
                continue;
            }
            if (!in_rows) {
                if (line != header) {
                    std::cerr << argv[i] << ": the columns are those of another pack\n";
                    return 2;
                }
                in_rows = true;
                continue;
            }
            const auto cell = split(line);
            if (cell.size() != columns) {
                std::cerr << argv[i] << ": a row is cut off\n";
                return 2;
            }
            ++rows;
            EdgeproofCase c;
            c.id = cell[0];
            c.kind = cell[1];
            double* const numbers[] = {&c.m, &c.C, &c.phi, &c.alpha, &c.t, &c.R,
                                       &c.a, &c.P, &c.M,   &c.E,     &c.Q, &c.S};
            for (std::size_t k = 0; k < 12; ++k) {
                *numbers[k] = number(cell[2 + k]);
            }
            c.edge = cell[14];
            c.u = number(cell[15]);
            c.quantity = cell[16];
            const double exact = number(cell[20]);
            const auto value = edgeproof_answer(c);
            if (!value) {
                ++not_there;
                continue;
            }
            ++answered;
            if (!within(level, *value, exact, number(cell[17]), number(cell[23]))) {
                ratios[c.quantity.substr(0, 1)].push_back(*value / exact);
                if (++wrong <= most_shown) {
                    std::printf("%s: %.17g, exact %.17g\n", c.id.c_str(), *value, exact);
                }
            }
        }
        if (rows != stated) {
            std::cerr << argv[i] << ": the file is not whole: it has " << rows
                      << " rows, and its line # rows has another number\n";
            return 2;
        }
    }
    std::printf("level %c: %ld answered, %ld wrong, %ld not answered\n", level, answered, wrong,
                not_there);
    print_causes(ratios);
    return wrong > 0 ? 1 : answered > 0 ? 0 : 2;
}
