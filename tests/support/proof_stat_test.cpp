/// Tests of the ladder: for every kind of sample it accepts what is right, and each rung rejects what is wrong by
/// little.
#include "steradian/tests/support/proof.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "steradian/core/sampling/distribution.h"
#include "steradian/core/sampling/warp.h"

namespace steradian::test {
namespace {

/// What may be wrong with a warp.
enum class Fault {
  None,
  TooDense,        // the density is 2 % too large everywhere
  Lopsided,        // it is 2 % too large on one side and too small on the other: its integral is right
  Shifted,         // random numbers are moved by up to 0.01
  Outside,         // one sample in ten thousand lies beyond the support
  NotFinite,       // the sample of the random numbers (0, 0) is NaN
  WrongInverse,    // invert() is 2 % off
  SwappedInverse,  // invert() takes one number for the other
  InverseAtOne,    // invert() can give 1
  WideDiffers,     // Lanes<N> round differently
  WidePdfDiffers,
  WideInverseDiffers,
};

/// The fault that only shows at width N.
template <class F>
F wideOnly(bool on, F x) {
  return on && widthOf<F> > 1 ? x * F(1.0f + 0x1p-23f) : x;
}
template <class F>
bool isRare(F u) {
  return lane(u, 0) > 0.3f && lane(u, 0) < 0.3001f;
}
template <class F>
F shifted(F u) {
  return u + F(0.04f) * u * (F(1.0f) - u);
}

/// Faults of the random numbers and of the inverse, the same for every kind.
template <class F>
struct FaultyBase {
  Fault fault;

  F used(F u) const { return fault == Fault::Shifted ? shifted(u) : u; }
  F inverted(F u) const {
    if (fault == Fault::WrongInverse) return minimum(u * F(1.02f), F(kOneMinusEpsilon));
    if (fault == Fault::InverseAtOne) return select(u > F(0.999f), F(1.0f), u);
    return wideOnly(fault == Fault::WideInverseDiffers, u);
  }
  /// `side`: the place in -1 to 1.
  F density(F right, F side) const {
    if (fault == Fault::TooDense) return right * F(1.02f);
    if (fault == Fault::Lopsided) return right * (F(1.0f) + F(0.02f) * copySign(F(1.0f), side));
    return wideOnly(fault == Fault::WidePdfDiffers, right);
  }
  F broken(F x, F u, F v) const {
    const F nan(std::numeric_limits<float>::quiet_NaN());
    if (fault != Fault::NotFinite) return wideOnly(fault == Fault::WideDiffers, x);
    return select((u == F(0.0f)) & (v == F(0.0f)), nan, x);
  }
};

template <class F>
struct FaultyDirections : FaultyBase<F> {
  Vec3<F> sample(Vec2<F> u) const {
    Vec3<F> w = CosineHemisphere<F>::sample({this->used(u.x), u.y});
    if (this->fault == Fault::Outside && isRare(u.y)) w = -w;
    w.x = this->broken(w.x, u.x, u.y);
    return w;
  }
  F pdf(Vec3<F> w) const { return this->density(CosineHemisphere<F>::pdf(w), w.x); }
  Vec2<F> invert(Vec3<F> w) const {
    const Vec2<F> u = CosineHemisphere<F>::invert(w);
    if (this->fault == Fault::SwappedInverse) return {u.y, u.x};
    return {this->inverted(u.x), u.y};
  }
};

template <class F>
struct FaultyPoints : FaultyBase<F> {
  Vec2<F> sample(Vec2<F> u) const {
    Vec2<F> p = UniformDisk<F>::sample({this->used(u.x), u.y});
    if (this->fault == Fault::Outside && isRare(u.y)) p = {F(0.8f), F(0.8f)};
    p.x = this->broken(p.x, u.x, u.y);
    return p;
  }
  F pdf(Vec2<F> p) const { return this->density(UniformDisk<F>::pdf(p), p.x); }
  Vec2<F> invert(Vec2<F> p) const {
    const Vec2<F> u = UniformDisk<F>::invert(p);
    if (this->fault == Fault::SwappedInverse) return {u.y, u.x};
    return {this->inverted(u.x), u.y};
  }
};

/// The density 2 x on [0, 1].
template <class F>
struct FaultyNumbers : FaultyBase<F> {
  F sample(F u) const {
    F x = squareRoot(maximum(this->used(u), F(0x1p-25f)));
    if (this->fault == Fault::Outside && isRare(u)) x = F(1.25f);
    return this->broken(x, u, F(0.0f));
  }
  F pdf(F x) const {
    const F right = select((x >= F(0.0f)) & (x <= F(1.0f)), F(2.0f) * x, F(0.0f));
    return this->density(right, x - F(squareRoot(0.5f)));
  }
  F invert(F x) const { return this->inverted(minimum(x * x, F(kOneMinusEpsilon))); }
};

/// Four indices of probability 0, 1/4, 1/2 and 1/4.
struct FaultyIndices {
  Fault fault;

