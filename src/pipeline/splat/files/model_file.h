// Models in files: PLY (exact), SPZ (small), glTF (for other programs), and the splats of .macula files
// (which can resume training). See ply.h, spz.h, glb.h and training_file.h for what each keeps.
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

// The formats, in one table that writers, messages and docs/model-files.md follow.
struct ModelFormat {
    ModelKind kind;
    std::string_view extension;  // lower case, with the dot
    std::string_view name;
    // Whether writeTraining writes it, and not writeModel.
    constexpr bool keepsTraining() const { return kind == ModelKind::training; }
};
inline constexpr std::array<ModelFormat, 4> kModelFormats{{{ModelKind::ply, ".ply", "PLY"},
                                                           {ModelKind::spz, ".spz", "SPZ"},
                                                           {ModelKind::glb, ".glb", "glTF"},
                                                           {ModelKind::training, ".macula", ".macula"}}};
// The format of the path's extension; null for an unknown extension.
const ModelFormat* modelFormatOf(const std::filesystem::path& path);
// ".ply, .spz, .glb or .macula"; without .macula unless `withTraining`, since writeModel does not write it.
Text modelExtensions(bool withTraining);

// What a reader does with splats that validate would refuse. `repair` removes or clamps them, see repair();
// `repairOrNone` does the same, and accepts a model that is or becomes empty.
enum class BadSplats { refuse, repair, repairOrNone };

struct ModelFile {
    Splats splats;  // valid; at least one, except with repairOrNone
    Repair repaired;
};

// Recognises the format by content, not by name. Fails with inputNotUsable when the file is missing, of
// another format, damaged, cut off, without splats, or has bad ones that are refused; with outOfMemory when
// the model does not fit. Allocates no more memory than a file of that size can fill.
Result<ModelFile> readModel(const std::filesystem::path& path, BadSplats bad = BadSplats::refuse);

// Writes the format of the extension, which must not be one that keeps training; the file is written whole or
// not at all. Returns the number of splats that the format had to change (see SpzBytes and writeGlb; 0 for
// PLY). Fails with usage for another extension, with inputNotUsable for a model that is not valid or empty,
// with outputNotWritable when it cannot be written.
Result<std::size_t> writeModel(const std::filesystem::path& path, const Splats& splats);

// The last step of every reader: refuses a model that is empty or not valid, or repairs it.
Result<ModelFile> finishModel(Splats splats, BadSplats bad);

}  // namespace macula::splat
