// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/causes/self_test.hpp"

#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/rational.hpp"
#include "edgeproof/precision/rounding/text.hpp"
#include "edgeproof/precision/split_mix.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <utility>

namespace edgeproof::conformance {
namespace {

constexpr std::size_t digits_of_a_double = 15;
constexpr std::size_t most_attempts = 1000;

// Placeholders for invalid quotes in a cell until the text is written.
const std::string quote_begins = "\x01";
const std::string quote_ends = "\x02";

std::string with_text_behind_quotes(std::string text) {
    boost::replace_first(text, quote_begins, "\"");
    boost::replace_first(text, quote_ends, "\"999");
    return text;
}

class Corrupter {
public:
    Corrupter(const io::Csv& right, std::uint64_t seed) : right_(right), random_(seed) {
        const auto id = right.column("id");
        const auto value = right.column("value");
        if (!id || !value || right.rows.size() < 3) {
            throw InputError("too few answers to corrupt", "give a recipe with more of them");
        }
        id_ = *id;
        value_ = *value;
        quantity_ = right.column("quantity");
        u_ = right.column("u");
    }

    /// Repeats until a change has an effect.
    Corruption corrupt(std::size_t kind) {
        const auto& [name, change] = kinds()[kind % kinds().size()];
        for (std::size_t attempt = 0; attempt < most_attempts; ++attempt) {
            io::Csv csv = right_;
            const std::string what = with_text_behind_quotes(change(*this, csv));
            if (!what.empty()) {
                std::string text = with_text_behind_quotes(csv_text(csv));
                text.resize(std::min(text.size(), std::exchange(cut_, std::string::npos)));
                return {name, what, text};
            }
        }
        return {};
    }

private:
    /// Changes the table; returns the change in words, or an empty text if there is none.
    using Change = std::function<std::string(Corrupter&, io::Csv&)>;
    static const std::vector<std::pair<std::string, Change>>& kinds();
    std::size_t below(std::size_t n) { return random_.below(n); }
    std::size_t row(const io::Csv& csv) { return below(csv.rows.size()); }
    static double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }
    /// Returns all digits; "inf" if a change leads out of range.
    static std::string text(double x) {
        return std::isfinite(x) ? exact_text(exact_rational(x)) : fmt::format("{}", x);
    }
    [[nodiscard]] std::string& value(io::Csv& csv, std::size_t r) const {
        return csv.rows[r].cells[value_];
    }
    [[nodiscard]] std::string changed_value(const io::Csv& csv, std::size_t r) const {
        return right_.rows[r].cells[id_] + ": " + right_.rows[r].cells[value_] + " to " +
               csv.rows[r].cells[value_];
    }
    /// Applies f to a random value that is not zero; returns an empty text if f changes nothing.
    std::string one(io::Csv& csv, const std::function<std::string(const std::string&)>& f) {
        const std::size_t r = row(csv);
        std::string& v = value(csv, r);
        const std::string was = v;
        if (number(v) == 0) {
            return {};
        }
        v = f(v);
        return v == was ? std::string{} : changed_value(csv, r);
    }
    std::string all(io::Csv& csv, const std::function<double(double)>& f) {
        bool any = false;
        for (std::size_t r = 0; r < csv.rows.size(); ++r) {
            const double x = number(value(csv, r));
            any = any || f(x) != x;
            value(csv, r) = text(f(x));
        }
        return any ? "every value" : "";
    }
    /// Returns the positions of the significant digits.
    static std::vector<std::size_t> digits(const std::string& v) {
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < v.size() && v[i] != 'e'; ++i) {
            const bool digit = v[i] >= '0' && v[i] <= '9';
            if (digit && (v[i] != '0' || !places.empty()) && places.size() < digits_of_a_double) {
                places.push_back(i);
            }
        }
        return places;
    }
    std::string digit(io::Csv& csv) {
        return one(csv, [&](std::string v) {
            const auto places = digits(v);
            char& c = v[places[below(places.size())]];
            c = static_cast<char>('0' + (c - '0' + 1 + static_cast<int>(below(9))) % 10);
            return v;
        });
    }
    std::string transposed(io::Csv& csv) {
        return one(csv, [&](std::string v) {
            const auto places = digits(v);
            const std::size_t k = below(places.size());
            if (k + 1 < places.size()) {
                std::swap(v[places[k]], v[places[k + 1]]);
            }
            return v;
        });
    }
    std::string shifted(io::Csv& csv) {
        const std::size_t from = row(csv);
        bool any = false;
        for (std::size_t r = csv.rows.size() - 1; r > from; --r) {
            any = any || value(csv, r) != right_.rows[r - 1].cells[value_];
            value(csv, r) = right_.rows[r - 1].cells[value_];
        }
        return any ? "from " + right_.rows[from].cells[id_] + " on" : "";
    }
    std::string exchanged(io::Csv& csv) {
        const std::size_t r = row(csv);
        const std::size_t other = row(csv);
        std::swap(value(csv, r), value(csv, other));
        return value(csv, r) == value(csv, other) ? "" : changed_value(csv, r);
    }
    /// Exchanges the values of the same question at the two edges.
    std::string other_edge(io::Csv& csv) {
        const std::size_t r = row(csv);
        const std::string& id = right_.rows[r].cells[id_];
        const std::size_t at = id.find(":left:");
        if (at == std::string::npos) {
            return {};
        }
        const std::string other = id.substr(0, at) + ":right:" + id.substr(at + 6);
        for (std::size_t k = 0; k < csv.rows.size(); ++k) {
            if (right_.rows[k].cells[id_] == other) {
                std::swap(value(csv, r), value(csv, k));
                return value(csv, r) == value(csv, k) ? "" : changed_value(csv, r);
            }
        }
        return {};
    }
    std::string quantity(io::Csv& csv, double factor) {
        const std::size_t chosen = row(csv);
        if (!quantity_ || number(value(csv, chosen)) == 0) {
            return {};
        }
        const std::string name = csv.rows[chosen].cells[*quantity_];
        for (io::Csv::Row& row : csv.rows) {
            if (row.cells[*quantity_] == name) {
                row.cells[value_] = text(number(row.cells[value_]) * factor);
            }
        }
        return name;
    }
    std::string echoed(io::Csv& csv) {
        const std::size_t r = row(csv);
        const std::size_t other = row(csv);
        if (!u_ || csv.rows[r].cells[*u_].empty() || csv.rows[other].cells[*u_].empty() ||
            csv.rows[r].cells[*u_] == csv.rows[other].cells[*u_]) {
            return {};
        }
        csv.rows[r].cells[*u_] = csv.rows[other].cells[*u_];
        return right_.rows[r].cells[id_];
    }
    std::string lost(io::Csv& csv) {
        const std::size_t r = row(csv);
        csv.rows.erase(csv.rows.begin() + static_cast<long>(r));
        return right_.rows[r].cells[id_];
    }
    std::string twice(io::Csv& csv) {
        const std::size_t r = row(csv);
        csv.rows.insert(csv.rows.begin() + static_cast<long>(r), right_.rows[r]);
        return right_.rows[r].cells[id_];
    }
    /// Cuts the text anywhere after the header, except within its last five characters, where the
    /// cut might not change a value.
    std::string truncated(io::Csv& csv) {
        const std::size_t size = csv_text(csv).size();
        io::Csv head;
        head.header = csv.header;
        const std::size_t header = csv_text(head).size();
        cut_ = header + below(size > header + 5 ? size - header - 5 : 1);
        return "after " + std::to_string(cut_) + " bytes";
    }

