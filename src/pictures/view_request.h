// Turns a view of a window into a request and a record; shared by view_picture.h and view_sequence.h.
#pragma once

#include <string>
#include <vector>

#include "base/text.h"
#include "pictures/drawn_picture.h"
#include "pictures/picture_request.h"
#include "pictures/render_record.h"
#include "pictures/view_picture.h"

namespace macula::pictures {

// usage for a size or effects out of range; fails as chooseQuality.
Result<PictureRequest> requestOf(const ViewPicture& picture, bool isLinear);

// The record for the metadata of the file; no patient data.
RenderRecord recordOf(const ViewPicture& picture, const PictureRequest& request, const DrawnPicture& drawn);

// The notes on the picture, each with its action.
std::vector<Text> sentencesOf(const DrawnPicture& drawn, const PictureRequest& request);

}  // namespace macula::pictures
