// The data elements of documents (PS3.6). Only for the sources of this folder.
#pragma once

#include "dicom/read/tags.h"

namespace macula::dicom::document_tag {

inline constexpr Tag kContentDate{0x0008, 0x0023};
inline constexpr Tag kContentTime{0x0008, 0x0033};
inline constexpr Tag kCodingScheme{0x0008, 0x0102};
inline constexpr Tag kCodeMeaning{0x0008, 0x0104};
inline constexpr Tag kLongCodeValue{0x0008, 0x0119};
inline constexpr Tag kUrnCodeValue{0x0008, 0x0120};
inline constexpr Tag kReferencedSopClassUid{0x0008, 0x1150};
inline constexpr Tag kReferencedSopInstanceUid{0x0008, 0x1155};
inline constexpr Tag kReferencedFrames{0x0008, 0x1160};
inline constexpr Tag kReferencedSops{0x0008, 0x1199};
inline constexpr Tag kVerifyingOrganisation{0x0040, 0xA027};
inline constexpr Tag kVerificationDateTime{0x0040, 0xA030};
inline constexpr Tag kRelationship{0x0040, 0xA010};
inline constexpr Tag kValueType{0x0040, 0xA040};
inline constexpr Tag kConceptName{0x0040, 0xA043};
inline constexpr Tag kVerifyingObservers{0x0040, 0xA073};
inline constexpr Tag kVerifyingObserver{0x0040, 0xA075};
inline constexpr Tag kDateTime{0x0040, 0xA120};
inline constexpr Tag kDate{0x0040, 0xA121};
inline constexpr Tag kTime{0x0040, 0xA122};
inline constexpr Tag kPersonName{0x0040, 0xA123};
inline constexpr Tag kUid{0x0040, 0xA124};
inline constexpr Tag kTemporalRange{0x0040, 0xA130};
inline constexpr Tag kTextValue{0x0040, 0xA160};
inline constexpr Tag kFloatingPointValue{0x0040, 0xA161};
inline constexpr Tag kConceptCode{0x0040, 0xA168};
inline constexpr Tag kMeasuredValue{0x0040, 0xA300};
inline constexpr Tag kNumericValueQualifier{0x0040, 0xA301};
inline constexpr Tag kNumericValue{0x0040, 0xA30A};
inline constexpr Tag kPredecessors{0x0040, 0xA360};
inline constexpr Tag kCompletionFlag{0x0040, 0xA491};
inline constexpr Tag kCompletionDescription{0x0040, 0xA492};
inline constexpr Tag kVerificationFlag{0x0040, 0xA493};
inline constexpr Tag kPreliminaryFlag{0x0040, 0xA496};
inline constexpr Tag kContent{0x0040, 0xA730};
inline constexpr Tag kReferencedItem{0x0040, 0xDB73};
inline constexpr Tag kDocumentTitle{0x0042, 0x0010};
inline constexpr Tag kEncapsulatedDocument{0x0042, 0x0011};
inline constexpr Tag kMimeType{0x0042, 0x0012};
inline constexpr Tag kEncapsulatedLength{0x0042, 0x0015};
inline constexpr Tag kGraphicData{0x0070, 0x0022};
inline constexpr Tag kGraphicType{0x0070, 0x0023};
inline constexpr Tag kFrameOfReferenceOfPoints{0x3006, 0x0024};
inline constexpr Tag kPlanLabel{0x300A, 0x0002};

}  // namespace macula::dicom::document_tag
