#include "app/camera/camera_file.h"

#include "base/atomic_file.h"
#include "pipeline/volume/json_reader.h"

namespace macula::app {

namespace {

glm::dvec3 vector(const JsonNode& node) {
    const std::vector<double> xyz = node.numbers(3, {-1e6, 1e6});
    return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace

Result<Camera> readCamera(const std::filesystem::path& path) {
    MACULA_TRY(const std::string text, readText(path));
    const JsonDocument document(text, path.string());
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    root.allowOnly({"positionMm", "targetMm", "up", "verticalFovDeg"});
    const Camera camera{vector(root["positionMm"]), vector(root["targetMm"]), vector(root["up"]),
                        root["verticalFovDeg"].number({0.1, 170.0})};
    MACULA_TRY_VOID(document.status());
    if (const auto valid = basis(camera); !valid) {
        Error error = valid.error();
        error.code = ErrorCode::inputNotUsable;  // it came from a file, not from the command line
        error.where = path.string();
        return error;
    }
    return camera;
}

}  // namespace macula::app
