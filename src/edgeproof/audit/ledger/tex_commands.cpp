// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/audit/ledger/tex_commands.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

namespace edgeproof::audit {
namespace {

using CommandNames = std::set<std::string, std::less<>>;

/// Commands of LaTeX and amsmath (from their manuals) for a formula or a line of text. None of them
/// reads or writes a file, defines anything, or changes how TeX reads.
constexpr const char* command_names =
    // Greek and Hebrew letters
    "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa varkappa lambda "
    "mu nu xi omicron pi varpi rho varrho sigma varsigma tau upsilon phi varphi chi psi omega "
    "digamma Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega varGamma varDelta varTheta "
    "varLambda varXi varPi varSigma varUpsilon varPhi varPsi varOmega aleph beth gimel daleth "
    // other letters and signs
    "ell hbar hslash imath jmath Re Im wp partial infty nabla emptyset varnothing prime backprime "
    "angle measuredangle sphericalangle triangle triangledown blacktriangle blacktriangledown "
    "square blacksquare lozenge blacklozenge Diamond Box bigstar diamondsuit heartsuit clubsuit "
    "spadesuit flat natural sharp surd top bot forall exists nexists neg lnot complement eth mho "
    "Bbbk Finv Game circledR circledS maltese checkmark yen degree dag ddag dagger ddagger S P "
    "copyright pounds diagup diagdown "
    // operators
    "pm mp times div cdot centerdot ast star circ bullet cap cup uplus sqcap sqcup vee wedge lor "
    "land setminus smallsetminus wr amalg oplus ominus otimes oslash odot bigcirc dotplus "
    "divideontimes "
    "ltimes rtimes leftthreetimes rightthreetimes barwedge doublebarwedge veebar curlyvee "
    "curlywedge "
    "Cap Cup doublecap doublecup boxplus boxminus boxtimes boxdot circleddash circledast "
    "circledcirc "
    "intercal lhd rhd unlhd unrhd bigtriangleup bigtriangledown triangleleft triangleright "
    "sum prod coprod int iint iiint iiiint idotsint oint fint smallint bigcap bigcup bigvee "
    "bigwedge "
    "bigoplus bigotimes bigodot biguplus bigsqcup "
    // relations
    "le leq leqq leqslant ge geq geqq geqslant lt gt ll gg lll ggg llless gggtr ne neq equiv sim "
    "simeq approx approxeq thickapprox thicksim cong propto varpropto asymp doteq doteqdot Doteq "
    "risingdotseq fallingdotseq circeq eqcirc triangleq bumpeq Bumpeq eqsim backsim backsimeq "
    "lesssim gtrsim lessapprox gtrapprox lessgtr gtrless lesseqgtr gtreqless lesseqqgtr gtreqqless "
    "eqslantless eqslantgtr lessdot gtrdot prec succ preceq succeq preccurlyeq succcurlyeq "
    "curlyeqprec curlyeqsucc precsim succsim precapprox succapprox subset supset subseteq supseteq "
    "subseteqq supseteqq Subset Supset sqsubset sqsupset sqsubseteq sqsupseteq in ni owns notin "
    "mid parallel shortmid shortparallel perp vdash dashv models vDash Vdash Vvdash smile frown "
    "smallsmile smallfrown bowtie Join pitchfork between therefore because varpropto "
    "trianglelefteq "
    "trianglerighteq vartriangle vartriangleleft vartriangleright blacktriangleleft "
    "blacktriangleright not nless ngtr nleq ngeq nleqslant ngeqslant nleqq ngeqq lneq gneq lneqq "
    "gneqq lvertneqq gvertneqq lnsim gnsim lnapprox gnapprox nprec nsucc npreceq nsucceq precneqq "
    "succneqq precnsim succnsim precnapprox succnapprox nsim ncong nmid nparallel nshortmid "
    "nshortparallel nvdash nvDash nVdash nVDash ntriangleleft ntriangleright ntrianglelefteq "
    "ntrianglerighteq nsubseteq nsupseteq nsubseteqq nsupseteqq subsetneq supsetneq varsubsetneq "
    "varsupsetneq subsetneqq supsetneqq varsubsetneqq varsupsetneqq colon "
    // arrows
    "to gets leftarrow rightarrow leftrightarrow Leftarrow Rightarrow Leftrightarrow longleftarrow "
    "longrightarrow longleftrightarrow Longleftarrow Longrightarrow Longleftrightarrow iff implies "
    "impliedby mapsto longmapsto hookleftarrow hookrightarrow uparrow downarrow updownarrow "
    "Uparrow "
    "Downarrow Updownarrow nearrow searrow swarrow nwarrow leftharpoonup leftharpoondown "
    "rightharpoonup rightharpoondown rightleftharpoons leftrightharpoons upharpoonleft "
    "upharpoonright "
    "downharpoonleft downharpoonright leadsto rightsquigarrow leftrightsquigarrow leftleftarrows "
    "rightrightarrows leftrightarrows rightleftarrows upuparrows downdownarrows Lleftarrow "
    "Rrightarrow twoheadleftarrow twoheadrightarrow leftarrowtail rightarrowtail looparrowleft "
    "looparrowright curvearrowleft curvearrowright circlearrowleft circlearrowright Lsh Rsh "
    "multimap restriction nleftarrow nrightarrow nLeftarrow nRightarrow nleftrightarrow "
    "nLeftrightarrow dashleftarrow dashrightarrow xleftarrow xrightarrow "
    // functions
    "arccos arcsin arctan arg cos cosh cot coth csc deg det dim exp gcd hom inf injlim ker lg lim "
    "liminf limsup ln log max min Pr projlim sec sin sinh sup tan tanh varinjlim varliminf "
    "varlimsup varprojlim bmod pmod pod mod operatorname operatornamewithlimits "
    // structure
    "frac dfrac tfrac cfrac binom dbinom tbinom genfrac sqrt root stackrel overset underset "
    "sideset "
    "overline underline overbrace underbrace overrightarrow overleftarrow overleftrightarrow "
    "underrightarrow underleftarrow underleftrightarrow substack boxed limits nolimits "
    "displaylimits "
    "left right middle big Big bigg Bigg bigl Bigl biggl Biggl bigr Bigr biggr Biggr bigm Bigm "
    "biggm "
    "Biggm lbrace rbrace lbrack rbrack langle rangle lvert rvert lVert rVert vert Vert lceil rceil "
    "lfloor rfloor lgroup rgroup lmoustache rmoustache ulcorner urcorner llcorner lrcorner "
    "backslash "
    "hat widehat check widecheck tilde widetilde acute grave dot ddot dddot ddddot breve bar vec "
    "mathring smash phantom hphantom vphantom mathstrut strut over atop choose "
    "dots ldots cdots vdots ddots dotsc dotsb dotsm dotsi dotso "
    // type and size
    "mathrm mathit mathbf mathsf mathtt mathcal mathbb mathfrak mathnormal boldsymbol bm pmb "
    "mathord mathop mathbin mathrel mathopen mathclose mathpunct mathinner "
    "displaystyle textstyle scriptstyle scriptscriptstyle text textrm textit textbf textsf texttt "
    "textsc textsl textup textmd textnormal emph mbox hbox intertext shortintertext rm it bf sf tt "
    "sl cal tiny scriptsize footnotesize small normalsize large "
    // spaces, marks and references
    "quad qquad thinspace medspace thickspace negthinspace negmedspace negthickspace enspace "
    "hspace "
    "hfill newline nonumber notag tag label ref eqref pageref cite par noindent textsection "
    "textbackslash textasciitilde textasciicircum textendash textemdash textquoteleft "
    "textquoteright textquotedblleft textquotedblright textdegree textellipsis slash begin end "
    "hline "
    // letters of other languages
    "aa AA ae AE oe OE o O l L ss i j c v u H k r t b d ";

constexpr const char* environment_names =
    "equation equation* align align* alignat alignat* aligned alignedat gather gather* gathered "
    "multline multline* flalign flalign* split cases array matrix pmatrix bmatrix Bmatrix vmatrix "
    "Vmatrix smallmatrix eqnarray eqnarray* math displaymath subequations subarray itemize "
    "enumerate";

CommandNames names_in(const char* list) {
    std::istringstream in(list);
    return {std::istream_iterator<std::string>(in), {}};
}

} // namespace

bool is_math_command(std::string_view name) {
    static const CommandNames names = names_in(command_names);
    return names.contains(name);
}

bool is_math_environment(std::string_view name) {
    static const CommandNames names = names_in(environment_names);
    return names.contains(name);
}

bool is_math_sign(char sign) {
    static constexpr std::string_view signs = "\\,;:! {}%&#_$|/-'\"^~=.()[]`>\n";
    return signs.find(sign) != std::string_view::npos;
}

} // namespace edgeproof::audit
