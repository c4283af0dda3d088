// Assimp over checked files in memory: the only header here that knows it.
//
// Nothing is read from the disk, nothing is printed, and no step that moves, joins or drops vertices is run.
#pragma once
#include <memory>
#include <string>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>

#include "model/core/progress.hpp"
#include "sim/load/prepare.hpp"

namespace rayclock {

/// Owns the imported scene; `scene` lives as long as this.
struct Imported {
    std::unique_ptr<Assimp::Importer> importer;
    const aiScene* scene = nullptr;
};

/// Throws UserError with `file` in front. `prepared` must outlive the call only.
Imported import_files(const std::string& file, const Prepared& prepared, const Progress& progress);

} // namespace rayclock
