// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <boost/algorithm/string/replace.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
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

/// A new folder next to, or in, the target, removed with its contents.
class Stage {
public:
    /// `base`: the beginning of its name.
    Stage(const fs::path& base, const fs::path& target)
        : path_([&] {
              const fs::path path = temporary_name(base);
              if (::mkdir(path.c_str(), 0777) != 0) {
                  cannot("write", target, errno);
              }
              return path;
          }) {}
    ~Stage() {
        std::error_code ignored;
        fs::remove_all(path_.path(), ignored);
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    [[nodiscard]] const fs::path& path() const noexcept { return path_.path(); }

private:
    TemporaryPath path_;
};

/// While it exists, no other run moves files into the folder.
class FolderLock {
public:
    explicit FolderLock(const fs::path& folder)
        : fd_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        (void)::flock(fd_, LOCK_EX);
    }
    ~FolderLock() { ::close(fd_); }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int fd_;
};

/// All files and folders in a folder, relative to it; a folder stands before its contents.
std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> all;
    std::error_code ends; // a folder that vanished has none
    for (const auto& entry : fs::recursive_directory_iterator(folder, ends)) {
        all.push_back(entry.path().lexically_relative(folder));
    }
    return all;
}

/// Moves files into the target: all, or, if one cannot be moved, none. `kept` is a folder for
/// copies of the files that are replaced.
class Moves {
public:
    Moves(const fs::path& from, const fs::path& to, fs::path kept)
        : from_(from), to_(to), kept_(std::move(kept)), entries_(entries_of(from)) {}
    /// Throws before anything is changed.
    void check() const {
        for (const fs::path& entry : entries_) {
            const fs::path to = to_ / entry;
            const fs::file_status found = fs::symlink_status(to); // a link is not followed
            const bool folder = fs::is_directory(from_ / entry);
            if (fs::exists(found) &&
                (folder ? !fs::is_directory(found) : !fs::is_regular_file(found))) {
                throw InputError(to.string() + " is no " + (folder ? "folder" : "ordinary file"),
                                 "remove it, or give another folder");
            }
            check_folder(to.parent_path());
            if (fs::exists(found) && !folder) {
                require_replaceable(to, first_bytes(from_ / entry));
                fs::create_directories((kept_ / entry).parent_path());
                fs::copy_file(to, kept_ / entry);
            }
        }
    }
    void make() {
        try {
            for (const fs::path& entry : entries_) {
                if (!fs::is_directory(from_ / entry)) {
                    fs::rename(from_ / entry, to_ / entry);
                } else if (!fs::create_directory(to_ / entry)) {
                    continue; // it was there
                }
                made_.push_back(entry);
            }
        } catch (const fs::filesystem_error&) {
            undo();
            throw;
        }
    }

private:
    void undo() const {
        std::error_code ignored;
        for (const fs::path& entry : std::vector(made_.rbegin(), made_.rend())) {
            if (fs::exists(kept_ / entry)) {
                fs::rename(kept_ / entry, to_ / entry, ignored);
            } else {
                fs::remove(to_ / entry, ignored);
            }
        }
    }

    const fs::path& from_;
    const fs::path& to_;
    fs::path kept_;
    std::vector<fs::path> entries_;
    std::vector<fs::path> made_;
};

/// Replaces `stage` in the message by the folder that the user named.
InputError with_final_names(const InputError& error, const std::string& stage,
                            const std::string& target) {
    return {boost::replace_all_copy(error.problem(), stage, target), error.instead()};
}

void move_files(const fs::path& from, const fs::path& target, const fs::path& kept) {
    make_folder(target);
    const FolderLock only_this_run(target);
    const auto lock = hold_cleanup(); // a signal acts either before or after all of it
    check_interruption();
    try {
        Moves moves(from, target, kept);
        moves.check();
        moves.make();
    } catch (const fs::filesystem_error& error) {
        cannot("write", error.path2().empty() ? error.path1() : error.path2(),
               error.code().value());
    }
}

} // namespace

void write_folder(const fs::path& folder, const std::function<void(const fs::path&)>& write) {
    check_folder(folder); // its error names the folder as the user does
    const fs::path target = plain_target(folder);
    const bool there = fs::exists(fs::status(target));
    const fs::path top = there ? target : first_missing(target);
    const Stage stage(there ? target / ".edgeproof" : top, target);
    const fs::path whole = stage.path() / "new"; // becomes `top`
    const fs::path from = in_stage(whole, target, top);
    const std::size_t before = files_created();
    try {
        make_folder(from);
        write(from);
    } catch (const InputError& error) {
        throw with_final_names(error, from.string(), target.string());
    }
    const auto is_file = [&](const fs::path& entry) { return !fs::is_directory(from / entry); };
    const auto files = std::ranges::count_if(entries_of(from), is_file);
    if (static_cast<std::size_t>(files) != files_created() - before) {
        throw InputError("files of " + target.string() + " vanished while they were written",
                         "run it again, and let no other program remove temporary files");
    }
    if (!there) {
        const auto lock = hold_cleanup();
        check_interruption();
        std::error_code failed;
        fs::rename(whole, top, failed);
        if (!failed) {
            return;
        }
    } // else another process has created it meanwhile
    move_files(from, target, stage.path() / "old");
}

} // namespace edgeproof::io
