// Whether a patient may be known by the face, which no name that is left out changes.
#pragma once

#include <optional>
#include <string_view>

namespace macula::dicom {

// For Recognizable Visual Features (PS3.3 C.7.6.1). Not only where the images say that they are of the trunk
// below the chest, or of a leg, and what is shown of the patient is no higher than that. What is not known
// may be a head: `bodyPart` is Body Part Examined (0018,0015), `heightMm` how much is shown along the
// patient.
bool mayShowFace(std::string_view bodyPart, std::optional<double> heightMm);

}  // namespace macula::dicom
