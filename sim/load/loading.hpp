#pragma once
// The state of one load, whichever files it reads: progress, the memory allowance and the notes for the user.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include <glm/vec4.hpp>

#include "model/base/progress.hpp"
#include "model/scene/placed.hpp"

namespace rayclock {

/// The largest number of triangles that loads. More would fill the memory long before tracing.
constexpr std::uint64_t max_triangles = 100'000'000;

/// The largest number of corners of a face: cutting a polygon takes quadratic time.
constexpr std::uint64_t max_corners = 10'000;

/// The memory allowance: the larger of `least` bytes and `for_a_byte` bytes per byte of all files read. It
/// exists because a few bytes can request copies of copies.
constexpr std::uint64_t least_allowance = std::uint64_t{1} << 30, bytes_for_a_byte = 1024;

struct Allowance {
    std::uint64_t least = least_allowance, for_a_byte = bytes_for_a_byte;
};

/// Returns the mean of a picture's texels (linear red, green, blue, and opacity) from the bytes of its file.
/// Throws std::runtime_error with the reason if the picture cannot be read.
using AverageColour = std::function<glm::vec4(const std::string& bytes)>;
/// Decodes a picture. Throws std::runtime_error with the reason if it cannot be read.
using DecodePicture = std::function<TexelLevel(const std::string& bytes)>;

/// Progress, allowance and notes of one load. Not safe to share between threads.
class Loading {
public:
    /// The caller must keep `progress` alive. Without `decode`, the load draws textures in their average
    /// colour.
    explicit Loading(const Progress& progress, Allowance allowance = {}, AverageColour average = {},
                     DecodePicture decode = {})
        : progress_(progress),
          allowance_(allowance),
          average_(std::move(average)),
          decode_(std::move(decode)) {}
    const Progress& progress() const { return progress_; }
    void report_progress(std::string_view what, std::uint64_t done, std::uint64_t total) const {
        if (progress_) progress_(what, done, total);
    }

    /// Reads a whole file and adds its size to the allowance. Throws UserError like read_file().
    std::string read(const std::filesystem::path& path, const std::string& asked_by = {});

    /// Returns the mean of a texture. Returns nothing, with the reason in `why`, if it cannot be read.
    std::optional<glm::vec4> average(const std::string& bytes, std::string& why) const;
    /// Returns true if the load draws pictures on triangles, false if it draws their average colours.
    bool draws_textures() const { return bool(decode_); }
    /// Returns a decoded picture. Returns nothing, with the reason in `why`, if it cannot be read.
    std::optional<TexelLevel> picture(const std::string& bytes, std::string& why) const;

    /// Charges bytes before they are made. Returns false if the files do not allow that many; the caller then
    /// throws UserError with the sentence too_much().
    bool may_make(std::uint64_t bytes);
    bool may_make(const Scene& part);
    std::string too_much() const;

    /// Adds a sentence about something that was left out or changed, with the file's name in front. Keeps
    /// equal sentences once.
    void note(const std::string& file, const std::string& sentence);
    const std::vector<std::string>& notes() const { return notes_; }

private:
    std::uint64_t most() const;

    const Progress& progress_;
    Allowance allowance_;
    AverageColour average_;
    DecodePicture decode_;
    std::uint64_t read_ = 0, made_ = 0;
    std::vector<std::string> notes_;
    std::unordered_set<std::string> noted_;   ///< the sentences in `notes_`, for searching
};

/// Returns a count with its noun: "1 triangle", "2 triangles", "2 vertices".
std::string counted(std::uint64_t count, std::string_view what);

/// Counts what the reader of one file repairs or leaves out. Each kind gives one sentence, independent of its
/// count: "a.obj: 3 lines skipped that are no statements of OBJ (the first: line 7, 'foo')". Call say() at
/// the end of a file that is drawn.
class Warnings {
public:
    explicit Warnings(std::string file) : file_(std::move(file)) {}
    /// Counts one occurrence. `what` is a noun in the singular, and `became` continues the sentence. The
    /// sentence shows `line` (0: none) and `value` of the first occurrence.
    void count(std::string_view what, std::string_view became, std::uint64_t line = 0,
               std::string_view value = {});
    /// Adds the sentences to the notes of the load.
    void say(Loading& loading) const;

private:
    struct WarningTally {
        std::string sentence() const;
        std::string what, became, first;
        std::uint64_t count;
    };
    std::string file_;
    std::vector<WarningTally> tallies_;   ///< a handful, in the order of their first occurrence
};

/// Returns true for a name that leads out of its folder: an absolute name, or one that begins with "..".
bool leaves_folder(const std::filesystem::path& name);

/// Returns the bytes of a scene's primitives, vertices and materials.
std::uint64_t bytes_of(const Scene& scene);
std::uint64_t bytes_of(const SharedMesh& mesh);
std::uint64_t bytes_of(const Motion& motion);       ///< of deforming meshes
std::uint64_t bytes_of(const PlacedScene& scene);   ///< of its own primitives and of each mesh once

}   // namespace rayclock
