// Transfer functions as JSON: 3D Slicer's volume property (.vp.json, schema 1.0.0) with one more object,
// "macula". presets/schema/transfer-function.schema.json is the reference.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"

namespace macula {

// A file without the macula object is taken for a CT preset of 3D Slicer: Hounsfield units, named
// `fallbackName`, or "preset". Of several volume properties or components the first is read. Fails with
// inputNotUsable; the message tells the line or the key, the hint what was expected. `where` is the file, for
// the error.
Result<TransferFunction> transferFunctionFromJson(std::string_view text, const std::string& where,
                                                  const std::string& fallbackName = {});

// Readable by 3D Slicer. Written into the document that the function was read from: keys that mean nothing to
// Macula stay, and so does whatever still says the same. Reading it back gives an equal function, and writing
// that the same text, bit for bit.
std::string toJson(const TransferFunction& function);

}  // namespace macula
