// Models in files: PLY (exact), SPZ (small), and the splats of .macula files (a training that can go on). See
// ply.h, spz.h and training_file.h for what each keeps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/result.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// What a reader does with splats that validate would refuse. `repair` also clamps, see repair();
// `repairOrNone` likewise, and a model of which nothing is left, or which was empty, is no error.
enum class BadSplats { refuse, repair, repairOrNone };

struct ModelFile {
    Splats splats;  // valid, and at least one but for repairOrNone
    Repair repaired;
};

// The format is known by content, not by name. Fails with inputNotUsable when the file is missing, of no such
// format, damaged, cut off, without splats, or has bad ones that are refused; with outOfMemory when the model
// does not fit. No more memory is asked for than a file of that size can fill.
Result<ModelFile> readModel(const std::filesystem::path& path, BadSplats bad = BadSplats::refuse);

// Of a file's name, in small letters, with its dot.
std::string extensionOf(const std::filesystem::path& path);

// By extension, .ply or .spz; whole or not at all. Returns the number of splats that the format could not
// hold as they are (see SpzBytes; 0 for PLY). Fails with usage for another extension, with inputNotUsable for
// a model that is not valid or empty, with outputNotWritable when it cannot be written.
Result<std::size_t> writeModel(const std::filesystem::path& path, const Splats& splats);

// The last step of every reader: refuses a model that is empty or not valid, or repairs it.
Result<ModelFile> finishModel(Splats splats, BadSplats bad);

}  // namespace macula::splat
