// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/certificate/certificate.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::certificate {

/// The result of record_accepted().
struct Recording {
    std::size_t theorems = 0; ///< accepted
    std::string coq;          ///< Coq's version
    /// The files whose theorems are not accepted, each with the reason.
    std::vector<std::pair<std::string, std::string>> refused;
};

/// The record of the theorems that Coq has accepted, `accepted.csv` in a folder of certificates.
///
/// A theorem is recorded from the stamp NAME.accepted that the folder's Makefile writes after coqc
/// has compiled NAME.v: Coq's version and the SHA-256 of NAME.v, of the compiled files of the
/// definitions, and of NAME.vo. record_accepted() compares these hashes, and those in the stamps of
/// the definitions, with the files, so that a compiled file of an earlier source does not count.
class AcceptedTheorems {
public:
    /// Reads the record of a folder; without a file nothing is accepted. Throws InputError for a
    /// malformed record.
    [[nodiscard]] static AcceptedTheorems read(const std::filesystem::path& folder);
    /// Whether Coq has accepted all theorems of the certificate, with the text and the definitions
    /// that this program writes.
    [[nodiscard]] bool contain(const Certificate& certificate) const;

private:
    friend Recording record_accepted(const std::vector<Certificate>& certificates,
                                     const std::filesystem::path& folder);
    struct Row {
        std::string sha256;
        std::string imports_sha256;
        std::string coq;
    };
    [[nodiscard]] std::string csv() const;

    std::map<std::pair<std::string, std::string>, Row> rows_; ///< for a file and a theorem
};

/// Writes into `folder`, in which `make` has run, the record of the theorems of these certificates
/// that Coq has accepted. Rows of other files of the folder stay. Throws InputError if the folder
/// does not hold the definitions that this program writes.
[[nodiscard]] Recording record_accepted(const std::vector<Certificate>& certificates,
                                        const std::filesystem::path& folder);

/// Returns the SHA-256 of what `sha256sum` prints for the files of the definitions, in the order in
/// which they are compiled.
[[nodiscard]] const std::string& definitions_sha256();

} // namespace edgeproof::certificate
