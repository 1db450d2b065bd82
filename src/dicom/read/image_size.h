// How large an image may be.
#pragma once

namespace macula::dicom {

// Rows and Columns are US in the standard; a header may use another VR, and then say anything.
inline constexpr int kMostRows = 65535;

}  // namespace macula::dicom
