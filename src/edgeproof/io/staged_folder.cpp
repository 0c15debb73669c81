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

/// Returns the path without a final slash, and without ".." after a missing folder.
fs::path plain_target(const fs::path& folder) {
    const fs::path plain =
        folder.has_filename() || !folder.has_parent_path() ? folder : folder.parent_path();
    const bool parent_is_there =
        !plain.has_parent_path() || fs::exists(fs::status(plain.parent_path()));
    return parent_is_there ? plain : plain.lexically_normal();
}

/// Returns the highest missing folder of the target's path, which commit() creates.
fs::path first_missing(const fs::path& target) {
    fs::path missing = target;
    while (missing.has_parent_path() && missing.parent_path() != missing &&
           !fs::exists(fs::status(missing.parent_path()))) {
        missing = missing.parent_path();
    }
    return missing;
}

/// Returns the folder in the stage for the files of the target; the stage becomes `top`.
fs::path in_stage(const fs::path& stage, const fs::path& target, const fs::path& top) {
    return target == top ? stage : stage / target.lexically_relative(top);
}

/// The beginning of the temporary names of this target; the process number and ".tmp" follow.
fs::path stage_base(const fs::path& target, bool inside) {
    return inside ? target / ".edgeproof" : first_missing(target);
}

/// Creates the stage by its given name, so that errors name the folder as the user does.
fs::path make_stage(const fs::path& target, bool inside) {
    check_folder(target); // its error names the target
    const fs::path base = stage_base(target, inside);
    if (inside) {
        remove_left_over(base);
    }
    remove_left_over(first_missing(target));
    const fs::path stage = base.string() + "." + std::to_string(::getpid()) + ".tmp";
    make_folder(inside ? stage : in_stage(stage, target, base));
    return stage;
}

} // namespace

StagedFolder::StagedFolder(const fs::path& target)
    : target_(plain_target(target)), inside_(fs::exists(fs::status(target_))),
      top_(inside_ ? target_ : first_missing(target_)),
      stage_([this] { return make_stage(target_, inside_); }),
      path_(in_stage(stage_.path(), target_, top_)),
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
    fs::remove_all(stage_.path(), ignored);
}

void StagedFolder::fill(const std::function<void(const fs::path&)>& write) const {
    try {
        write(path());
    } catch (const InputError& error) {
        throw with_final_names(error);
    }
}

InputError StagedFolder::with_final_names(const InputError& error) const {
    std::string problem = error.problem();
    const std::string stage = path().string();
    for (std::size_t at = 0; (at = problem.find(stage, at)) != std::string::npos;) {
        problem.replace(at, stage.size(), target_.string());
        at += target_.string().size();
    }
    return {problem, error.instead()};
}

void StagedFolder::commit() {
    const auto lock = hold_cleanup(); // a signal acts either before or after all of it
    check_interruption();
    std::error_code failed;
    if (!inside_) {
        fs::rename(stage_.path(), top_, failed);
        if (!failed) {
            stage_.keep_locked();
            return;
        }
        failed.clear(); // another process has created it meanwhile
    }
    if (fs::create_directories(target_, failed); failed) {
        cannot("write", target_, failed.value());
    }
    std::vector<std::pair<fs::path, fs::path>> moves;
    for (const auto& entry : fs::recursive_directory_iterator(path(), failed)) {
        const fs::path to = target_ / fs::relative(entry.path(), path());
        if (!entry.is_directory()) {
            moves.emplace_back(entry.path(), to);
        } else if (fs::create_directories(to, failed); failed) {
            cannot("write", to, failed.value());
        }
    }
    if (failed) {
        cannot("write", target_, failed.value());
    }
    for (const auto& [from, to] : moves) {
        fs::rename(from, to, failed);
        if (failed) {
            cannot("write", to, failed.value());
        }
    }
    fs::remove_all(stage_.path(), failed);
}

} // namespace edgeproof::io
