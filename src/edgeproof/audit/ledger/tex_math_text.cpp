// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/audit/ledger/printed_source.hpp"
#include "edgeproof/precision/message.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace edgeproof::audit {
namespace {

constexpr std::size_t most_shown = 40;
constexpr std::size_t most_expanded_bytes = 100'000;
constexpr std::size_t most_expansions = 10'000;
constexpr const char* write_mathematics =
    "write commands of LaTeX and amsmath for formulas and text, or define the macro in "
    "[print.macros]";

/// Commands of LaTeX and amsmath (from their manuals) for a formula or a line of text. None of them
/// reads or writes a file, defines anything, or changes how TeX reads.
constexpr const char* command_names =
    // Greek and Hebrew letters
    " alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa varkappa lambda "
    "mu nu xi omicron pi varpi rho varrho sigma varsigma tau upsilon phi varphi chi psi omega "
    "digamma Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega varGamma varDelta varTheta "
    "varLambda varXi varPi varSigma varUpsilon varPhi varPsi varOmega aleph beth gimel daleth "
    // other letters and signs
    "ell hbar imath jmath Re Im wp partial infty nabla emptyset varnothing prime angle triangle "
    "square lozenge surd top bot forall exists neg lnot degree dag ddag dagger ddagger S P "
    "copyright pounds "
    // operators
    "pm mp times div cdot centerdot ast star circ bullet cap cup uplus vee wedge lor land setminus "
    "oplus ominus otimes oslash odot bigcirc triangleleft triangleright sum prod coprod int iint "
    "iiint iiiint idotsint oint fint smallint bigcap bigcup bigvee bigwedge bigoplus bigotimes "
    // relations and arrows
    "le leq leqq leqslant ge geq geqq geqslant lt gt ll gg lesssim gtrsim ne neq equiv sim simeq "
    "approx approxeq cong propto varpropto asymp doteq triangleq prec succ preceq succeq subset "
    "supset subseteq supseteq in ni notin mid parallel perp not nless ngtr nleq ngeq nmid "
    "nparallel colon therefore because to gets leftarrow rightarrow leftrightarrow Leftarrow "
    "Rightarrow Leftrightarrow longleftarrow longrightarrow longleftrightarrow Longleftarrow "
    "Longrightarrow Longleftrightarrow iff implies impliedby mapsto longmapsto uparrow downarrow "
    "updownarrow Uparrow Downarrow Updownarrow nearrow searrow swarrow nwarrow leftharpoonup "
    "rightharpoonup rightleftharpoons leadsto xleftarrow xrightarrow "
    // functions
    "arccos arcsin arctan arg cos cosh cot coth csc deg det dim exp gcd hom inf injlim ker lg lim "
    "liminf limsup ln log max min Pr projlim sec sin sinh sup tan tanh varinjlim varliminf "
    "varlimsup varprojlim bmod pmod pod mod operatorname operatornamewithlimits "
    // structure
    "frac dfrac tfrac cfrac binom dbinom tbinom genfrac sqrt root stackrel overset underset "
    "sideset overline underline overbrace underbrace overrightarrow overleftarrow "
    "overleftrightarrow underrightarrow underleftarrow underleftrightarrow substack boxed limits "
    "nolimits displaylimits left right middle big Big bigg Bigg bigl Bigl biggl Biggl bigr Bigr "
    "biggr Biggr bigm Bigm biggm Biggm lbrace rbrace lbrack rbrack langle rangle lvert rvert lVert "
    "rVert vert Vert lceil rceil lfloor rfloor lgroup rgroup lmoustache rmoustache ulcorner "
    "urcorner llcorner lrcorner backslash hat widehat check widecheck tilde widetilde acute grave "
    "dot ddot dddot ddddot breve bar vec mathring smash phantom hphantom vphantom mathstrut strut "
    "over atop choose dots ldots cdots vdots ddots dotsc dotsb dotsm dotsi dotso "
    // type and size
    "mathrm mathit mathbf mathsf mathtt mathcal mathbb mathfrak mathnormal boldsymbol bm pmb "
    "mathord mathop mathbin mathrel mathopen mathclose mathpunct mathinner displaystyle textstyle "
    "scriptstyle scriptscriptstyle text textrm textit textbf textsf texttt textsc textsl textup "
    "textmd textnormal emph mbox hbox intertext shortintertext rm it bf sf tt sl cal tiny "
    "scriptsize footnotesize small normalsize large "
    // spaces, marks and references
    "quad qquad thinspace medspace thickspace negthinspace negmedspace negthickspace enspace "
    "hspace hfill newline nonumber notag tag label ref eqref pageref cite par noindent textsection "
    "textbackslash textasciitilde textasciicircum textendash textemdash textquoteleft "
    "textquoteright textquotedblleft textquotedblright textdegree textellipsis slash begin end "
    "hline "
    // letters of other languages
    "aa AA ae AE oe OE o O l L ss i j c v u H k r t b d ";

constexpr const char* environment_names =
    " equation equation* align align* alignat alignat* aligned alignedat gather gather* gathered "
    "multline multline* flalign flalign* split cases array matrix pmatrix bmatrix Bmatrix vmatrix "
    "Vmatrix smallmatrix eqnarray eqnarray* math displaymath subequations subarray itemize "
    "enumerate ";

/// True for one of the words of a list that begins and ends with a blank.
bool is_word_of(std::string_view list, std::string_view name) {
    return name.find(' ') == std::string_view::npos &&
           list.find(" " + std::string(name) + " ") != std::string_view::npos;
}

bool is_math_sign(char sign) {
    static constexpr std::string_view signs = "\\,;:! {}%&#_$|/-'\"^~=.()[]`>\n";
    return signs.find(sign) != std::string_view::npos;
}

bool is_tex_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string shown_tex(std::string_view text) { return printable(shortened(text, most_shown)); }

/// Returns the letters of the command whose backslash is at `at`; empty if a sign follows the
/// backslash.
std::string_view command_at(std::string_view tex, std::size_t at) {
    std::size_t end = at + 1;
    while (end < tex.size() && is_tex_letter(tex[end])) {
        ++end;
    }
    return tex.substr(at + 1, end - at - 1);
}

class TexChecker {
public:
    TexChecker(std::string_view tex, const TexMacros& macros) : tex_(tex), macros_(macros) {}

