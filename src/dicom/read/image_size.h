// The largest image size.
#pragma once

namespace macula::dicom {

// Rows and Columns are US in the standard; a header may use another VR, with any value.
inline constexpr int kMostRows = 65535;

}  // namespace macula::dicom