  template <class F>
  struct Sample {
    UintOf<F> index;
    F probability;
  };
  template <class F>
  Sample<F> sample(F u) const {
    const F v = fault == Fault::Shifted ? shifted(u) : u;
    UintOf<F> index = select(v < F(0.25f), UintOf<F>(1u), select(v < F(0.75f), UintOf<F>(2u), UintOf<F>(3u)));
    if (fault == Fault::Outside && isRare(u)) index = UintOf<F>(0u);
    if (fault == Fault::NotFinite) index = select(u == F(0.0f), UintOf<F>(4u), index);
    if (fault == Fault::WideDiffers && widthOf < F >> 1) index = UintOf<F>(2u);
    F p = select(index == UintOf<F>(2u), F(0.5f), F(0.25f));
    if (fault == Fault::TooDense) p *= F(1.02f);
    if (fault == Fault::Lopsided)
      p *= select(index == UintOf<F>(1u), F(1.02f), select(index == UintOf<F>(3u), F(0.98f), F(1.0f)));
    return {index, wideOnly(fault == Fault::WidePdfDiffers, p)};
  }
  static std::size_t size() { return 4; }
  float probability(std::size_t i) const {
    const float right = i == 0 ? 0.0f : i == 2 ? 0.5f : 0.25f;
    if (fault == Fault::TooDense) return right * 1.02f;
    if (fault == Fault::Lopsided) return right * (i == 1 ? 1.02f : i == 3 ? 0.98f : 1.0f);
    return right;
  }
};

/// Accepted without a fault; each of `faults` is rejected by the rung whose message has `word`.
struct Expected {
  Fault fault;
  const char* word;
};
template <class Prove>
void expectRejections(const Prove& proveWith, std::initializer_list<Expected> faults) {
  EXPECT_TRUE(proveWith(Fault::None));
  for (const Expected& e : faults) {
    const testing::AssertionResult result = proveWith(e.fault);
    EXPECT_FALSE(result) << static_cast<int>(e.fault);
    EXPECT_NE(std::string(result.message()).find(e.word), std::string::npos)
        << static_cast<int>(e.fault) << ": " << result.message();
  }
}

template <template <class> class T>
auto proverOf(const CheckOptions& options) {
  return [options](Fault fault) { return prove([fault](auto f) { return T<decltype(f)>{{fault}}; }, options); };
}

TEST(Proof, OfDirectionsRejectsEachFault) {
  expectRejections(proverOf<FaultyDirections>({}), {{Fault::TooDense, "integrates"},
                                                    {Fault::Lopsided, "chi-square"},
                                                    {Fault::Shifted, "chi-square"},
                                                    {Fault::Outside, "no sample"},
                                                    {Fault::NotFinite, "not finite"},
                                                    {Fault::WrongInverse, "invert() gives"},
                                                    {Fault::SwappedInverse, "invert() gives"},
                                                    {Fault::InverseAtOne, "leaves [0, 1)"},
                                                    {Fault::WideDiffers, "differs from width 1: sample"},
                                                    {Fault::WidePdfDiffers, "differs from width 1: pdf"},
                                                    {Fault::WideInverseDiffers, "differs from width 1: invert"}});
}

TEST(Proof, OfPointsRejectsEachFault) {
  expectRejections(proverOf<FaultyPoints>({.domain = {-1.0, 1.0, -1.0, 1.0}}),
                   {{Fault::TooDense, "integrates"},
                    {Fault::Lopsided, "chi-square"},
                    {Fault::Shifted, "chi-square"},
                    {Fault::Outside, "no sample"},
                    {Fault::NotFinite, "no sample"},
                    {Fault::WrongInverse, "invert() gives"},
                    {Fault::SwappedInverse, "invert() gives"},
                    {Fault::InverseAtOne, "leaves [0, 1)"},
                    {Fault::WideDiffers, "differs from width 1: sample"},
                    {Fault::WidePdfDiffers, "differs from width 1: pdf"},
                    {Fault::WideInverseDiffers, "differs from width 1: invert"}});
}

TEST(Proof, OfNumbersRejectsEachFault) {
  expectRejections(proverOf<FaultyNumbers>({}), {{Fault::TooDense, "integrates"},
                                                 {Fault::Lopsided, "chi-square"},
                                                 {Fault::Shifted, "chi-square"},
                                                 {Fault::Outside, "no sample"},
                                                 {Fault::NotFinite, "no sample"},
                                                 {Fault::WrongInverse, "invert() gives"},
                                                 {Fault::InverseAtOne, "leaves [0, 1)"},
                                                 {Fault::WideDiffers, "differs from width 1: sample"},
                                                 {Fault::WidePdfDiffers, "differs from width 1: pdf"},
                                                 {Fault::WideInverseDiffers, "differs from width 1: invert"}});
}

TEST(Proof, OfIndicesRejectsEachFault) {
  const auto proveWith = [](Fault fault) { return prove(FaultyIndices{fault}, {.inverse = false}); };
  expectRejections(proveWith, {{Fault::TooDense, "integrates"},
                               {Fault::Lopsided, "chi-square"},
                               {Fault::Shifted, "chi-square"},
                               {Fault::Outside, "pdf() says 0"},
                               {Fault::NotFinite, "outside of the domain"},
                               {Fault::WideDiffers, "differs from width 1: sample"},
                               {Fault::WidePdfDiffers, "differs from width 1: pdf"}});
}

// A sample outside of the domain is detected even if its density is not 0.
TEST(Proof, DomainsAreChecked) {
  EXPECT_FALSE(prove<UniformDisk>({.domain = {-1.0, 0.5, -1.0, 1.0}}));
  EXPECT_FALSE(prove([](auto f) { return ExponentialFlight<decltype(f)>{decltype(f)(1.0f)}; },
                     {.domain = {0.0, 3.0, 0.0, 1.0}}));
}

// Samplers without inverse or lanes must declare it, and those with them must not: no check is left out unnoticed.
TEST(Proof, RungsAreLeftOutOnlyWhereTheyDoNotExist) {
  const AliasTable table(std::array{1.0f, 2.0f});
  EXPECT_TRUE(prove(table, {.inverse = false}));
  EXPECT_FALSE(prove(table));
  EXPECT_FALSE(prove(table, {.inverse = false, .lanes = false}));
  EXPECT_TRUE(prove(UniformSphere<float>{}, {.lanes = false}));
  EXPECT_FALSE(prove(UniformSphere<float>{}));
  EXPECT_FALSE(prove<UniformSphere>({.inverse = false}));
}

TEST(Proof, MissingSamplesAreCounted) {
  // One in fifty is lost.
  struct Lossy {
    float pdfScale;
    DirectionSample<float> sample(float choice, Vec2f u) const {
      if (choice < 0.02f) return {};
      return {UniformSphere<float>::sample(u), pdf({})};
    }
    float pdf(Vec3f) const { return kInvFourPi * pdfScale; }
  };
  EXPECT_FALSE(prove(Lossy{1.0f}, {.inverse = false, .lanes = false}));
  EXPECT_FALSE(prove(Lossy{0.98f}, {.inverse = false, .lanes = false}));
  EXPECT_TRUE(prove(Lossy{0.98f}, {.noSample = 0.02, .inverse = false, .lanes = false}));
  EXPECT_TRUE(prove(Lossy{0.98f}, {.noSample = std::nullopt, .inverse = false, .lanes = false}));
}

}  // namespace
}  // namespace steradian::test
