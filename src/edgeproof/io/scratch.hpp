// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "edgeproof/io/process_cleanup.hpp"
#include "edgeproof/precision/error.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace edgeproof::io {

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
        std::error_code failed;
        const std::filesystem::path folder = std::filesystem::temp_directory_path(failed);
        std::string name = (folder / "edgeproof-XXXXXX").string();
        if (failed || mkdtemp(name.data()) == nullptr) {
            throw InputError("no temporary folder can be made",
                             "set TMPDIR to a folder that can be written to");
        }
        return name;
    }
    TemporaryPath folder_;
};

} // namespace edgeproof::io