    std::optional<TexFault> fault() {
        if (printable_lines(tex_) != tex_) {
            return TexFault{"it contains control characters, or is not UTF-8",
                            "write printable text"};
        }
        while (at_ < tex_.size()) {
            if (auto found = tex_[at_] == '\\' ? command() : character()) {
                return found;
            }
        }
        if (depth_ != 0) {
            return unbalanced("{");
        }
        if (in_math_) {
            return unbalanced("$");
        }
        return {}; // a sentence may end inside an environment
    }

private:
    static TexFault unbalanced(const std::string& what) {
        return {"it contains " + what + " without its counterpart", "write both, or none"};
    }

    std::optional<TexFault> character() {
        const char c = tex_[at_];
        if (c == '%' || c == '#') {
            return TexFault{std::string("it contains ") + c + ", which TeX does not print",
                            std::string("write \\") + c};
        }
        if (tex_.substr(at_, 2) == "^^") {
            return TexFault{"it contains ^^, by which TeX reads another character",
                            "write the character itself"};
        }
        ++at_;
        in_math_ = c == '$' ? !in_math_ : in_math_;
        depth_ += c == '{' ? 1 : c == '}' ? -1 : 0;
        return depth_ < 0 ? std::optional(unbalanced("}")) : std::nullopt;
    }

    std::optional<TexFault> command() {
        const std::string_view name = command_at(tex_, at_);
        if (name.empty()) {
            if (at_ + 1 == tex_.size() || !is_math_sign(tex_[at_ + 1])) {
                return TexFault{"it contains " + shown_tex(tex_.substr(at_, 2)) +
                                    ", which is not a command of mathematics",
                                write_mathematics};
            }
            at_ += 2;
            return {};
        }
        at_ += 1 + name.size();
        if (macros_.contains(name)) {
            return {};
        }
        if (!is_word_of(command_names, name)) {
            return TexFault{"it contains \\" + shown_tex(name) +
                                ", which is not a command of mathematics",
                            write_mathematics};
        }
        return name == "begin" || name == "end" ? environment(name == "begin") : std::nullopt;
    }

