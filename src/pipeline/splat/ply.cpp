#include "pipeline/splat/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/splat/model_notes.h"
#include "pipeline/splat/ply_header.h"
#include "pipeline/splat/ply_values.h"

namespace macula::splat {

namespace {

static_assert(std::endian::native == std::endian::little, "rows are written as they lie in memory");

// Where a row holds what. The bands of spherical harmonics come last, channel by channel.
enum Slot : std::size_t { kPosition = 0, kDc = 3, kOpacity = 6, kScale = 7, kRotation = 10, kRest = 14 };

// By slot.
constexpr std::array<std::string_view, kRest> kNames{"x",      "y",       "z",       "f_dc_0",  "f_dc_1",
                                                     "f_dc_2", "opacity", "scale_0", "scale_1", "scale_2",
                                                     "rot_0",  "rot_1",   "rot_2",   "rot_3"};

Error unusable(std::string message, std::string hint = "Export the model again from where it came.") {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(hint)};
}

// The slots of an element's properties, kNone for those that mean nothing to us.
struct Layout {
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> slots;
    int shDegree = 0;
    std::size_t size() const { return kRest + 3 * shCount(shDegree); }
};

// The number behind "f_rest_", or nothing.
std::optional<std::size_t> restIndex(std::string_view name) {
    constexpr std::string_view kRestName = "f_rest_";
    if (!name.starts_with(kRestName)) return std::nullopt;
    name.remove_prefix(kRestName.size());
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
    if (error != std::errc() || end != name.data() + name.size() || index > 1000) return std::nullopt;
    return index;
}

Result<Layout> layoutOf(const PlyElement& vertex) {
    Layout layout;
    std::vector<bool> seen(kRest + 1000 + 1, false);
    std::size_t rest = 0;
    for (const PlyProperty& property : vertex.properties) {
        std::size_t slot = Layout::kNone;
        const auto* found = std::find(kNames.begin(), kNames.end(), property.name);
        if (found != kNames.end()) slot = static_cast<std::size_t>(found - kNames.begin());
        if (const auto index = restIndex(property.name)) {
            slot = kRest + *index;
            ++rest;
        }
        if (slot != Layout::kNone) {
            if (property.countType)
                return unusable(fmt::format("The PLY file has a list in the place of {}.", property.name));
            if (seen[slot]) return unusable(fmt::format("The PLY file has {} twice.", property.name));
            seen[slot] = true;
        }
        layout.slots.push_back(slot);
    }
    std::string missing;
    for (std::size_t slot = 0; slot < kRest; ++slot) {
        if (!seen[slot]) missing += fmt::format("{}{}", missing.empty() ? "" : ", ", kNames[slot]);
    }
    if (!missing.empty())
        return unusable(fmt::format("The PLY file is no model of Gaussians: it lacks {}.", missing),
                        "Choose a model as 3D Gaussian splatting writes it, not a mesh or a point cloud.");
    while (layout.shDegree < kMaxShDegree && 3 * shCount(layout.shDegree) < rest) ++layout.shDegree;
    if (3 * shCount(layout.shDegree) != rest ||
        !std::all_of(seen.begin() + kRest, seen.begin() + static_cast<std::ptrdiff_t>(kRest + rest),
                     [](bool is) { return is; }))
        return unusable(fmt::format("The PLY file has {} coefficients of colour beyond the first of each "
                                    "channel; 0, 9, 24 or 45 are understood.",
                                    rest),
                        "Export it with spherical harmonics of degree 3 or less.");
    return layout;
}

void setRow(Splats& splats, std::size_t i, const std::vector<float>& row) {
    const auto three = [&](std::size_t slot) { return glm::vec3(row[slot], row[slot + 1], row[slot + 2]); };
    splats.position[i] = three(kPosition);
    splats.dc[i] = three(kDc);
    splats.opacityLogit[i] = row[kOpacity];
    splats.logScale[i] = three(kScale);
    splats.rotation[i] =
        glm::vec4(row[kRotation], row[kRotation + 1], row[kRotation + 2], row[kRotation + 3]);
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t k = 0; k < count; ++k)
        splats.sh[i * count + k] = {row[kRest + k], row[kRest + count + k], row[kRest + 2 * count + k]};
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

Result<Splats> readVertices(PlyValues& values, const PlyElement& vertex, const Layout& layout) {
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
                return unusable(fmt::format("The PLY file is cut off or damaged at splat {} of {}.", i + 1,
                                            vertex.count));
            if (layout.slots[p] != Layout::kNone) row[layout.slots[p]] = toFloat(value);
        }
        setRow(splats, i, row);
    }
    return splats;
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
    for (const PlyElement& element : header.elements) {
        // Before anything is made for them, or walked.
        if (!values.canHold(element))
            return unusable(
                fmt::format("The PLY file is cut off: its header counts {} {}, for which it is "
                            "too small.",
                            element.count, element.name == "vertex" ? "splats" : "elements"));
        if (element.name != "vertex") {
            if (!values.skip(element)) return unusable("The PLY file is cut off or damaged.");
            continue;
        }
        MACULA_TRY(const Layout layout, layoutOf(element));
        try {
            MACULA_TRY(Splats splats, readVertices(values, element, layout));
            MACULA_TRY_VOID(applyNotes(header.comments, splats));
            return finishModel(std::move(splats), bad);
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory,
                         "The model does not fit into memory.",
                         {},
                         "Close other programs, or export a smaller one."};
        }
    }
    return unusable("The PLY file holds no points.", "Choose a model of Gaussians.");
}

Result<void> writePly(std::ostream& stream, const Splats& splats) {
    MACULA_TRY_VOID(splats.validate());
    if (splats.size() == 0) return unusable("The model holds no splats.", "Train it first.");
    const std::string header = headerOf(splats);
    stream.write(header.data(), static_cast<std::streamsize>(header.size()));
    constexpr std::size_t kNormal = 3;
    std::vector<float> row(kRest + kNormal + 3 * shCount(splats.shDegree));
    for (std::size_t i = 0; i < splats.size() && stream; ++i) {
        getRow(splats, i, row.data());
        stream.write(reinterpret_cast<const char*>(row.data()),
                     static_cast<std::streamsize>(row.size() * sizeof(float)));
    }
    return {};
}

}  // namespace macula::splat
