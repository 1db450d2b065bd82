#include "study/export/grid_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/english.h"

namespace macula::study {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json gridToJson(const glm::ivec3& size, const glm::dmat4& worldFromVoxel) {
    Json spacing = Json::array();
    for (int axis = 0; axis < 3; ++axis) spacing.push_back(glm::length(glm::dvec3(worldFromVoxel[axis])));
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        Json values = Json::array();
        for (int column = 0; column < 4; ++column) values.push_back(worldFromVoxel[column][row]);
        rows.push_back(values);
    }
    return {{"size", {size.x, size.y, size.z}},
            {"spacingMm", spacing},
            {"orientation", orientationOf(worldFromVoxel)},
            {"worldFromVoxel", rows}};
}

std::string orientationOf(const glm::dmat4& worldFromVoxel) {
    std::string letters;
    for (int axis = 0; axis < 3; ++axis)
        letters += orientationLetters(glm::normalize(glm::dvec3(worldFromVoxel[axis]))).substr(0, 1);
    return letters;
}

bool isSheared(const glm::dmat4& worldFromVoxel) {
    constexpr double kMostCosine = 9e-4;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 a = glm::normalize(glm::dvec3(worldFromVoxel[axis]));
        const glm::dvec3 b = glm::normalize(glm::dvec3(worldFromVoxel[(axis + 1) % 3]));
        if (std::abs(glm::dot(a, b)) > kMostCosine) return true;
    }
    return false;
}

nlohmann::ordered_json toJson(const formats::VolumeFileInfo& info, const Volume* volume) {
    nlohmann::ordered_json json = {{"format", info.format}, {"values", info.values}};
    json.update(gridToJson(info.size, info.worldFromVoxel));
    json["calibrated"] = info.isCalibrated;
    json["sheared"] = isSheared(info.worldFromVoxel);
    if (volume != nullptr) {
        json["unit"] = volume->unitName();
        if (const auto& range = volume->valueRange()) json["valueRange"] = {range->low, range->high};
    }
    json["assumptions"] = inEnglish(info.assumptions);
    return json;
}

}  // namespace macula::study
