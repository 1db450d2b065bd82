#include "scene/camera/camera_file.h"

#include "base/atomic_file.h"
#include "pipeline/volume/json_reader.h"

namespace macula::scene {

namespace {

glm::dvec3 vector(const JsonNode& node) {
    const std::vector<double> xyz = node.numbers(3, {-1e6, 1e6});
    return {xyz[0], xyz[1], xyz[2]};
}

}  // namespace

Camera cameraFrom(const JsonNode& node) {
    node.allowOnly({"positionMm", "targetMm", "up", "verticalFovDeg", "parallelHeightMm"});
    Camera camera;
    camera.positionMm = vector(node["positionMm"]);
    camera.targetMm = vector(node["targetMm"]);
    camera.up = vector(node["up"]);
    camera.verticalFovDeg = node["verticalFovDeg"].number({0.1, 170.0});
    if (const auto height = node.find("parallelHeightMm"))
        camera.parallelHeightMm = height->number({kLeastParallelMm, kMostParallelMm});
    return camera;
}

nlohmann::ordered_json toJson(const Camera& camera) {
    const auto list = [](const glm::dvec3& p) { return nlohmann::ordered_json{p.x, p.y, p.z}; };
    nlohmann::ordered_json json{{"positionMm", list(camera.positionMm)},
                                {"targetMm", list(camera.targetMm)},
                                {"up", list(camera.up)},
                                {"verticalFovDeg", camera.verticalFovDeg}};
    if (isParallel(camera)) json["parallelHeightMm"] = camera.parallelHeightMm;
    return json;
}

Result<Camera> readCamera(const std::filesystem::path& path) {
    MACULA_TRY(const std::string text, readText(path));
    const JsonDocument document(text, path.string());
    MACULA_TRY_VOID(document.status());
    const Camera camera = cameraFrom(document.root());
    MACULA_TRY_VOID(document.status());
    if (const auto valid = basis(camera); !valid) {
        Error error = valid.error();
        error.code = ErrorCode::inputNotUsable;  // it came from a file, not from the command line
        error.where = path.string();
        return error;
    }
    return camera;
}

}  // namespace macula::scene
