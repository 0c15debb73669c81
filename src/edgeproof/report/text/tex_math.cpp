// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/report/text/tex_math.hpp"

#include "edgeproof/report/text/escape.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

namespace edgeproof::report {
namespace {

using Nodes = std::vector<MathNode>;

MathNode math_leaf(const char* tag, std::string text, std::string attributes = {}) {
    return {tag, std::move(text), {}, std::move(attributes)};
}
MathNode math_row(Nodes children) {
    if (children.size() == 1) {
        return std::move(children.front());
    }
    return {"mrow", {}, std::move(children)};
}
MathNode math_element_of(const char* tag, Nodes children) { return {tag, {}, std::move(children)}; }

constexpr int most_expansions = 200; // of macros: one may call itself

/// Reads tokens into nodes. A token that ends a list of nodes (a brace, \right, \\, &) is left to
/// the function that started the list.
class MathReader {
public:
    MathReader(std::string_view tex, const audit::PrintedSource& source)
        : source_(source), tokens_(tex_tokens(tex)) {}

    MathNode read() {
        Nodes lines;
        while (true) {
            lines.push_back(math_row(list()));
            if (at_end()) {
                break;
            }
            const bool new_line = peek() == "\\\\";
            ++at_; // the end of a line, or an unmatched brace or fence
            if (!new_line) {
                MathNode rest = math_row(list());
                Nodes both{std::move(lines.back()), std::move(rest)};
                lines.back() = math_row(std::move(both));
            }
        }
        std::erase_if(lines,
                      [](const MathNode& n) { return n.tag == "mrow" && n.children.empty(); });
        return lines.size() > 1 ? table(std::move(lines)) : math_row(std::move(lines));
    }

private:
    [[nodiscard]] bool at_end() const { return at_ >= tokens_.size(); }
    [[nodiscard]] const std::string& peek() const { return tokens_[at_]; }
    [[nodiscard]] bool ends_list() const {
        return at_end() || peek() == "}" || peek() == "\\right" || peek() == "\\\\" ||
               peek() == "\\end";
    }

    static MathNode table(Nodes rows) {
        MathNode out{"mtable", {}, {}, " columnalign=\"left\""};
        for (MathNode& line : rows) {
            out.children.push_back(
                math_element_of("mtr", {math_element_of("mtd", {std::move(line)})}));
        }
        return out;
    }

    Nodes list() {
        Nodes nodes;
        while (!ends_list()) {
            const std::string token = peek();
            if (token == "^" || token == "_" || token == "'") {
                if (nodes.empty()) {
                    nodes.push_back(math_row({}));
                }
                nodes.back() = scripts(std::move(nodes.back()));
            } else if (auto node = atom()) {
                nodes.push_back(std::move(*node));
            }
        }
        return nodes;
    }

    MathNode scripts(MathNode base) {
        std::optional<MathNode> below;
        Nodes above;
        std::string primes;
        while (!at_end() && (peek() == "^" || peek() == "_" || peek() == "'")) {
            const std::string which = tokens_[at_++];
            if (which == "'") {
                primes += "′";
            } else if (which == "_") {
                below = argument();
            } else {
                above.push_back(argument());
            }
        }
        if (!primes.empty()) {
            above.insert(above.begin(), math_leaf("mo", primes));
        }
        const bool limits = base.tag == "mo" && (base.text == "∑" || base.text == "lim");
        if (below && !above.empty()) {
            return math_element_of(
                limits ? "munderover" : "msubsup",
                {std::move(base), std::move(*below), math_row(std::move(above))});
        }
        if (below) {
            return math_element_of(limits ? "munder" : "msub",
                                   {std::move(base), std::move(*below)});
        }
        return math_element_of("msup", {std::move(base), math_row(std::move(above))});
    }

    /// Reads a group, or one atom.
    MathNode argument() {
        if (at_end()) {
            return math_row({});
        }
        if (peek() == "{") {
            ++at_;
            MathNode inside = math_row(list());
            at_ += at_end() ? 0 : 1;
            return inside;
        }
        while (!ends_list()) {
            if (auto node = atom()) {
                return std::move(*node);
            }
        }
        return math_row({});
    }

