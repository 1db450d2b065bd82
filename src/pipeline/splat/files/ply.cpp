#include "pipeline/splat/files/ply.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/splat/files/model_notes.h"
#include "pipeline/splat/files/ply_header.h"
#include "pipeline/splat/files/ply_layout.h"
#include "pipeline/splat/files/ply_packed.h"
#include "pipeline/splat/files/ply_values.h"
#include "pipeline/splat/model/constant_colour.h"

namespace macula::splat {

namespace {

static_assert(std::endian::native == std::endian::little, "rows are written as they lie in memory");

Error unusable(Text message, Text hint = Text("Export the model again from where it came.")) {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(hint)};
}

// Mip-Splatting stores a splat before its 3D filter, but draws it after: widened in space by f, with its
// opacity lowered in proportion. This applies the filter.
void widen(float filter, glm::vec3& logScale, float& opacityLogit) {
    if (filter == 0.0f) return;
    const double logFilter = std::log(std::abs(double(filter)));
    if (std::isnan(logFilter)) {
        opacityLogit = filter;  // not finite: repair drops the splat, as for any such number
        return;
    }
    double logShare = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double before = logScale[axis];
        const double more = std::max(before, logFilter);
        const double after = more + 0.5 * std::log1p(std::exp(2.0 * (std::min(before, logFilter) - more)));
        logShare += std::min(before - after, 0.0);
        logScale[axis] = static_cast<float>(after);
    }
    // With o the opacity and r the share, this is the logit of r o, computed without 1 - r o, which may
    // cancel.
    const double logit = opacityLogit;
    const double rest = -std::expm1(logShare);
    opacityLogit = static_cast<float>(logit < 0.0 ? logit + logShare - std::log1p(rest * std::exp(logit))
                                                  : logShare - std::log(std::exp(-logit) + rest));
}

void setRow(Splats& splats, std::size_t i, const PlyLayout& layout, const std::vector<float>& row) {
    const auto three = [&](std::size_t slot) { return glm::vec3(row[slot], row[slot + 1], row[slot + 2]); };
    splats.position[i] = three(PlyLayout::kPosition);
    splats.dc[i] = layout.hasColourBytes ? dcOfColour(three(PlyLayout::kDc) / 255.0f) : three(PlyLayout::kDc);
    splats.opacityLogit[i] = row[PlyLayout::kOpacity];
    splats.logScale[i] = three(PlyLayout::kScale);
    if (layout.isFlat) splats.logScale[i].z = -kMaxLogScale;
    if (layout.hasFilter) widen(row[PlyLayout::kFilter], splats.logScale[i], splats.opacityLogit[i]);
    splats.rotation[i] = glm::vec4(row[PlyLayout::kRotation], row[PlyLayout::kRotation + 1],
                                   row[PlyLayout::kRotation + 2], row[PlyLayout::kRotation + 3]);
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t k = 0; k < count; ++k)
        splats.sh[i * count + k] = {row[PlyLayout::kRest + k], row[PlyLayout::kRest + count + k],
                                    row[PlyLayout::kRest + 2 * count + k]};
}

void getRow(const Splats& splats, std::size_t i, float* out) {
    const auto add = [&](const auto& values) {
        for (int k = 0; k < values.length(); ++k) *out++ = values[k];
    };
    add(splats.position[i]);
    add(glm::vec3(0.0f));  // the normal
    add(splats.dc[i]);
    const std::size_t count = shCount(splats.shDegree);
    for (int channel = 0; channel < 3; ++channel) {
        for (std::size_t k = 0; k < count; ++k) *out++ = splats.sh[i * count + k][channel];
    }
    *out++ = splats.opacityLogit[i];
    add(splats.logScale[i]);
    add(splats.rotation[i]);
}

