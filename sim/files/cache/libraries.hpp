#pragma once
// The folder of built libraries. An entry is a folder with a library and a seal, which holds the library's
// size and hash, so that whatever happened to the disk is noticed before anything is loaded. Entries appear
// whole, by a rename. Whoever builds one holds its lock; what a dead builder has left is swept by the next
// program.
#include <cstdint>
#include <filesystem>
#include <string>

namespace rayclock {

/// Where built libraries are kept, and who says so.
struct CachePlace {
    std::filesystem::path folder;   ///< absolute
    std::string from;               ///< RAYCLOCK_CACHE, XDG_CACHE_HOME, HOME, or nothing of these
    std::string warning;            ///< a sentence if it is no good place
};
/// $RAYCLOCK_CACHE, $XDG_CACHE_HOME/rayclock or ~/.cache/rayclock. Without a home it is a folder of temporary
/// files that must belong to this user alone; throws UserError if it does not.
CachePlace cache_place();
/// Its folder. A warning is said on standard error, once.
std::filesystem::path rtl_cache();

/// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::string& bytes);

/// The entry of Verilator's own sources begins so, and its library is an object that is linked to the others.
inline constexpr const char *support_begin = "rc_verilated-", *support_name = "support.o";

/// The entry of a netlist begins so, and its library is Verilog.
inline constexpr const char* netlist_begin = "rc_netlist-";

/// The library of an entry.
std::filesystem::path library_of(const std::filesystem::path& entry);

/// Writes the seal of the library in a folder. `made_by` is for readers.
void seal(const std::filesystem::path& folder, const std::string& made_by);

/// Whether the entry is a folder with a library as it was sealed. Links and devices are not followed.
bool is_whole(const std::filesystem::path& entry);

/// A whole entry whose name begins so, or empty: for a machine without tools, where any will do.
std::filesystem::path whole_entry(const std::string& begin);

/// Makes the cache's folder, and removes what dead builders have left there: once for a program and a folder.
/// Throws UserError if the folder cannot be made.
void open_cache();

/// Removes whatever is at this place of the cache. Throws UserError if it cannot.
void clear_place(const std::filesystem::path& place);

/// Text into a new file of the cache. Throws UserError if it cannot be written.
void write_text(const std::filesystem::path& path, const std::string& text);

/// The right to build an entry. It ends with this object, and with the program, however it ends.
class BuildLock {
public:
    explicit BuildLock(const std::filesystem::path& entry) : path_(entry.string() + ".lock") {}
    ~BuildLock();
    BuildLock(const BuildLock&) = delete;
    BuildLock& operator=(const BuildLock&) = delete;

    /// False if another builder has it. Throws UserError if the cache cannot be written.
    bool take();

private:
    std::filesystem::path path_;
    int file_ = -1;
};

/// An empty folder of its own beside an entry, removed in the end.
class WorkFolder {
public:
    explicit WorkFolder(const std::filesystem::path& entry);
    ~WorkFolder();
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Becomes the entry, in whose place nothing is.
    void publish(const std::filesystem::path& entry);

private:
    std::filesystem::path path_;
};

}   // namespace rayclock