    /// Reads the characters of a group unchanged.
    std::string words() {
        std::string text;
        if (at_end() || peek() != "{") {
            return text;
        }
        int depth = 0;
        do {
            const std::string& token = tokens_[at_++];
            depth += token == "{" ? 1 : token == "}" ? -1 : 0;
            if (token != "{" && token != "}" && token != "$") {
                text += token == "~" ? " " : token;
            }
        } while (!at_end() && depth > 0);
        return text;
    }

    std::string fence() {
        if (at_end()) {
            return "";
        }
        const std::string token = tokens_[at_++];
        if (token.size() == 2 && token[0] == '\\') {
            return token.substr(1); // \{ and \}
        }
        return token == "." ? "" : token;
    }

    MathNode fenced() {
        Nodes nodes;
        const auto add = [&](const std::string& sign) {
            if (!sign.empty()) {
                nodes.push_back(math_leaf("mo", sign, " stretchy=\"true\""));
            }
        };
        add(fence());
        for (MathNode& node : list()) {
            nodes.push_back(std::move(node));
        }
        // A line may end between \left and \right; then the fence stays open.
        if (!at_end() && peek() == "\\right") {
            ++at_;
            add(fence());
        }
        return {"mrow", {}, std::move(nodes)};
    }

    MathNode environment() {
        const std::string name = words();
        if (name != "cases") {
            return math_row({});
        }
        Nodes lines;
        while (!at_end() && peek() != "\\end") {
            MathNode line = math_row(list());
            if (!line.children.empty() || !line.text.empty()) {
                lines.push_back(std::move(line));
            }
            if (!at_end() && peek() != "\\end") {
                ++at_;
                skip_option();
            }
        }
        if (!at_end()) {
            ++at_;
            words();
        }
        return {"mrow", {}, {math_leaf("mo", "{", " stretchy=\"true\""), table(std::move(lines))}};
    }
    /// Skips [2mm] after \\.
    void skip_option() {
        if (!at_end() && peek() == "[") {
            while (!at_end() && tokens_[at_++] != "]") {
            }
        }
    }

    std::optional<MathNode> command(const std::string& name) {
        if (const auto it = source_.macros.find(name); it != source_.macros.end()) {
            if (++expansions_ <= most_expansions) {
                const std::vector<std::string> body = tex_tokens(it->second);
                tokens_.insert(tokens_.begin() + static_cast<std::ptrdiff_t>(at_), body.begin(),
                               body.end());
            }
            return std::nullopt;
        }
        if (name == "frac" || name == "dfrac" || name == "tfrac") {
            MathNode above = argument();
            MathNode below = argument();
            return math_element_of("mfrac", {std::move(above), std::move(below)});
        }
        if (name == "sqrt") {
            return math_element_of("msqrt", {argument()});
        }
        if (name == "hat" || name == "bar") {
            return math_element_of("mover", {argument(), math_leaf("mo", name == "hat" ? "^" : "¯",
                                                                   " stretchy=\"false\"")});
        }
        if (name == "left") {
            return fenced();
        }
        if (name == "begin") {
            return environment();
        }
        if (name == "label") {
            words();
            return std::nullopt;
        }
        if (name == "ref") {
            const std::string label = words();
            const auto number = source_.labels.find(label);
            return math_leaf("mtext", number == source_.labels.end() ? "?" : number->second);
        }
        if (name == "mathcal") {
            const std::string letter = words();
            return math_leaf("mi", letter == "P" ? "𝒫" : letter);
        }
        if (name == "mbox" || name == "mathrm" || name == "text" || name == "operatorname" ||
            name == "textrm") {
            const std::string text = words();
            const bool sign = text.find(' ') == std::string::npos && name != "text";
            return sign ? math_leaf("mi", text, text.size() == 1 ? " mathvariant=\"normal\"" : "")
                        : math_leaf("mtext", " " + text + " ");
        }
        if (const auto symbol = tex_symbol(name)) {
            const std::string text(symbol->text);
            if (symbol->tag != std::string_view("mspace")) {
                return math_leaf(symbol->tag, text);
            }
            return text.empty() ? std::nullopt
                                : std::optional(math_leaf("mspace", "", " width=\"" + text + "\""));
        }
        return math_leaf(name.size() > 1 ? "mi" : "mo", name); // \sin, \log, \%, ...
    }

