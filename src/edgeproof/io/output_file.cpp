// SPDX-License-Identifier: BSD-3-Clause
#include "edgeproof/io/output_file.hpp"
#include "edgeproof/io/text_file.hpp"
#include "edgeproof/precision/error.hpp"
#include "edgeproof/precision/interruption.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <system_error>
#include <utility>

namespace edgeproof::io {

namespace {

using Identity = std::pair<dev_t, ino_t>;

struct Inputs {
    std::atomic<bool> counted{false};
    std::mutex mutex;
    std::set<Identity> all;
};

Inputs& inputs() {
    static Inputs read;
    return read;
}

/// Returns the beginning without blanks, which depend on the width of columns.
std::string beginning_of(std::string_view text) {
    constexpr std::size_t enough = 16; // more than the first words of most files
    std::string out;
    for (const char c : text) {
        if (out.size() == enough) {
            break;
        }
        if (c != ' ' && c != '\n') {
            out += c;
        }
    }
    return out;
}

/// True for formats in which the files of all programs begin alike.
bool begins_like_any(std::string_view head) {
    return head.starts_with('<') || head.starts_with("\x89PNG") || head.starts_with("%PDF");
}

/// True for a line with "edgeproof 1.2.3 (".
bool names_program(std::string_view line) {
    constexpr std::string_view name = "edgeproof ";
    for (std::size_t at = line.find(name); at != std::string_view::npos; at = line.find(name, at)) {
        at += name.size();
        const std::size_t end = line.find_first_not_of("0123456789.", at);
        if (end > at && line.substr(end < line.size() ? end : line.size()).starts_with(" (")) {
            return true;
        }
    }
    return false;
}

bool contains_program(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    for (std::string line; std::getline(in, line);) {
        if (names_program(line)) {
            return true;
        }
    }
    return false;
}

char kind_of(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 ? 'a' : c; }

/// A text of the user's may quote a result, but it then begins in another way.
bool is_own(const std::filesystem::path& file, std::string_view head) {
    const std::string line = first_bytes(file);
    if (!begins_like_any(head) && beginning_of(line) == beginning_of(head)) {
        return true;
    }
    if (line.empty() || head.empty() || kind_of(line.front()) != kind_of(head.front())) {
        return false;
    }
    return contains_program(file);
}

/// True for a file that names the program, or whose first line may be that of a table without
/// notes.
bool may_be_own(const std::filesystem::path& file) {
    std::string line = first_bytes(file);
    line.resize(std::min(line.find('\n'), line.size()));
    constexpr std::string_view other_formats = "{|%\\"; // JSON, Markdown, LaTeX
    return line.find(',') != std::string::npos ||
           (!line.empty() && other_formats.find(line.front()) != std::string_view::npos &&
            !line.starts_with("%PDF")) ||
           contains_program(file);
}

void require_own(const std::filesystem::path& file, const std::function<bool()>& is_own_file) {
    struct stat found {};
    if (::stat(file.c_str(), &found) != 0 || found.st_size == 0) {
        return;
    }
    const std::lock_guard lock(inputs().mutex);
    if (inputs().all.contains({found.st_dev, found.st_ino})) {
        throw InputError(file.string() + " is an input of this command", "name another output");
    }
    if (!is_own_file()) {
        throw InputError(file.string() + " is there, and Edgeproof did not write it",
                         "remove it, or name another output");
    }
}

} // namespace

std::string first_bytes(const std::filesystem::path& file) {
    std::string head(4096, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

void protect_inputs() { inputs().counted = true; }

void remember_input(const std::filesystem::path& file) {
    struct stat found {};
    if (inputs().counted && ::stat(file.c_str(), &found) == 0 && S_ISREG(found.st_mode)) {
        const std::lock_guard lock(inputs().mutex);
        inputs().all.emplace(found.st_dev, found.st_ino);
    }
}

void require_replaceable(const std::filesystem::path& file, std::string_view head) {
    require_own(file, [&] { return is_own(file, head); });
}

void require_replaceable(const std::filesystem::path& file) {
    require_own(file, [&] { return may_be_own(file); });
}

namespace {

constexpr std::size_t most_of_head = 4096;

/// The files that write_whole() has created.
std::atomic<std::size_t> created{0};

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// Opens a file without a name, if the system supports such files and naming them later; else
/// returns -1.
int open_unnamed(const std::filesystem::path& folder) {
#ifdef O_TMPFILE
    if (::access("/proc/self/fd", X_OK) == 0) {
        return ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
    }
#endif
    return -1;
}

/// Returns N for a name of this process's descriptor N, else -1.
int own_descriptor(const std::filesystem::path& file) {
    const std::string name = file.lexically_normal().string();
    if (name == "/dev/stdout") {
        return STDOUT_FILENO;
    }
    if (name == "/dev/stderr") {
        return STDERR_FILENO;
    }
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (name.starts_with(folder)) {
            return read_whole<int>(std::string_view(name).substr(folder.size())).value_or(-1);
        }
    }
    return -1;
}

/// Writes the whole text to an open file. Returns 0, or the error number.
int write_all(int fd, const std::string& text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const ssize_t n = ::write(fd, text.data() + at, text.size() - at);
        if (n < 0 && errno != EINTR) {
            return errno;
        }
        at += n > 0 ? static_cast<std::size_t>(n) : 0;
    }
    return 0;
}

} // namespace

void cannot(const std::string& what, const std::filesystem::path& path, int error) {
    throw InputError("cannot " + what + " " + path.string() + ": " + std::strerror(error),
                     give_writable_folder);
}

namespace {

/// The target of a file to be written: links are followed, devices and FIFOs are detected.
struct OutputTarget {
    std::filesystem::path path;   ///< not a link
    int descriptor = -1;          ///< of this process, for /dev/stdout, /dev/fd/N, /proc/self/fd/N
    bool special = false;         ///< not a regular file: written directly, and never replaced
    std::optional<unsigned> mode; ///< permissions of an existing file
    /// Throws InputError for a folder and for a chain of more than forty links.
    [[nodiscard]] static OutputTarget of(const std::filesystem::path& file);
};

OutputTarget OutputTarget::of(const std::filesystem::path& file) {
    OutputTarget target;
    target.path = file;
    target.descriptor = own_descriptor(file);
    if (target.descriptor >= 0) {
        const int flags = ::fcntl(target.descriptor, F_GETFL);
        if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) {
            cannot("write", file, EBADF);
        }
        target.special = true;
        return target;
    }
    constexpr int most_links = 40; // as in the Linux kernel
    std::error_code none;
    for (int links = 0; std::filesystem::is_symlink(target.path, none); ++links) {
        const std::filesystem::path next = std::filesystem::read_symlink(target.path, none);
        if (links == most_links || next.empty()) {
            cannot("write", file, ELOOP);
        }
        target.path = next.is_absolute() ? next : folder_of(target.path) / next;
    }
    struct stat found {};
    if (::stat(target.path.c_str(), &found) == 0) {
        require(!S_ISDIR(found.st_mode), file.string() + " is a folder", "name a file");
        target.special = !S_ISREG(found.st_mode);
        target.mode = found.st_mode & 07777U;
    }
    return target;
}

/// An open file, which is closed, and removed if it has a temporary name.
struct OpenFile {
    int fd = -1;
    std::filesystem::path temporary = {};

