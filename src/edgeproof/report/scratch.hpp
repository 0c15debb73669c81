// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/conformance/process_cleanup.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace edgeproof {

/// A folder of one's own under the system's temporary one, removed in the end, also where a signal
/// ends the process: files on the way to
/// a picture are never among the results.
class Scratch {
public:
    Scratch() : folder_(make) {}
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path(), ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return folder_.path(); }

private:
    static std::filesystem::path make() {
        std::string name = (std::filesystem::temp_directory_path() / "edgeproof-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) {
            throw Error("no temporary folder can be made as " + name);
        }
        return name;
    }
    TemporaryPath folder_;
};

} // namespace edgeproof