    std::optional<MathNode> atom() {
        const std::string token = tokens_[at_];
        if (token == "{") {
            return argument();
        }
        ++at_;
        if (token == "&" || token == "$" || token == " " || token == "~") {
            return std::nullopt;
        }
        if (token[0] == '\\') {
            return command(token.substr(1));
        }
        if (std::isdigit(static_cast<unsigned char>(token[0])) != 0) {
            return math_leaf("mn", token);
        }
        if (std::isalpha(static_cast<unsigned char>(token[0])) != 0 ||
            static_cast<unsigned char>(token[0]) >= 0x80) {
            return math_leaf("mi", token);
        }
        static constexpr std::array fences{"(", ")", "[", "]", "|"};
        const bool plain = std::ranges::find(fences, token) != fences.end();
        return math_leaf("mo", token == "-" ? "−" : token, plain ? " stretchy=\"false\"" : "");
    }

    const audit::PrintedSource& source_;
    std::vector<std::string> tokens_;
    std::size_t at_ = 0;
    int expansions_ = 0;
};

void flatten(MathNode& node, std::vector<std::pair<std::string, MathNode*>>& out) {
    if (node.children.empty()) {
        if (!node.text.empty()) {
            out.emplace_back(node.tag + node.text, &node);
        }
        return;
    }
    if (node.tag != "mrow") {
        out.emplace_back('<' + node.tag, node.tag == "msqrt" ? &node : nullptr);
    }
    for (MathNode& child : node.children) {
        flatten(child, out);
    }
    if (node.tag != "mrow") {
        out.emplace_back("</" + node.tag, nullptr);
    }
}

std::string markup(const MathNode& node) {
    const std::string mark = node.changed ? " class=\"changed\"" : "";
    std::string out = '<' + node.tag + node.attributes + mark + '>' + escape_html(node.text);
    for (const MathNode& child : node.children) {
        out += markup(child);
    }
    return out + "</" + node.tag + '>';
}

} // namespace

MathNode math_of_tex(std::string_view tex, const audit::PrintedSource& source) {
    return MathReader(tex, source).read();
}

void mark_changes(MathNode& printed, MathNode& corrected) {
    std::vector<std::pair<std::string, MathNode*>> x;
    std::vector<std::pair<std::string, MathNode*>> y;
    flatten(printed, x);
    flatten(corrected, y);
    std::vector<std::vector<unsigned>> common(x.size() + 1, std::vector<unsigned>(y.size() + 1));
    for (std::size_t i = x.size(); i-- > 0;) {
        for (std::size_t j = y.size(); j-- > 0;) {
            common[i][j] = x[i].first == y[j].first ? common[i + 1][j + 1] + 1
                                                    : std::max(common[i + 1][j], common[i][j + 1]);
        }
    }
    const auto mark = [](MathNode* node) {
        if (node != nullptr) {
            node->changed = true;
        }
    };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < x.size() || j < y.size()) {
        if (i < x.size() && j < y.size() && x[i].first == y[j].first) {
            ++i;
            ++j;
        } else if (j == y.size() || (i < x.size() && common[i + 1][j] >= common[i][j + 1])) {
            mark(x[i++].second);
        } else {
            mark(y[j++].second);
        }
    }
}

std::string inline_math(const MathNode& node) {
    return "<math xmlns=\"http://www.w3.org/1998/Math/MathML\">" + markup(node) + "</math>";
}

std::string block_math(const MathNode& node, std::string_view name) {
    return "<math display=\"block\" xmlns=\"http://www.w3.org/1998/Math/MathML\" aria-label=\"" +
           escape_html(name) + "\">" + markup(node) + "</math>";
}

} // namespace edgeproof::report
