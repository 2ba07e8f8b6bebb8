#pragma once
/// Path reuse: neighbouring pixels share what their paths find after the second vertex (Bekaert, Sbert and Halton 2002,
/// "Accelerating path tracing by re-using paths").
///
/// Pixels form groups: aligned blocks of 2 x 1, 2 x 2, 4 x 2, ... The samples of one index in a group each trace a path
/// of their own: camera, x1, x2, and on from there. A Lambertian x2 sends the same radiance L in all directions, so the
/// x1 of all other paths of the group can be connected with it. Each of them might have sampled the direction to this
/// x2 itself: with a density p_k(x2) per m^2, which is 0 if something is between them. By the balance heuristic (Veach
/// 1997, 9.2.2) over these densities, path i gathers
///
///     sum over j of f_i(x2_j) G(x1_i, x2_j) V(x1_i, x2_j) L_j / sum over k of p_k(x2_j).
///
/// That is unbiased, because each L_j is. A connection costs one evaluation of a BSDF and a shadow ray, where a path
/// takes a dozen rays. Not shared are the light that x2 emits, which each path counts for itself as in path_loop.h,
/// what comes by Dirac lobes, and what comes from surfaces that are not Lambertian.
///
/// Each pixel has less noise, but pixels of a group have much of it in common: the mean of a group is no better than
/// without reuse.
#include <bit>
#include <span>
#include <vector>

#include "steradian/core/math/morton.h"
#include "steradian/integrators/path/group_rows.h"
#include "steradian/integrators/path/path_kernels.h"
#include "steradian/integrators/path/path_packet.h"

namespace STERADIAN_API steradian {

/// The samples of one square of pixels. It traces paths up to where they leave x2, is the Source of PathPacket for the
/// rest of them, and connects them when they have all ended.
template <class F>
class SharedPaths {
 public:
  static constexpr std::uint32_t kEdge = kSharingEdge, kPixels = kEdge * kEdge;  ///< of the square
  static constexpr int width = widthOf<F>;

  /// Samples first, ..., first + perPixel - 1 of the pixels of the square whose corner is (x, y).
  SharedPaths(const WideScene& scene, const PathPlan& plan, const RenderJob& job, int x, int y, std::uint32_t first,
              std::uint32_t perPixel, PathCounts& counts);

  // The Source of PathPacket.
  bool empty() {
    while (waiting_ == 0 && begun_ < count_) begin();
    return waiting_ == 0;
  }
  PathStart take();
  void arrived(const PathLanes<F>&, const typename PathLanes<F>::Vertex&, UintOf<F>,
               const typename PathPacket<F>::Numbers&) {}
  void ended(std::uint32_t number, Rgb radiance) { later_[number] += radiance; }

  /// To be called when the packet has traced all paths: the samples, pixel by pixel, row by row.
  std::span<const PixelSample> finish();

 private:
  using Mask = MaskOf<F>;
  using Uint = UintOf<F>;
  using Vertex = typename PathLanes<F>::Vertex;

  /// What is kept of as many paths as there are lanes, to connect them later.
  struct Batch {
    Vertex vertex;                                                     ///< x1
    Mask connects;                                                     ///< x1 can gather light from x2 of other paths
    Mask alone;                                                        ///< the path has an x2 that is not shared
    Spectrum<F> throughput;                                            ///< from x2 to the camera
    Spectrum<F> radiance;                                              ///< that the path has found before x2 reflects
    F weight;                                                          ///< of the camera sample, by the filter
    std::array<std::uint32_t, static_cast<std::size_t>(width)> place;  ///< of the samples in results_
  };
  enum Row : std::size_t { kX, kY, kZ, kNormalX, kNormalY, kNormalZ, kRed, kGreen, kBlue, kRows };

  void begin();
  /// How many paths are connected at a time: whole groups and whole batches.
  std::size_t together() const { return std::max(group_, static_cast<std::size_t>(width)); }
  void connect(std::size_t first);
  BsdfValue<F> connection(const Batch& batch, std::size_t first, std::size_t shift);
  Spectrum<F> radianceOf(std::size_t first, std::size_t shift) const {
    return {ends_.get(kRed, first, shift), ends_.get(kGreen, first, shift), ends_.get(kBlue, first, shift)};
  }

  static constexpr std::uint32_t kLambert = indexOfModel<Lambert<float>>();

  const WideScene& scene_;
  PathPlan plan_;
  const RenderJob& job_;
  int x_, y_;
  std::uint32_t first_, perPixel_, count_;
  std::size_t group_;
  PathCounts& counts_;
  PathLanes<F> lanes_;

  std::uint32_t begun_ = 0;
  std::vector<Batch> batches_;
  std::vector<Rgb> later_;  ///< radiance that each x2 reflects
  GroupRows<F> ends_;       ///< each x2: position, normal, and radiance in the end

