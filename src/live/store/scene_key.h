// What a stored model is of.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "base/volume.h"
#include "live/model/part_digests.h"
#include "scene/drawing/drawing.h"
#include "session/model_key.h"

namespace macula::app {

// The same key means the same voxels, geometry, preset, clip, table, lights, and settings that light depends
// on, of the same trainer and tracer: by what they are, and not by what they are called. Of a complete
// drawing. What of the parts is known is not read again: a whole second volume takes as long as the first.
session::ModelKey sceneKey(const std::string& volumeDigest, const Volume& volume, const Drawing& drawing,
                           PartDigests& parts);

// What a model can begin with that was stored under another key: splats of the same look.
enum class Kinship {
    none,          // points are a better beginning (docs/peripheral-model.md)
    otherLights,   // colours are other ones, all else is the same
    otherVersion,  // of trainer or tracer: it cannot be gone on with, but its splats are what they are
};
Kinship kinshipOf(const session::ModelKey& wanted, const session::ModelKey& stored);

}  // namespace macula::app