    ~OpenFile() {
        if (fd >= 0) {
            ::close(fd);
        }
        if (!temporary.empty()) {
            ::unlink(temporary.c_str());
        }
    }
};

} // namespace

std::filesystem::path temporary_name(const std::filesystem::path& target) {
    std::random_device random;
    return target.string() + fmt::format(".{:08x}{:08x}.tmp", random(), random());
}

std::size_t files_created() { return created; }

void write_whole(const std::filesystem::path& file, const std::string& text) {
    const OutputTarget target = OutputTarget::of(file);
    TemporaryPath aside(temporary_name(target.path));
    OpenFile open;
    const auto require_done = [&](bool done) {
        if (!done) {
            cannot("write", file, errno);
        }
    };
    if (target.special) {
        open.fd = target.descriptor >= 0
                      ? ::fcntl(target.descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)
                      : ::open(target.path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    } else {
        std::error_code reported_below;
        std::filesystem::create_directories(folder_of(target.path), reported_below);
        open.fd = open_unnamed(folder_of(target.path));
        if (open.fd < 0) {
            open.fd = ::open(aside.path().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            open.temporary = open.fd < 0 ? std::filesystem::path() : aside.path();
        }
    }
    require_done(open.fd >= 0 &&
                 (target.special || !target.mode || ::fchmod(open.fd, *target.mode) == 0));
    check_interruption(); // a result may be incomplete then
    if (const int error = write_all(open.fd, text); error != 0) {
        cannot("write", file, error);
    }
    if (target.special) {
        return;
    }
    require_replaceable(file, std::string_view(text).substr(0, most_of_head));
    require_done(::fsync(open.fd) == 0);
    const auto lock = hold_cleanup();
    if (open.temporary.empty()) { // it gets a name
        const std::string by_number = "/proc/self/fd/" + std::to_string(open.fd);
        require_done(::linkat(AT_FDCWD, by_number.c_str(), AT_FDCWD, aside.path().c_str(),
                              AT_SYMLINK_FOLLOW) == 0);
        open.temporary = aside.path();
    }
    require_done(::rename(aside.path().c_str(), target.path.c_str()) == 0);
    open.temporary.clear();
    aside.keep_locked();
    created += target.mode ? 0 : 1;
}

namespace {

/// `errno` is 0 or the error of the last output: a stream does not store the number of an earlier
/// error.
void flush_printed() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw InputError("cannot write standard output" +
                             (errno != 0 ? std::string(": ") + std::strerror(errno) : ""),
                         errno == EPIPE
                             ? "the program that reads it ended before the end of the output"
                             : "make room where it is sent");
    }
}

} // namespace

