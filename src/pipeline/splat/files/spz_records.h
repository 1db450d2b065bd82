// The records of others in an SPZ file (github.com/nianticlabs/spz, extensions/README.md): each a type (u32),
// a length (u32) and so many bytes, one behind the other. Numbers are little endian.
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
    std::string notes;                  // ours: the text of model_notes.h
    std::optional<std::uint32_t> axes;  // of SPZ_ADOBE_coordinate_system: the axes that the file is stored in
};

// What is of neither type is skipped. Of several axes the last count, as they do for the format's own
// library. Nothing behind a record that does not fit is read.
SpzRecords readSpzRecords(std::span<const std::byte> zone);

// A record with our notes.
std::vector<std::byte> spzNotesRecord(const std::string& notes);

// Turns a model that was read as if its file were in the format's axes (right, up, back) to what it is in
// those that the record names: each of left or right, down or up, back or front, with y and z in this order
// or the other. 0 is unspecified, and right, up, back. Some are of the other hand: what is mirrored in the
// file is right then. Fails with inputNotUsable for what is no such number.
Result<void> heedSpzAxes(std::uint32_t axes, Splats& splats);

}  // namespace macula::splat
