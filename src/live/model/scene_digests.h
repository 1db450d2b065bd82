// SHA-256 of the parts of a scene, over what they are and not over what they are called: 64 hexadecimal
// digits. No patient data.
#pragma once

#include <string>

#include "base/volume.h"
#include "live/model/part_digests.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// Of the preset's numbers: the same curves under another name are the same preset.
std::string digestOf(TransferFunction function);
// The volume is the one that is clipped. What of the parts is known is not read again.
std::string digestOf(const Clip& clip, const Volume& volume, PartDigests& parts);
// Of what is shown beside the volume; none where that is nothing.
std::string digestOf(const Additions& additions, PartDigests& parts);
// Of the clip and of that; where that is nothing, of the clip alone.
std::string digestOf(const Clip& clip, const Additions& additions, const Volume& volume, PartDigests& parts);
std::string digestOf(const trace::Environment& lights);
// Of all of them; set those that do not matter to their defaults before.
std::string digestOf(const trace::Settings& settings);

}  // namespace macula::app
