// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/io/staged_folder.hpp"

#include "edgeproof/io/atomic_file.hpp"
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace edgeproof::io {
namespace {

namespace fs = std::filesystem;

/// Without a slash at its end.
fs::path without_slash(const fs::path& folder) {
    return folder.has_filename() || !folder.has_parent_path() ? folder : folder.parent_path();
}

fs::path checked(const fs::path& target, bool inside) {
    // Says what is wrong with it.
    make_folder(inside ? target : target.has_parent_path() ? target.parent_path() : fs::path("."));
    return target;
}

/// What temporary names of this target begin with; the process, and ".tmp", follow.
fs::path stage_base(const fs::path& target, bool inside) {
    return inside ? target / ".edgeproof" : target;
}

/// By its name, so that errors name the folder as the user does.
fs::path make_stage(const fs::path& target, bool inside) {
    const fs::path base = stage_base(target, inside);
    remove_left_over(stage_base(target, true));
    remove_left_over(stage_base(target, false));
    const fs::path stage = base.string() + "." + std::to_string(::getpid()) + ".tmp";
    make_folder(stage);
    return stage;
}

[[noreturn]] void cannot_move(const fs::path& file, const std::error_code& why) {
    throw InputError("cannot write " + file.string() + ": " + why.message(), give_writable_folder);
}

} // namespace

StagedFolder::StagedFolder(const fs::path& target)
    : target_(without_slash(target)), inside_(fs::exists(fs::status(target_))),
      stage_([this] { return make_stage(checked(target_, inside_), inside_); }),
      lock_(::open(stage_.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (lock_ >= 0) {
        (void)::flock(lock_, LOCK_SH | LOCK_NB);
    }
}

StagedFolder::~StagedFolder() {
    if (lock_ >= 0) {
        ::close(lock_);
    }
    std::error_code ignored;
    fs::remove_all(path(), ignored);
}

InputError StagedFolder::told(const InputError& error) const {
    std::string problem = error.problem();
    const std::string stage = path().string();
    for (std::size_t at = 0; (at = problem.find(stage, at)) != std::string::npos;) {
        problem.replace(at, stage.size(), target_.string());
        at += target_.string().size();
    }
    return {problem, error.instead()};
}

void StagedFolder::commit() {
    const auto lock = hold_cleanup(); // a signal comes before all of it, or after
    check_interruption();
    std::error_code failed;
    if (!inside_) {
        fs::rename(path(), target_, failed);
        if (!failed) {
            stage_.keep_locked();
            return;
        }
        failed.clear(); // somebody has made it meanwhile
    }
    std::vector<std::pair<fs::path, fs::path>> moves;
    for (const auto& entry : fs::recursive_directory_iterator(path(), failed)) {
        const fs::path to = target_ / fs::relative(entry.path(), path());
        if (!entry.is_directory()) {
            moves.emplace_back(entry.path(), to);
        } else if (fs::create_directories(to, failed); failed) {
            cannot_move(to, failed);
        }
    }
    if (failed) {
        cannot_move(target_, failed);
    }
    for (const auto& [from, to] : moves) {
        fs::rename(from, to, failed);
        if (failed) {
            cannot_move(to, failed);
        }
    }
    fs::remove_all(path(), failed);
}

} // namespace edgeproof::io
