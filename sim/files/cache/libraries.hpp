#pragma once
// The cache of built libraries. An entry is a folder with a library and a seal. The seal holds the library's
// size and hash, so that damage on the disk is noticed before anything is loaded. Entries appear complete, by
// a rename. A builder holds the lock of its entry. The next program removes the files that a dead builder
// left.
#include <cstdint>
#include <filesystem>
#include <string>

namespace rayclock {

/// The folder of the cache, and the variable that set it.
struct CachePlace {
    std::filesystem::path folder;   ///< absolute
    std::string from;               ///< RAYCLOCK_CACHE, XDG_CACHE_HOME or HOME; empty if none of them is set
    std::string warning;            ///< a sentence if the folder is a poor choice, or empty
};
/// Returns $RAYCLOCK_CACHE, $XDG_CACHE_HOME/rayclock or ~/.cache/rayclock. Without a home it returns a
/// temporary folder, which must belong to this user alone. Throws UserError if it does not.
CachePlace cache_place();
/// Creates and returns the cache's folder. Prints the warning of cache_place() on standard error, once per
/// program. Throws UserError if others can write to the folder.
std::filesystem::path rtl_cache();

/// The prefix of the entry for Verilator's own sources. Its library is an object file that is linked to the
/// others.
inline constexpr const char *support_begin = "rc_verilated-", *support_name = "support.o";

/// The prefix of entries that hold a netlist. Their library is Verilog.
inline constexpr const char* netlist_begin = "rc_netlist-";

/// Returns the path of an entry's library.
std::filesystem::path library_of(const std::filesystem::path& entry);

/// Writes the seal of the library in a folder. `made_by` is a note for readers of the file. Throws UserError
/// if it cannot write.
void seal(const std::filesystem::path& folder, const std::string& made_by);

/// Returns true if the entry is a folder with an unchanged library, which only this user and root can write.
/// Does not follow links or open devices.
bool is_whole(const std::filesystem::path& entry);

/// Returns a whole entry whose name begins with `begin`, or an empty path. A machine without tools can use
/// any such entry.
std::filesystem::path whole_entry(const std::string& begin);

/// Creates the cache's folder and removes what dead builders left in it, once per program and folder. Throws
/// UserError if the folder cannot be made.
void open_cache();

/// Removes the file or folder at a place of the cache. Throws UserError if it cannot.
void clear_place(const std::filesystem::path& place);

/// Writes text into a file of the cache. Throws UserError if it cannot.
void write_text(const std::filesystem::path& path, const std::string& text);

/// The exclusive right to build an entry. It ends with this object or with the program, however the program
/// ends.
class BuildLock {
public:
    explicit BuildLock(const std::filesystem::path& entry) : path_(entry.string() + ".lock") {}
    ~BuildLock();
    BuildLock(const BuildLock&) = delete;
    BuildLock& operator=(const BuildLock&) = delete;

    /// Returns false if another builder holds the lock. Throws UserError if the cache cannot be written.
    bool take();

private:
    std::filesystem::path path_;
    int file_ = -1;
};

/// An empty folder next to an entry, for one builder. The destructor removes it.
class WorkFolder {
public:
    explicit WorkFolder(const std::filesystem::path& entry);
    ~WorkFolder();
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Renames the folder to the entry, which must not exist. Throws UserError if it cannot.
    void publish(const std::filesystem::path& entry);

private:
    std::filesystem::path path_;
};

}   // namespace rayclock
