#include "scene/camera/splat_cameras.h"

#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "pipeline/volume/json_reader.h"
#include "scene/camera/camera_file.h"

namespace macula::scene {

namespace {

constexpr std::size_t kMostBytes = 256u << 20;
constexpr std::size_t kMostCameras = 1u << 20;

// The rotation nearest to one that was rounded to a few digits (polar decomposition, Newton's iteration).
// Returns any other matrix unchanged; validation refuses it later.
glm::dmat3 rotationNear(const glm::dmat3& rounded) {
    constexpr double kRounded = 0.01;
    const glm::dmat3 square = rounded * glm::transpose(rounded);
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            if (!(std::abs(square[i][k] - (i == k ? 1.0 : 0.0)) < kRounded)) return rounded;
        }
    }
    glm::dmat3 m = rounded;
    for (int turn = 0; turn < 4; ++turn) m = 0.5 * (m + glm::inverse(glm::transpose(m)));
    return m;
}

// Whether a picture of one size, scaled, has the other size, apart from rounding of each side.
bool isScaled(const glm::ivec2& from, const glm::ivec2& to) {
    return std::abs(double(to.x) * from.y - double(to.y) * from.x) <= double(std::max(from.x, from.y));
}

// Changes a view to another picture size. Where the shape stays, the whole picture is scaled, as trainers
// shrink theirs; otherwise only the vertical field of view stays.
void resize(splat::RasterView& view, const glm::ivec2& size) {
    glm::dvec2 scale(double(size.y) / view.sizePx.y);
    if (isScaled(view.sizePx, size)) scale.x = double(size.x) / view.sizePx.x;
    const glm::dvec2 fromMiddle = (view.principalPx - 0.5 * glm::dvec2(view.sizePx)) * scale;
    view.focalPx *= scale;
    view.principalPx = 0.5 * glm::dvec2(size) + fromMiddle;
    view.sizePx = size;
}

SplatCamera cameraOf(const JsonNode& node) {
    SplatCamera camera;
    if (const auto name = node.find("img_name"); name && name->isText()) camera.name = name->text();
    splat::RasterView& view = camera.view;
    const auto sideOf = [&](const char* key) {
        return static_cast<int>(std::lround(node[key].number({1, splat::kMaxRasterSide})));
    };
    view.sizePx = {sideOf("width"), sideOf("height")};
    view.focalPx = {node["fx"].number({1e-2, 1e8}), node["fy"].number({1e-2, 1e8})};
    view.principalPx = 0.5 * glm::dvec2(view.sizePx);
    const auto cx = node.find("cx");
    const auto cy = node.find("cy");
    if (cx && cy) view.principalPx = {cx->number({-1e6, 1e6}), cy->number({-1e6, 1e6})};
    const std::vector<double> position = node["position"].numbers(3, {-1e8, 1e8});
    view.eyeMm = {position[0], position[1], position[2]};
    const std::vector<JsonNode> rows = node["rotation"].items(3, 3);
    // cameraFromWorld is the transpose of the file's worldFromCamera, so its columns are the rows of the
    // file.
    for (int row = 0; row < static_cast<int>(rows.size()); ++row) {
        const std::vector<double> numbers = rows[std::size_t(row)].numbers(3, {-2.0, 2.0});
        view.cameraFromWorld[row] = {numbers[0], numbers[1], numbers[2]};
    }
    view.cameraFromWorld = rotationNear(view.cameraFromWorld);
    return camera;
}

Error noList(const std::filesystem::path& path) {
    return {ErrorCode::inputNotUsable, Text("The file is no list of cameras."), path.string(),
            Text("Give --cameras the cameras.json that was written beside the model; --camera takes one of "
                 "Macula's own.")};
}

}  // namespace

Result<SplatCamera> readSplatCamera(const std::filesystem::path& path, std::optional<glm::ivec2> size) {
    {
        MACULA_TRY(const std::string text, readText(path, kMostBytes));
        if (const auto start = text.find_first_not_of(" \t\r\n"); start != text.npos && text[start] == '[')
            return Error{ErrorCode::inputNotUsable,
                         Text("The file holds a list, not one camera of Macula's own."), path.string(),
                         Text("Give it as --cameras.")};
    }
    MACULA_TRY(const Camera camera, readCamera(path));
    MACULA_TRY(const splat::RasterView view,
               splat::rasterView(camera, size.value_or(kDefaultCameraSize), glm::dvec3(0.0)));
    return SplatCamera{path.stem().string(), view};
}

Result<std::vector<SplatCamera>> readSplatCameras(const std::filesystem::path& path,
                                                  std::optional<glm::ivec2> size) {
    MACULA_TRY(const std::string text, readText(path, kMostBytes));
    const JsonDocument document(text, path.string());
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    if (!root.isList()) return noList(path);
    const std::vector<JsonNode> nodes = root.items(0, kMostCameras);
    MACULA_TRY_VOID(document.status());
    if (nodes.empty())
        return Error{ErrorCode::inputNotUsable, Text("The file holds no cameras."), path.string(),
                     Text("Check that it is the cameras.json of this model.")};
    std::vector<SplatCamera> cameras;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        cameras.push_back(cameraOf(nodes[i]));
        MACULA_TRY_VOID(document.status());
        splat::RasterView& view = cameras.back().view;
        if (size) resize(view, *size);
        if (const auto usable = splat::validate(view); !usable) {
            Error error = usable.error();
            error.code = ErrorCode::inputNotUsable;  // it came from a file, not from the command line
            error.message = Text("Camera [{}]: {}", i, error.message);
            error.where = path.string();
            return error;
        }
    }
    return cameras;
}

Result<std::vector<SplatCamera>> readSplatCameras(const std::filesystem::path& list,
                                                  std::span<const std::string> files,
                                                  std::optional<glm::ivec2> size) {
    if (!list.empty()) return readSplatCameras(list, size);
    std::vector<SplatCamera> cameras;
    for (const std::string& file : files) {
        MACULA_TRY(SplatCamera camera, readSplatCamera(file, size));
        cameras.push_back(std::move(camera));
    }
    return cameras;
}

}  // namespace macula::scene
