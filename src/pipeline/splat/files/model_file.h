// Models in files: PLY (exact), SPZ (small), and the splats of .macula files (a training that can go on). See
// ply.h, spz.h and training_file.h for what each keeps.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// The formats, in one table: readers, writers, messages and docs/model-files.md go by it.
struct ModelFormat {
    std::string_view extension;  // small letters, with the dot
    std::string_view name;
    bool keepsTraining = false;  // written by writeTraining
};
inline constexpr std::array<ModelFormat, 3> kModelFormats{
    {{".ply", "PLY"}, {".spz", "SPZ"}, {".macula", ".macula", true}}};
// The format by extension; null for another.
const ModelFormat* modelFormatOf(const std::filesystem::path& path);
// ".ply, .spz or .macula"; `withTraining`: also what writeModel does not write.
std::string modelExtensions(bool withTraining);

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

// Writes the format of the extension, .ply or .spz, whole or not at all. Returns the number of splats that
// the format could not hold as they are (see SpzBytes; 0 for PLY). Fails with usage for another extension,
// with inputNotUsable for a model that is not valid or empty, with outputNotWritable when it cannot be
// written.
Result<std::size_t> writeModel(const std::filesystem::path& path, const Splats& splats);

// The last step of every reader: refuses a model that is empty or not valid, or repairs it.
Result<ModelFile> finishModel(Splats splats, BadSplats bad);

}  // namespace macula::splat