    const io::Csv& right_;
    SplitMix64 random_;
    std::size_t id_ = 0;
    std::size_t value_ = 0;
    std::optional<std::size_t> quantity_;
    std::optional<std::size_t> u_;
    std::size_t cut_ = std::string::npos;
};

const std::vector<std::pair<std::string, Corrupter::Change>>& Corrupter::kinds() {
    using C = Corrupter;
    using Text = std::string;
    const auto one = [](const std::function<Text(const Text&)>& f) {
        return [f](C& c, io::Csv& csv) { return c.one(csv, f); };
    };
    const auto all = [](const std::function<double(double)>& f) {
        return [f](C& c, io::Csv& csv) { return c.all(csv, f); };
    };
    const auto quantity = [](double factor) {
        return [factor](C& c, io::Csv& csv) { return c.quantity(csv, factor); };
    };
    const auto single = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    static const std::vector<std::pair<std::string, Change>> list{
        {"one digit of one value", &C::digit},
        {"two digits of one value transposed", &C::transposed},
        {"last bit of one value", one([](const Text& v) {
             return text(std::nextafter(number(v), std::numeric_limits<double>::infinity()));
         })},
        {"one sign lost",
         one([](const Text& v) { return v.front() == '-' ? v.substr(1) : "-" + v; })},
        {"one power of ten", one([](const Text& v) { return text(number(v) * 10); })},
        {"values shifted by a row", &C::shifted},
        {"two values exchanged", &C::exchanged},
        {"left and right exchanged", &C::other_edge},
        {"single precision in one value",
         one([single](const Text& v) { return text(single(number(v))); })},
        {"single precision throughout", all(single)},
        {"all off by 1e-13", all([](double x) { return x * (1 + 1e-13); })},
        {"one quantity doubled", quantity(2)},
        {"one quantity off by 1e-14", quantity(1 + 1e-14)},
        {"one value cut to 10 digits",
         one([](const Text& v) { return fmt::format("{:.10g}", number(v)); })},
        {"another u repeated", &C::echoed},
        {"a row lost", &C::lost},
        {"a row twice", &C::twice},
        {"file cut off", &C::truncated},
        {"nan", one([](const Text&) { return "nan"; })},
        {"inf", one([](const Text&) { return "-inf"; })},
        {"an empty value", one([](const Text&) { return ""; })},
        {"garbage", one([](const Text& v) { return v + " MPa"; })},
        {"two signs", one([](const Text& v) { return "+-" + v; })},
        {"a NUL byte", one([](const Text& v) { return v + '\0'; })},
        {"text behind a closing quote",
         one([](const Text& v) { return quote_begins + v + quote_ends; })},
        {"a decimal comma", one([](Text v) {
             const std::size_t point = v.find('.');
             return point == Text::npos ? v : v.replace(point, 1, ",");
         })},
    };
    return list;
}

std::string cell(const std::string& text) {
    if (text.find_first_of("\",\n") == std::string::npos) {
        return text;
    }
    return "\"" + boost::replace_all_copy(text, "\"", "\"\"") + "\"";
}

} // namespace

std::string csv_text(const io::Csv& csv) {
    std::string out;
    const auto add = [&](const io::Csv::Row& row) {
        for (const std::string& text : row.cells) {
            out += cell(text) + ",";
        }
        out.back() = '\n';
    };
    add(csv.header);
    std::ranges::for_each(csv.rows, add);
    return out;
}

std::vector<Corruption> corruptions(const io::Csv& right, std::uint64_t seed, std::size_t count) {
    Corrupter corrupter(right, seed);
    std::vector<Corruption> list;
    for (std::size_t kind = 0; list.size() < count; ++kind) {
        Corruption corrupted = corrupter.corrupt(kind);
        if (!corrupted.kind.empty()) {
            list.push_back(std::move(corrupted));
        }
    }
    return list;
}

} // namespace edgeproof::conformance
