// Models in files: PLY (exact), SPZ (small), glTF (for other programs), and the splats of .macula files (a
// training that can go on). See ply.h, spz.h, glb.h and training_file.h for what each keeps.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

enum class ModelKind { ply, spz, glb, training };

// The formats, in one table: writers, messages and docs/model-files.md go by it.
struct ModelFormat {
    ModelKind kind;
    std::string_view extension;  // small letters, with the dot
    std::string_view name;
    // Written by writeTraining.
    constexpr bool keepsTraining() const { return kind == ModelKind::training; }
};
inline constexpr std::array<ModelFormat, 4> kModelFormats{{{ModelKind::ply, ".ply", "PLY"},
                                                           {ModelKind::spz, ".spz", "SPZ"},
                                                           {ModelKind::glb, ".glb", "glTF"},
                                                           {ModelKind::training, ".macula", ".macula"}}};
// By extension; null for another.
const ModelFormat* modelFormatOf(const std::filesystem::path& path);
// ".ply, .spz, .glb or .macula"; `withTraining`: also what writeModel does not write.
Text modelExtensions(bool withTraining);

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

// By extension, of a format that keeps no training; whole or not at all. Returns the number of splats that
// the format could not hold as they are (see SpzBytes and writeGlb; 0 for PLY). Fails with usage for another
// extension, with inputNotUsable for a model that is not valid or empty, with outputNotWritable when it
// cannot be written.
Result<std::size_t> writeModel(const std::filesystem::path& path, const Splats& splats);

// The last step of every reader: refuses a model that is empty or not valid, or repairs it.
Result<ModelFile> finishModel(Splats splats, BadSplats bad);

}  // namespace macula::splat
