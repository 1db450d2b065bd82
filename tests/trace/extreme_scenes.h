// Scenes at the ends of what may come: values, sizes, places, curves, cameras and lights.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "base/camera.h"
#include "trace/scenes.h"

namespace macula::scenes {

struct ExtremeScene {
    std::string name;
    std::shared_ptr<const Volume> volume;
    TransferFunction function;
    trace::View view;
    trace::Environment environment = trace::Environment::constant(glm::vec3(1.0f));

    friend void PrintTo(const ExtremeScene& scene, std::ostream* out) { *out << scene.name; }
};

inline trace::View lookAt(const Volume& volume, double fovDeg = 20.0, int pixels = 16) {
    return {.camera = frameBox(volume.worldBox(), ViewDirection::anterior, fovDeg, 1.0),
            .width = pixels,
            .height = pixels};
}

inline std::shared_ptr<const Volume> volumeWithUnits(
    glm::ivec3 size, const glm::dmat4& worldFromVoxel, UnitsFromStored units,
    const std::function<std::uint16_t(int, int, int)>& stored) {
    std::vector<std::uint16_t> voxels;
    for (int k = 0; k < size.z; ++k) {
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) voxels.push_back(stored(i, j, k));
        }
    }
    VolumeOptions options{.size = size, .worldFromVoxel = worldFromVoxel, .unitsFromStored = units};
    options.modality = "OT";
    return std::make_shared<const Volume>(
        std::move(Volume::create(std::move(options), std::move(voxels))).value());
}

// A curve that rises over [low, high] to `opacity` per `unitMm`.
inline TransferFunction ramp(double low, double high, double opacity, double unitMm) {
    TransferFunction function = homogeneous(1.0);
    function.opacity = {{low, 0.0}, {high, opacity}};
    function.density = 1.0;
    function.unitDistanceMm = unitMm;
    return function;
}

inline glm::dmat4 grid(const glm::dvec3& spacingMm, const glm::ivec3& size,
                       const glm::dvec3& centreMm = glm::dvec3(0.0)) {
    const glm::dvec3 first = centreMm - 0.5 * spacingMm * glm::dvec3(size - 1);
    return affine({spacingMm.x, 0, 0}, {0, spacingMm.y, 0}, {0, 0, spacingMm.z}, first);
}

// A ball of smoothly varying values from 0 to `high`, in the middle of the grid.
inline std::function<std::uint16_t(int, int, int)> blob(glm::ivec3 size, std::uint16_t high) {
    return [size, high](int i, int j, int k) {
        const glm::dvec3 p = (glm::dvec3(i, j, k) + 0.5) / glm::dvec3(size) * 2.0 - 1.0;
        return static_cast<std::uint16_t>(high * std::clamp(1.0 - glm::dot(p, p), 0.0, 1.0));
    };
}

