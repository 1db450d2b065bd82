#include "live/model/model_output.h"

#include <string>

#include "pipeline/splat/draw/displayed.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::live {

Result<void> checkModelName(const std::filesystem::path& path) {
    if (splat::modelFormatOf(path) != nullptr) return {};
    return Error{ErrorCode::usage, Text("The model's name says no format."), path.string(),
                 Text("End it with {}.", splat::modelExtensions(true))};
}

Result<void> checkSplatsName(const std::filesystem::path& path) {
    const splat::ModelFormat* format = splat::modelFormatOf(path);
    if (format != nullptr && !format->keepsTraining()) return {};
    return Error{ErrorCode::usage, Text("The name says no format that splats alone are written in."),
                 path.string(), Text("End it with {}.", splat::modelExtensions(false))};
}

bool holdsTraining(const std::filesystem::path& path) {
    const splat::ModelFormat* format = splat::modelFormatOf(path);
    return format != nullptr && format->keepsTraining();
}

Result<std::size_t> writeTrained(const std::filesystem::path& path, const splat::TrainingState& state,
                                 bool displayColours) {
    if (!holdsTraining(path)) return writeSplats(path, state.splats, displayColours);
    MACULA_TRY_VOID(splat::writeTraining(path, state));
    return std::size_t{0};
}

Result<std::size_t> writeSplats(const std::filesystem::path& path, const splat::Splats& splats,
                                bool displayColours) {
    return splat::writeModel(path, displayColours ? splat::asDisplayed(splats) : splats);
}

}  // namespace macula::live
