// SPDX-License-Identifier: BSD-3-Clause
// REPLAY COUNT FILE...: gives a reader every file, and COUNT texts made from them by cutting,
// doubling, mixing and overwriting, always the same ones. It is for compilers without libFuzzer,
// and for reproducible runs. If EDGEPROOF_FUZZ_KEEP is set, the current text is in the file
// last-input while it is read.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

const std::vector<std::string> tokens{
    "\"", "'''", "[",     "]]",        "{",     "}",     "=",       "\n",   "#",
    ",",  "nan", "inf",   "-",         "0",     "1e9",   "(",       ")",    "^",
    "/",  "*",   "pi",    ".",         "sqrt(", "1e-30", "\\u0000", "\xff", "999999999999999999999",
    "a",  "P",   "alpha", "= \"1/0\"", "\r"};

class Mutator {
public:
    explicit Mutator(const std::vector<std::string>& seeds) : seeds_(seeds) {}

    std::string next() {
        std::string text = seeds_[below(seeds_.size())];
        for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
            edit(text);
        }
        return text;
    }

private:
    std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
    void edit(std::string& text) {
        const std::size_t at = below(text.size() + 1);
        const std::size_t length = std::min(below(24), text.size() - at);
        switch (below(6)) {
        case 0:
            text.erase(at, length);
            break;
        case 1:
            text.insert(at, text.substr(at, length));
            break;
        case 2:
            text.insert(at, tokens[below(tokens.size())]);
            break;
        case 3:
            if (at < text.size()) {
                text[at] = static_cast<char>(below(256));
            }
            break;
        case 4: {
            const std::string& other = seeds_[below(seeds_.size())];
            text.insert(at, other.substr(below(other.size()), below(80)));
            break;
        }
        default:
            text.resize(at);
            break;
        }
    }

    const std::vector<std::string>& seeds_;
    std::mt19937 random_{20260611};
};

int give(const std::string& text) {
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    return LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("give how many texts to make, and files to make them from\n", stderr);
        return 2;
    }
    std::vector<std::string> seeds;
    for (int k = 2; k < argc; ++k) {
        std::ifstream in(argv[k], std::ios::binary);
        seeds.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
        if (seeds.back().empty()) {
            std::fprintf(stderr, "%s: nothing to read\n", argv[k]);
            return 2;
        }
        give(seeds.back());
    }
    Mutator mutator(seeds);
    const long count = std::strtol(argv[1], nullptr, 10);
    for (long k = 0; k < count; ++k) {
        const std::string text = mutator.next();
        if (std::getenv("EDGEPROOF_FUZZ_KEEP") != nullptr) {
            std::ofstream("last-input", std::ios::binary) << text;
        }
        give(text);
    }
    std::printf("%zu texts and %ld made of them, none of which did harm\n", seeds.size(), count);
    return 0;
}
