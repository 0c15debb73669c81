// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/audit/ledger/ledger.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace edgeproof::scene {
struct Scene;
struct SceneResult;
} // namespace edgeproof::scene

namespace edgeproof::certificate {

using audit::Claim;
using audit::ClaimResult;
using audit::Ledger;
using audit::SceneSpec;

/// The theorems of one claim as a file for Coq, or the reason why there are none. Nothing here is
/// trusted: the file contains a statement and a proposed proof, and Coq's kernel accepts or rejects
/// it.
struct Certificate {
    std::string id;      ///< of the claim
    std::string verdict; ///< the verdict that `verify` gives
    /// The name of each theorem, and its statement in words.
    struct Theorem {
        std::string name;
        std::string states;
    };
    std::vector<Theorem> theorems; ///< empty: there is no file
    bool whole_verdict = false;    ///< the theorems state everything that the verdict does
    std::string leaves_out;        ///< the part that is not stated, or why there is no theorem
    std::string file;              ///< the file's name: "EQ18.v"
    std::string text;              ///< the file's content
};

/// Returns the theorems that can be stated about a claim as printed (its readings are left out).
[[nodiscard]] Certificate certify(const ClaimResult& result, const Ledger& ledger);

/// Returns the name in Coq for an id: "EQ30_L" for "EQ30.L".
[[nodiscard]] std::string coq_name(const std::string& id);

/// The facts that the README.md of a folder of certificates contains.
struct FolderTitle {
    std::string of;      ///< the subject: "the ledger moore-hills"
    std::string things;  ///< what the theorems are about: "claims"
    std::string command; ///< the command that writes the folder again
    std::string version; ///< the program's version
};

/// Writes a folder that `make -C DIR` checks with Coq and Coq-Interval: a file for each claim, the
/// Coq files that they import, Makefile, index.csv (a row for each theorem, and one for each claim
/// without a theorem) and README.md (what is trusted). Throws InputError if a file cannot be
/// written.
void write_certificates(const std::vector<Certificate>& certificates,
                        const std::filesystem::path& folder, const FolderTitle& title);

/// Adds to each result its certificate from `folder`, if the claim's file and the Coq files that it
/// imports are byte for byte those that write_certificates would write now. A claim whose text or
/// verdict has changed since gets no certificate. The certificate is `accepted` if accepted.csv in
/// the folder records all its theorems. `shown` is the folder's name in TheoremFile::path.
void attach_certificates(audit::AuditResult& result, const Ledger& ledger,
                         const std::filesystem::path& folder, const std::string& shown);

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

/// States the values of a scene as theorems: the printed value is the exact value, rounded. There
/// is one file for the load, and at each edge one for the coefficients, one for the pressures and
/// one for each extent. A value that cannot be stated has no theorem, and its certificate gives the
/// reason. The `verdict` of each certificate is "value".
/// @param scene the scene, with all quantities that it asks for
/// @param result the values of those that can be stated
[[nodiscard]] std::vector<Certificate> certify_scene(const scene::Scene& scene,
                                                     const scene::SceneResult& result);

} // namespace edgeproof::certificate
