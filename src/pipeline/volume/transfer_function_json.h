// Transfer functions as JSON: the volume property of 3D Slicer (.vp.json, schema 1.0.0) with an additional
// object "macula". presets/schema/transfer-function.schema.json is the reference.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"

namespace macula {

// A file without the macula object counts as a CT preset of 3D Slicer: Hounsfield units, named
// `fallbackName`, or "preset". Reads the first of several volume properties or components. Fails with
// inputNotUsable: the message names the line or the key, the hint says what was expected. `where` names the
// file in the error.
Result<TransferFunction> transferFunctionFromJson(std::string_view text, const std::string& where,
                                                  const std::string& fallbackName = {});

// Makes a text that 3D Slicer can read. Writes into the document that the function was read from, and keeps
// its unknown keys and unchanged values. Reading the text gives an equal function, and writing that gives the
// same text, bit for bit.
std::string toJson(const TransferFunction& function);

}  // namespace macula