inline std::vector<ExtremeScene> extremeScenes() {
    std::vector<ExtremeScene> scenes;
    const auto add = [&](ExtremeScene scene) { scenes.push_back(std::move(scene)); };
    const glm::ivec3 size(24, 20, 16);
    const auto plain = volumeOf(size, grid(glm::dvec3(1.0), size), blob(size, 1000));
    const TransferFunction soft = ramp(100, 900, 0.3, 1.0);

    add({"a ball", plain, soft, lookAt(*plain)});

    // Values.
    const auto allStored =
        volumeWithUnits(size, grid(glm::dvec3(1.0), size), {1.0, -32768.0}, blob(size, 65535));
    add({"HU from -32768 to 32767", allStored, ramp(-30000, 30000, 0.2, 1.0), lookAt(*allStored)});
    const auto tinySlope = volumeWithUnits(size, grid(glm::dvec3(1.0), size), {1e-6, 0.0}, blob(size, 65535));
    add({"slope of a millionth", tinySlope, ramp(0.01, 0.06, 0.2, 1.0), lookAt(*tinySlope)});
    const auto hugeSlope =
        volumeWithUnits(size, grid(glm::dvec3(1.0), size), {1e6, -3e10}, blob(size, 65535));
    add({"slope of a million", hugeSlope, ramp(-2e10, 3e10, 0.2, 1.0), lookAt(*hugeSlope)});
    {
        std::vector<float> values;
        const auto stored = blob(size, 10000);
        for (int k = 0; k < size.z; ++k) {
            for (int j = 0; j < size.y; ++j) {
                for (int i = 0; i < size.x; ++i) values.push_back(100.0f * stored(i, j, k) + 0.25f);
            }
        }
        VolumeOptions options{.size = size, .worldFromVoxel = grid(glm::dvec3(1.0), size)};
        options.modality = "PT";
        const auto pet = in16Bits(std::make_shared<const Volume>(
            std::move(Volume::createFloat(std::move(options), std::move(values))).value()));
        add({"float PET up to a million", pet, ramp(1e4, 9e5, 0.3, 1.0), lookAt(*pet)});
    }

    // Sizes and places.
    const auto fine = volumeOf(size, grid(glm::dvec3(0.01), size), blob(size, 1000));
    add({"voxels of 0.01 mm", fine, ramp(100, 900, 0.3, 0.01), lookAt(*fine)});
    const auto coarse = volumeOf(size, grid(glm::dvec3(50.0), size), blob(size, 1000));
    add({"voxels of 50 mm", coarse, ramp(100, 900, 0.3, 50.0), lookAt(*coarse)});
    const auto flat = volumeOf(size, grid({0.05, 50.0, 0.05}, size), blob(size, 1000));
    trace::View alongFlat = lookAt(*flat);
    alongFlat.camera.positionMm = {0, -1500, 0};
    alongFlat.camera.verticalFovDeg = 0.1;
    add({"a thousand to one along the view", flat, ramp(100, 900, 0.3, 50.0), alongFlat});
    const auto tall = volumeOf(size, grid({50.0, 0.05, 0.05}, size), blob(size, 1000));
    trace::View acrossTall = lookAt(*tall);
    acrossTall.camera.positionMm = {10, -500, 0};
    acrossTall.camera.targetMm = {10, 0, 0};
    acrossTall.camera.verticalFovDeg = 0.1;
    add({"a thousand to one across the view", tall, ramp(100, 900, 0.3, 0.05), acrossTall});
    const auto far = volumeOf(size, grid(glm::dvec3(1.0), size, {1e5, -1e5, 1e5}), blob(size, 1000));
    add({"100 m from the scanner's origin", far, soft, lookAt(*far)});
    const auto one = volumeOf({1, 1, 1}, grid(glm::dvec3(3.0), {1, 1, 1}), [](int, int, int) { return 900; });
    add({"one voxel", one, soft, lookAt(*one)});
    const auto slice = volumeOf({32, 32, 1}, grid({1, 1, 2}, {32, 32, 1}),
                                [](int i, int j, int) { return std::uint16_t(20 * (i + j)); });
    add({"one slice, seen on edge", slice, soft, lookAt(*slice)});
    trace::View above = lookAt(*slice);
    above.camera = frameBox(slice->worldBox(), ViewDirection::superior, 20, 1.0);
    add({"one slice, seen from above", slice, soft, above});
    const auto empty = volumeOf(size, grid(glm::dvec3(1.0), size), [](int, int, int) { return 0; });
    add({"all the same value, unseen", empty, soft, lookAt(*empty)});

    // Curves.
    TransferFunction step = soft;
    step.opacity = {{500.5, 0.0}, {500.5, 0.3}};
    add({"a step of no width", plain, step, lookAt(*plain)});
    TransferFunction band = soft;
    band.opacity = {{500, 0.0}, {500, 0.5}, {520, 0.5}, {520, 0.0}};
    add({"a narrow band", plain, band, lookAt(*plain)});
    TransferFunction none = soft;
    none.opacity = {{0, 0.0}, {1000, 0.0}};
    add({"nothing to see", plain, none, lookAt(*plain)});
    TransferFunction all = soft;
    all.opacity = {{0, 1.0}, {1000, 1.0}};
    add({"everything opaque", plain, all, lookAt(*plain)});
    TransferFunction thin = soft;
    thin.opacity = {{0, 1e-4}, {1000, 1e-4}};
    add({"almost nothing", plain, thin, lookAt(*plain)});
    thin.opacity = {{0, 1e-7}, {1000, 1e-7}};
    add({"next to nothing", plain, thin, lookAt(*plain)});

    // Cameras.
    trace::View inside = lookAt(*plain, 60);
    inside.camera.positionMm = {0.3, -0.2, 0.1};
    inside.camera.targetMm = {1, 3, 0.5};
    add({"the eye inside of matter", plain, soft, inside});
    trace::View corner = inside;
    corner.camera.positionMm = {0.5, 0.5, 0.5};  // of voxels, and of bricks at their faces
    corner.camera.targetMm = {0.5, 10.5, 0.5};   // along an axis, in a face
    add({"the eye on a corner, along an axis", plain, soft, corner});
    trace::View away = lookAt(*plain);
    away.camera.positionMm = {1, -1e4, 2};
    away.camera.verticalFovDeg = 0.12;
    add({"10 m away", plain, soft, away});
    trace::View awayFromFine = lookAt(*fine);
    awayFromFine.camera.positionMm = {0, -1e3, 0};
    awayFromFine.camera.verticalFovDeg = 0.1;
    add({"1 m from voxels of 0.01 mm", fine, ramp(100, 900, 0.3, 0.01), awayFromFine});
    trace::View wide = lookAt(*plain);
    wide.camera.positionMm = {0, -12, 0};
    wide.camera.verticalFovDeg = 170;
    add({"a field of view of 170 degrees", plain, soft, wide});
    trace::View narrow = lookAt(*plain);
    narrow.camera.verticalFovDeg = 0.1;
    add({"a field of view of 0.1 degrees", plain, soft, narrow});

    // Lights.
    std::vector<glm::vec3> spark(64 * 32, glm::vec3(0.0f));
    spark[10 * 64 + 20] = glm::vec3(1e6f);
    add({"one texel of a million", plain, soft, lookAt(*plain),
         *trace::Environment::fromImage(64, 32, spark)});
    spark[10 * 64 + 20] = glm::vec3(1.0f);
    add({"one texel of one", plain, soft, lookAt(*plain), *trace::Environment::fromImage(64, 32, spark)});
    add({"no light at all", plain, soft, lookAt(*plain), trace::Environment::constant(glm::vec3(0.0f))});
    return scenes;
}

}  // namespace macula::scenes