Result<Splats> readVertices(PlyValues& values, const PlyElement& vertex, const PlyLayout& layout) {
    Splats splats;
    splats.shDegree = layout.shDegree;
    splats.resize(vertex.count);
    std::vector<float> row(layout.size());
    for (std::size_t i = 0; i < vertex.count; ++i) {
        for (std::size_t p = 0; p < vertex.properties.size(); ++p) {
            const PlyProperty& property = vertex.properties[p];
            double value = 0.0;
            const bool read = property.countType ? values.skip(property) : values.next(property.type, value);
            if (!read)
                return unusable(
                    Text("The PLY file is cut off or damaged at splat {} of {}.", i + 1, vertex.count));
            if (layout.slots[p] != PlyLayout::kNone) row[layout.slots[p]] = toFloat(value);
        }
        setRow(splats, i, layout, row);
    }
    return splats;
}

Error doesNotFit() {
    return {ErrorCode::outOfMemory,
            Text("The model does not fit into memory."),
            {},
            Text("Close other programs, or export a smaller one.")};
}

Result<ModelFile> readPacked(const PlyHeader& header, PlyValues& values, BadSplats bad) {
    try {
        MACULA_TRY(Splats splats, readPackedPly(header, values));
        MACULA_TRY_VOID(applyNotes(header.comments, splats));
        return finishModel(std::move(splats), bad);
    } catch (const std::bad_alloc&) {
        return doesNotFit();
    }
}

std::string headerOf(const Splats& splats) {
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& note : notesOf(splats)) text += fmt::format("comment {}\n", note);
    text += fmt::format("element vertex {}\n", splats.size());
    const auto add = [&](std::string_view name) { text += fmt::format("property float {}\n", name); };
    const auto numbered = [&](std::string_view name, std::size_t count) {
        for (std::size_t k = 0; k < count; ++k) add(fmt::format("{}{}", name, k));
    };
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) add(name);
    numbered("f_dc_", 3);
    numbered("f_rest_", 3 * shCount(splats.shDegree));
    add("opacity");
    numbered("scale_", 3);
    numbered("rot_", 4);
    return text + "end_header\n";
}

}  // namespace

Result<ModelFile> readPly(std::istream& stream, std::uint64_t bytes, BadSplats bad) {
    MACULA_TRY(const PlyHeader header, readPlyHeader(stream));
    PlyValues values(stream, header.format, bytes - std::min(bytes, header.bytes));
    if (isPackedPly(header)) return readPacked(header, values, bad);
    for (const PlyElement& element : header.elements) {
        // Checked before memory is allocated for the elements, or they are read.
        if (!values.canHold(element))
            return unusable(
                Text("The PLY file is cut off: its header counts {} {}, for which it is too small.",
                     element.count, element.name == "vertex" ? Text("splats") : Text("elements")));
        if (element.name != "vertex") {
            if (!values.skip(element)) return unusable(Text("The PLY file is cut off or damaged."));
            continue;
        }
        MACULA_TRY(const PlyLayout layout, plyLayoutOf(element));
        try {
            MACULA_TRY(Splats splats, readVertices(values, element, layout));
            MACULA_TRY_VOID(applyNotes(header.comments, splats));
            if (layout.hasFilter) splats.lowPass = LowPass::mip;
            return finishModel(std::move(splats), bad);
        } catch (const std::bad_alloc&) {
            return doesNotFit();
        }
    }
    return unusable(Text("The PLY file holds no points."), Text("Choose a model of Gaussians."));
}

Result<void> writePly(std::ostream& stream, const Splats& splats) {
    MACULA_TRY_VOID(splats.validate());
    if (splats.size() == 0) return unusable(Text("The model holds no splats."), Text("Train it first."));
    const std::string header = headerOf(splats);
    stream.write(header.data(), static_cast<std::streamsize>(header.size()));
    constexpr std::size_t kOurs = PlyLayout::kFilter;  // slots before it have one property each
    constexpr std::size_t kNormal = 3;
    std::vector<float> row(kOurs + kNormal + 3 * shCount(splats.shDegree));
    for (std::size_t i = 0; i < splats.size() && stream; ++i) {
        getRow(splats, i, row.data());
        stream.write(reinterpret_cast<const char*>(row.data()),
                     static_cast<std::streamsize>(row.size() * sizeof(float)));
    }
    return {};
}

}  // namespace macula::splat
