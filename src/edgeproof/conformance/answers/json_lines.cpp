// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/conformance/answers/program_driver.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace edgeproof::conformance {
namespace {

using Json = nlohmann::ordered_json;

/// Reads `id` and `value` of one object. A number is kept as text, so that no digit is lost.
class JsonRow : public nlohmann::json_sax<nlohmann::json> {
public:
    std::string id;
    std::string value;
    bool has_id = false;
    bool has_value = false;

    bool null() override { return take(""); }
    bool boolean(bool b) override { return take(b ? "true" : "false"); }
    bool number_integer(number_integer_t n) override { return take(std::to_string(n)); }
    bool number_unsigned(number_unsigned_t n) override { return take(std::to_string(n)); }
    bool number_float(number_float_t, const string_t& text) override { return take(text); }
    bool string(string_t& text) override { return take(text); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override {
        const bool good = depth_ == 0 || take("an object");
        ++depth_;
        return good;
    }
    bool end_object() override { return depth_-- > 0; }
    bool start_array(std::size_t) override {
        const bool good = take("a list");
        ++depth_;
        return good;
    }
    bool end_array() override { return depth_-- > 0; }
    bool key(string_t& name) override {
        if (depth_ == 1) {
            key_ = name;
        }
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
        return false;
    }

private:
    /// Takes a value of the object itself; values nested in it are ignored. Returns false if there
    /// is no object, or if it has the value twice.
    bool take(const std::string& text) {
        if (depth_ != 1) {
            return depth_ > 1;
        }
        if (key_ == "id") {
            id = text;
            return !std::exchange(has_id, true);
        }
        if (key_ == "value") {
            value = text;
            return !std::exchange(has_value, true);
        }
        return true;
    }
    std::string key_;
    int depth_ = 0;
};

bool read(const std::string& line, JsonRow& row) {
    row = {};
    return nlohmann::json::sax_parse(line, &row) && row.has_id && row.has_value;
}

/// Puts quotes around NaN, Infinity and -Infinity, which Python writes and JSON does not allow.
std::string with_quotes(std::string line) {
    for (const std::string word : {"-Infinity", "Infinity", "NaN"}) {
        for (std::size_t at = 0; (at = line.find(word, at)) != std::string::npos;) {
            const bool bare = at > 0 && (line[at - 1] == ':' || line[at - 1] == ' ');
            if (bare) {
                line.replace(at, word.size(), "\"" + word + "\"");
            }
            at += word.size() + (bare ? 2 : 0);
        }
    }
    return line;
}

} // namespace

std::string json_lines(const Questions& questions) {
    std::string out;
    for (const Question& q : questions.list) {
        Json object = Json::object();
        object["id"] = q.id;
        for (const Parameter& p : questions.contacts[q.contact].parameters) {
            object[p.key] = p.text;
        }
        object["quantity"] = symbol_of(q);
        if (q.at_edge()) {
            object["edge"] = scene::edge_name(q.edge);
        }
        if (q.tolerance) {
            object["tolerance"] = q.tolerance->text();
        }
        if (q.u) {
            object["u"] = q.u->text();
        }
        if (q.in_body) {
            object["body"] = q.in_body->body == scene::Body::A ? "A" : "B";
            object["x"] = q.in_body->x.text();
            object["z"] = q.in_body->z.text();
        }
        out += object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    }
    return out;
}

io::Csv parse_json_lines(std::string_view text, const std::string& file, std::size_t most_rows) {
    io::Csv csv;
    csv.file = file;
    csv.header = {1, {"id", "value"}};
    std::size_t number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string::npos) {
            continue;
        }
        if (csv.rows.size() >= most_rows) {
            csv.cut = true;
            break;
        }
        JsonRow row;
        if (read(line, row) || read(with_quotes(line), row)) {
            csv.rows.push_back({number, {row.id, row.value}});
        } else {
            csv.rows.push_back({number, {line}});
        }
    }
    return csv;
}

} // namespace edgeproof::conformance