    std::optional<TexFault> environment(bool begins) {
        const std::size_t close = tex_.find('}', at_);
        if (at_ == tex_.size() || tex_[at_] != '{' || close == std::string_view::npos) {
            return unbalanced(begins ? "\\begin" : "\\end");
        }
        const std::string name(tex_.substr(at_ + 1, close - at_ - 1));
        if (!is_word_of(environment_names, name)) {
            return TexFault{"it contains the environment '" + shown_tex(name) +
                                "', which is not an environment for formulas",
                            "write equation, align, cases, array or another one of amsmath"};
        }
        at_ = close + 1;
        if (begins) {
            open_.push_back(name);
        } else if (open_.empty() || open_.back() != name) {
            return unbalanced("\\end{" + name + "}");
        } else {
            open_.pop_back();
        }
        return {};
    }

    std::string_view tex_;
    const TexMacros& macros_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool in_math_ = false;
    std::vector<std::string> open_;
};

/// True if `tex` uses a macro, directly or through other macros.
bool uses_macro(std::string_view tex, const std::string& name, const TexMacros& macros,
                std::set<std::string_view>& seen) {
    for (std::size_t at = 0; (at = tex.find('\\', at)) != std::string_view::npos;) {
        const std::string_view used = command_at(tex, at);
        at += used.empty() ? 2 : 1 + used.size();
        const auto body = macros.find(used);
        if (used == name || (body != macros.end() && seen.insert(body->first).second &&
                             uses_macro(body->second, name, macros, seen))) {
            return true;
        }
    }
    return false;
}

/// A text with its macros replaced by their bodies, within the limits of size and number.
class Expansion {
public:
    Expansion(std::string_view tex, const TexMacros& macros) : macros_(macros) { add(tex); }
    [[nodiscard]] bool is_whole() const { return !cut_; }
    std::string text;

private:
    void add(std::string_view tex) {
        for (std::size_t at = 0; at < tex.size() && !cut_;) {
            cut_ = text.size() > most_expanded_bytes;
            if (tex[at] != '\\') {
                text += tex[at++];
                continue;
            }
            const std::string_view name = command_at(tex, at);
            const std::size_t size = name.empty() ? 2 : 1 + name.size();
            const auto macro = macros_.find(name);
            if (macro == macros_.end()) {
                text += tex.substr(at, size);
            } else {
                put_in(macro->second);
            }
            at += size;
        }
    }
    void put_in(const std::string& body) {
        cut_ = cut_ || ++count_ > most_expansions;
        // A letter of the body must not be read as part of the command before it.
        const std::size_t backslash = text.find_last_of('\\');
        if (backslash != std::string::npos && !body.empty() && is_tex_letter(body.front()) &&
            std::all_of(text.begin() + static_cast<std::ptrdiff_t>(backslash) + 1, text.end(),
                        is_tex_letter)) {
            text += ' ';
        }
        add(body);
    }

    const TexMacros& macros_;
    std::size_t count_ = 0;
    bool cut_ = false;
};

} // namespace

std::optional<TexFault> tex_fault(std::string_view tex, const TexMacros& macros) {
    if (auto fault = TexChecker(tex, macros).fault()) {
        return fault;
    }
    if (!Expansion(tex, macros).is_whole()) {
        return TexFault{"its macros expand to more than " + std::to_string(most_expanded_bytes) +
                            " characters, or use more than " + std::to_string(most_expansions) +
                            " macros",
                        "write shorter macros"};
    }
    return {};
}

std::optional<TexFault> macro_fault(const std::string& name, const TexMacros& macros) {
    if (name.empty() || !std::ranges::all_of(name, is_tex_letter)) {
        return TexFault{"the name of a macro is not letters only", "write NAME = 'TeX'"};
    }
    const std::string& body = macros.find(name)->second;
    std::set<std::string_view> seen;
    if (uses_macro(body, name, macros, seen)) {
        return TexFault{"the macro \\" + shown_tex(name) + " uses itself",
                        "write its body with commands of LaTeX"};
    }
    return TexChecker(body, macros).fault();
}

std::string without_macros(std::string_view tex, const TexMacros& macros) {
    return Expansion(tex, macros).text;
}

} // namespace edgeproof::audit
