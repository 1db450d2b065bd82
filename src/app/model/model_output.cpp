#include "app/model/model_output.h"

#include <string>

#include "pipeline/splat/draw/displayed.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::app {

Result<void> checkModelName(const std::filesystem::path& path) {
    if (splat::modelFormatOf(path) != nullptr) return {};
    return Error{ErrorCode::usage, "The model's name says no format.", path.string(),
                 "End it with " + splat::modelExtensions(true) + "."};
}

bool holdsTraining(const std::filesystem::path& path) {
    const splat::ModelFormat* format = splat::modelFormatOf(path);
    return format != nullptr && format->keepsTraining();
}

Result<std::size_t> writeTrained(const std::filesystem::path& path, const splat::TrainingState& state,
                                 bool displayColours) {
    if (!holdsTraining(path))
        return splat::writeModel(path, displayColours ? splat::asDisplayed(state.splats) : state.splats);
    MACULA_TRY_VOID(splat::writeTraining(path, state));
    return std::size_t{0};
}

}  // namespace macula::app
