// The model key of a scene.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/volume.h"
#include "live/model/part_digests.h"
#include "scene/drawing/drawing.h"
#include "session/model_key.h"

namespace macula::live {

// The same key means the same voxels, geometry, preset, clip, table, lights, and settings that light depends
// on, of the same trainer and tracer: by content, not by name. `drawing` is complete. Parts whose digest is
// known are not read again; reading a second volume takes as long as the first.
session::ModelKey modelKeyOf(const std::string& volumeDigest, const Volume& volume,
                             const scene::Drawing& drawing, PartDigests& parts);

// How a model stored under another key helps a new one to begin: with splats of the same look.
enum class Kinship {
    none,          // not at all; points are better (docs/peripheral-model.md)
    otherLights,   // only the colours differ
    otherVersion,  // another trainer or tracer: the training cannot resume, but its splats can be drawn
};
Kinship kinshipOf(const session::ModelKey& wanted, const session::ModelKey& stored);

}  // namespace macula::live
