// What a model looks like under another curve or clip, before anything of that is traced. Each splat stands
// for the matter at its place: it gets the density and colour that this has now, and is removed if nothing is
// shown there any more. Matter that appears where the model has no splats gets coarse ones, in the light that
// the model has learnt (matter_light.h); so do clip faces that show grey values. Where nothing was learnt
// yet, the estimate has only coarse splats, in the light of the environment.
//
// An estimate, not a model: it hides and shows the right matter, but its light is only nearly right.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "pipeline/hybrid/estimate/clip_faces.h"
#include "pipeline/hybrid/estimate/coarse_matter.h"
#include "pipeline/hybrid/estimate/matter_light.h"
#include "pipeline/splat/model/splats.h"

namespace macula::hybrid {

struct SplatEstimateOptions {
    std::size_t mostNewSplats = 50'000;  // the most visible ones
};

class SplatEstimate {
  public:
    // `model` learnt `matter` as `learntOf` shows it; if it has no splats, nothing counts as learnt.
    // `environment` is in the patient's frame. Keeps all of them, and changes none. Uses all cores.
    SplatEstimate(std::shared_ptr<const CoarseMatter> matter, std::shared_ptr<const splat::Splats> model,
                  ShownMatter learntOf, const trace::Environment& environment,
                  const SplatEstimateOptions& options = {});

    // Returns valid splats, without those of the model that are hidden now; for `learntOf` the model itself,
    // up to rounding. Uses all cores.
    splat::Splats under(const ShownMatter& shown) const;

  private:
    // The sampled voxels of a splat: its middle, and one standard deviation to each side along its axes.
    static constexpr std::size_t kPlaces = 7;
    struct Place {
        std::array<std::uint16_t, kPlaces> entries;
        glm::vec3 voxel;
        std::uint32_t cell;
    };
    struct Matter {
        float extinction = 0.0f;  // mean over the places
        glm::vec3 reflectance{0.0f};
    };

    Matter matterAt(const Place& place, const ShownMatter& shown) const;
    // The splats of one part of the parallel work, and how much of which cells they cover.
    struct Part {
        splat::Splats splats;
        std::vector<std::pair<std::uint32_t, float>> covers;
    };
    splat::Splats none() const;
    void addChanged(std::size_t i, const ShownMatter& shown, const LitMatter& lit, Part& part) const;
    std::vector<std::uint32_t> cellsWithout(const LitMatter& lit, const std::vector<float>& covered) const;
    void addFace(const FacePlace& place, splat::Splats& splats) const;
    float opacityOfCell(const LitMatter& lit, std::size_t cell) const;
    void addSplatOf(std::uint32_t cell, const ShownMatter& shown, const LitMatter& lit, float covered,
                    splat::Splats& splats) const;

    std::shared_ptr<const CoarseMatter> matter_;
    std::shared_ptr<const splat::Splats> model_;
    ShownMatter learntOf_;
    SplatEstimateOptions options_;
    glm::dmat4 voxelFromWorld_;
    std::vector<Place> places_;         // by splat of the model
    std::vector<Matter> learntMatter_;  // likewise
    LitMatter learntLit_;
    std::vector<bool> wasFace_;  // by cell: `learntOf_` had a face with grey values there
    LightOfSides light_;
};

}  // namespace macula::hybrid
