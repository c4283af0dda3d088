// Allowance, notes and warnings of a load.
#include "sim/load/loading.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/files/input.hpp"

namespace rayclock {
namespace {

/// Returns a reason without its further lines, in which the library of picture formats gives advice.
std::string first_line(std::string_view reason) {
    return printable(reason.substr(0, reason.find('\n')), 200);
}

}   // namespace

std::string Loading::read(const std::filesystem::path& path, const std::string& asked_by) {
    std::string bytes = read_file(path, asked_by);
    read_ += bytes.size();
    return bytes;
}

std::uint64_t Loading::most() const { return std::max(allowance_.least, allowance_.for_a_byte * read_); }

bool Loading::may_make(std::uint64_t bytes) {
    if (bytes > most() - std::min(most(), made_)) return false;
    made_ += bytes;
    return true;
}

std::optional<glm::vec4> Loading::average(const std::string& bytes, std::string& why) const {
    if (!average_) {
        why = "pictures are not read here";
        return std::nullopt;
    }
    try {
        return average_(bytes);
    } catch (const std::runtime_error& error) {
        why = first_line(error.what());
        return std::nullopt;
    }
}

std::optional<TexelLevel> Loading::picture(const std::string& bytes, std::string& why) const {
    try {
        return decode_(bytes);
    } catch (const std::runtime_error& error) {
        why = first_line(error.what());
        return std::nullopt;
    }
}

bool Loading::may_make(const Scene& part) { return may_make(bytes_of(part)); }

std::string Loading::too_much() const {
    return fmt::format("makes more than {} MB of {} bytes of files", most() >> 20, read_);
}

void Loading::note(const std::string& file, const std::string& sentence) {
    std::string whole = printable(file) + ": " + sentence;
    if (noted_.insert(whole).second) notes_.push_back(std::move(whole));
}

std::string counted(std::uint64_t count, std::string_view what) {
    if (count == 1) return fmt::format("1 {}", what);
    if (what.ends_with("ex")) return fmt::format("{} {}ices", count, what.substr(0, what.size() - 2));
    return fmt::format("{} {}s", count, what);
}

void Warnings::count(std::string_view what, std::string_view became, std::uint64_t line,
                     std::string_view value) {
    for (WarningTally& tally : tallies_)
        if (tally.what == what && tally.became == became) {
            ++tally.count;
            return;
        }
    std::string first = line > 0 ? fmt::format("line {}", line) : std::string();
    if (!value.empty()) (first += first.empty() ? "" : ", ") += shown(value);
    tallies_.push_back({std::string(what), std::string(became), std::move(first), 1});
}

std::string Warnings::WarningTally::sentence() const {
    std::string all = counted(count, what) + " " + became;
    if (!first.empty()) all += (count == 1 ? " (" : " (the first: ") + first + ")";
    return all;
}

void Warnings::say(Loading& loading) const {
    for (const WarningTally& tally : tallies_) loading.note(file_, tally.sentence());
}

bool leaves_folder(const std::filesystem::path& name) {
    const std::filesystem::path plain = name.lexically_normal();
    return plain.is_absolute() || (!plain.empty() && *plain.begin() == "..");
}

std::uint64_t bytes_of(const Scene& scene) {
    return sizeof(glm::dvec3) * (scene.vertices.size() + scene.normals.size()) +
           sizeof(Triangle) * scene.triangles.size() + sizeof(CornerCoordinates) * scene.coordinates.size() +
           sizeof(Sphere) * scene.spheres.size() + sizeof(Plane) * scene.planes.size() +
           sizeof(Material) * scene.materials.size();
}

std::uint64_t bytes_of(const SharedMesh& mesh) {
    return sizeof(glm::dvec3) * (mesh.vertices.size() + mesh.normals.size()) +
           sizeof(Triangle) * mesh.triangles.size() + sizeof(CornerCoordinates) * mesh.coordinates.size();
}

std::uint64_t bytes_of(const PlacedScene& scene) {
    std::uint64_t bytes = bytes_of(scene.own);
    for (const SharedMesh& mesh : scene.meshes) bytes += bytes_of(mesh);
    return bytes + bytes_of(scene.motion);
}

std::uint64_t bytes_of(const Motion& motion) {
    std::uint64_t bytes = 0;
    for (const Deforming& d : motion.deforming) {
        bytes += sizeof(glm::dvec3) * (d.rest.size() + d.normals.size()) + sizeof(Joint) * d.joints.size() +
                 sizeof(Pull) * d.pulls.size() + sizeof(std::uint32_t) * d.first_pull.size();
        for (const MorphTarget& target : d.targets)
            bytes += sizeof(MorphTarget) + sizeof(glm::dvec3) * (target.moves.size() + target.turns.size());
    }
    return bytes;
}

}   // namespace rayclock
