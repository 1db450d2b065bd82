// DICOM files byte by byte: what no toolkit would write.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "dicom/read/tags.h"

namespace macula::dicom::test {

inline constexpr const char* kExplicit = "1.2.840.10008.1.2.1";
inline constexpr const char* kImplicit = "1.2.840.10008.1.2";
inline constexpr const char* kDeflated = "1.2.840.10008.1.2.1.99";
inline constexpr std::uint32_t kUndefined = 0xFFFFFFFF;

std::string bytesOf(std::uint64_t value, int count);  // little endian
// Explicit VR Little Endian; the value is padded to an even length.
std::string shortElement(Tag tag, const std::string& vr, std::string value);
std::string longElement(Tag tag, const std::string& vr, std::uint32_t length);  // the value is to follow
std::string sequence(Tag tag, const std::vector<std::string>& items);           // with lengths
std::string preamble(const std::string& transferSyntaxUid);
// SOP class and instance of a CT image, and its modality.
std::string sopClass();
std::string deflated(const std::string& bytes);

extern const std::string kItem;  // without its length
extern const std::string kItemEnd;
extern const std::string kSequenceEnd;

}  // namespace macula::dicom::test
