// What each way to find values between voxels does to a picture: how smooth surfaces are, and how much of
// fine detail is left.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/made_shapes.h"
#include "evaluate/ripple.h"
#include "pipeline/trace/settings.h"
#include "scene/choice/lights_choice.h"

namespace macula::evaluate {

struct InterpolationOptions {
    std::string preset = "cinematic-skin";  // of the shapes: CT
    std::string lights{scene::kDefaultLights};
    std::string device;
    std::filesystem::path pictures;  // a folder for those of the shapes; empty: none
    bool overwrite = false;          // those that are there
    int size = 96;                   // of the pictures, which are square
    std::uint32_t samples = 512;     // of each of the two pictures that are traced
};

struct SurfaceRow {
    Shape shape = Shape::plane;
    std::string by;  // "cinematic smooth", "vtk"
    Ripple ripple;
};

struct DetailRow {
    Detail detail = Detail::lines;
    trace::Filter filter = trace::Filter::trilinear;
    double contrast = 0.0;  // of lines the amplitude of their period over the mean; else what is above the
                            // background, over that
    double kept = 1.0;      // of the contrast that the trilinear filter has
};

struct InterpolationReport {
    std::string device;
    std::vector<SurfaceRow> surfaces;
    std::vector<DetailRow> details;
    std::optional<Error> withoutVtk;
};

// The middle of a picture of the shape, where its surface is turned away from the eye by less than 40
// degrees.
std::vector<std::uint8_t> middleOf(Shape shape, int size, double heightMm);

// usage, inputNotUsable or outputNotWritable for what would fail later.
Result<void> check(const InterpolationOptions& options);
Result<InterpolationReport> measureInterpolation(const InterpolationOptions& options, Progress& progress);
nlohmann::ordered_json reportOf(const InterpolationOptions& options, const InterpolationReport& report);

}  // namespace macula::evaluate
