// What each interpolation filter does to a picture: how smooth surfaces are, and how much fine detail
// remains.
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
    std::string preset = "cinematic-skin";  // for the shapes: CT
    std::string lights{scene::kDefaultLights};
    std::string device;
    std::filesystem::path pictures;  // a folder for pictures of the shapes; empty: none
    bool overwrite = false;          // existing pictures
    int size = 96;                   // side of the square pictures, in pixels
    std::uint32_t samples = 512;     // of each of the two traced pictures
};

struct SurfaceRow {
    Shape shape = Shape::plane;
    std::string by;  // "cinematic smooth", "vtk"
    Ripple ripple;
};

struct DetailRow {
    Detail detail = Detail::lines;
    trace::Filter filter = trace::Filter::trilinear;
    double contrast = 0.0;  // of lines: amplitude of their period over the mean; else (peak - background) /
    // background
    double kept = 1.0;  // part of the contrast of the trilinear filter
};

struct InterpolationReport {
    std::string device;
    std::vector<SurfaceRow> surfaces;
    std::vector<DetailRow> details;
    std::optional<Error> withoutVtk;
};

// Marks the middle of a picture of the shape, where the surface is turned away from the eye by less than 40
// degrees.
std::vector<std::uint8_t> middleOf(Shape shape, int size, double heightMm);

// Finds errors before any measurement. Fails with usage, inputNotUsable or outputNotWritable.
Result<void> check(const InterpolationOptions& options);
Result<InterpolationReport> measureInterpolation(const InterpolationOptions& options, Progress& progress);
nlohmann::ordered_json reportOf(const InterpolationOptions& options, const InterpolationReport& report);

}  // namespace macula::evaluate