  // Of the groups that are being connected. Row s of densities_ has for each x1 the density per m^2 of the x2 that is s
  // places further in the group; the last row has for each x2 one over the sum of all x1's densities. gathered_ is what
  // each x1 gathers from each x2, before it is divided by that sum.
  GroupRows<F> densities_;
  std::vector<Spectrum<F>> gathered_;

  // The last batch, and a bit for each of its paths that the packet has yet to take.
  std::uint32_t waiting_ = 0;
  PathState<F> path_;
  Uint pixel_{0u}, sample_{0u};

  std::vector<PixelSample> results_;
};

template <class F>
SharedPaths<F>::SharedPaths(const WideScene& scene, const PathPlan& plan, const RenderJob& job, int x, int y,
                            std::uint32_t first, std::uint32_t perPixel, PathCounts& counts)
    : scene_(scene),
      plan_(plan),
      job_(job),
      x_(x),
      y_(y),
      first_(first),
      perPixel_(perPixel),
      count_(kPixels * perPixel),
      group_(plan.reuse),
      counts_(counts),
      lanes_(scene, plan_, counts),
      later_(count_),
      ends_(kRows, count_, group_),
      densities_(group_ + 1, together(), group_),
      gathered_(together() / static_cast<std::size_t>(width) * group_),
      results_(count_) {
  // The densities of x2 are those of directions alone: they leave out the chance of ending at x1.
  plan_.rouletteStart = std::max(plan_.rouletteStart, 1u);
  batches_.reserve(count_ / static_cast<std::uint32_t>(width));
}

/// Traces the next paths, one in each lane, up to where they leave x2.
template <class F>
void SharedPaths<F>::begin() {
  const std::uint32_t number = begun_;
  const std::uint32_t inSquare = number % kPixels, sample = number / kPixels;
  begun_ += static_cast<std::uint32_t>(width);
  sample_ = Uint(first_ + sample);
  F x, y;
  std::array<std::uint32_t, static_cast<std::size_t>(width)> place;
  for (int i = 0; i < width; ++i) {
    const std::uint32_t inOrder = inSquare + static_cast<std::uint32_t>(i);  // along the Z curve
    const std::uint32_t inX = gatherBits(inOrder), inY = gatherBits(inOrder >> 1), pixel = inY * kEdge + inX;
    const int column = x_ + static_cast<int>(inX), row = y_ + static_cast<int>(inY);
    setLane(x, i, static_cast<float>(column));
    setLane(y, i, static_cast<float>(row));
    setLane(pixel_, i, RenderJob::pixelKey(column, row));
    place[static_cast<std::size_t>(i)] = pixel * perPixel_ + sample;
    results_[pixel * perPixel_ + sample] = kMiss;
  }
  const Sampler<F> sampler(job_.samplerSettings, pixel_, sample_);
  const WeightedRay<F> camera = job_.cameraRay(x, y, sampler);
  path_ = PathState<F>(camera.ray);
  Spectrum<F> radiance;

  const Vertex vertex = lanes_.nextVertex(path_, sampler, Uint(0u), Mask(true), radiance);
  lanes_.recordFirstHit(vertex, vertex.hit,
                        [&](int i) -> PixelSample& { return results_[place[static_cast<std::size_t>(i)]]; });
  Mask going = plan_.maxDepth > 0 ? vertex.hit : Mask(false);
  radiance = select(going, radiance + lanes_.sampleDirectLight(vertex, sampler, Uint(0u), going), radiance);
  const auto first = lanes_.scatter(vertex, sampler, Uint(0u), going, path_);
  const Spectrum<F> throughput = path_.throughput;

  const Vertex second = lanes_.nextVertex(path_, sampler, Uint(1u), first.going, radiance);
  going = plan_.maxDepth > 1 ? second.hit : Mask(false);
  const Spectrum<F> direct = lanes_.sampleDirectLight(second, sampler, Uint(1u), going);
  path_.throughput = grey(F(1.0f));
  path_.refraction = path_.refraction * maxChannel(throughput);  // so that roulette counts what is before x2
  const Mask goOn = lanes_.scatter(second, sampler, Uint(1u), going, path_).going;

  // With a shading normal that differs, the radiance sent depends on the direction (usableShadingNormal).
  const Vec3<F> shading = second.frame.shadingNormal(), normal = second.surface.geometricNormal;
  const Mask shared = going & (first.pdf != F(kDirac)) & (second.material.model == Uint(kLambert)) &
                      (shading.x == normal.x) & (shading.y == normal.y) & (shading.z == normal.z);
  const Vec3<F> end = offsetOrigin(second.point.position, second.point.positionError, normal, second.wo);
  const Vec3<F> facing = select(shared, faceForward(normal, second.wo), Vec3<F>{});
  const std::array<F, kRed> rows{end.x, end.y, end.z, facing.x, facing.y, facing.z};
  for (std::size_t row = 0; row < rows.size(); ++row) ends_.set(row, number, rows[row]);
  batches_.push_back({vertex, vertex.hit & (vertex.diracProbability < F(1.0f)), going & !shared, throughput, radiance,
                      camera.weight, place});
  for (int i = 0; i < width; ++i) {
    later_[number + static_cast<std::uint32_t>(i)] = lane(going, i) ? lane(direct, i) : Rgb{};
    if (!lane(goOn, i)) counts_.countPath(lane(first.going, i) ? 1u : 0u);
  }
  waiting_ = laneBits(goOn);
}

template <class F>
PathStart SharedPaths<F>::take() {
  const int i = std::countr_zero(waiting_);
  waiting_ &= waiting_ - 1;
  const std::uint32_t number = begun_ - static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(i);
  return {lane(path_, i), 2, lane(pixel_, i), lane(sample_, i), number};
}

template <class F>
std::span<const PixelSample> SharedPaths<F>::finish() {
  for (std::size_t first = 0; first < count_; first += together()) connect(first);
  return results_;
}

/// Connects the paths first, ..., first + together() - 1.
template <class F>
void SharedPaths<F>::connect(std::size_t first) {
  const std::size_t count = together(), end = first + count, lanes = static_cast<std::size_t>(width);
  for (std::size_t n = first; n < end; n += lanes) {
    Spectrum<F> later;
    for (std::size_t i = 0; i < lanes; ++i) setLane(later, static_cast<int>(i), later_[n + i]);
    ends_.set(kRed, n, later.r);
    ends_.set(kGreen, n, later.g);
    ends_.set(kBlue, n, later.b);
  }
  for (std::size_t n = first; n < end; n += lanes) {
    for (std::size_t shift = 0; shift < group_; ++shift) {
      const BsdfValue<F> pair = connection(batches_[n / lanes], n, shift);
      densities_.set(shift, n - first, pair.pdf);
      gathered_[(n - first) / lanes * group_ + shift] = pair.value;
    }
  }
  for (std::size_t n = 0; n < count; n += lanes) {
    F sum(0.0f);
    for (std::size_t shift = 0; shift < group_; ++shift)
      sum = sum + densities_.get(shift, n, (group_ - shift) % group_);
    densities_.set(group_, n, select(sum > F(0.0f), F(1.0f) / sum, F(0.0f)));
  }
  for (std::size_t n = first; n < end; n += lanes) {
    const Batch& batch = batches_[n / lanes];
    Spectrum<F> radiance = batch.radiance;
    if (any(batch.alone)) {
      radiance = select(batch.alone, radiance + batch.throughput * radianceOf(n, 0), radiance);
    }
    for (std::size_t shift = 0; shift < group_; ++shift) {
      const F inverse = densities_.get(group_, n - first, shift);
      radiance += gathered_[(n - first) / lanes * group_ + shift] * inverse;
    }
    radiance = radiance * batch.weight;
    for (int i = 0; i < width; ++i) {
      PixelSample& result = results_[batch.place[static_cast<std::size_t>(i)]];
      result.radiance = lane(radiance, i);
      result.alpha *= lane(batch.weight, i);
    }
  }
}

/// What the x1 of each path of the batch gathers from the x2 that is `shift` places further in its group, before it is
/// divided by the sum of densities; and the density per m^2 with which this x1 might have sampled that x2.
template <class F>
BsdfValue<F> SharedPaths<F>::connection(const Batch& batch, std::size_t first, std::size_t shift) {
  const ScatterPoint<F>& from = batch.vertex.point;
  const Vec3<F> end{ends_.get(kX, first, shift), ends_.get(kY, first, shift), ends_.get(kZ, first, shift)};
  const Vec3<F> normal{ends_.get(kNormalX, first, shift), ends_.get(kNormalY, first, shift),
                       ends_.get(kNormalZ, first, shift)};
  const Vec3<F> across = end - from.position;
  const F squared = dot(across, across);
  const Vec3<F> wi = across / squareRoot(squared);
  const F cosine = -dot(normal, wi);
  Mask sees = batch.connects & (cosine > F(0.0f)) & (squared > F(0.0f));
  if (!any(sees)) return {};
  const BsdfValue<F> f = lanes_.evaluate(batch.vertex, wi, sees);
  sees = sees & ((f.pdf > F(0.0f)) | !isBlack(f.value));
  if (shift > 0 && any(sees)) {  // nothing is between x1 and the x2 of its own path
    const Vec3<F> start = offsetOrigin(from.position, from.positionError, from.geometricNormal, wi);
    const Vec3<F> way = end - start;
    const F distance = length(way);
    counts_.shadowRays += static_cast<std::uint64_t>(std::popcount(laneBits(sees)));
    sees = sees & !scene_.template occluded<F>({start, way / distance, distance * F(1.0f - 0x1p-21f), from.time}, sees,
                                               &counts_.embree);
  }
  const F perArea = cosine / squared;
  return {select(sees, f.value * perArea * radianceOf(first, shift), Spectrum<F>{}),
          select(sees, f.pdf * perArea, F(0.0f))};
}

}  // namespace steradian
