// Vendors' records in an SPZ file (github.com/nianticlabs/spz, extensions/README.md): each a type (u32), a
// length (u32) and that many bytes, one after another. Numbers are little endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

struct SpzRecords {
    std::string notes;                  // of Macula's own record: the text of model_notes.h
    std::optional<std::uint32_t> axes;  // of SPZ_ADOBE_coordinate_system: the axes of the file
};

// Skips records of other types. Of several records with axes the last counts, as in the format's own library.
// Stops at a record that does not fit.
SpzRecords readSpzRecords(std::span<const std::byte> zone);

// Makes the record with Macula's notes.
std::vector<std::byte> spzNotesRecord(const std::string& notes);

// Converts a model that was read as if its file had the format's axes (right, up, back) from the axes that
// the record names: each of left or right, down or up, back or front, with y and z in this order or swapped.
// 0 is unspecified, and means right, up, back. Left-handed axes are mirrored, which makes the model right.
// Fails with inputNotUsable for an unknown number.
Result<void> heedSpzAxes(std::uint32_t axes, Splats& splats);

}  // namespace macula::splat
