// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/certificate/certificate.hpp"

#include "edgeproof/certificate/parts.hpp"
#include "edgeproof/io/csv.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/sha256.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

namespace edgeproof::certificate {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view record_name = "accepted.csv";
const std::vector<std::string> record_head{"theorem", "file", "sha256", "imports_sha256", "coq"};

/// The content of NAME.accepted.
struct Stamp {
    std::string coq;
    std::map<std::string, std::string, std::less<>> sha256; ///< for each file
};

/// Returns no value for a file that is missing or that `make` did not write.
std::optional<Stamp> read_stamp(const fs::path& file) {
    std::error_code none;
    if (!fs::is_regular_file(file, none)) {
        return std::nullopt;
    }
    std::istringstream in(io::read_text(file, "stamp"));
    Stamp stamp;
    std::string word;
    if (!(in >> word >> stamp.coq) || word != "Coq" ||
        stamp.coq.find_first_not_of("0123456789.+") != std::string::npos) {
        return std::nullopt;
    }
    for (std::string hash; in >> hash >> word;) {
        stamp.sha256.emplace(word, hash);
    }
    return stamp;
}

/// The files of a folder in which `make` has run.
class CompiledFolder {
public:
    explicit CompiledFolder(const fs::path& folder) : folder_(folder) {
        for (const TheoryFile& file : theory_files()) {
            const std::string name = fmt::format("{}.v", file.name);
            if (io::sha256(file.content) != file_sha256(name)) {
                throw InputError("is missing, or is not the file that this program writes",
                                 "write the folder again with certify, then run make in it")
                    .at((folder_ / name).string(), 0);
            }
            definitions_.push_back(fmt::format("{}.vo", file.name));
        }
        for (const TheoryFile& file : theory_files()) {
            std::istringstream needs{std::string(file.needs)};
            std::vector<std::string> needed;
            for (std::string name; needs >> name;) {
                needed.push_back(name);
            }
            if (problem_.empty()) {
                problem_ = refusal(std::string(file.name), needed);
            }
        }
    }

    /// Returns why the theorems of the certificate are not accepted; empty if they are.
    [[nodiscard]] std::string refusal(const Certificate& c) {
        if (!problem_.empty()) {
            return problem_;
        }
        if (file_sha256(c.file) != io::sha256(c.text)) {
            return c.file + " is missing, or is not the file that this program writes";
        }
        return refusal(c.file.substr(0, c.file.size() - 2), definitions_);
    }
    [[nodiscard]] std::string coq() const { return coq_; }

private:
    /// Returns an empty text for a missing file.
    const std::string& file_sha256(const std::string& name) {
        const auto [known, is_new] = sha256_.emplace(name, "");
        std::error_code none;
        if (is_new && fs::is_regular_file(folder_ / name, none)) {
            known->second = io::sha256(io::read_text(folder_ / name, "file of Coq"));
        }
        return known->second;
    }
    /// Compares the stamp of NAME.v with the files: the source, the compiled files that it needs,
    /// and the compiled file.
    std::string refusal(const std::string& name, const std::vector<std::string>& needed) {
        const std::optional<Stamp> stamp = read_stamp(folder_ / (name + ".accepted"));
        if (!stamp) {
            return fmt::format("make has not compiled {}.v", name);
        }
        coq_ = coq_.empty() ? stamp->coq : coq_;
        std::vector<std::string> all = needed;
        all.insert(all.end(), {name + ".v", name + ".vo"});
        for (const std::string& file : all) {
            const auto then = stamp->sha256.find(file);
            if (then == stamp->sha256.end() || then->second != file_sha256(file)) {
                return fmt::format("{} has changed since make compiled {}.v", file, name);
            }
        }
        return stamp->coq == coq_ ? ""
                                  : fmt::format("{}.v was compiled by Coq {}, other files by {}",
                                                name, stamp->coq, coq_);
    }

    fs::path folder_;
    std::map<std::string, std::string> sha256_;
    std::vector<std::string> definitions_;
    std::string problem_; ///< of the definitions
    std::string coq_;
};

} // namespace

const std::string& definitions_sha256() {
    static const std::string hash = [] {
        std::string list;
        for (const TheoryFile& file : theory_files()) {
            list += fmt::format("{}  {}.v\n", io::sha256(file.content), file.name);
        }
        return io::sha256(list);
    }();
    return hash;
}

AcceptedTheorems AcceptedTheorems::read(const fs::path& folder) {
    AcceptedTheorems accepted;
    const fs::path file = folder / record_name;
    std::error_code none;
    if (!fs::is_regular_file(file, none)) {
        return accepted;
    }
    const std::string again =
        "record the theorems again: make in the folder, then certify --record";
    const io::Csv csv = io::parse_csv(io::read_text(file, "record of theorems"), file.string());
    if (csv.header.cells != record_head) {
        throw InputError("the first line is not 'theorem,file,sha256,imports_sha256,coq'", again)
            .at(file.string(), csv.header.line);
    }
    for (const io::Csv::Row& row : csv.rows) {
        if (row.cells.size() != record_head.size()) {
            throw InputError(
                fmt::format("a row of {} cells, not {}", row.cells.size(), record_head.size()),
                again)
                .at(file.string(), row.line);
        }
        const bool is_new = accepted.rows_
                                .emplace(std::pair(row.cells[1], row.cells[0]),
                                         Row{row.cells[2], row.cells[3], row.cells[4]})
                                .second;
        if (!is_new) {
            throw InputError(fmt::format("the theorem {} a second time", row.cells[0]), again)
                .at(file.string(), row.line);
        }
    }
    return accepted;
}

bool AcceptedTheorems::contain(const Certificate& certificate) const {
    const std::string sha256 = io::sha256(certificate.text);
    return !certificate.theorems.empty() &&
           std::ranges::all_of(certificate.theorems, [&](const Certificate::Theorem& theorem) {
               const auto row = rows_.find({certificate.file, theorem.name});
               return row != rows_.end() && row->second.sha256 == sha256 &&
                      row->second.imports_sha256 == definitions_sha256();
           });
}

std::string AcceptedTheorems::csv() const {
    std::string text = "theorem,file,sha256,imports_sha256,coq\n";
    for (const auto& [key, row] : rows_) {
        text += fmt::format("{},{},{},{},{}\n", key.second, key.first, row.sha256,
                            row.imports_sha256, row.coq);
    }
    return text;
}

Recording record_accepted(const std::vector<Certificate>& certificates, const fs::path& folder) {
    CompiledFolder compiled(folder);
    AcceptedTheorems accepted = AcceptedTheorems::read(folder);
    Recording recording;
    std::erase_if(accepted.rows_, [&](const auto& row) {
        std::error_code none;
        return !fs::exists(folder / row.first.first, none);
    });
    for (const Certificate& c : certificates) {
        std::erase_if(accepted.rows_, [&](const auto& row) { return row.first.first == c.file; });
        if (c.theorems.empty()) {
            continue;
        }
        if (std::string problem = compiled.refusal(c); !problem.empty()) {
            recording.refused.emplace_back(c.file, std::move(problem));
            continue;
        }
        for (const Certificate::Theorem& theorem : c.theorems) {
            accepted.rows_.insert_or_assign(
                {c.file, theorem.name},
                AcceptedTheorems::Row{io::sha256(c.text), definitions_sha256(), compiled.coq()});
        }
        recording.theorems += c.theorems.size();
    }
    recording.coq = compiled.coq();
    io::write_whole(folder / record_name, accepted.csv());
    return recording;
}

} // namespace edgeproof::certificate
