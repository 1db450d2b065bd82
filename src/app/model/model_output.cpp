#include "app/model/model_output.h"

#include <string>

#include "pipeline/splat/draw/displayed.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::app {

Result<void> checkModelName(const std::filesystem::path& path) {
    const std::string extension = splat::extensionOf(path);
    if (extension == ".ply" || extension == ".spz" || extension == ".macula") return {};
    return Error{ErrorCode::usage, "The model's name says no format.", path.string(),
                 "End it with .ply, .spz or .macula."};
}

bool holdsTraining(const std::filesystem::path& path) {
    return splat::extensionOf(path) == ".macula";
}

Result<std::size_t> writeTrained(const std::filesystem::path& path, const splat::TrainingState& state,
                                 bool displayColours) {
    if (!holdsTraining(path))
        return splat::writeModel(path, displayColours ? splat::asDisplayed(state.splats) : state.splats);
    MACULA_TRY_VOID(splat::writeTraining(path, state));
    return std::size_t{0};
}

}  // namespace macula::app