void write_output(const std::filesystem::path& file, const std::string& text) {
    if (file != "-") {
        write_whole(file, text);
        return;
    }
    errno = 0;
    (void)std::fwrite(text.data(), 1, text.size(), stdout);
    flush_printed();
}

void finish_standard_output() {
    errno = 0;
    flush_printed();
}

void check_output(const std::filesystem::path& file) {
    if (file.empty() || file == "-") {
        return;
    }
    const OutputTarget target = OutputTarget::of(file);
    if (!target.special) {
        const auto folder = target.path.parent_path();
        check_folder(folder.empty() ? std::filesystem::path(".") : folder);
        require_replaceable(file);
    } else if (target.descriptor < 0 && ::access(target.path.c_str(), W_OK) != 0) {
        cannot("write", file, errno);
    }
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed) {
        cannot("make the folder", folder, failed.value());
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
        cannot("write into", folder, errno);
    }
}

void check_folder(const std::filesystem::path& folder) {
    std::filesystem::path there = folder; // the nearest existing folder
    std::error_code none;
    while (!there.empty() && !std::filesystem::exists(there, none)) {
        there = there.parent_path();
    }
    if (there.empty()) {
        there = ".";
    }
    if (!std::filesystem::is_directory(there, none)) {
        cannot("make the folder", folder, ENOTDIR);
    }
    if (::access(there.c_str(), W_OK | X_OK) != 0) {
        cannot(there == folder ? "write into" : "make the folder", folder, errno);
    }
}

namespace {

constexpr std::size_t hash_digits = 16;

bool is_file_name_character(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
}

bool begins_well(std::string_view name) {
    return !name.empty() && name.front() != '.' && name.front() != '-';
}

/// True for a text that ends like "-0123456789abcdef", the form of a changed name. Such an id is
/// changed, too, so that no id equals the name of another one.
bool ends_as_changed(std::string_view id) {
    if (id.size() <= hash_digits || id[id.size() - hash_digits - 1] != '-') {
        return false;
    }
    const std::string_view end = id.substr(id.size() - hash_digits);
    return end.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

} // namespace

FileStem::FileStem(std::string_view id) : text_(id) {
    if (id.size() <= most_bytes && begins_well(id) && !ends_as_changed(id) &&
        std::ranges::all_of(id, is_file_name_character)) {
        return;
    }
    text_.resize(std::min(text_.size(), most_bytes - hash_digits - 1));
    std::ranges::replace_if(
        text_, [](char c) { return !is_file_name_character(c); }, '-');
    if (!text_.empty() && !begins_well(text_)) {
        text_.front() = '_';
    }
    text_ = (text_.empty() ? "_" : text_) + '-' + sha256(id).substr(0, hash_digits);
}

} // namespace edgeproof::io
