// What one load has in common, however many files it reads: progress, what may be made of them, what is to be
// said.
#pragma once
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

/// More triangles than this do not load: they would fill the memory long before they were traced.
constexpr std::uint64_t max_triangles = 100'000'000;

/// More corners than this in one face are refused: cutting a polygon takes quadratic time.
constexpr std::uint64_t max_corners = 10'000;

/// A few bytes can ask for copies of copies. All that is made takes no more than this, or so many times the
/// bytes of all files.
constexpr std::uint64_t least_allowance = std::uint64_t{1} << 30, bytes_for_a_byte = 1024;

struct Allowance {
    std::uint64_t least = least_allowance, for_a_byte = bytes_for_a_byte;
};

/// The mean of a picture's texels, linear red, green and blue and opacity, from the bytes of its file. Throws
/// std::runtime_error with the reason if it cannot be read.
using AverageColour = std::function<glm::vec4(const std::string& bytes)>;

class Loading {
public:
    /// `progress` must outlive it.
    explicit Loading(const Progress& progress, Allowance allowance = {}, AverageColour average = {})
        : progress_(progress), allowance_(allowance), average_(std::move(average)) {}
    const Progress& progress() const { return progress_; }
    void tell(std::string_view what, std::uint64_t done, std::uint64_t total) const {
        if (progress_) progress_(what, done, total);
    }

    /// A whole file; its size counts for the allowance.
    std::string read(const std::filesystem::path& path, const std::string& asked_by = {});

    /// The mean of a texture; nothing, with the reason in `why`, if it cannot be had.
    std::optional<glm::vec4> average(const std::string& bytes, std::string& why) const;

    /// Before so many bytes are made: false if that is more than the files allow. Refuse by the sentence
    /// too_much().
    bool may_make(std::uint64_t bytes);
    bool may_make(const Scene& part);
    std::string too_much() const;

    /// One sentence about something that was left out or changed, with the file in front. The same is kept
    /// once.
    void note(const std::string& file, const std::string& sentence);
    const std::vector<std::string>& notes() const { return notes_; }

private:
    std::uint64_t most() const;

    const Progress& progress_;
    Allowance allowance_;
    AverageColour average_;
    std::uint64_t read_ = 0, made_ = 0;
    std::vector<std::string> notes_;
    std::unordered_set<std::string> noted_;   ///< the same, to be searched
};

/// "1 triangle", "2 triangles", "2 vertices".
std::string counted(std::uint64_t count, std::string_view what);

/// What the reader of one file repairs or leaves out. A kind gives one sentence, whatever its number:
/// "a.obj: 3 lines skipped that are no statements of OBJ (the first: line 7, 'foo')". Call say() at the end
/// of a file that is drawn.
class Warnings {
public:
    explicit Warnings(std::string file) : file_(std::move(file)) {}
    /// `what` is in the singular, and what has become of it follows. Of the first, `line` (0: none) and
    /// `value` are shown.
    void count(std::string_view what, std::string_view became, std::uint64_t line = 0,
               std::string_view value = {});
    void say(Loading& loading) const;

private:
    struct Kind {
        std::string sentence() const;
        std::string what, became, first;
        std::uint64_t count;
    };
    std::string file_;
    std::vector<Kind> kinds_;   ///< a handful, in the order in which they are met
};

/// True for a name that leads out of the folder that it is relative to: absolute, or by "..".
bool leaves_folder(const std::filesystem::path& name);

/// Bytes that a scene's primitives, vertices and materials take.
std::uint64_t bytes_of(const Scene& scene);
std::uint64_t bytes_of(const SharedMesh& mesh);
std::uint64_t bytes_of(const Motion& motion);       ///< of what deforms
std::uint64_t bytes_of(const PlacedScene& scene);   ///< of its own and its meshes', each once

}   // namespace rayclock
