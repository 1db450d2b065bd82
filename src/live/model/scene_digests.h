// SHA-256 of the parts of a scene, from their content and not their names: 64 hexadecimal digits. No patient
// data.
#pragma once

#include <string>

#include "base/volume.h"
#include "live/model/part_digests.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::live {

// Digest of the preset's numbers: the same curves under another name are the same preset.
std::string digestOf(TransferFunction function);
// `volume` is the clipped one. Parts whose digest is known are not read again.
std::string digestOf(const Clip& clip, const Volume& volume, PartDigests& parts);
// Digest of the additions; empty if there are none.
std::string digestOf(const Additions& additions, PartDigests& parts);
// Digest of clip and additions; without additions, that of the clip alone.
std::string digestOf(const Clip& clip, const Additions& additions, const Volume& volume, PartDigests& parts);
std::string digestOf(const trace::Environment& lights);
// Digest of all settings; set those that do not matter to their defaults before.
std::string digestOf(const trace::Settings& settings);

}  // namespace macula::live
