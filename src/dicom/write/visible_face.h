// Decides whether a patient may be recognised by the face, even without a name.
#pragma once

#include <optional>
#include <string_view>

namespace macula::dicom {

// For Recognizable Visual Features (PS3.3 C.7.6.1). False only if Body Part Examined (0018,0015), `bodyPart`,
// is in the trunk below the chest or in a leg, and the length shown along the patient, `heightMm`, is at most
// 600 mm. An unknown part or length may include a head.
bool mayShowFace(std::string_view bodyPart, std::optional<double> heightMm);

}  // namespace macula::dicom
